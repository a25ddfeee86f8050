"""Objectives and conditions: numeric expressions over the figures of a variant.

Examples are `time + 0.1 * peak.0` and `peak.0 < 400`.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from math import inf

_NAME = re.compile(r"""("[^"]*"|'[^']*')|(?<![\w.])(cycle\([^()]*\)(?:\.\w+)?|[A-Za-z_]\w*(?:\.\w+)*)""")
_WORDS = frozenset(("and", "or", "not", "True", "False"))
_OPERATORS: dict[type, Callable[..., object]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Not: operator.not_,
}
_FUNCTIONS: dict[str, Callable[..., object]] = {"abs": abs, "min": min, "max": max}
# The maximum nodes of an expression's syntax tree, and the maximum exponent.
_MAX_NODES, _MAX_POWER = 500, 100.0


class QuantityExpression:
    """An expression over names such as `time`, `accel` and `axis.0.plant.inertia`.

    Raises ValueError if it is invalid.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        # Names with dots are not Python identifiers: each gets one that is.
        aliases: dict[str, str] = {}

        def plain(found: re.Match[str]) -> str:
            name = found[2]
            if name is None or name in _WORDS or name in _FUNCTIONS:
                return found[0]
            return aliases.setdefault(name, f"n{len(aliases)}_")

        try:
            self._tree = ast.parse(_NAME.sub(plain, text).strip(), mode="eval").body
            self._names = {alias: name for name, alias in aliases.items()}
            nodes = list(ast.walk(self._tree))
            if len(nodes) > _MAX_NODES:
                raise ValueError("it is too long")
            for node in nodes:
                self._check(node)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            raise ValueError(
                f"{text!r} is not an expression such as time + 0.1 * peak.0, or peak.0 < 400"
            ) from error
        self.names = tuple(aliases)

    def _check(self, node: ast.AST) -> None:
        known = (
            *_OPERATORS, ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.And, ast.Or, ast.Compare, ast.Constant, ast.Name,
            ast.Load, ast.Call,
        )  # fmt: skip
        if not isinstance(node, known) or (
            isinstance(node, ast.Constant) and not isinstance(node.value, (int, float, str))
        ):
            raise ValueError(ast.dump(node))
        if isinstance(node, ast.Call):
            called = isinstance(node.func, ast.Name) and node.func.id in _FUNCTIONS
            if not called or node.keywords or not node.args:
                raise ValueError(ast.dump(node))

    def __call__(self, values: Mapping[str, object]) -> object | None:
        """Return its value; None for a missing value, a division by zero and the like."""
        try:
            return self._value(self._tree, values)
        except (ArithmeticError, TypeError, ValueError, LookupError):
            return None

    def number(self, values: Mapping[str, object]) -> float | None:
        """Return its value if that is a finite number; None if it is not."""
        found = self(values)
        finite = isinstance(found, (int, float)) and abs(found) < inf
        return float(found) if finite else None  # type: ignore[arg-type]

    def _value(self, node: ast.expr, values: Mapping[str, object]) -> object:
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Name):
            found = values[self._names[node.id]]
            if found is None:
                raise LookupError(node.id)
            return found
        if isinstance(node, ast.UnaryOp):
            return _OPERATORS[type(node.op)](self._value(node.operand, values))
        if isinstance(node, ast.BinOp):
            left, right = self._value(node.left, values), self._value(node.right, values)
            if isinstance(left, str) or isinstance(right, str):
                raise TypeError("a text can only be compared")
            if isinstance(node.op, ast.Pow) and abs(right) > _MAX_POWER:  # type: ignore[arg-type]
                raise ArithmeticError("too large")
            return _OPERATORS[type(node.op)](left, right)
        if isinstance(node, ast.BoolOp):
            every = isinstance(node.op, ast.And)
            return (all if every else any)(self._value(each, values) for each in node.values)
        if isinstance(node, ast.Compare):
            left = self._value(node.left, values)
            for op, comparator in zip(node.ops, node.comparators, strict=True):
                right = self._value(comparator, values)
                if not _OPERATORS[type(op)](left, right):
                    return False
                left = right
            return True
        assert isinstance(node, ast.Call)
        assert isinstance(node.func, ast.Name)
        return _FUNCTIONS[node.func.id](*(self._value(each, values) for each in node.args))


def pareto(costs: list[tuple[float, ...]]) -> list[int]:
    """Return the indices of the Pareto front, in order of the first cost."""
    order = sorted(range(len(costs)), key=lambda n: (costs[n], n))
    if costs and len(costs[0]) == 2:
        front, least = [], inf
        for n in order:
            if costs[n][1] < least:
                front.append(n)
                least = costs[n][1]
        return front
    front = []
    for n in order:
        if not any(all(a <= b for a, b in zip(costs[m], costs[n], strict=True)) for m in front):
            front.append(n)
    return front
