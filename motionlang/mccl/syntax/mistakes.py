"""Where a piece of text stops being a command, by the table of `grammars/mccl.lark`."""

from __future__ import annotations

import re

from motionlang.lang.parsing.linked_stack import empty, expected, feed
from motionlang.lang.parsing.parser import END
from motionlang.mccl.syntax.tables import AUTOMATON, TERMINALS

_PATTERNS = {name: re.compile(pattern, re.ASCII) for name, pattern in TERMINALS.items()}


def stuck(text: str) -> tuple[int, set[str]]:
    """How much of a text is the beginning of a command, and the kinds of token that could follow it there."""
    top, at = empty(AUTOMATON), 0
    while True:
        kinds = expected(AUTOMATON, top) - {END}
        found = {kind: each for kind in kinds if (each := _PATTERNS[kind].match(text, at))}
        if not found:
            return at, kinds
        kind = next(name for name in _PATTERNS if name in found)
        top, at = feed(top, kind, at)[0], found[kind].end()
