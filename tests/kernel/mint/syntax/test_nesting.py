"""How deep the expressions and the blocks of a text may be nested."""

from __future__ import annotations

import pytest

from motionlang import parse
from motionlang.kernel import ProgramError
from tests.cases import cases


def errors(text: str) -> list[tuple[int, int, str]]:
    """Return line, column and message of each error of a text."""
    try:
        parse(text, "mint")
    except ProgramError as error:
        return [(each.line, each.column, each.message) for each in error.diagnostics]
    return []


@pytest.mark.parametrize("sign", ["-", "Not "])
def test_signs_are_levels_of_an_expression(sign: str) -> None:
    """199 signs and the number are 200 levels. The expression begins in column 5."""
    levels = 199
    assert errors(f"x = {sign * levels}1") == []
    column = 5 + len(sign) * (levels + 1)
    message = (2, column, "the expression is nested more than 200 deep")
    assert errors(f"y = 2\nx = {sign * (levels + 1)}1") == [message]


@cases("depth, message", [(200, ""), (201, "blocks are nested more than 200 deep here")])
def test_blocks_are_nested_up_to_a_depth(depth: int, message: str) -> None:
    text = "While 1\n" * depth + "PRINT 1\n" + "End While\n" * depth
    assert [each[2] for each in errors(text)] == ([message] if message else [])


@pytest.mark.parametrize("text", ["If x Then ", "If x Then y = 2 Else "])
def test_ifs_of_one_line_are_nested_up_to_a_depth(text: str) -> None:
    assert errors(text * 200 + "y = 1") == []
    message = "blocks are nested more than 200 deep here"
    assert [each[2] for each in errors(text * 201 + "y = 1\nz = 2\n")] == [message]
    assert [each[2] for each in errors(text * 3_000 + "y = 1")] == [message]
