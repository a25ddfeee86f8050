"""The tables of blocks agree with the grammar."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from motionlang.kernel.lang.syntax.grammar import Token
from motionlang.kernel.lang.syntax.stack import Stack
from motionlang.kernel.mint.syntax.blocks import CLOSERS, DECLARATIONS, OPENERS
from motionlang.kernel.mint.syntax.tokens import PARSER, Tokens

OPENED = {
    "IF": "If a Then",
    "FOR": "For i = 1 To 2",
    "SELECT": "Select Case a\nCase 1",
    "WHILE": "While a",
    **{kind: kind for kind in ("REPEAT", "LOOP", "STARTUP")},
    **{kind: f"{kind} a" for kind in DECLARATIONS if kind != "STARTUP"},
}


def accepted(text: str) -> set[str]:
    """Return the kinds of token that may follow a text."""
    stack = Stack(PARSER)
    for kind in Tokens(text).kinds[:-1]:
        assert stack.feed(Token(kind, ""))
    return stack.accepts()


@pytest.mark.parametrize("kind", OPENED)
def test_a_block_is_closed_or_continued_by_its_words(kind: str) -> None:
    closers = accepted(OPENED[kind]) - accepted("")
    assert closers == {closer for closer, block in CLOSERS.items() if block == kind}
    stack = Stack(PARSER)
    ends = [*Tokens(OPENED[kind]).kinds[:-1], "END", kind, "_NL"]
    assert all(stack.feed(Token(each, "")) for each in ends) is (kind not in ("FOR", "REPEAT"))


def test_every_block_is_in_the_table() -> None:
    heads = {
        symbol.name for rule in PARSER.rules for symbol in rule.expansion[:1] if _has_body(rule.expansion)
    }
    assert set(OPENERS) == set(OPENED) == {head for head in heads if head.isupper()} | {"IF", "FOR", "SELECT"}


def _has_body(symbols: Sequence[object]) -> bool:
    return any(getattr(symbol, "name", "") in ("body", "task_body", "members") for symbol in symbols)
