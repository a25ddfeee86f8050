"""The structure of an MCCL file: its commands from the lines, its graph from their steps."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.steps import BACK, BRANCH, CALL, END, ENTER, GO, Steps
from motionlang.kernel.lang.structure import (
    ACTS,
    LEADS,
    READ,
    SET_UP,
    WRITE,
    ChannelUse,
    Statement,
    Structure,
    Unit,
    Use,
    Written,
    role_of,
)
from motionlang.kernel.mccl.models import written_for
from motionlang.kernel.mccl.resolve.command import NUMBER, REGISTER, Command
from motionlang.kernel.mccl.resolve.line import Line
from motionlang.kernel.mccl.runtime.board import Board
from motionlang.kernel.mccl.runtime.register_uses import variable
from motionlang.kernel.mccl.runtime.writer import LineSteps, LineWriter
from motionlang.kernel.source import Source

# What the accumulator has: a register, or that and a number more or less.
_REGISTER, _SUM = re.compile(r"register \d+"), re.compile(r"register \d+ [+-] .+")
# Commands that the graph shows, or that do nothing.
_SILENT = frozenset(("define_macro", "jump", "jump_by", "repeat", "leave", "nothing"))


def structure(
    source: Source,
    lines: Sequence[Line],
    settings: Mapping[str, object],
) -> Structure:
    """Return the structure of a file on a board with these settings; invalid commands do nothing."""
    machine = Machine(dict(settings), first_axis=1)
    machine.model = machine.model or written_for(source.name)
    board = Board(machine)
    foreground, macros = list[LineSteps](), dict[int, list[LineSteps]]()
    for line in lines:
        foreground.append(LineWriter(line, board).steps)
        first = line.commands[0]
        if first.function == "define_macro" and first.number is not None and len(line.commands) > 1:
            body = LineWriter(line.rest(1), board).steps
            macros.setdefault(first.number, []).append(body)
    branching = {step.at for steps in foreground for step in steps if step.kind in (BRANCH, BACK)}
    statements = {
        at: _statement(line, command, at, at in branching)
        for line in lines
        for command, at in zip(line.commands, line.offsets, strict=True)
    }
    bodies = [(number, body) for number, found in sorted(macros.items()) for body in found]
    lists = [*foreground, *(body for _, body in bodies)]
    for steps in lists:
        _link(steps, macros)
    choices = _choices(lists, macros)
    end = Steps()
    end.name = "end"
    end.add(END)
    in_sequence = [*foreground, end]
    graph = StepGraph(
        [*in_sequence, *(body for _, body in bodies), *choices.values()], in_sequence, _computed, enters=True
    )
    units = [Unit("program", "program", 0, 0)]
    for number, body in bodies:
        again = f" of line {body.line.number}" if body is not macros[number][-1] else ""
        units.append(Unit(f"{number}{again}", "macro", body.line.number, graph.first(body)))
    # A jump by a register has a unit of its own, so that its callers and the macros behind it are not multiplied.
    units += (Unit(name, "macro", each.line_number, graph.first(each)) for name, each in choices.items())
    found: dict[int, set[str]] = {}
    for steps in lists:
        for pc, what in _held(steps):
            found.setdefault(steps[pc].at, set()).add(what)
    held = {at: min(what) for at, what in found.items() if len(what) == 1}
    writes = {
        at + len(command.text) - len(str(command.number)): held.get(at, "")
        for line in lines
        for command, at in zip(line.commands, line.offsets, strict=True)
        if command.function == "store"
    }
    for at, each in statements.items():
        if held.get(at, "")[:1].isalpha():
            each.condition = each.condition.replace("accumulator", held[at])
    used = frozenset[int]().union(*(use.reads | use.sets for use in graph.uses if use is not None))
    registers = {n: f"register {n if n >= 0 else -1 - n}" for n in sorted(used)}
    return Structure(source, statements, graph, units, writes, registers)


def _link(steps: LineSteps, macros: Mapping[int, list[LineSteps]]) -> None:
    """Record the macros that the calls of a line enter: the last definition above the line, else the last one."""
    for pc, step in enumerate(steps):
        command = steps.command(pc)
        found = macros.get(command.number) if command is not None and command.number is not None else None
        if step.kind in (CALL, ENTER) and found:
            above = [body for body in found if body.line.number < steps.line.number]
            steps.called[pc] = (above or found)[-1], 0


def _held(steps: LineSteps) -> Iterator[tuple[int, str]]:
    """Yield the first step of each command of a line with what the accumulator has there, "" if that is unknown.

    It is a number, a channel, a register, or a register and a number more or less, the same in all ways to the step.
    """
    ways: dict[int, set[str]] = {0: {""}}
    for pc, step in enumerate(steps):
        is_computed = step.kind == GO and step.to < 0
        for to in steps.starts if is_computed else steps.following(pc):
            if to <= pc or is_computed:
                ways.setdefault(to, set()).add("")
    last = -1
    for pc, step in enumerate(steps):
        came = ways.get(pc)
        if came is None:  # behind a jump, or in a macro that is only defined here
            continue
        held = min(came) if len(came) == 1 else ""
        command = steps.command(pc)
        if step.at != last and command is not None and command.row is not None:
            yield pc, held
            last, held = step.at, _held_behind(command, held)
        for to in steps.following(pc):
            ways.setdefault(to, set()).add("" if step.kind == CALL else held)


def _held_behind(command: Command, held: str) -> str:
    """Return what the accumulator has behind a command, by what it has before."""
    number = _parameter(command) if command.kind == NUMBER else ""
    match getattr(command.action, "accumulator", ""):
        case "stores":
            return f"register {number}" if not held or _SUM.fullmatch(held) else held
        case "recalls":
            return f"register {number}"
        case "sets" if command.function == "load":
            return number
        case "sets":
            return f"{command.row.channel} {number}" if command.row and command.row.channel and number else ""
        case "adds":
            sign = "+" if command.function == "add" else "-"
            return f"{held} {sign} {number}" if _REGISTER.fullmatch(held) and number else ""
        case "computes" | "reads":
            return ""
    return held


def _choices(lists: Sequence[LineSteps], macros: Mapping[int, list[LineSteps]]) -> dict[str, Steps]:
    """Link the calls by registers that get only constants, as in AL200,AR40: to steps that enter one of these macros.

    The steps of each such register are returned by its name. What any other register calls stays unknown.
    """
    calls: dict[int, list[tuple[LineSteps, int]]] = {}
    given: dict[int, set[int | None]] = {}
    for steps in lists:
        for pc, what in _held(steps):
            command = steps.command(pc)
            if command is not None and command.function == "store" and command.number is not None:
                number = int(what) if what.isdecimal() else None
                given.setdefault(variable(command.number), set()).add(number)
        for pc, step in enumerate(steps):
            command = steps.command(pc)
            if step.kind in (CALL, ENTER) and command is not None and command.kind == REGISTER:
                calls.setdefault(int(command.value), []).append((steps, pc))
    found: dict[str, Steps] = {}
    for register, places in calls.items():
        numbers = given.get(register, {None})
        if None in numbers:
            continue
        choice = found[f"@{register}"] = Steps()
        choice.name, choice.line_number = f"@{register}", places[0][0].line.number
        for number in sorted(macros.keys() & numbers):
            choice.add(BRANCH, to=len(choice) + 2)
            choice.called[choice.add(ENTER)] = macros[number][-1], 0
        choice.add(END)
        for steps, pc in places:
            steps.called[pc] = choice, 0
    return found


def _computed(steps: Steps, pc: int) -> Iterable[int]:
    """Return the steps to which a computed jump may lead: the commands of its line."""
    return steps.starts if isinstance(steps, LineSteps) else ()


def _statement(line: Line, command: Command, at: int, branches: bool) -> Statement:
    made = Statement(at, line.number, command.text)
    made.form = f"{command.axis}{command.name} {_parameter(command) or command.value!r}"
    row = command.row
    if row is None:
        return made
    made.is_silent = row.function in _SILENT
    made.effect = LEADS if made.is_silent and row.function != "repeat" else ACTS
    does_wait = row.waits != "time" or command.number != 0
    made.waits = row.waits if does_wait else ""
    made.what = (command.axis,) if row.waits == "axis" and command.axis else ()
    if row.function == "start_task":
        made.starts.append(f"macro {_parameter(command)}")
    if row.function == "end_task":
        made.ends.append(f"task {_parameter(command)}")
    if row.tests:
        made.condition = row.tests.format(_parameter(command))
    elif branches and not row.waits:
        made.condition = command.text
    if row.channel:
        number = _parameter(command)
        made.channels.append(ChannelUse(row.channel, number, _access(row), at, value=row.output, name_at=at))
    if row.selects:
        made.channels.append(
            ChannelUse(row.selects, str(command.axis or "?"), SET_UP, at, value=command.text, name_at=at)
        )
    made.uses.append(use_of(command, row, at))
    return made


def use_of(command: Command, row: Keyword, at: int) -> Use:
    access = READ if row.access == "R" else WRITE
    value = float(command.value) if command.kind == NUMBER else None
    written = [Written(_parameter(command), value)] if command.kind in (NUMBER, REGISTER) else []
    return Use(role_of(row, access), row, at, (command.axis or None,), written, numbers=(command.number,))


def _access(row: Keyword) -> str:
    """Return what a command does to the channel of its parameter."""
    if row.channel == "digital":
        return SET_UP
    return WRITE if row.channel.endswith("output") else READ


def _parameter(command: Command) -> str:
    if command.kind == REGISTER:
        return f"@{int(command.value)}"
    return "" if command.kind != NUMBER else f"{command.value:.10g}"
