"""All errors in a file that can be found without running it, and commands without effect, in one pass."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.machine.machine import DEFAULT_AXES
from motionlang.kernel.lang.typography import plain
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.keywords.row import takes_number
from motionlang.kernel.mccl.models import DEFAULT, MODELS, Model, missing, named, no_macro_number, written_for
from motionlang.kernel.mccl.resolve.command import REGISTER, Command
from motionlang.kernel.mccl.resolve.decode import fault_of
from motionlang.kernel.mccl.resolve.line import Line, locate
from motionlang.kernel.mccl.syntax.parser import mistake
from motionlang.kernel.source import Source

# Jumps within a line.
_JUMPS = frozenset({"jump", "jump_by"})
DEFINES = "define_macro"
# Verbs that need a defined macro.
CALLS = frozenset({"call_macro", "jump_macro", "start_task"})
_WORD = re.compile("[A-Za-z]+")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)")
# An axis behind its command, and a value.
_ASSIGNED = re.compile(rf"([A-Za-z]{{2}})(\d+)[ \t]*=[ \t]*({_NUMBER.pattern})")


def diagnostics_of(
    source: Source, lines: Sequence[Line | tuple[Fault, int, int]], settings: Mapping[str, object]
) -> Iterator[Diagnostic]:
    """Yield the errors of the lines of a file, and a warning for each other command without effect."""
    model, flow = model_of(source, settings), flow_of(settings)
    axes = axis_count(settings)
    macros = {line.commands[0].number for line in lines if isinstance(line, Line) and defines(line)}
    for line in lines:
        if not isinstance(line, Line):
            fault, at, _ = line
            yield diagnostic(source, at, fault)
            continue
        for k, command in enumerate(line.commands):
            wrong = _unknown_to(model, command) or fault_of(command) or _no_axis(command, axes)
            wrong = _apart(line, k, wrong, axes) or wrong or _wrong_here(line, k, command, model, flow)
            idle = _not_simulated(command) or _undefined(line, k, macros)
            if wrong is not None:
                yield diagnostic(source, line.offsets[k], wrong)
                if wrong.kind == "syntax" and not command.text[0].isdigit() and command.row is None:
                    break  # no command: the board drops the line here, and the rest may be a comment
            elif idle is not None:
                yield diagnostic(source, line.offsets[k], idle, "warning")


def model_of(source: Source, settings: Mapping[str, object]) -> Model:
    """Return the controller model of the settings, or that of the file's extension."""
    wanted = str(settings.get("controller.model", "")) or written_for(source.name)
    return named(wanted) or MODELS[DEFAULT]


def axis_count(settings: Mapping[str, object]) -> int:
    """Return the number of axes of the controller."""
    return settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[return-value]


def defines(line: Line) -> bool:
    """True if the line defines a macro."""
    row = line.commands[0].row
    return row is not None and row.function == DEFINES


def diagnostic(source: Source, at: int, fault: Fault, severity: str = "error") -> Diagnostic:
    """Return the diagnostic of a fault of the command at an offset."""
    line, column, length = locate(source, at)
    code = f" (?{fault.code}: {codes.MEANINGS[fault.code]})" if fault.code else ""
    fix, candidates = "", []
    if fault.candidates:
        text = source.line(line)[column - 1 : column - 1 + length]
        candidates = [_WORD.sub(each, text, count=1) for each in fault.candidates]
    if fault.kind == "syntax":
        text = source.line(line)[column - 1 :]
        end = mistake(text[:length])
        replaced, fix = plain(text[end:])
        if replaced:
            length, fix = end + replaced, text[:end] + fix
    return Diagnostic(
        fault.kind,
        fault.message + code,
        line,
        column,
        length=length,
        hint=fault.hint,
        severity=severity,
        fix=fix,
        candidates=candidates,
    )


def _unknown_to(model: Model, command: Command) -> Fault | None:
    row = command.row
    return missing(model, row) if row is not None and row.family in model.lacks else None


def _not_simulated(command: Command) -> Fault | None:
    if command.row is None or command.row.simulated:
        return None
    message = f"{command.name} is not simulated: the command has no effect"
    return Fault(0, message, command.row.help, "not-simulated")


def _undefined(line: Line, k: int, macros: set[int | None]) -> Fault | None:
    """Return the warning about a call of a macro that no line defines, or None.

    It is no error, because the controller may already have the macro. The number may stand apart, as in MC 1.
    """
    command, behind = line.commands[k], line.commands[k + 1 : k + 2]
    if command.function not in CALLS or command.number is None or command.number in macros:
        return None
    if any(each.text.isdigit() for each in behind):
        return None
    message = f"no line of this file defines macro {command.number}"
    hint = f"{table().doing(DEFINES)}{command.number},... defines it"
    return Fault(0, message, hint, "unknown-word")


def _apart(line: Line, k: int, wrong: Fault | None, axes: int) -> Fault | None:
    """Return the fault of a number apart from its command, with a hint of both in one piece; None for others."""
    text = line.commands[k].text
    assigned = _ASSIGNED.fullmatch(text)
    first = last = k
    while first and _NUMBER.fullmatch(line.commands[first - 1].text):
        first -= 1
    while last < len(line.commands) and _NUMBER.fullmatch(line.commands[last].text):
        last += 1
    owner = line.commands[k if assigned else first - 1]
    row = owner.row
    if wrong is None or row is None or row.unit == "text" or not (assigned or 0 < first < last):
        return None
    numbers = [each.text for each in line.commands[first:last]]
    if assigned:
        numbers = [assigned[2], assigned[3]]
    elif axis_behind(owner, owner.text[2:], axes):
        numbers.insert(0, owner.text[2:])
    is_axis = axis_behind(owner, numbers[0], axes) and (len(numbers) > 1 or not takes_number(row))
    if is_axis:
        hint = f"the axis goes before the command: {''.join([numbers[0], row.name, *numbers[1:2]])}"
    elif owner.is_bare and takes_number(row) and not assigned:
        hint = f"a number follows its command directly: {owner.text.upper()}{numbers[0]}"
    else:
        return None
    return Fault(wrong.code, wrong.message, hint, wrong.kind)


def axis_behind(command: Command, number: str, axes: int) -> bool:
    """True if a number behind a command without an axis is likely its axis."""
    row = command.row
    takes_axis = row is not None and row.index in ("axis", "axes") and not command.axis
    return takes_axis and number.isdecimal() and 1 <= int(number[:9]) <= axes


def _no_axis(command: Command, axes: int) -> Fault | None:
    if command.row is None or command.row.index not in ("axis", "axes") or command.axis <= axes:
        return None
    hint = f"the axes are 1 to {axes}; controller.axes sets their number"
    return Fault(codes.NOT_ASSIGNED, f"there is no axis {command.axis}", hint, "axis")


def _wrong_here(line: Line, k: int, command: Command, model: Model, flow: Flow) -> Fault | None:
    row = command.row
    assert row is not None
    if row.index == "axis" and command.axis == 0:
        return codes.needs_axis(command.name, command.text.lstrip("0"))
    if command.kind == REGISTER and int(command.value) >= model.registers:
        return codes.no_register(int(command.value), model.registers)
    number = command.number
    if row.function == "define_macro":
        if k:
            return codes.define_not_first()
        if number is not None and not 0 <= number <= model.macros:
            return no_macro_number(model, number)
    if row.function == "repeat" and number is not None and number < 0:
        return codes.negative_repeat(number)
    if row.function in _JUMPS and number is not None:
        return _jump(line, k, row.function, number, flow)
    return None


def _jump(line: Line, k: int, function: str, number: int, flow: Flow) -> Fault | None:
    first = 1 if defines(line) else 0
    last = len(line.commands) - first - 1
    target = flow.target(function, number, k - first)
    if 0 <= target <= last + 1:
        return None
    hint = f"they are numbered {flow.base} to {flow.base + last}"
    return Fault(codes.PARAMETER, f"there is no command {flow.base + target} here", hint, "range")


_PREFIX = "assumptions.mccl."


@dataclass(eq=False, slots=True)
class Flow:
    """The settled assumptions on flow.

    Commands count from `base`, JR from `after` commands behind itself. A condition governs `skipped` commands. RP
    without a number repeats for ever if `endless`.
    """

    base: int
    after: int
    skipped: int
    endless: bool

    def target(self, function: str, number: int, here: int) -> int:
        """Return the command, from 0, to which JP or JR jumps if it is command `here`."""
        return number - self.base if function == "jump" else here + number + self.after


def flow_of(settings: Mapping[str, object]) -> Flow:
    """Return the flow of a board with these settings."""
    return Flow(
        _number(settings, "jump-base", 0),
        int(settings.get(f"{_PREFIX}jump-relative") == "next"),
        _number(settings, "skipped", 2),
        settings.get(f"{_PREFIX}repeat-for-ever") != "once",
    )


def _number(settings: Mapping[str, object], name: str, usual: int) -> int:
    value = settings.get(_PREFIX + name, usual)
    return value if isinstance(value, int) else usual
