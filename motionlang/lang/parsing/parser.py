"""The LALR table that `generate` writes for MCCL.

Lark decides which states there are, what they shift and what they reduce. A state is read from its row of the table on
the first visit.
"""

from __future__ import annotations

from collections.abc import Iterable

# Number of symbols, name of the left side, and nothing.
Rule = tuple[int, str, None]

END = "$END"  # Lark's name for the end of the text
BAD = "BAD"  # the kind of a token that is in no grammar


class State:
    """The actions on each kind of token, and the transitions after reductions."""

    __slots__ = ("_actions", "_row", "default", "number", "tables")

    def __init__(self, tables: Automaton, number: int, row: str) -> None:
        self.tables, self.number, self._row = tables, number, row
        self._actions: dict[str, State | Rule | None] = {BAD: None}
        self.default: Rule | None = None

    def step(self, kind: str) -> State | Rule | None:
        """Return the state to shift to, the rule to reduce by, or None if neither exists."""
        if self._row:
            self._fill()
        return self._actions.get(kind, self.default)

    def after(self, rule: Rule) -> State:
        """Return the state after a reduction by a rule that began here."""
        return self._actions[rule[1]]  # type: ignore[return-value]  # the beginning of the rule has been read

    def end(self) -> None:
        """Shift the end of the text like any other token."""
        self._actions[END] = self

    def _fill(self) -> None:
        """Read the row: `target=kind,kind …`.

        A target is a state, a rule such as `r5`, or the default rule, such as `d5`.
        """
        row, self._row = self._row, ""
        tables, actions = self.tables, self._actions
        for entry in row.split():
            target, _, kinds = entry.partition("=")
            if target[0] == "d":
                self.default = tables.rules[int(target[1:])]
            elif target[0] == "r":
                actions.update(dict.fromkeys(kinds.split(","), tables.rules[int(target[1:])]))
            else:
                actions.update(dict.fromkeys(kinds.split(","), tables.states[int(target)]))


class Automaton:
    """The LALR(1) table of a grammar: its states and kinds of token."""

    def __init__(self, kinds: Iterable[str], rules: Iterable[Rule], rows: Iterable[str], finish: int) -> None:
        self.kinds = {*kinds, END}
        self.rules = tuple(rules)
        self.states = [State(self, number, row) for number, row in enumerate(rows)]
        self.start = self.states[0]
        self.states[finish].end()
