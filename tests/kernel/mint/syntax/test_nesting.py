"""How deep the expressions and the blocks of a text may be nested."""

from __future__ import annotations

import pytest

from motionlang.kernel import ProgramError, Source
from motionlang.kernel.mint.syntax.nesting import LINKS, MAX_DEPTH, MAX_EXPRESSION_DEPTH, depth_of
from motionlang.kernel.mint.syntax.nodes import Assign
from motionlang.kernel.mint.syntax.parser import parse
from tests.cases import cases


def errors(text: str) -> list[tuple[int, int, str]]:
    """Return line, column and message of each error of a text."""
    try:
        parse(Source("a.mnt", text))
    except ProgramError as error:
        return [(each.line, each.column, each.message) for each in error.diagnostics]
    return []


@pytest.mark.parametrize("sign", ["-", "Not "])
def test_signs_are_levels_of_an_expression(sign: str) -> None:
    """199 signs and the number are 200 levels. The expression begins in column 5."""
    levels = MAX_EXPRESSION_DEPTH - 1
    assert errors(f"x = {sign * levels}1") == []
    column = 5 + len(sign) * (levels + 1)
    message = (2, column, "the expression is nested more than 200 deep")
    assert errors(f"y = 2\nx = {sign * (levels + 1)}1") == [message]


def test_a_chain_of_operations_is_one_level() -> None:
    """Up to 50 operations are nested; a chain, its links and values are 3 levels.

    A line of up to 200 characters is too short for a long chain to matter.
    """

    def depth(text: str) -> int:
        (assignment,) = parse(Source("a.mnt", f"x = {text}")).body
        assert isinstance(assignment, Assign)
        return depth_of(assignment.values[0])

    assert depth("1") == 1
    assert depth("1 + 2 + 3") == 3
    assert depth("1 + (2 + 3)") == 3
    assert depth("f(1 + 2)") == 3
    assert depth("1" + " + 111" * LINKS) == LINKS + 1
    assert depth("1" + " + 111" * (LINKS + 1)) == 3


@cases("depth, message", [(MAX_DEPTH, ""), (MAX_DEPTH + 1, "blocks are nested more than 200 deep here")])
def test_blocks_are_nested_up_to_a_depth(depth: int, message: str) -> None:
    text = "While 1\n" * depth + "PRINT 1\n" + "End While\n" * depth
    assert [each[2] for each in errors(text)] == ([message] if message else [])
