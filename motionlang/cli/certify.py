"""`motionlang run --certify`: machine limits and extremes of a program or folder."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from motionlang.analysis.certificate import certificate, violations
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.program_files import programs
from motionlang.cli.signals import SIGNALS
from motionlang.errors import ProgramError
from motionlang.execution import MACHINE_SUFFIX, machine_of, run
from motionlang.source import STDIN_NAME, Source

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.analysis.certificate import Limit
    from motionlang.analysis.proof.checker import Proof
    from motionlang.cli.options import Options
    from motionlang.result import Run

# Maximum programs without limits that are named.
MAX_NAMED = 5


def certify(result: Run, machine: str | None) -> list[Limit]:
    """Return the certificate of a run; violations become diagnostics of the run."""
    lines = certificate(result.controller, result.machine.settings, result.time)
    if machine is None:
        stem = os.path.splitext(result.source.name)[0]
        of_none = result.source.name == STDIN_NAME
        machine = "a machine file" if of_none else f"{stem}{MACHINE_SUFFIX} next to the program"
    result.diagnostics += violations(lines, machine)
    return lines


def print_certificate(result: Run, lines: Sequence[Limit], proof: Proof | None, machine: str | None) -> None:
    """Write the table to standard output."""
    from motionlang.views.certificate import certificate_lines
    from motionlang.views.terminal import draws, is_terminal, plain, wants_colour, width_of

    width = width_of(sys.stdout) if is_terminal(sys.stdout) else 160
    text = _text_of(machine)
    made = certificate_lines(result, lines, proof, text, width=width, colour=wants_colour(sys.stdout))
    written = "\n".join(made) + "\n"
    sys.stdout.write(written if draws(sys.stdout) else plain(written))


def _text_of(machine: str | None) -> str:
    try:
        return "" if machine is None else Source.read(machine).text
    except OSError:
        return ""


def certify_folder(folder: str, options: Options) -> int:
    """Certify all programs of a folder, each on its machine; 1 if one fails.

    Programs whose machine has no limits are named at the end.
    """
    found, without, failed = programs([folder]), [], 0
    if not found:
        sys.stderr.write(f"no programs in {folder}\n")
        return 1
    signed = 0
    for program in found:
        try:
            result = run(program, until=options.until, overrides=options.overrides, prove=True)
        except OSError as error:
            complain([unreadable(str(error.filename or program), error)], None, program)
            failed += 1
            continue
        except ProgramError as error:
            machine = machine_of(program)
            complain(error.diagnostics, None if machine is None else Source.read(machine), machine or program)
            failed += 1
            continue
        SIGNALS.end_with(result)
        if not any(".limits." in key for key in result.machine.settings):
            without.append(os.path.relpath(program, folder))
            continue
        proof = result.proof()
        result.diagnostics += proof.violations
        lines = certify(result, machine_of(program))
        if options.report == "table":
            print_certificate(result, lines, proof, machine_of(program))
            sys.stdout.write("\n")
        wrong = result.status == "fault" or any(each.severity == "error" for each in result.diagnostics)
        if result.diagnostics:
            complain(result.diagnostics, result.source, program)
        failed += wrong
        signed += not wrong
    sys.stdout.write(f"{signed} of {signed + failed} machines within their limits\n")
    if without:
        more = f", and {len(without) - MAX_NAMED} more" if len(without) > MAX_NAMED else ""
        sys.stdout.write(f"no limits given for {len(without)}: {', '.join(without[:MAX_NAMED])}{more}\n")
    return 1 if failed or not signed else 0
