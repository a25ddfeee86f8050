"""From the rules of a grammar and their actions to reducers: one in-place function for every alternative."""

from __future__ import annotations

import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Rules:
    """Numbers the rules in the order in which they are met, and writes their reducers."""

    def __init__(self, actions: dict[str, str]) -> None:
        self.actions = actions
        self.rows: list[str] = []
        self.functions: list[str] = []
        self._numbers: dict[Any, int] = {}
        self._written: dict[str, str] = {}

    def number(self, rule: Any) -> int:
        """The number of a rule of Lark's."""
        if rule not in self._numbers:
            self._numbers[rule] = len(self.rows)
            self.rows.append(f"({len(rule.expansion)}, {str(rule.origin.name)!r}, {self._reducer(rule)})")
        return self._numbers[rule]

    def identity(self, rule: Any) -> bool:
        """Does the rule have one symbol, whose value stays as it is?"""
        return len(rule.expansion) == 1 and rule.options.expand1 and not rule.alias

    def _reducer(self, rule: Any) -> str:
        """The name of the function that does a rule's action, written once for every shape of it."""
        length = len(rule.expansion)
        if self.identity(rule):
            return "None"
        alias = rule.alias or rule.options.template_source or rule.origin.name
        lines = _reducer_body(self._expression(rule, alias), length)
        if not lines:
            return "None"
        text = "\n".join(lines)
        if text not in self._written:
            name = self._written[text] = f"_{alias}_{len(self._written)}"
            self.functions.append(f"\ndef {name}(V, T):\n{text}\n")
        return self._written[text]

    def _expression(self, rule: Any, alias: str) -> str:
        """The action with its `v…` counted over the symbols that are there."""
        present = rule.options.empty_indices or (False,) * len(rule.expansion)
        places: list[str] = []
        symbols = iter(range(len(rule.expansion)))
        for missing in present:
            places.append("None" if missing else f"v{next(symbols)}")
        if alias == "more":
            last = max(i for i, symbol in enumerate(rule.expansion) if not symbol.is_term)
            return f"+ v{last}"
        return re.sub(r"\bv(\d+)", lambda found: places[int(found[1])], self.actions[alias])


def _reducer_body(expression: str, length: int) -> list[str]:
    """The lines that replace the last `length` values by one, taking only what is needed off the stack."""
    append = expression.startswith("+ ")
    value = expression.removeprefix("+ ")
    used = {int(digits) for digits in re.findall(r"\bv(\d+)", value)}
    if length == 0:
        return [f"    V.append({value})"]
    if value == "v0":
        return _drop(length - 1)
    lines = []
    for place in sorted(used, reverse=True) if length <= 3 else sorted(used):
        if length > 3:
            lines.append(f"    v{place} = V[{place - length}]")
    if length > 3:
        lines += _drop(length - 1)
    else:
        for place in range(length - 1, 0, -1):
            lines.append(f"    v{place} = V.pop()" if place in used else "    V.pop()")
        if 0 in used:
            lines.append("    v0 = V[-1]")
    lines.append(f"    V[-1].append({value})" if append else f"    V[-1] = {value}")
    return lines


def _drop(count: int) -> list[str]:
    return ["    V.pop()"] * count if count <= 2 else [f"    del V[-{count}:]"]
