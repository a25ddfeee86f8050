"""Statements: assignments, Dim, calls, tasks, and the table of all kinds of statement."""

from __future__ import annotations

from collections.abc import Callable
from math import prod

from motionlang.kernel.lang.steps import DO, END, NOTE, NOW, STOP, TURN, Values
from motionlang.kernel.lang.variable_uses import Copy
from motionlang.kernel.mint.check.unknown_words import task_named, unknown_command, unknown_name
from motionlang.kernel.mint.resolve.symbols import INTEGER, RECORD, SEMAPHORE, Symbol, Type
from motionlang.kernel.mint.steps import blocks, calls, expressions, keywords, terminal, waiting
from motionlang.kernel.mint.steps.places import copied
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.steps.values import NOTHING, Get, article
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import is_stop, meant


def block(w: UnitWriter, body: list[nodes.Stmt]) -> None:
    """Write or check statements in sequence."""
    is_guarded = w.program.is_guarded and not handles_errors(w)
    for node in body:
        first = len(w.steps)
        w.at = node.start
        if is_stop(node):
            w.begins(node.start)
        _STATEMENTS[type(node)](w, node)
        if is_guarded and type(node) in _CAN_FAIL:
            w.steps.guard(first, len(w.steps))
        w.close_regions(node)


def handles_errors(w: UnitWriter) -> bool:
    """True within ONERROR itself, where a failing statement ends the program."""
    return w.function.name.lower() == "onerror" or w.label == "onerror"


# -------------------------------------------------------------------------------------------------- assignments


def _assign(w: UnitWriter, node: nodes.Assign) -> None:
    target = meant(node.target)
    if not isinstance(target, nodes.Name):
        target = node.target
        if not isinstance(target, nodes.Member):
            named = target.symbol.name  # type: ignore[union-attr]
            w.error("type", f"{named} is an expression and cannot be assigned to", node)
            return
    elif not w.is_result(target):
        symbol = target.symbol
        if symbol is None and target.row is not None:
            keywords.write(w, node, target, target.row)
            return
        if symbol is None:
            unknown_name(w, target)
            for each in node.values:
                expressions.value(w, each)
            return
        if symbol.kind not in ("variable", "parameter"):
            is_function = symbol.kind == "sub" and symbol.home.result is not None
            what = {"const": "constant"}.get(symbol.kind, "function" if is_function else symbol.kind)
            w.error("read-only", f"{symbol.name} is a {what} and cannot be assigned to", target)
            return
    noted = _begin_call(w, node)
    _give(w, node, target)
    _end_call(w, node, noted)


def _give(w: UnitWriter, node: nodes.Assign, target: nodes.Name | nodes.Member) -> None:
    where, which, kind = expressions.target(w, target)
    if len(node.values) != 1:
        w.error("values", f"a variable takes one value, {len(node.values)} given", node)
        return
    if node.repeat:
        w.error("values", "a ; after the value is only for keywords with axes", node)
        return
    (given,) = node.values
    if kind.name == SEMAPHORE:
        wanted = expressions.assigned(w, expressions.value(w, given), Type(INTEGER), given)
        waiting.take_or_give(w, lambda values: where(values)[which(values)], wanted)
        return
    w.settle(given, target)
    if kind.name == "Time":
        w.add(NOW)
    plain = expressions.plain_variable(w, target)
    found = (expressions.value if plain is None else expressions.linear)(w, given)
    if kind.name == RECORD:
        if found.type != str(kind) and found is not NOTHING:
            w.error("type", f"cannot assign {article(found.type)} to {article(str(kind))}", node)
        _copy(w, where, which, found.get)
        return
    get = expressions.assigned(w, found, kind, given)
    if w.checks:
        return
    sets = None
    if plain is not None:
        sets = w.program.places.number(plain)
        if found.solved is not None:
            copy = Copy(w.steps, len(w.steps), sets, expressions.is_word(given))
            get = w.marking(lambda: copy, get)
    is_copy = sets is not None and found.solved is not None
    w.add(DO, expressions.storing(w, target, where, which, get), cost=1.0, sets=sets, is_copy=is_copy)


def _copy(w: UnitWriter, where: Get, which: Get, get: Get) -> None:
    environment = w.program.environment

    def copy(values: Values) -> None:
        environment.acts += 1
        new = copied(get(values))
        where(values)[which(values)][:] = new

    w.add(DO, copy, cost=1.0)


def _dim(w: UnitWriter, node: nodes.Dim) -> None:
    for variable in node.variables:
        symbol = variable.symbol
        if symbol is None or symbol.kind != "variable" or not variable.values:
            continue
        count, given = prod(symbol.dimensions), len(variable.values)
        if given > count:
            has = f"has {count} elements, {given} values are" if symbol.is_array else f"is one value, {given}"
            w.error("values", f"{variable.name} {has} given", variable)
            continue
        if w.checks:
            for each in variable.values:
                expressions.assigned(w, expressions.value(w, each), symbol.type, each)
            continue
        w.settle(*variable.values)
        found = expressions.values(w, variable.values)
        gets = [expressions.converted(w, each, symbol.type) for each in found]
        if symbol.is_array:
            _fill(w, symbol, gets)
        else:
            target = nodes.Name(variable.start, variable.end, variable.name).resolve(symbol)
            where, which, _ = expressions.target(w, target)
            plain = expressions.plain_variable(w, target)
            sets = None if plain is None else w.program.places.number(plain)
            w.add(DO, expressions.storing(w, target, where, which, gets[0]), sets=sets)
    if node.nv and not w.checks:
        for variable in node.variables:
            if variable.symbol is not None and variable.symbol.kind == "variable":
                _restore(w, variable.symbol)


def _fill(w: UnitWriter, symbol: Symbol, gets: list[Get]) -> None:
    array, environment = expressions.whole(w, symbol), w.program.environment

    def fill(values: Values) -> None:
        environment.acts += 1
        array(values)[1 : len(gets) + 1] = [get(values) for get in gets]

    w.add(DO, fill)


def _restore(w: UnitWriter, symbol: Symbol) -> None:
    name = symbol.name.lower()
    if w.function.kind != "main":
        name = f"{w.function.name.lower()}.{name}"
    content, restore = expressions.whole(w, symbol), w.program.environment.machine.nonvolatile.restore
    w.add(DO, lambda values: restore(name, content(values)))


# ------------------------------------------------------------------------------------------------ calls and tasks


def _call(w: UnitWriter, node: nodes.Call) -> None:
    target = node.target
    symbol, row = target.symbol, target.row
    if symbol is None:
        if row is None:
            unknown_command(w, target)
        else:
            keywords.command(w, node, row)
        return
    if symbol.kind != "sub":
        hint = f"write {symbol.name} = value to give it one" if symbol.kind == "variable" else ""
        w.error("not-a-command", f"{symbol.name} is a {symbol.kind}, not a command", target, hint)
        return
    noted = _begin_call(w, node)
    w.settle(*(target.args or ()))
    calls.call(w, target, symbol, wanted=False)
    w.pay()
    _end_call(w, node, noted)


def _begin_call(w: UnitWriter, node: nodes.Assign | nodes.Call) -> int | None:
    """Note a statement that calls a sub like a loop, so that computing in the sub is charged to it.

    In a loop its iterations are enough.
    """
    w.callee = None
    if any(kind != "select" for kind, _ in w.around) or not w.has_steps(node):
        return None
    index, environment = w.new_index(), w.program.environment

    def begin(values: Values) -> None:
        values[index] = environment.statements.count, environment.statements.base

    w.add(NOTE, begin)
    return index


def _end_call(w: UnitWriter, node: nodes.Assign | nodes.Call, noted: int | None) -> None:
    callee = w.callee
    if noted is None or callee is None or callee is w.function:
        return
    environment, at, index = w.program.environment, node.start, noted

    def end(values: Values) -> None:
        count, base = values[index]
        environment.task.loop_log.called(count, base, callee.at, at)

    w.add(NOTE, end)


def _run(w: UnitWriter, node: nodes.Run) -> None:
    task = task_named(w, node, node.name)
    if task is None or w.checks:
        return
    environment, unit, name = w.program.environment, w.program.unit(task.home), task.name.lower()
    w.add(NOW)
    w.add(DO, lambda values: environment.start_task(name, unit), name="RUN")
    w.add(TURN, cost=1.0)


def _end(w: UnitWriter, node: nodes.End) -> None:
    environment = w.program.environment
    if node.name is not None:
        task = task_named(w, node, node.name)
        if task is None or w.checks:
            return
        name = task.name.lower()
        w.add(NOW)
        w.add(DO, lambda values: environment.end_task(name), cost=1.0, name="END")
        return
    if w.function.kind == "main" and w.program.is_guarded:
        w.add(NOW)
    w.add(END, lambda values: environment.end_program(), role=STOP, name="END")


def _nothing(w: UnitWriter, node: nodes.Stmt) -> None:
    """Write nothing: a declaration has no effect at run time, and the parser has reported a `Wrong`."""


Write = Callable[..., None]


def _with_block(write: Callable[..., None]) -> Write:
    return lambda w, node: write(w, node, block)


_STATEMENTS: dict[type, Write] = {
    nodes.Assign: _assign,
    nodes.Call: _call,
    nodes.Print: terminal.print_,
    nodes.Input: waiting.input_,
    nodes.Dim: _dim,
    nodes.Const: _nothing,
    nodes.Define: _nothing,
    nodes.If: _with_block(blocks.if_),
    nodes.Select: _with_block(blocks.select),
    nodes.For: _with_block(blocks.for_),
    nodes.While: _with_block(blocks.while_),
    nodes.Repeat: _with_block(blocks.repeat),
    nodes.Loop: _with_block(blocks.loop),
    nodes.Exit: blocks.exit_,
    nodes.Pause: waiting.pause,
    nodes.Run: _run,
    nodes.End: _end,
    nodes.Label: blocks.label,
    nodes.Jump: blocks.jump,
    nodes.Return: blocks.return_,
    nodes.Auto: _nothing,
    nodes.Wrong: _nothing,
}

# Statements whose failure ONERROR can handle. The statements inside a block are guarded separately.
_CAN_FAIL = frozenset(
    (nodes.Assign, nodes.Call, nodes.Print, nodes.Input, nodes.Dim, nodes.If, nodes.Select, nodes.For, nodes.While,
     nodes.Repeat, nodes.Pause, nodes.Run)
)  # fmt: skip
