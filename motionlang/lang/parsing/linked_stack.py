"""The stack of the table parser as a linked list, for texts that are wrong.

`motionlang.lang.parsing.parser` parses at full speed and forgets how it came to where it stands. Here nothing is
forgotten: a stack is a `Cell`, feeding a token makes a new one, and the old one is still good. So a mistake
is undone by keeping the cell from before it, and "what could stand here" is found by trying.
"""

from __future__ import annotations

from motionlang.lang.parsing.parser import State

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.lang.parsing.parser import Automaton, Rule


class Cell:
    """A stack: its top symbol (a kind of token or a rule), the first token of that, and what lies below."""

    __slots__ = ("at", "below", "depth", "state", "symbol")

    def __init__(self, state: State, below: Cell | None, symbol: str, at: int) -> None:
        self.state, self.below, self.symbol, self.at = state, below, symbol, at
        self.depth: int = below.depth + 1 if below else 0

    def __iter__(self) -> Iterator[Cell]:
        """The cells from the top down."""
        cell: Cell | None = self
        while cell:
            yield cell
            cell = cell.below


def empty(tables: Automaton) -> Cell:
    """The stack before the first token."""
    return Cell(tables.start, None, "", 0)


def feed(top: Cell, kind: str, at: int) -> tuple[Cell, bool]:
    """Reduce and shift; when the token does not fit, the stack as far reduced as it goes, and False."""
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
    """Feed made-up tokens that stand at `at`; None when they do not fit."""
    for kind in kinds:
        top, fits = feed(top, kind, at)
        if not fits:
            return None
    return top


def expected(tables: Automaton, top: Cell) -> set[str]:
    """The kinds of token that may come next."""
    return {kind for kind in tables.kinds if feed(top, kind, 0)[1]}
