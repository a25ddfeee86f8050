"""Reducers, generated from the rules of a grammar and their actions.

Each distinct shape of an alternative has one function.
"""

from __future__ import annotations

import ast
import re
from inspect import signature

from motionlang.lang.parsing.driver import popped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Sequence
    from types import ModuleType
    from typing import Any


class Rules:
    """Numbers the rules in the order in which they are met, and writes their reducers.

    Without actions there are no reducers. For the first shape of each action in `inlined` the lines are
    stored for the driver instead. `leaves` are the actions of tokens that are complete values; the
    driver has their lines, too.
    """

    def __init__(
        self,
        actions: dict[str, str] | None,
        nodes: ModuleType | None = None,
        inlined: Sequence[str] = (),
        leaves: Collection[str] = (),
    ) -> None:
        self.actions = actions
        self._nodes = (
            {name: cls for name, cls in vars(nodes).items() if isinstance(cls, type)} if nodes else {}
        )
        self.rows: list[str] = []
        self.functions: list[str] = []
        # Actions that the driver carries out itself: the lines of each inlined action, and the lines and the
        # reducer of each leaf.
        self.inlined: dict[str, list[str]] = {action: [] for action in inlined}
        self.leaves: dict[str, tuple[list[str], str]] = dict.fromkeys(leaves, ([], ""))
        self._numbers: dict[Any, int] = {}
        self._written: dict[tuple[str, ...], str] = {}

    def number(self, rule: Any) -> int:
        """Return the number of a Lark rule."""
        if rule not in self._numbers:
            self._numbers[rule] = len(self.rows)
            self.rows.append(f"({len(rule.expansion)}, {str(rule.origin.name)!r}, {self._reducer(rule)})")
        return self._numbers[rule]

    def identity(self, rule: Any) -> bool:
        """True if the rule has one symbol, whose value stays unchanged."""
        return len(rule.expansion) == 1 and rule.options.expand1 and not rule.alias

    def _reducer(self, rule: Any) -> str:
        """Return the name of the reducer of a rule, which is written once per shape."""
        length = len(rule.expansion)
        if self.actions is None or self.identity(rule):
            return "None"
        alias = rule.alias or rule.options.template_source or rule.origin.name
        lines = self._body(self._expression(rule, alias), length)
        if not lines:
            return "None"
        shape = (str(length), *lines)
        if shape not in self._written:
            if self.inlined.get(alias) == []:
                self._written[shape] = str([*self.inlined].index(alias))
                self.inlined[alias] = [*popped(length, _used(lines)), *_with_top(lines, length)]
            else:
                self._written[shape] = self._function(alias, length, lines)
        return self._written[shape]

    def _function(self, alias: str, length: int, lines: list[str]) -> str:
        name = f"_{alias}_{len(self._written)}"
        push = ["S = S, M, top"] if length == 0 else popped(length, _used(lines))
        if length == 1 and self.leaves.get(alias) == ([], ""):
            self.leaves[alias] = _with_top(lines, length, "at"), name
        body = [*push, *_with_top(lines, length), "return S, top"]
        self.functions.append(f"\ndef {name}(S, M, top, T):\n" + "".join(f"    {line}\n" for line in body))
        return name

    def _expression(self, rule: Any, alias: str) -> str:
        """Return the action; its `v…` count only the symbols that are present."""
        present = rule.options.empty_indices or (False,) * len(rule.expansion)
        values: list[str] = []
        symbols = iter(range(len(rule.expansion)))
        for missing in present:
            values.append("None" if missing else f"v{next(symbols)}")
        if alias == "more":
            last = max(i for i, symbol in enumerate(rule.expansion) if not symbol.is_term)
            return f"+ v{last}"
        assert self.actions is not None
        return re.sub(r"\bv(\d+)", lambda found: values[int(found[1])], self.actions[alias])

    def _body(self, expression: str, length: int) -> list[str]:
        """Return the lines that compute `top` from `length` values.

        There are no lines if the only value stays unchanged.
        """
        append = expression.startswith("+ ")
        value = expression.removeprefix("+ ")
        if value == "v0" and length == 1:
            return []
        made = self._made(value)
        if append:
            return [*made, f"v0.append({'n' if made else value})", "top = v0"]
        return [*made, f"top = {'n' if made else value}"]

    def _made(self, value: str) -> list[str]:
        """Return a node's constructor inlined as lines, which is a third faster.

        Returns no lines for any other value.
        """
        call = ast.parse(value, mode="eval").body
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name) or call.keywords:
            return []
        fields = _fields(self._nodes.get(call.func.id, object))
        texts = [ast.unparse(argument) for argument in call.args]
        if not fields or any(text.startswith("*") for text in texts):
            return []
        texts += [repr(default) for _, default in fields[len(texts) :]]
        stores = [f"n.{name} = {text}" for (name, _), text in zip(fields, texts, strict=True)]
        return [f"n = new({call.func.id})", *stores]


def _fields(cls: type) -> list[tuple[str, Any]]:
    """Return the parameters, with defaults, of a class that only stores each of them.

    Each parameter must be stored under its own name.
    """
    if "__init__" not in vars(cls):
        return []
    fields = [(each.name, each.default) for each in signature(cls).parameters.values()]
    marks = [object() for _ in fields]
    made = cls(*marks)
    slots = [slot for base in cls.__mro__ for slot in getattr(base, "__slots__", ()) if hasattr(made, slot)]
    stores_all = all(getattr(made, name, None) is mark for (name, _), mark in zip(fields, marks, strict=True))
    return fields if stores_all and len(slots) == len(fields) else []


def _used(lines: list[str]) -> set[int]:
    """Return the indexes of the values that the lines read."""
    return {int(digits) for digits in re.findall(r"\bv(\d+)", "\n".join(lines))}


def _with_top(lines: list[str], length: int, name: str = "top") -> list[str]:
    """Return the lines with the topmost value renamed to `name`."""
    return [re.sub(rf"\bv{length - 1}\b", name, line) for line in lines]
