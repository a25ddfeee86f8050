"""Constant folding: find values that are known before the program runs."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.resolve.symbols import Symbol
from motionlang.kernel.mint.runtime import functions
from motionlang.kernel.mint.syntax import nodes

Meaning = tuple[Symbol | None, Keyword | None]

Known = float | str

_WHOLE = (-(2**31), 2**31 - 1)


def resolved(name: nodes.Name) -> tuple[Symbol | None, Keyword | None]:
    """Return what a resolved name refers to."""
    return name.symbol, name.row


def fold(node: nodes.Expr, means: Callable[[nodes.Name], Meaning] = resolved) -> Known | None:
    """Return the value of `node`, None if it is unknown before the run.

    `means` returns what a name refers to.
    """
    if type(node) is nodes.Number or type(node) is nodes.String:
        return node.value
    if type(node) is nodes.Name and node.args is None:
        symbol, row = means(node)
        if symbol is not None:
            return symbol.const
        return constant(row.function, row.unit) if row is not None and row.kind == "constant" else None
    if type(node) is nodes.Unary:
        value = fold(node.operand, means)
        return None if value is None else unary(node.op, value)
    if type(node) is nodes.Binary:
        left, right = fold(node.left, means), fold(node.right, means)
        return None if left is None or right is None else binary(node.op, left, right)
    if type(node) is nodes.Chain:
        value = fold(node.first, means)
        for link in node.links:
            right = fold(link.value, means)
            if value is None or right is None:
                return None
            value = binary(link.op, value, right)
        return value
    return None


def given(node: nodes.Expr, means: Callable[[nodes.Name], Meaning]) -> nodes.Expr | None:
    """Return `node` without names if its value is known when the program starts.

    Returns None if the value depends on the run.
    """
    if type(node) is nodes.Given:
        return node
    known = fold(node, means)
    if known is not None:
        return (
            nodes.String(node.start, node.end, known)
            if isinstance(known, str)
            else nodes.Number(node.start, node.end, known)
        )
    if type(node) is nodes.Name and node.args is None:
        symbol, _ = means(node)
        return symbol.node if symbol is not None and symbol.given else None  # type: ignore[return-value]
    if type(node) is nodes.Unary:
        operand = given(node.operand, means)
        return None if operand is None else nodes.Unary(node.start, node.end, node.op, operand)
    if type(node) is nodes.Binary:
        left, right = given(node.left, means), given(node.right, means)
        return (
            None
            if left is None or right is None
            else nodes.Binary(node.start, node.end, node.op, left, right)
        )
    if type(node) is nodes.Chain:
        first, links = given(node.first, means), []
        for link in node.links:
            right = given(link.value, means)
            if first is None or right is None:
                return None
            links.append(nodes.Link(link.start, link.end, link.op, right))
        return None if first is None else nodes.Chain(node.start, node.end, first, links)
    return None


def constant(text: str, unit: str) -> float:
    """Return the value of a predefined constant, given as text in its row."""
    return float(text) if unit == "number" else int(text)


def unary(op: str, value: Known) -> Known | None:
    """Return `op value`, None if it is undefined or must fail at run time."""
    if isinstance(value, str):
        return None
    if op == "-":
        return _fits(-value, type(value) is int)
    if op == "+":
        return value
    if op == "Not":
        return int(not value)
    return ~value if type(value) is int else None


def binary(op: str, left: Known, right: Known) -> Known | None:
    """Return `left op right`, None if it is undefined or must fail at run time."""
    if isinstance(left, str) or isinstance(right, str):
        if isinstance(left, str) and isinstance(right, str) and op in ("+", "&"):
            return left + right
        return None
    function = _BINARY.get(op)
    if function is None:
        return None
    try:
        return _fits(function(left, right), type(left) is int and type(right) is int)
    except (Rejected, ArithmeticError, ValueError):
        return None


def _fits(value: float, whole: bool) -> float | None:
    """Return the value, None on integer overflow, which the run reports with its line."""
    return None if whole and type(value) is int and not _WHOLE[0] <= value <= _WHOLE[1] else value


_BINARY: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "\\": functions.divide,
    "Mod": functions.modulo,
    "^": functions.power,
    "<<": functions.shift_left,
    ">>": functions.shift_right,
    "&": lambda a, b: functions.integer(a) & functions.integer(b),
    "|": lambda a, b: functions.integer(a) | functions.integer(b),
    "Xor": lambda a, b: functions.integer(a) ^ functions.integer(b),
    "=": lambda a, b: int(a == b),
    "<>": lambda a, b: int(a != b),
    "<": lambda a, b: int(a < b),
    ">": lambda a, b: int(a > b),
    "<=": lambda a, b: int(a <= b),
    ">=": lambda a, b: int(a >= b),
    "And": lambda a, b: int(bool(a) and bool(b)),
    "Or": lambda a, b: int(bool(a) or bool(b)),
}
