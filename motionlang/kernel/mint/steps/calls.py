"""Calls of subs and functions: arguments by value and by reference."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.steps import CALL, DO, Steps, Values, own
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.resolve.symbols import FLOAT, RECORD, Function, Symbol
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.steps.places import copied
from motionlang.kernel.mint.steps.values import NOTHING, Get, Value, typed
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import count_of

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def call(w: UnitWriter, node: nodes.Name, symbol: Symbol, wanted: bool) -> Value:
    """Write the call of a sub; return its result, which may be `wanted`."""
    callee, program = symbol.home, w.program
    if wanted and callee.result is None:
        w.error("type", f"{symbol.name} is a sub and has no value", node, "a Function has a value")
        return NOTHING
    args, count = node.args or [], len(callee.parameters)
    if len(args) != count:
        w.error("values", f"{symbol.name} takes {count_of(count, 'value')}, {len(args)} given", node)
        return NOTHING
    gets = _arguments(w, args, callee)
    if w.checks:
        return typed(str(symbol.type))
    places, steps = program.places, program.environment.steps_of(callee)
    indices = [places.index(each) for each in callee.parameters]

    def enter(values: Values) -> tuple[Steps, Values]:
        called = places.new_values(callee)
        for index, get in zip(indices, gets, strict=True):
            called[index] = get(values)
        return steps, called

    w.steps.called[w.add(CALL, enter, to=0)] = steps, 0
    w.callee = callee
    if callee.result is None:
        return Value(lambda values: 0, FLOAT)
    index, environment = w.new_index(), program.environment

    def take(values: Values) -> None:
        values[index] = environment.task.result

    w.add(DO, take, sets=own(index))
    kind = callee.result.type
    return expressions.kept(w, index, str(kind) if kind.name == RECORD else kind.name)


def _arguments(w: UnitWriter, args: list[nodes.Expr], callee: Function) -> list[Get]:
    found: list[Get] = []
    for number, (node, parameter) in enumerate(zip(args, callee.parameters, strict=True)):
        get = _argument(w, node, parameter)
        if any(w.has_steps(each) for each in args[number + 1 :]):
            get = expressions.stored(w, Value(get, "argument")).get
        found.append(get)
    return found


def _argument(w: UnitWriter, node: nodes.Expr, parameter: Symbol) -> Get:
    if parameter.is_array:
        return _array(w, node, parameter)
    if parameter.by_ref:
        return _reference(w, node, parameter)
    found = expressions.value(w, node)
    if parameter.type.name == RECORD:
        if found.type != str(parameter.type):
            w.error("type", f"{parameter.name} must be a {parameter.type}", node)
        get = found.get
        return lambda values: copied(get(values))
    return expressions.assigned(w, found, parameter.type, node)


def _array(w: UnitWriter, node: nodes.Expr, parameter: Symbol) -> Get:
    """Return the function for a whole array, which may be a member of a record."""
    get, found, given = None, None, ""
    if isinstance(node, nodes.Member) and node.args is None:
        (get, found), given = expressions.member(w, node), node.field
    elif isinstance(node, nodes.Name) and node.args is None:
        found, given = node.symbol, node.name
    wanted = len(parameter.dimensions)
    if found is None or len(found.dimensions) != wanted:
        many = "one subscript" if wanted == 1 else f"{wanted} subscripts"
        w.error("type", f"{parameter.name} must be given an array with {many}", node)
        return NOTHING.get
    kind = str(found.type)
    if w.checks:
        node.type = kind
    if kind != str(parameter.type):
        w.error("type", f"{parameter.name} is an array of {parameter.type}, {given} one of {kind}", node)
    return get or expressions.whole(w, found)


def _reference(w: UnitWriter, node: nodes.Expr, parameter: Symbol) -> Get:
    """Return the function for a ByRef argument: a variable, or an expression, whose value the sub may change."""
    symbol = node.symbol if type(node) is nodes.Name else None
    if type(node) is nodes.Member or (symbol is not None and symbol.kind in ("variable", "parameter")):
        where, which, kind = expressions.place(w, node)  # type: ignore[arg-type]
        if str(kind) != str(parameter.type):
            w.error("type", f"{parameter.name} is by reference and needs a variable of type {parameter.type}, "
                    f"not {kind}", node)  # fmt: skip
        return lambda values: (where(values), which(values))
    if type(node) is nodes.Name and symbol is None and node.row is None:
        unknown_name(w, node)
        return NOTHING.get
    # Any other expression is a temporary value, which the sub may change.
    get = expressions.assigned(w, expressions.value(w, node), parameter.type, node)
    return lambda values: ([get(values)], 0)
