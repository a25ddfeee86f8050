"""The rules of a grammar, as rows of text."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Rules:
    """Numbers the rules in the order in which they are met."""

    def __init__(self) -> None:
        self.rows: list[str] = []
        self._numbers: dict[Any, int] = {}

    def number(self, rule: Any) -> int:
        """Return the number of a Lark rule."""
        if rule not in self._numbers:
            self._numbers[rule] = len(self.rows)
            self.rows.append(f"({len(rule.expansion)}, {str(rule.origin.name)!r}, None)")
        return self._numbers[rule]

    def identity(self, rule: Any) -> bool:
        """True if the rule has one symbol, whose value stays unchanged."""
        return len(rule.expansion) == 1 and rule.options.expand1 and not rule.alias
