"""From Lark's LALR(1) table to rows of text, in a fixed order.

Each state has a default reduction, which makes the table a quarter of the size. A mistake is then found after
the text before it has been fully reduced, so that "expected" lists the tokens that a reader would list. Lark
numbers states by the order of its sets, which varies. Here they are numbered in the order in which they are
reached, so that the same grammar always gives the same text.
"""

from __future__ import annotations

from collections import Counter

from lark.parsers.lalr_analysis import Shift

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.lang.parsing.rules import Rules


class States:
    """The states of a parse table as rows; the first is the start, `finish` accepts."""

    def __init__(self, table: Any, rules: Rules) -> None:
        self._states = table.states
        self.rules = rules
        self._through = self._renaming()
        self._numbers: dict[int, int] = {}
        self.rows: list[str] = []
        self._number(table.start_states["start"])
        self._write_all()
        self.finish = self._numbers[table.end_states["start"]]

    def _write_all(self) -> None:
        """Write the rows in the order of their numbers.

        Each row may number further states.
        """
        while len(self.rows) < len(self._numbers):
            self.rows.append(self._row(self._states[list(self._numbers)[len(self.rows)]]))

    def _number(self, state: int) -> int:
        return self._numbers.setdefault(state, len(self._numbers))

    def _renaming(self) -> dict[int, str]:
        """Map each state that can only rename one symbol to the symbol's new name.

        A shift to such a state is replaced by one to where the renaming leads.
        """
        found = {}
        for state, actions in self._states.items():
            rules = {rule for kind, rule in actions.values() if kind is not Shift}
            if len(rules) == 1 and all(kind is not Shift for kind, _ in actions.values()):
                rule = rules.pop()
                if self.rules.identity(rule):
                    found[state] = rule.origin.name
        return found

    def _row(self, actions: dict[str, tuple[Any, Any]]) -> str:
        """Return the row of a state.

        A row has `state=kind,kind` for shifts and for transitions after reductions, `r5=kind` for a rule and
        `d5` for the default.
        """
        default = self._default(actions)
        entries: dict[str, list[str]] = {}
        for symbol, (kind, target) in sorted(actions.items()):
            if kind is Shift:
                while target in self._through:
                    target = actions[self._through[target]][1]
                entries.setdefault(str(self._number(target)), []).append(symbol)
            elif target is not default:
                entries.setdefault(f"r{self.rules.number(target)}", []).append(symbol)
        row = [f"{target}={','.join(symbols)}" for target, symbols in entries.items()]
        return " ".join([*row, f"d{self.rules.number(default)}"] if default else row)

    def _default(self, actions: dict[str, tuple[Any, Any]]) -> Any:
        """Return the rule by which most kinds reduce; in a tie, the first by its symbols."""
        counts = Counter(rule for kind, rule in actions.values() if kind is not Shift)
        return min(counts, key=lambda rule: (-counts[rule], str(rule)), default=None)
