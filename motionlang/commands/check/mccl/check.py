"""All errors in a file that can be found without running it, in one pass."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from motionlang.commands.check.mccl.channels import check_channels
from motionlang.commands.check.mccl.checks import CALLS, lint
from motionlang.commands.check.mccl.flow import Flow, flow_of
from motionlang.commands.check.mccl.numbers import check_numbers
from motionlang.commands.check.silence import silence
from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.machine.machine import DEFAULT_AXES
from motionlang.kernel.lang.typography import plain
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.models import DEFAULT, MODELS, Model, missing, named, no_macro_number, written_for
from motionlang.kernel.mccl.resolve.command import Command
from motionlang.kernel.mccl.resolve.decode import problem
from motionlang.kernel.mccl.resolve.line import Line, lines_of
from motionlang.kernel.mccl.runtime.program import locate
from motionlang.kernel.mccl.syntax.comments import COMMENT
from motionlang.kernel.mccl.syntax.parser import mistake
from motionlang.kernel.source import Source

# Jumps within a line.
_JUMPS = frozenset({"jump", "jump_by"})
_DEFINES = "define_macro"
_WORD = re.compile("[A-Za-z]+")


def check(source: Source, settings: Mapping[str, object] | None = None) -> list[Diagnostic]:
    """Return the diagnostics of a file in text order.

    A file without errors also gets the warnings of the linter.
    """

    wanted = str((settings or {}).get("controller.model", "")) or written_for(source.name)
    model = named(wanted) or MODELS[DEFAULT]
    lines = list(lines_of(source))
    whole = [each for each in lines if isinstance(each, Line)]
    axes = (settings or {}).get("controller.axes", DEFAULT_AXES)
    flow = flow_of(settings or {})
    found: list[Diagnostic] = []
    for each in lines:
        if isinstance(each, Line):
            found.extend(_line(source, each, model, axes, flow))  # type: ignore[arg-type]
        else:
            fault, at, _ = each
            found.append(_diagnostic(source, at, fault))
    found.extend(_macros(source, whole))
    if not any(each.severity == "error" for each in found):
        found.extend(_lint(source, whole, settings or {}, model))
    return sorted(silence(source, found, COMMENT), key=lambda d: (d.line, d.column))


def _lint(
    source: Source, lines: list[Line], settings: Mapping[str, object], model: Model
) -> list[Diagnostic]:
    found: list[Diagnostic] = []

    def add(at: int, fault: Fault) -> None:
        found.append(_diagnostic(source, at, fault, "warning"))

    lint(lines, flow_of(settings), add)
    check_channels(lines, settings, model, add)
    check_numbers(lines, model, add)
    return found


def _line(source: Source, line: Line, model: Model, axes: int, flow: Flow) -> Iterator[Diagnostic]:
    for k, command in enumerate(line.commands):
        fault = _unknown_to(model, command) or problem(command) or _no_axis(command, axes)
        fault = fault or _wrong_here(line, k, command, model, flow)
        if fault is not None:
            yield _diagnostic(source, line.offsets[k], fault)
        elif command.row is not None and not command.row.simulated:
            message = f"{command.name} is not simulated: the command has no effect"
            fault = Fault(0, message, command.row.help, "not-simulated")
            yield _diagnostic(source, line.offsets[k], fault, "warning")


def _unknown_to(model: Model, command: Command) -> Fault | None:
    """Return the fault of a command that this board does not have, or None."""
    row = command.row
    return missing(model, row) if row is not None and row.family in model.lacks else None


def _no_axis(command: Command, axes: int) -> Fault | None:
    """Return the fault of an axis that this board does not have, or None."""
    if command.row is None or command.row.index not in ("axis", "axes") or command.axis <= axes:
        return None
    hint = f"the axes are 1 to {axes}; controller.axes sets their number"
    return Fault(codes.NOT_ASSIGNED, f"there is no axis {command.axis}", hint, "axis")


def _wrong_here(line: Line, k: int, command: Command, model: Model, flow: Flow) -> Fault | None:
    """Return the fault of a command at its position in the line, or None."""
    row = command.row
    assert row is not None
    if row.index == "axis" and command.axis == 0:
        return codes.needs_axis(command.name, command.text.lstrip("0"))
    number = command.number
    if row.verb == "define_macro":
        if k:
            return codes.define_not_first()
        if number is not None and number > model.macros:
            return no_macro_number(model, number)
    if row.verb == "repeat" and number is not None and number < 0:
        return codes.negative_repeat(number)
    if row.verb in _JUMPS and number is not None:
        return _jump(line, k, row.verb, number, flow)
    return None


def _defines(line: Line) -> bool:
    """True if the line defines a macro."""
    row = line.commands[0].row
    return row is not None and row.verb == _DEFINES


def _jump(line: Line, k: int, verb: str, number: int, flow: Flow) -> Fault | None:
    first = 1 if _defines(line) else 0
    last = len(line.commands) - first - 1
    target = flow.target(verb, number, k - first)
    if 0 <= target <= last + 1:
        return None
    hint = f"they are numbered {flow.base} to {flow.base + last}"
    return Fault(codes.PARAMETER, f"there is no command {flow.base + target} here", hint, "range")


def _macros(source: Source, lines: list[Line]) -> Iterator[Diagnostic]:
    """Yield warnings about calls of macros that no line of the file defines.

    These are not errors, because the controller may already have the macros.
    """
    defined = {line.commands[0].number for line in lines if _defines(line)}
    for line in lines:
        for k, command in enumerate(line.commands):
            if command.row is None or command.row.verb not in CALLS or problem(command):
                continue
            number = command.number
            if number is not None and number not in defined:
                message = f"no line of this file defines macro {number}"
                yield _diagnostic(
                    source,
                    line.offsets[k],
                    Fault(0, message, f"{table().doing(_DEFINES)}{number},... defines it", "unknown-word"),
                    "warning",
                )


def _diagnostic(source: Source, at: int, fault: Fault, severity: str = "error") -> Diagnostic:
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
