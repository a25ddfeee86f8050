"""The parser's stack as a linked list, for texts with mistakes.

Lark's own stack changes with each token. Here a stack is an immutable `Cell`, and feeding a token creates a new one. To
recover from a mistake, return to the cell before it. To find which tokens may come next, try each of them.

A state that can reduce does so before a mistake is reported, by the rule that most kinds of token reduce by. The text
before a mistake has then been fully reduced, so that "expected" lists the tokens that a reader would list.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from lark import Lark
from lark.grammar import Rule

from motionlang.kernel.lang.syntax.grammar import BAD, END


class Table:
    """The parse table of a grammar, and its kinds of token."""

    def __init__(self, parser: Lark) -> None:
        found = parser.parse_interactive("").parser_state.parse_conf
        self.states, self.start, self.end = found.states, found.start_state, found.end_state
        self.kinds = {str(each.name) for each in parser.terminals} - {BAD, *parser.lexer_conf.ignore} | {END}
        # The spelling of each kind that has only one.
        self.spellings = {
            str(each.name): each.pattern.value for each in parser.terminals if each.pattern.type == "str"
        }
        self._defaults: dict[object, Rule | None] = {}

    def default(self, state: object) -> Rule | None:
        """Return the rule by which most kinds reduce in a state; in a tie, the first by its symbols."""
        if state not in self._defaults:
            rules = [arg for _, arg in self.states[state].values() if isinstance(arg, Rule)]
            counts = Counter(rules)
            self._defaults[state] = min(counts, key=lambda rule: (-counts[rule], str(rule)), default=None)
        return self._defaults[state]

    def empty(self) -> Cell:
        """Return the stack before the first token."""
        return Cell(self, self.start, None, "", 0)


class Cell:
    """A stack: its top symbol, the first token of that symbol, and the stack below.

    The symbol is a kind of token or a rule.
    """

    __slots__ = ("at", "below", "depth", "state", "symbol", "table")

    def __init__(self, table: Table, state: object, below: Cell | None, symbol: str, at: int) -> None:
        self.table, self.state, self.below, self.symbol, self.at = table, state, below, symbol, at
        self.depth: int = below.depth + 1 if below else 0

    def __iter__(self) -> Iterator[Cell]:
        """Iterate over the cells from the top down."""
        cell: Cell | None = self
        while cell:
            yield cell
            cell = cell.below

    def feed(self, kind: str, at: int) -> tuple[Cell, bool]:
        """Reduce and shift a token; return the new stack and True if the token fits.

        If it does not fit, return the stack after all possible reductions, and False.
        """
        top, table = self, self.table
        if kind == BAD:
            return top, False
        while True:
            if kind == END and top.state == table.end:
                return top, True
            _, found = table.states[top.state].get(kind, (None, None))
            if found is None:
                found = table.default(top.state)
            if found is None:
                return top, False
            if not isinstance(found, Rule):
                return Cell(table, found, top, kind, at), True
            top = top._reduced(found, at)

    def feed_all(self, kinds: tuple[str, ...], at: int) -> Cell | None:
        """Feed synthetic tokens at `at`; return None if they do not fit."""
        top = self
        for kind in kinds:
            top, fits = top.feed(kind, at)
            if not fits:
                return None
        return top

    def expected(self) -> set[str]:
        """Return the kinds of token that may come next."""
        return {kind for kind in self.table.kinds if self.feed(kind, 0)[1]}

    def _reduced(self, rule: Rule, at: int) -> Cell:
        below = self
        for _ in rule.expansion:
            at = below.at
            assert below.below
            below = below.below
        _, state = self.table.states[below.state][rule.origin.name]
        return Cell(self.table, state, below, str(rule.origin.name), at)
