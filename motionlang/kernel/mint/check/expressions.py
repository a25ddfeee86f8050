"""Check expressions: literals, names, members; each kind has a function in `VALUES`."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from motionlang.kernel.mint.check import keywords, operators
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.calls import call
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.check.values import INT_HIGH, NOTHING, KnownValue, literal, read_from
from motionlang.kernel.mint.check.variables import location
from motionlang.kernel.mint.resolve.symbols import FLOAT, STRING, Symbol
from motionlang.kernel.mint.syntax import nodes


def _number(b: Body, node: nodes.Number) -> KnownValue:
    known = node.value
    if known in (inf, -inf):
        b.problem("overflow", "the number is too large", node)
        return NOTHING
    if type(known) is int and INT_HIGH < known < 1 << 32 and b.program.problems.is_pattern(node):
        known -= 1 << 32  # a 32-bit pattern is an Integer, even if its highest bit is set
    return literal(known)


def _string(b: Body, node: nodes.String) -> KnownValue:
    return literal(node.value)


def _given(b: Body, node: nodes.Given) -> KnownValue:
    return KnownValue(STRING if node.is_text else FLOAT)


def _cast(b: Body, node: nodes.Cast) -> KnownValue:
    b.convert(b.value(node.value), node.to, node)
    return KnownValue(node.to.name)


def _omitted(b: Body, node: nodes.Omitted) -> KnownValue:
    hint = "only a list of values for single axes may leave one out: SPEED(0, 1) = , 20"
    b.problem("values", "a value is missing here", node, hint)
    return NOTHING


def _wrong(b: Body, node: nodes.Wrong) -> KnownValue:
    return NOTHING  # the parser has reported it


def _name(b: Body, node: nodes.Name) -> KnownValue:
    symbol, result = node.symbol, b.function.result_named(node)
    if result is not None:
        return read_from(result.type)
    if symbol is None:
        return _keyword(b, node)
    if symbol.kind == "const" and node.args is None:
        assert symbol.const is not None
        return literal(symbol.const)
    if symbol.kind == "define" and node.args is None:
        return NOTHING if node.definition is None else b.value(node.definition)
    if symbol.kind == "sub":
        return call(b, node, symbol, wanted=True)
    if symbol.kind in ("variable", "parameter"):
        return _variable(b, node, symbol)
    b.problem("type", f"{symbol.name} is a {symbol.kind} and has no value", node)
    return NOTHING


def _keyword(b: Body, node: nodes.Name) -> KnownValue:
    if node.row is not None:
        return keywords.read(b, node, node.row)
    unknown_name(b, node)
    return NOTHING


def _variable(b: Body, node: nodes.Name, symbol: Symbol) -> KnownValue:
    if symbol.is_array and node.args is None:
        b.problem("index", f"{symbol.name} is an array and needs a subscript", node)
        return NOTHING
    return read_from(location(b, node))


def _member(b: Body, node: nodes.Member) -> KnownValue:
    return read_from(location(b, node))


VALUES: dict[type, Callable[..., KnownValue]] = {
    nodes.Number: _number,
    nodes.String: _string,
    nodes.Given: _given,
    nodes.Cast: _cast,
    nodes.Omitted: _omitted,
    nodes.Name: _name,
    nodes.Member: _member,
    nodes.Unary: operators.unary,
    nodes.Binary: operators.binary,
    nodes.Chain: operators.chain,
    nodes.Wrong: _wrong,
}
