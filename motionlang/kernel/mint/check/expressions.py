"""Check expressions: literals, names, members, operators; each kind has a function in `VALUES`."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from motionlang.kernel.mint.check import keywords
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.calls import call
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.check.values import NOTHING, Value, article, literal, read_from, typed
from motionlang.kernel.mint.check.variables import location
from motionlang.kernel.mint.resolve.folding import binary as fold_binary
from motionlang.kernel.mint.resolve.folding import unary as fold_unary
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, STRING
from motionlang.kernel.mint.runtime.functions import INT_HIGH
from motionlang.kernel.mint.syntax import nodes

_COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))
_LOGIC = frozenset(("And", "Or"))
_ARITHMETIC = frozenset(("+", "-", "*"))
_FRACTIONS = frozenset(("/", "^"))


def _number(b: Body, node: nodes.Number) -> Value:
    known = node.value
    if known in (inf, -inf):
        b.problem("overflow", "the number is too large", node)
        return NOTHING
    if type(known) is int and INT_HIGH < known < 1 << 32 and b.program.problems.is_pattern(node):
        known -= 1 << 32  # a 32-bit pattern is an Integer, even if its highest bit is set
    return literal(known)


def _cast(b: Body, node: nodes.Cast) -> Value:
    b.convert(b.value(node.value), node.to, node)
    return typed(node.to.name)


def _omitted(b: Body, node: nodes.Omitted) -> Value:
    hint = "only a list of values for single axes may leave one out: SPEED(0, 1) = , 20"
    b.problem("values", "a value is missing here", node, hint)
    return NOTHING


def _name(b: Body, node: nodes.Name) -> Value:
    symbol, result = node.symbol, b.function.result_named(node)
    if result is not None:
        return read_from(result.type)
    if symbol is None:
        if node.row is not None:
            return keywords.read(b, node, node.row)
        unknown_name(b, node)
        return NOTHING
    if symbol.kind == "const" and node.args is None:
        assert symbol.const is not None
        return literal(symbol.const)
    if symbol.kind == "define" and node.args is None:
        return NOTHING if node.definition is None else b.value(node.definition)
    if symbol.kind == "sub":
        return call(b, node, symbol, wanted=True)
    if symbol.kind in ("variable", "parameter"):
        if symbol.is_array and node.args is None:
            b.problem("index", f"{symbol.name} is an array and needs a subscript", node)
            return NOTHING
        return read_from(location(b, node))
    b.problem("type", f"{symbol.name} is a {symbol.kind} and has no value", node)
    return NOTHING


# ---------------------------------------------------------------------------------------------- operators


def _unary(b: Body, node: nodes.Unary) -> Value:
    """Check `Not x`, `-x`, `+x` and `~x`."""
    if node.op == "Not":
        b.condition(node.operand)
        return typed(INTEGER)
    found = b.number(node.operand)
    known = None if found.const is None else fold_unary(node.op, found.const)
    if known is not None:
        return literal(known)
    if node.op == "+":
        return found
    return typed(INTEGER if node.op == "~" else _sum(found, found))


def _binary(b: Body, node: nodes.Binary) -> Value:
    """Check an operation on two sides."""
    return _operated(b, node.op, (node.left, b.value(node.left)), node.right)


def _chain(b: Body, node: nodes.Chain) -> Value:
    """Check a long run of operations, and annotate each `Link` with the result up to it."""
    found = b.value(node.first)
    for link in node.links:
        found = _operated(b, link.op, (node, found), link.value)
        link.type, link.const = found.type, found.const
    return found


def _operated(b: Body, op: str, left: tuple[nodes.Node, Value], right: nodes.Expr) -> Value:
    """Return the result of an operation, whose left side is checked already: its node and its value."""
    at, one = left
    if op in _LOGIC:
        b.as_number(one, at, "a condition")
        b.condition(right)
        return typed(INTEGER)
    other = b.value(right)
    if not (one.is_number and other.is_number):
        return _other_than_numbers(b, op, left, (right, other))
    if one.const is None or other.const is None:
        return typed(_result(op, one, other))
    known = fold_binary(op, one.const, other.const)
    if known is not None:
        return literal(known)
    if op in ("/", "\\", "Mod") and other.const == 0:
        b.problem("division-by-zero", "division by zero", at, "the divisor is 0 whatever the program does")
        return NOTHING
    return typed(_result(op, one, other))


def _result(op: str, left: Value, right: Value) -> str:
    """Return the type of an operation on numbers."""
    if op in _ARITHMETIC:
        return _sum(left, right)
    if op in _FRACTIONS or (op == "Mod" and FLOAT in (left.type, right.type)):
        return FLOAT
    return INTEGER


def _sum(left: Value, right: Value) -> str:
    return INTEGER if left.type == right.type == INTEGER else FLOAT


def _other_than_numbers(
    b: Body, op: str, left: tuple[nodes.Node, Value], right: tuple[nodes.Node, Value]
) -> Value:
    if STRING in (left[1].type, right[1].type):
        return _texts(b, op, left[0], left[1], right[1])
    side, found = right if left[1].is_number else left
    b.problem("type", f"{op} needs numbers, not {article(found.type)}", side)
    return NOTHING


def _texts(b: Body, op: str, at: nodes.Node, left: Value, right: Value) -> Value:
    """Return the result of an operation on two strings; report an error if one is no string."""
    if left is NOTHING or right is NOTHING:
        return NOTHING
    if left.type != STRING or right.type != STRING:
        hint = "convert the number with Str" if op in ("+", "&") else ""
        b.problem("type", f"{op} cannot take {article(left.type)} and {article(right.type)}", at, hint)
        return NOTHING
    if op in ("+", "&"):
        known = isinstance(left.const, str) and isinstance(right.const, str)
        return literal(left.const + right.const) if known else typed(STRING)  # type: ignore[operator]
    if op in _COMPARISONS:
        return typed(INTEGER)
    b.problem("type", f"{op} needs numbers, not texts", at)
    return NOTHING


VALUES: dict[type, Callable[..., Value]] = {
    nodes.Number: _number,
    nodes.String: lambda b, node: literal(node.value),
    nodes.Given: lambda b, node: typed(STRING if node.is_text else FLOAT),
    nodes.Cast: _cast,
    nodes.Omitted: _omitted,
    nodes.Name: _name,
    nodes.Member: lambda b, node: read_from(location(b, node)),
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Chain: _chain,
    nodes.Wrong: lambda b, node: NOTHING,  # the parser has reported it
}
