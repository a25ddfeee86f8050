"""The expected items in messages equal Lark's sets, for every prefix of a text.

The texts are those that test errors.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import lark
import pytest
from lark.parsers.lalr_interactive_parser import InteractiveParser

from motionlang.kernel.lang.syntax.grammar import BAD, END, build
from motionlang.kernel.lang.syntax.stack import Cell
from motionlang.kernel.mint.syntax.tokens import TABLE, Tokens

TESTS = Path(__file__).parents[3]


def mint_texts() -> list[str]:
    """Return Mint programs with errors: one per file, or separated by lines of dashes."""
    files = sorted((TESTS / "errors" / "mint").glob("*.mnt"))
    many = (TESTS / "kernel" / "mint" / "syntax" / "parser_errors.txt").read_text().split("\n----\n")
    return [*(file.read_text() for file in files), *many]


class Accepted:
    """Lark's accepted tokens, cached by its stack of states."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, ...], set[str]] = {}

    def __call__(self, parser: InteractiveParser) -> set[str]:
        stack = tuple(parser.parser_state.state_stack)
        if stack not in self._known:
            self._known[stack] = set(parser.accepts())  # type: ignore[no-untyped-call]
        return self._known[stack]


@pytest.mark.slow
def test_mint_expects_what_lark_accepts() -> None:
    reference, accepted, seen = build("mint", None), Accepted(), 0
    own = cache(Cell.expected)
    for text in mint_texts():
        parser, top = reference.parse_interactive(""), TABLE.empty()
        tokens = Tokens(text)
        for at, (kind, piece) in enumerate(zip(tokens.kinds, tokens.texts, strict=True)):
            assert own(top) == accepted(parser), (text, piece)
            seen += 1
            if kind in own(top) - {END, BAD}:  # wrong tokens are omitted
                parser.feed_token(lark.Token(kind, piece))
                top = top.feed(kind, at)[0]
    assert seen > 1000
