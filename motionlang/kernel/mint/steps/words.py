"""Keywords of Mint bound to a machine: reads, writes, moves and commands as functions of the variables.

The row of a keyword gives its access, index and unit. `runtime/binding.py` makes the operation when the program starts,
so that a step only works out what the program computes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.steps import Values
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.check import unsimulated
from motionlang.kernel.mint.check.access import can_be_read, many
from motionlang.kernel.mint.check.unknown_words import task_named
from motionlang.kernel.mint.keywords.no_effect import VERB as STORED
from motionlang.kernel.mint.resolve.folding import constant
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING
from motionlang.kernel.mint.runtime import binding, functions
from motionlang.kernel.mint.runtime.task import PARENT
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.steps.values import (
    NOTHING,
    Get,
    Value,
    answer,
    article,
    as_float,
    as_integer,
    literal,
    type_of,
    typed,
)
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import named

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


# The sections of the machine file that write to the memory that a controller shares with its host.
HOST_MEMORY = frozenset(("comms", "netdata"))


# ------------------------------------------------------------------------------------------------------- reads


def read(w: UnitWriter, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of a keyword, a function or a constant."""
    if row.kind == "constant":
        if node.args is not None:
            w.error("values", f"{row.word} is a constant and takes no brackets", node)
        return literal(constant(row.function, row.unit))
    if row.kind == "function":
        return _function(w, node, row)
    if row.kind == "statement":
        w.error("type", f"{row.word} is a statement and has no value", node)
        return NOTHING
    if not can_be_read(w, node, row):
        return NOTHING
    environment = w.program.environment
    environment.reads_host_memory |= row.group == "comms"
    if not row.simulated:
        unsimulated.warn(w, node, row)
        gets, last = whatever(w, node, row)
        if w.checks:
            return typed(type_of(row))
        return Value(_with(row, binding.bind(environment, "read", row), gets, last), type_of(row))
    if row.every and node.args and len(node.args) > 1:
        each = [_reading(w, [index], row).get for index in indices(w, node, row)]
        return answer(lambda values: all(get(values) for get in each))
    if row.every and by_default(w, node, row):
        reads, default_axes = binding.ByNumber(_by_axis(w, "read", row)), environment.default_axes
        return answer(lambda values: all(reads[axis]() for axis in default_axes()))
    return _reading(w, indices(w, node, row, single=True), row)


def _reading(w: UnitWriter, where: list[Value], row: Keyword) -> Value:
    if w.checks:
        return typed(type_of(row))
    operation, gets = bound(w, "read", row, where)
    found = Value(_with(row, operation, gets), type_of(row))
    if row.solved:
        if not gets:
            found.solved = lambda values, level: operation(level)
        else:
            found.solved = lambda values, level: operation(*[get(values) for get in gets], level)
    return found


def _with(row: Keyword, operation: Callable[..., Any], gets: list[Get], last: tuple[int, ...] = ()) -> Get:
    """Return the function that calls the operation of a keyword with these arguments, and is called as the keyword."""
    if last or len(gets) > 1:
        return named(row.name, lambda values: operation(*[get(values) for get in gets], *last))
    if not gets:
        return named(row.name, lambda values: operation())
    (get,) = gets
    return named(row.name, lambda values: operation(get(values)))


def _function(w: UnitWriter, node: nodes.Name, row: Keyword) -> Value:
    """A function of the language; the unit "same" means that its result has the type of its arguments."""
    environment, args = w.program.environment, node.args or []
    kinds = row.index.split(", ") if row.index else []
    if not len(kinds) - row.optional <= len(args) <= len(kinds):
        message = f"{row.word} takes {many(len(kinds), 'value')}, {len(args)} given"
        w.error("values", message, node, f"{row.word}({row.index})")
        return NOTHING
    each_kind = iter(kinds)
    found = expressions.values(w, args, lambda w, arg: _argument(w, arg, next(each_kind), row))
    if row.function == "choice":
        return _choice(w, node, *found)
    if row.function == "random":
        return Value(lambda values: environment.random(), FLOAT)
    if row.unit == "same":
        kind = FLOAT if any(each.type == FLOAT for each in found) else INTEGER
    else:
        kind = type_of(row)
    if w.checks:
        return typed(kind)
    function = (
        functions.shown_by(environment.machine)
        if row.function == "shown"
        else getattr(functions, row.function)
    )
    made = Value(_with(row, function, [each.get for each in found]), kind)
    if row.function == "absolute" and found[0].solved is not None:
        solved = found[0].solved
        made.solved = lambda values, level: function(solved(values, (level, 0.0)))
    return made


def _argument(w: UnitWriter, node: nodes.Expr, kind: str, row: Keyword) -> Value:
    found = expressions.value(w, node)
    if kind == "bool":
        return expressions.as_number(w, found, node, "a condition")
    if kind == "text" and found.type != STRING and found is not NOTHING:
        w.error("type", f"{row.word} needs a text, not a number", node, "convert the number with Str")
    return found if kind in ("text", "any") else expressions.as_number(w, found, node)


def _choice(w: UnitWriter, node: nodes.Name, test: Value, yes: Value, no: Value) -> Value:
    """IIf: only the chosen value is worked out."""
    if yes is NOTHING or no is NOTHING:
        return NOTHING
    if (yes.type == STRING) is not (no.type == STRING):
        w.error("type", "the two values of IIf must both be numbers or both be texts", node)
        return NOTHING
    holds, first, second = test.holds, yes.get, no.get
    kind = yes.type if yes.type == no.type else FLOAT
    return Value(lambda values: first(values) if holds(values) else second(values), kind)


# ----------------------------------------------------------------------------------------------------- indices


def indices(w: UnitWriter, node: nodes.Name, row: Keyword, single: bool = False) -> list[Value]:
    """Return the values in the brackets of a keyword; without brackets they are 0, or come from AXES or BANK."""
    if by_default(w, node, row):
        default_axes = w.program.environment.default_axes
        if row.index == "axes" and not single:
            return [Value(lambda values: default_axes(), "axes")]
        return [Value(lambda values: default_axes()[0], INTEGER)]
    args = node.args or []
    if row.index == "none":
        if args:
            w.error("values", f"{row.word} takes no brackets", node)
        return []
    kinds = row.index.split(", ")
    missing = len(kinds) - len(args)
    if kinds[-1] == "array":
        if not 0 <= missing < kinds.count("array"):
            message = f"{row.word} takes {row.index} in brackets, {len(args)} given"
            w.error("values", message, node, row.example.split("\n")[0])
            return [NOTHING] * len(kinds)
        found = [_index(w, *each, row) for each in zip(args, kinds, strict=False)]
        return found + [Value(lambda values: None, "array")] * missing
    if not args:
        if len(kinds) > 1 or row.index == "task":
            needed = row.index if len(kinds) > 1 else article(row.index)
            w.error("values", f"{row.word} needs {needed} in brackets", node)
        bank = w.program.names.default_bank
        if row.index == "bank" and row.group == "io" and bank is not None:
            return [Value(as_integer(_reading(w, [], bank)), INTEGER)]
        return [literal(0)] * len(kinds)
    if missing and (missing > 0 or single or kinds[-1] not in ("axis", "axes")):
        wanted = many(1, kinds[0]) if len(kinds) == 1 else f"{many(len(kinds), 'value')} ({row.index})"
        w.error("values", f"{row.word} takes {wanted} in brackets, {len(args)} given", node)
        return [NOTHING] * len(kinds)
    return [_index(w, *each, row) for each in zip(args, kinds + kinds[-1:] * -missing, strict=True)]


def by_default(w: UnitWriter, node: nodes.Name, row: Keyword) -> bool:
    """True if a keyword without brackets means the axes of AXES."""
    return node.args is None and row.index in ("axis", "axes") and w.program.names.uses_axes


def _index(w: UnitWriter, node: nodes.Expr, kind: str, row: Keyword) -> Value:
    if kind == "task":
        return _task(w, node)
    if kind == "array":
        return _array(w, node, row)
    found = expressions.value(w, node)
    if w.checks:
        return _checked_index(w, found, node, kind)
    if kind == "distance":
        return Value(as_float(found), FLOAT)
    known = found.const
    return Value(as_integer(found), INTEGER, int(known) if isinstance(known, (int, float)) else None)


def _checked_index(w: UnitWriter, found: Value, node: nodes.Expr, kind: str) -> Value:
    """Return an index; report one that is no number, no whole one, or that of no axis."""
    what = (
        "a distance" if kind == "distance" else f"the number of {article('axis' if kind == 'axes' else kind)}"
    )
    known = expressions.as_number(w, found, node, what).const
    if kind == "distance" or not isinstance(known, (int, float)):
        return typed(FLOAT)
    if known != int(known):
        w.error("range", f"{known} is not {what}", node)
    elif kind in ("axis", "axes") and known not in w.program.axes:
        hint = f"this controller has axes 0 to {w.program.axes[-1]}; controller.axes sets their number"
        w.error("axis", f"there is no axis {known}", node, hint)
    return typed(INTEGER)


def _task(w: UnitWriter, node: nodes.Expr) -> Value:
    """Return the name of a task, which is no expression: its node has the symbol, none for the parent task."""
    word = node.name if type(node) is nodes.Name else Word("")
    if type(node) is not nodes.Name or node.args is not None:
        node = nodes.Name(node.start, node.end, word).resolve(None)
    elif node.symbol is None and word.lower() == PARENT.lower():
        return literal(PARENT)
    task = task_named(w, node, word)
    return NOTHING if task is None else literal(task.name.lower())


def _array(w: UnitWriter, node: nodes.Expr, row: Keyword) -> Value:
    """Return an array as a whole, or None for NULL and 0."""
    symbol = node.symbol if type(node) is nodes.Name and node.args is None else None
    is_null = symbol is None and type(node) is nodes.Name and node.name.lower() == "null"
    if is_null or (type(node) is nodes.Number and node.value == 0):
        return Value(lambda values: None, "array")
    if symbol is None or len(symbol.dimensions) != 1 or symbol.type.name not in NUMERIC:
        message = f"{row.word} needs an array of numbers with one subscript here"
        w.error("type", message, node, "NULL stands for a table that is not given")
        return NOTHING
    if w.checks:
        node.type = str(symbol.type)
    return Value(expressions.whole(w, symbol), "array")


def whatever(
    w: UnitWriter, node: nodes.Name, row: Keyword, single: bool = True
) -> tuple[list[Get], tuple[int, ...]]:
    """Return the values in the brackets of a keyword that is not simulated, and its last arguments."""
    found = anything(w, node, row, single)
    return joined(found, row, single), location(w, node, row)


def anything(w: UnitWriter, node: nodes.Name, row: Keyword, single: bool = False) -> list[Value]:
    """Return the values in the brackets of a keyword that is not simulated, whose number is not known for certain."""
    if row.function == STORED or row.index in ("axis", "axes"):
        return indices(w, node, row, single)
    return [literal(0) if _is_whole(each) else expressions.value(w, each) for each in node.args or ()]


def _is_whole(node: nodes.Expr) -> bool:
    """True if a name refers to a whole array or is NULL."""
    if not isinstance(node, nodes.Name) or node.args is not None:
        return False
    return node.name.lower() == "null" if node.symbol is None else node.symbol.is_array


def joined(found: list[Value], row: Keyword, single: bool = False) -> list[Get]:
    """Return the functions for these values, one for all axes if the keyword takes them together."""
    return [each.get for each in ([together(found)] if row.index == "axes" and not single else found)]


def location(w: UnitWriter, node: nodes.Node, row: Keyword) -> tuple[int, ...]:
    """Return the last arguments of the operations of a keyword that is not simulated: line and source offset."""
    line = w.program.line(node.start)
    if row.function == STORED:
        return (line,)
    # A typed sub may run when another line is executed.
    return line, -1 if w.program.names.typed else node.start


# ----------------------------------------------------------------------------------------------------- binding


def bound(w: UnitWriter, how: str, row: Keyword, where: list[Value]) -> tuple[Callable[..., Any], list[Get]]:
    """Return an operation, and the functions of the indices that it still needs."""
    environment, gets = w.program.environment, [each.get for each in where]
    if row.index in ("axis", "axes") and row.simulated and len(where) == 1:
        if where[0].const is not None:
            return _by_axis(w, how, row)(int(where[0].const)), []
        if how in ("read", "write", "replaced"):
            each = binding.ByNumber(_by_axis(w, how, row))
            return lambda axis, *more: each[axis](*more), gets
    return binding.bind(environment, how, row), gets


def _by_axis(w: UnitWriter, how: str, row: Keyword) -> Callable[[int], Callable[..., Any]]:
    """Return the function that makes the operation of a keyword on an axis."""
    environment = w.program.environment
    if how == "replaced":
        return binding.replaced_by_axis(environment, row)
    return binding.bind_to_axis(environment, how, row)


def action(
    w: UnitWriter, how: str, row: Keyword, where: list[Value], given: list[Get], last: tuple[int, ...]
) -> Get:
    """Return the function of a step that changes the machine, and counts as an action.

    The operation receives the indices, the values that it is `given`, and what is known before the run. A loop may
    repeat a write that changes nothing; see `changes.py`.
    """
    environment, clock = w.program.environment, w.program.environment.clock
    operation, indices = bound(w, how, row, where)
    gets = [*indices, *given]

    if not binding.is_repeatable(how, row):

        def acted(values: Values) -> None:
            environment.acts += 1
            operation(*[get(values) for get in gets], *last)

        return acted
    if binding.is_reported(how, row):
        listeners = environment.controller.outputs.listeners

        def switched(values: Values) -> None:
            if operation(*[get(values) for get in gets], *last):
                environment.switched += 1
                environment.acts += bool(listeners)

        return switched
    before = _replaced(w, row, where)
    dependencies = environment.dependencies

    def changed(values: Values) -> bool:
        arguments = [get(values) for get in gets]
        if dependencies.notes is None:  # no loop asks
            operation(*arguments, *last)
            return True
        made, old = clock.made, before(*arguments, *last)
        operation(*arguments, *last)
        return bool(clock.made != made or before(*arguments, *last) != old)

    if row.driven in HOST_MEMORY:

        def copied(values: Values) -> None:
            has_changed = changed(values)
            environment.copies += has_changed
            environment.acts += has_changed and environment.reads_host_memory

        return copied

    def acts(values: Values) -> None:
        environment.acts += changed(values)

    return acts


def _replaced(w: UnitWriter, row: Keyword, where: list[Value]) -> Callable[..., Any]:
    """Return the function of the arguments of a write that reads what it replaces."""
    if row.simulated and (row.index == "axis" or (row.index == "axes" and where and where[0].type != "axes")):
        return bound(w, "replaced", row, where)[0]
    return binding.replaced(w.program.environment, row)


def together(axes: list[Value]) -> Value:
    """Return several axes as one argument."""
    if len(axes) == 1 and axes[0].type == "axes":
        return axes[0]
    gets = [each.get for each in axes]
    if all(each.const is not None for each in axes):
        known = tuple([int(each.const) for each in axes])  # type: ignore[arg-type]
        return Value(lambda values: known, "axes")
    return Value(lambda values: tuple([get(values) for get in gets]), "axes")
