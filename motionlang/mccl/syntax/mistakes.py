"""The offset at which a text is no longer a valid command.

It is found with the table of `grammars/mccl.lark`.
"""

from __future__ import annotations

import re

from motionlang.lang.parsing.linked_stack import Cell, empty, expected, feed
from motionlang.lang.parsing.parser import END
from motionlang.mccl.syntax.tables import AUTOMATON, TERMINALS

_PATTERNS = {name: re.compile(pattern, re.ASCII) for name, pattern in TERMINALS.items()}


def stuck(text: str) -> tuple[int, set[str]]:
    """Return the length of the valid beginning of a command, and what could follow.

    The latter is a set of kinds of token.
    """
    top, at = empty(AUTOMATON), 0
    while True:
        kinds = _could_follow(top)
        found = {kind: each for kind in kinds if (each := _PATTERNS[kind].match(text, at))}
        if not found:
            return at, kinds
        kind = next(name for name in _PATTERNS if name in found)
        top, at = feed(top, kind, at)[0], found[kind].end()


def _could_follow(top: Cell) -> set[str]:
    """Return the kinds of token that could come next.

    The result is cached per stack, because commands have few different stacks.
    """
    states = tuple([cell.state.number for cell in top])
    kinds = _FOLLOW.get(states)
    if kinds is None:
        kinds = _FOLLOW[states] = expected(AUTOMATON, top) - {END}
    return kinds


_FOLLOW: dict[tuple[int, ...], set[str]] = {}
