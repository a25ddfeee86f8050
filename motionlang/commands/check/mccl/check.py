"""The check of a file in MCCL: its errors and, if it has none, the warnings of the linter."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.commands.check.mccl.channels import check_channels
from motionlang.commands.check.mccl.checks import CALLS, lint
from motionlang.commands.check.mccl.numbers import check_numbers
from motionlang.commands.check.silence import silence
from motionlang.kernel import Diagnostic, Source
from motionlang.kernel.mccl import COMMENT, Fault, Line, MacroFile, table
from motionlang.kernel.mccl.resolve.decode import problem
from motionlang.kernel.mccl.resolve.errors import DEFINES, defines, diagnostic, model_of
from motionlang.kernel.mccl.resolve.flow import flow_of


def check(program: MacroFile) -> list[Diagnostic]:
    """Return the diagnostics of a file in text order.

    A file without errors also gets the warnings of the linter.
    """
    source = program.source
    whole = [each for each in program.lines if isinstance(each, Line)]
    found = list(program.errors)
    wrong = {(each.line, each.column) for each in found}
    further = [] if found else _lint(program, whole)
    found += (each for each in _without_effect(source, whole) if (each.line, each.column) not in wrong)
    found += [*_macros(source, whole), *further]
    return sorted(silence(source, found, COMMENT), key=lambda each: (each.line, each.column))


def _lint(program: MacroFile, lines: list[Line]) -> list[Diagnostic]:
    source, settings = program.source, program.settings
    found: list[Diagnostic] = []
    model = model_of(source, settings)

    def add(at: int, fault: Fault) -> None:
        found.append(diagnostic(source, at, fault, "warning"))

    lint(lines, program.structure, flow_of(settings), add)
    check_channels(lines, settings, model, add)
    check_numbers(lines, model, add)
    return found


def _without_effect(source: Source, lines: list[Line]) -> Iterator[Diagnostic]:
    """Yield a warning about each command that is not simulated."""
    for line in lines:
        for k, command in enumerate(line.commands):
            if command.row is not None and not command.row.simulated:
                message = f"{command.name} is not simulated: the command has no effect"
                fault = Fault(0, message, command.row.help, "not-simulated")
                yield diagnostic(source, line.offsets[k], fault, "warning")


def _macros(source: Source, lines: list[Line]) -> Iterator[Diagnostic]:
    """Yield warnings about calls of macros that no line of the file defines.

    These are not errors, because the controller may already have the macros.
    """
    defined = {line.commands[0].number for line in lines if defines(line)}
    for line in lines:
        for k, command in enumerate(line.commands):
            if command.row is None or command.row.verb not in CALLS or problem(command):
                continue
            number = command.number
            if number is not None and number not in defined:
                message = f"no line of this file defines macro {number}"
                hint = f"{table().doing(DEFINES)}{number},... defines it"
                yield diagnostic(source, line.offsets[k], Fault(0, message, hint, "unknown-word"), "warning")
