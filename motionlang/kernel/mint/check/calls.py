"""Check calls of subs and functions: arguments by value and by reference."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.check.values import NOTHING, Value, typed
from motionlang.kernel.mint.check.variables import array, location
from motionlang.kernel.mint.resolve.symbols import RECORD, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import count_of


def call(b: Body, node: nodes.Name, symbol: Symbol, wanted: bool) -> Value:
    """Check the call of a sub, whose value may be `wanted`."""
    callee = symbol.home
    if wanted and callee.result is None:
        b.problem("type", f"{symbol.name} is a sub and has no value", node, "a Function has a value")
        return NOTHING
    args = node.args or []
    count = len(callee.parameters)
    if len(args) != count:
        b.problem("values", f"{symbol.name} takes {count_of(count, 'value')}, {len(args)} given", node)
        return NOTHING
    for arg, parameter in zip(args, callee.parameters, strict=True):
        _argument(b, arg, parameter)
    return typed(str(symbol.type))


def _argument(b: Body, node: nodes.Expr, parameter: Symbol) -> None:
    if parameter.is_array:
        _array(b, node, parameter)
    elif parameter.by_ref:
        _reference(b, node, parameter)
    elif parameter.type.name == RECORD:
        if b.value(node).type != str(parameter.type):
            b.problem("type", f"{parameter.name} must be a {parameter.type}", node)
    else:
        b.convert(b.value(node), parameter.type, node)


def _array(b: Body, node: nodes.Expr, parameter: Symbol) -> None:
    wanted = len(parameter.dimensions)
    found = array(b, node)
    if found is None or len(found.dimensions) != wanted:
        many = "one subscript" if wanted == 1 else f"{wanted} subscripts"
        b.problem("type", f"{parameter.name} must be given an array with {many}", node)
        return
    kind = node.type = str(found.type)
    if kind != str(parameter.type):
        given = node.field if type(node) is nodes.Member else getattr(node, "name", "")
        b.problem("type", f"{parameter.name} is an array of {parameter.type}, {given} one of {kind}", node)


def _reference(b: Body, node: nodes.Expr, parameter: Symbol) -> None:
    """Check a ByRef argument: a variable, or an expression, whose value the sub may change."""
    symbol = node.symbol if type(node) is nodes.Name else None
    if type(node) is nodes.Member or (symbol is not None and symbol.kind in ("variable", "parameter")):
        kind = location(b, node)  # type: ignore[arg-type]
        if str(kind) != str(parameter.type):
            b.problem("type", f"{parameter.name} is by reference and needs a variable of type {parameter.type}, "
                      f"not {kind}", node)  # fmt: skip
    elif type(node) is nodes.Name and symbol is None and node.row is None:
        unknown_name(b, node)
    else:
        b.convert(b.value(node), parameter.type, node)
