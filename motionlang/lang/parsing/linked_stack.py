"""The parser's stack as a linked list, for texts with mistakes.

`motionlang.lang.parsing.parser` parses at full speed and does not record how it reached its state. Here every
state is preserved: a stack is an immutable `Cell`, and feeding a token creates a new one. To recover from a
mistake, return to the cell before it. To find which tokens may come next, try each of them.
"""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.lang.parsing.parser import Automaton, Rule, State


class Cell:
    """A stack: its top symbol, the first token of that symbol, and the stack below.

    The symbol is a kind of token or a rule.
    """

    __slots__ = ("at", "below", "depth", "state", "symbol")

    def __init__(self, state: State, below: Cell | None, symbol: str, at: int) -> None:
        self.state, self.below, self.symbol, self.at = state, below, symbol, at
        self.depth: int = below.depth + 1 if below else 0

    def __iter__(self) -> Iterator[Cell]:
        """Iterate over the cells from the top down."""
        cell: Cell | None = self
        while cell:
            yield cell
            cell = cell.below


def empty(tables: Automaton) -> Cell:
    """Return the stack before the first token."""
    return Cell(tables.start, None, "", 0)


def feed(top: Cell, kind: str, at: int) -> tuple[Cell, bool]:
    """Reduce and shift a token; return the new stack and True if the token fits.

    If it does not fit, return the stack after all possible reductions, and False.
    """
    while True:
        action = top.state.step(kind)
        if isinstance(action, State):
            return Cell(action, top, kind, at), True
        if action is None:
            return top, False
        top = _reduced(top, action, at)


def _reduced(top: Cell, rule: Rule, at: int) -> Cell:
    length, origin, _ = rule
    below = top
    for _ in range(length):
        at = below.at
        assert below.below
        below = below.below
    return Cell(below.state.after(rule), below, origin, at)


def feed_all(top: Cell, kinds: tuple[str, ...], at: int) -> Cell | None:
    """Feed synthetic tokens at `at`; return None if they do not fit."""
    for kind in kinds:
        top, fits = feed(top, kind, at)
        if not fits:
            return None
    return top


def expected(tables: Automaton, top: Cell) -> set[str]:
    """Return the kinds of token that may come next."""
    return {kind for kind in tables.kinds if feed(top, kind, 0)[1]}
