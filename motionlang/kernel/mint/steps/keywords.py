"""Keywords as statements: values written to them, moves, paths, commands."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.steps import DO, NOW, TRY, Values
from motionlang.kernel.lang.variable_uses import Copy
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mint.check import unsimulated
from motionlang.kernel.mint.check.access import check_count, check_path, not_a_command, refuse
from motionlang.kernel.mint.keywords.no_effect import VERB as STORED
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, STRING, Type
from motionlang.kernel.mint.runtime import binding
from motionlang.kernel.mint.steps import expressions, terminal, waiting, words
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.steps.values import NOTHING, Value
from motionlang.kernel.mint.syntax import nodes

# The number in `Uses` of the memory that a host reads, for which no variable is so far from 0.
HOST_VARIABLE = 1 << 40


def write(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Write `KEYWORD(axes) = values`."""
    takes_values = row.access == "C" and row.function != STORED and not row.simulated
    if "W" not in row.access and not takes_values:
        refuse(w, target, row)
        for each in node.values:
            expressions.value(w, each)
        return
    if not row.simulated:
        unsimulated.warn(w, target, row, by=node)
    if row.simulated and row.function == "wait":
        if target.args or node.repeat:
            w.error("values", "WAIT = ms takes one time and no axis", target, "WAIT = 100 waits for 100 ms")
        waiting.wait(w, node, node.values, row)
    elif row.simulated and row.kind == "move" and row.index == "axes":
        _path(w, node, target, row)
    elif words.by_default(w, target, row):
        _write_to_defaults(w, node, target, row)
    else:
        _write_to_each(w, node, target, row)


def command(w: UnitWriter, node: nodes.Call, row: Keyword) -> None:
    """Write a keyword as a statement: `GO(0, 1)`, `WAIT(100)`."""
    target = node.target
    if row.simulated and row.function == "wait":
        waiting.wait(w, target, target.args or [], row)
        return
    if row.simulated and row.function == "line":
        terminal.line(w, node)
        return
    if row.access != "C" or (row.kind == "statement" and row.simulated):
        not_a_command(w, target, row)
        return
    if not row.simulated:
        unsimulated.warn(w, target, row, by=node)
        _unsimulated(w, target, row)
        return
    line: tuple[int, ...] = ()
    if row.index in ("axes", "axis") or row.group == "motion":
        line = (w.program.line(node.start),)
    has_calls = w.has_steps(target)
    where = words.indices(w, target, row)
    if w.checks:
        return
    if row.index == "axes":
        where = [words.together(where)]
    if has_calls:
        where = [_worked_out(w, each) for each in where]
    do = words.action(w, "do", row, where, [], line)
    w.add(NOW)
    w.add(DO, do, cost=1.0, name=row.name)


def _unsimulated(w: UnitWriter, target: nodes.Name, row: Keyword) -> None:
    gets, last = words.whatever(w, target, row, single=False)
    if w.checks:
        return
    do = words.action(w, "do", row, [], gets, last)
    w.add(NOW)
    w.add(DO, do, cost=1.0, name=row.name)


# ---------------------------------------------------------------------------------------------------- values


def _write_to_each(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    has_calls = w.has_steps(node)
    if has_calls:
        w.settle(node)
    where = words.indices(w, target, row) if row.simulated else words.anything(w, target, row)
    given = [None if isinstance(each, nodes.Omitted) else given_to(w, each, row) for each in node.values]
    if w.checks:
        check_count(w, node, row, len(where))
        return
    if not row.simulated:
        where = [Value(get, "anything") for get in words.joined(where, row)]
    if row.index in ("axis", "axes"):
        given += given[-1:] * (max(1, len(where)) - len(given)) if node.repeat else []
        pairs = [([axis], value) for axis, value in zip(where, given, strict=True) if value is not None]
    else:
        pairs = [(where, given[0])] if given[0] is not None else []
    if has_calls:
        pairs = [([_worked_out(w, each) for each in axes], _worked_out(w, one)) for axes, one in pairs]
    last = _last(w, node, target, row)
    if row.kind == "move" and row.simulated:
        pairs = [(axes, _worked_out(w, one)) for axes, one in pairs]
    w.add(NOW)
    for number, (axes, one) in enumerate(pairs, 1):
        cost = float(number == len(pairs))
        if row.kind == "move" and row.simulated:
            _load(w, row, axes, one, last, cost)
        else:
            _store(w, row, axes, one, last, cost)
    if not pairs:
        w.pay()


def _worked_out(w: UnitWriter, found: Value) -> Value:
    """Return a value that does not change while time passes, in a called sub or in a wait for space in a buffer."""
    return found if found.const is not None else expressions.stored(w, found)


def _last(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> tuple[int, ...]:
    if not row.simulated:
        return words.location(w, target, row)
    return (w.program.line(node.start),) if row.group == "motion" else ()


def given_to(w: UnitWriter, node: nodes.Expr, row: Keyword) -> Value:
    """Return a value that is written to a keyword, of its type; report one of another type or out of range."""
    found = expressions.value(w, node)
    if w.checks:
        _check_value(w, node, found, row)
        return NOTHING
    if row.unit == "text":
        return found
    kind = Type(FLOAT if row.takes_fractions else INTEGER)
    return Value(expressions.converted(w, found, kind), kind.name, found.const)


def _check_value(w: UnitWriter, node: nodes.Expr, found: Value, row: Keyword) -> None:
    if row.unit == "text":
        if found.type != STRING and found is not NOTHING:
            w.error("type", f"{row.word} takes a text, not a number", node)
    elif not found.is_number:
        w.error("type", f"{row.word} takes a number, not a text", node)
    elif found.const is not None and (refusal := row.refusal(float(found.const))) is not None:
        message, hint = refusal
        w.error("range", message, node, hint)


def _store(
    w: UnitWriter, row: Keyword, where: list[Value], given: Value, last: tuple[int, ...], cost: float
) -> None:
    get, sets = given.get, None
    if row.driven in words.HOST_MEMORY:
        sets = HOST_VARIABLE
        copy = Copy(w.steps, len(w.steps), sets)
        get = w.marking(lambda: copy, get)
    write = words.action(w, _how(row), row, where, [get], last)
    w.add(DO, write, cost=cost, sets=sets, name=row.name)


def _how(row: Keyword) -> str:
    return "write" if "W" in row.access else "do"


def _load(
    w: UnitWriter, row: Keyword, where: list[Value], given: Value, last: tuple[int, ...], cost: float
) -> None:
    environment, value, axes = w.program.environment, given.get, where[0].get
    load, gets = words.bound(w, "load", row, where)

    def loaded(values: Values) -> Wait | None:
        environment.acts += 1
        if not load(*[get(values) for get in gets], value(values), *last):
            return None
        full = axes(values)
        return environment.space_wait(full if isinstance(full, tuple) else (full,))

    w.add(TRY, loaded, cost=cost, name=row.name)


def _write_to_defaults(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Write `SPEED = 10, 20` after `AXES[0, 1]`; the number of axes is known only at run time."""
    environment = w.program.environment
    w.settle(node)
    given = [None if isinstance(each, nodes.Omitted) else given_to(w, each, row) for each in node.values]
    if w.checks:
        return
    gets = [None if each is None else each.get for each in given]
    last = _last(w, node, target, row)
    pairs = w.new_index()

    def pair(values: Values) -> None:
        found = tuple([None if get is None else get(values) for get in gets])
        values[pairs] = environment.pairs(found, node.repeat)

    w.add(NOW)
    w.add(DO, pair)
    if row.kind == "move" and row.simulated:
        load = binding.bind(environment, "load", row)

        def loaded(values: Values) -> Wait | None:
            while values[pairs]:
                axis, value = values[pairs][0]
                environment.acts += 1
                if value is not None and load(axis, value, *last):
                    return environment.space_wait((axis,))
                del values[pairs][0]
            return None

        w.add(TRY, loaded, cost=1.0, name=row.name)
        return
    axis_now = Value(lambda values: values[pairs][0][0], INTEGER)
    write = words.action(w, _how(row), row, [axis_now], [lambda values: values[pairs][0][1]], last)

    def write_all(values: Values) -> None:
        while values[pairs]:
            if values[pairs][0][1] is not None:
                write(values)
            del values[pairs][0]

    w.add(DO, write_all, cost=1.0, name=row.name)


def _path(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Write `VECTORA(0, 1) = 10, 20` and `CIRCLER(0, 1) = 10, 0, 90`: one move of several axes."""
    if w.has_steps(node):
        w.settle(node)
    given = [given_to(w, each, row) for each in node.values]
    where = words.indices(w, target, row)
    if w.checks:
        if not words.by_default(w, target, row):
            check_path(w, node, target, row, len(where))
        return
    axes = words.together(where)
    gets = [each.get for each in given]
    values_of = Value(lambda values: tuple([get(values) for get in gets]), "values")
    if any(each.const is None for each in given):
        values_of = expressions.stored(w, values_of)
    w.add(NOW)
    _load(w, row, [axes], values_of, (w.program.line(node.start),), 1.0)
