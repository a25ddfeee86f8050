"""The generated pattern splits commands like Lark with the same grammar."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lark import Token, Tree
from lark.exceptions import LarkError

from motionlang.lang.parsing.generate import build_lark
from motionlang.mccl import codes
from motionlang.mccl.keywords import table
from motionlang.mccl.resolve.command import NONE, NUMBER, REGISTER, TEXT
from motionlang.mccl.resolve.decode import problem
from motionlang.mccl.resolve.line import Line, lines_of
from tests.cases import examples

GRAMMAR = build_lark("mccl.lark", lexer="contextual", keep_all_tokens=False)
KINDS = {"WHOLE": NUMBER, "REAL": NUMBER, "REGISTER": REGISTER, "TEXT": TEXT}
Read = list[list[tuple[int, str, int, Any]]]

numbers = st.one_of(
    st.integers(-9999, 9999).map(str),
    st.decimals(-999, 999, places=3).map(str),
    st.sampled_from([".5", "5.", "+3", "-.25", "1e3", "2.5E-1", ""]),
)
parameters = st.one_of(
    numbers, st.integers(0, 255).map("@{}".format), st.sampled_from(['"A"', '"a;b,c d"', '""'])
)
names = st.sampled_from([row.name for row in table()]).flatmap(
    lambda name: st.sampled_from([name, name.lower()])
)
commands = st.builds("{}{}{}".format, st.sampled_from(["", "1", "2", "0", "08"]), names, parameters)
remarks = st.sampled_from(["", "; a remark", " ;1MR5", ";,\"'"])
lines = st.builds(
    "{}{}{}".format,
    st.sampled_from(["", " ", "\t", ","]),
    st.lists(commands, max_size=5).flatmap(
        lambda found: st.sampled_from([",", " ", ", ", ",,", "\t"]).map(
            lambda separator: separator.join(found)
        )
    ),
    remarks,
)
files = st.lists(st.one_of(lines, st.sampled_from(["", "# a whole line", "  #1MR5", ";"])), max_size=6).map(
    "\n".join
)


def by_grammar(text: str) -> Read:
    """Return the commands of a text, parsed by Lark."""
    tree = GRAMMAR.parse(text)
    return [[_command(each) for each in line.children] for line in tree.children if line.children]  # type: ignore[union-attr, arg-type]


def _command(tree: Tree[Token]) -> tuple[int, str, int, Any]:
    word, *parameter = tree.children
    *axis, mnemonic = map(str, word.children)  # type: ignore[union-attr]
    head = int("".join(axis) or 0), mnemonic.upper()
    if not parameter:
        return *head, NONE, 0
    token = parameter[0]
    assert isinstance(token, Token)
    kind, text = KINDS[token.type], str(token)
    value = float(text) if kind == NUMBER else int(text[1:]) if kind == REGISTER else text[1:-1]
    return *head, kind, value


def by_pattern(text: str) -> Read:
    """Return the commands of a text, parsed by the package.

    The range of values is not compared.
    """
    read: Read = []
    for line in lines_of(text):
        assert isinstance(line, Line)
        read.append([(c.axis, c.name, c.kind, c.value) for c in line.commands])
    return read


def is_form(text: str) -> bool:
    """True if the package finds the form of a command in every command of a text."""
    for line in lines_of(text):
        if isinstance(line, Line):
            faults = [problem(command) for command in line.commands]
            if any(
                fault is not None and fault.code == codes.FORMAT and fault.kind == "syntax"
                for fault in faults
            ):
                return False
    return True


@settings(max_examples=examples(300))
@given(files)
def test_both_ways_read_the_same(text: str) -> None:
    own = by_pattern(text)
    for expected, found in zip(by_grammar(text), own, strict=True):
        assert [each[:2] for each in expected] == [each[:2] for each in found]
        for (_, _, kind, value), (_, _, own_kind, own_value) in zip(expected, found, strict=True):
            # A command with an invalid parameter has none.
            assert (own_kind, own_value) in ((kind, value), (NONE, 0))


@settings(max_examples=examples(300))
@given(st.text(alphabet='1aM.@",; -+e#\n', max_size=12))
def test_what_one_way_refuses_the_other_refuses(text: str) -> None:
    try:
        GRAMMAR.parse(text)
    except LarkError:
        assert not is_form(text) or _only_unknown(text)
    else:
        assert is_form(text)


def _only_unknown(text: str) -> bool:
    """True if a command name is unknown, for which only the package rejects a text."""
    return any(
        isinstance(line, Line) and any(c.row is None for c in line.commands) for line in lines_of(text)
    )


@pytest.mark.parametrize(
    "text", ["1MR1000,2MR5", "1MR1000 2MR5", "1mr1e3;x", '#no\nLU"A,B",1RL@0', "0MC1\n\n1TP"]
)
def test_a_few_by_name(text: str) -> None:
    assert by_grammar(text) == by_pattern(text)
