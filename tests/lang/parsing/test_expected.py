"""The expected items in messages equal Lark's sets, for every prefix of a text.

The texts are those that test errors.
"""

from __future__ import annotations

from pathlib import Path

import lark
from lark.parsers.lalr_interactive_parser import InteractiveParser

from motionlang.lang.parsing.generate import build_lark
from motionlang.lang.parsing.linked_stack import empty, expected, feed
from motionlang.lang.parsing.parser import END
from motionlang.mccl.syntax.mistakes import stuck
from motionlang.mccl.syntax.parser import parts, pieces
from motionlang.mccl.syntax.tables import AUTOMATON

TESTS = Path(__file__).parents[2]


class Accepted:
    """Lark's accepted tokens, cached by its stack of states."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, ...], set[str]] = {}

    def __call__(self, parser: InteractiveParser) -> set[str]:
        stack = tuple(parser.parser_state.state_stack)
        if stack not in self._known:
            self._known[stack] = set(parser.accepts())  # type: ignore[no-untyped-call]
        return self._known[stack]


def test_mccl_expects_what_lark_accepts() -> None:
    reference, accepted, seen = build_lark("mccl.lark", lexer="contextual"), Accepted(), 0
    for file in sorted((TESTS / "errors" / "mccl").glob("*.mcl")):
        for line in file.read_text().splitlines():
            parser, top = reference.parse_interactive(line), empty(AUTOMATON)
            try:
                for token in parser.iter_parse():  # which takes it when the next one is requested
                    assert expected(AUTOMATON, top) == accepted(parser), (line, token)
                    top = feed(top, token.type, 0)[0]
                    seen += 1
            except lark.exceptions.UnexpectedInput:
                wrong = next(piece for piece in pieces(line) if parts(piece) is None)
                # By itself it begins at the start of a line; a separator may precede a command, too.
                around = {"_SEPARATOR", "_NEWLINE", END}
                assert stuck(wrong)[1] | around == accepted(parser) | around, line
            assert expected(AUTOMATON, top) == accepted(parser), line
    assert seen > 100
