"""From the rules of a grammar and their actions to reducers: one in-place function for every alternative."""

from __future__ import annotations

import ast
import re
from inspect import signature

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import ModuleType
    from typing import Any


class Rules:
    """Numbers the rules in the order in which they are met, and writes their reducers, where there are actions."""

    def __init__(self, actions: dict[str, str] | None, nodes: ModuleType | None = None) -> None:
        self.actions = actions
        self._nodes = (
            {name: cls for name, cls in vars(nodes).items() if isinstance(cls, type)} if nodes else {}
        )
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
        if self.actions is None or self.identity(rule):
            return "None"
        alias = rule.alias or rule.options.template_source or rule.origin.name
        lines = self._body(self._expression(rule, alias), length)
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
        assert self.actions is not None
        return re.sub(r"\bv(\d+)", lambda found: places[int(found[1])], self.actions[alias])

    def _body(self, expression: str, length: int) -> list[str]:
        """The lines that replace the last `length` values by one, taking only what is needed off the stack."""
        append = expression.startswith("+ ")
        value = expression.removeprefix("+ ")
        if length == 0:
            return [f"    V.append({value})"]
        if value == "v0":
            return _drop(length - 1)
        lines = _taken({int(digits) for digits in re.findall(r"\bv(\d+)", value)}, length)
        made = self._made(value)
        if made and append:
            return [*lines, f"    n = {made[0]}", *made[1:], "    V[-1].append(n)"]
        if made:
            return [*lines, f"    V[-1] = n = {made[0]}", *made[1:]]
        return [*lines, f"    V[-1].append({value})" if append else f"    V[-1] = {value}"]

    def _made(self, value: str) -> list[str]:
        """What a call of a node's class does, written out, which is a third quicker; nothing for other values."""
        call = ast.parse(value, mode="eval").body
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name) or call.keywords:
            return []
        fields = _fields(self._nodes.get(call.func.id, object))
        texts = [ast.unparse(argument) for argument in call.args]
        if not fields or any(text.startswith("*") for text in texts):
            return []
        texts += [repr(default) for _, default in fields[len(texts) :]]
        stores = [f"    n.{name} = {text}" for (name, _), text in zip(fields, texts, strict=True)]
        return [f"new({call.func.id})", *stores]


def _fields(cls: type) -> list[tuple[str, Any]]:
    """The parameters of a class that keeps each of them under its own name and does nothing else, with defaults."""
    if "__init__" not in vars(cls):
        return []
    fields = [(each.name, each.default) for each in signature(cls).parameters.values()]
    marks = [object() for _ in fields]
    made = cls(*marks)
    slots = [slot for base in cls.__mro__ for slot in getattr(base, "__slots__", ()) if hasattr(made, slot)]
    kept = all(getattr(made, name, None) is mark for (name, _), mark in zip(fields, marks, strict=True))
    return fields if kept and len(slots) == len(fields) else []


def _taken(used: set[int], length: int) -> list[str]:
    """The lines that take the values in use off the stack, which keeps one place for the new one."""
    if length > 3:
        return [f"    v{place} = V[{place - length}]" for place in sorted(used)] + _drop(length - 1)
    lines = [
        f"    v{place} = V.pop()" if place in used else "    V.pop()" for place in range(length - 1, 0, -1)
    ]
    return [*lines, "    v0 = V[-1]"] if 0 in used else lines


def _drop(count: int) -> list[str]:
    return ["    V.pop()"] * count if count <= 2 else [f"    del V[-{count}:]"]
