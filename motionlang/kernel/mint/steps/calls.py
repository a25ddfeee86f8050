"""Calls of subs and functions: arguments by value and by reference."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.steps import CALL, DO, Steps, Values, own
from motionlang.kernel.mint.check.values import Get, Value
from motionlang.kernel.mint.resolve.symbols import FLOAT, RECORD, Function, Symbol
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.steps.places import copied
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def call(w: UnitWriter, node: nodes.Name, symbol: Symbol) -> Value:
    """Write the call of a sub; return its result."""
    callee, program = symbol.home, w.program
    args = node.args or []
    gets = _arguments(w, args, callee)
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
        return array(w, node)
    if parameter.by_ref:
        return _reference(w, node, parameter)
    found = expressions.value(w, node)
    if parameter.type.name == RECORD:
        get = found.get
        return lambda values: copied(get(values))
    return expressions.converted(w, found, parameter.type)


def array(w: UnitWriter, node: nodes.Expr) -> Get:
    """Return the function for a whole array, which may be a member of a record."""
    if isinstance(node, nodes.Member):
        return expressions.member(w, node)
    return expressions.whole(w, w.symbol(node))


def _reference(w: UnitWriter, node: nodes.Expr, parameter: Symbol) -> Get:
    is_variable = isinstance(node, nodes.Member) or (
        isinstance(node, nodes.Name)
        and node.symbol is not None
        and node.symbol.kind in ("variable", "parameter")
    )
    if is_variable:
        where, which, _ = expressions.place(w, node)  # type: ignore[arg-type]
        return lambda values: (where(values), which(values))
    # Any other expression is a temporary value, which the sub may change.
    get = expressions.converted(w, expressions.value(w, node), parameter.type)
    return lambda values: ([get(values)], 0)
