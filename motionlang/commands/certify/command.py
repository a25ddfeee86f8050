"""`motionlang certify`: machine limits and extremes of a program or folder."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar

from motionlang.cli.command import argument
from motionlang.cli.complaints import complain, run_status, unreadable
from motionlang.cli.program_files import programs
from motionlang.cli.run_command import Simulated
from motionlang.cli.signals import SIGNALS
from motionlang.commands.certify import CertifiedLimit, certificate, missing_limits, violations
from motionlang.commands.certify.motion import VerifiedMotion, verify_motion
from motionlang.commands.certify.view import certificate_lines, conclusion_of, limits_table
from motionlang.kernel import Diagnostic, ProgramError, Source, machine_of, run
from motionlang.kernel import Run as Result
from motionlang.views.table import Document
from motionlang.views.terminal import draws, is_terminal, plain, wants_colour, width_of

# Maximum programs without limits that are named.
MAX_NAMED = 5
# Profiles of an interrupted run up to which it is still certified: a report comes within a second of the signal.
CERTIFIED_IN_TIME = 10_000


@dataclass
class Certify(Simulated):
    """Report how far a run uses each limit of its machine; a folder has many programs."""

    title: ClassVar[str] = "certificate"
    epilog: ClassVar[str] = """\
Each axis is checked against [axis.N.limits] of the machine file, and a table to
sign is printed. Other code verifies the motion: that it is continuous, ends at
its targets, and is that of the log.

exit status: 1 if a limit is exceeded, an axis that moved has none, or the run
was cut off in its motion; or as in run

examples:
  motionlang certify pick.mnt
  motionlang certify scripts/mint
"""
    file: str = argument("FILE", "the program, or a folder with programs")

    motion: VerifiedMotion | None = field(default=None, init=False, repr=False)
    certificate: list[CertifiedLimit] = field(default_factory=list, init=False, repr=False)

    def run(self) -> int:
        return self._run_folder() if os.path.isdir(self.file) else super().run()

    def _run_folder(self) -> int:
        """Certify all programs of a folder, each on its machine; 1 if one fails.

        Programs whose machine has no limits are named at the end.
        """
        found, without, failed = programs([self.file]), [], 0
        if not found:
            sys.stderr.write(f"no programs in {self.file}\n")
            return 1
        signed = 0
        for program in found:
            try:
                result = run(program, until=self.until, overrides=self.overrides())
            except OSError as error:
                complain([unreadable(str(error.filename or program), error)], None, program)
                failed += 1
                continue
            except ProgramError as error:
                machine = machine_of(program)
                complain(
                    error.diagnostics, None if machine is None else Source.read(machine), machine or program
                )
                failed += 1
                continue
            SIGNALS.end_with(result)
            if not any(".limits." in key for key in result.machine.settings):
                without.append(os.path.relpath(program, self.file))
                continue
            lines, motion = certify(result, machine_of(program))
            if self.format == "text":
                made = certificate_text(result, lines, motion, machine_of(program)) + "\n"
                sys.stdout.write(made if draws(sys.stdout) else plain(made))
            if result.diagnostics:
                complain(result.diagnostics, result.source, program)
            wrong = run_status(result, self.allow)
            failed += wrong
            signed += not wrong
        sys.stdout.write(f"{signed} of {signed + failed} machines within their limits\n")
        if without:
            more = f", and {len(without) - MAX_NAMED} more" if len(without) > MAX_NAMED else ""
            sys.stdout.write(f"no limits given for {len(without)}: {', '.join(without[:MAX_NAMED])}{more}\n")
        return 1 if failed or not signed else 0

    def extend(self, result: Result) -> None:
        if result.crash is not None:
            return
        count = sum(len(axis.profiles) for axis in result.controller.axes.values())
        if result.status == "interrupted" and count > CERTIFIED_IN_TIME:
            message = f"the run was not certified: it ended after {count} profiles of motion"
            hint = f"at most {CERTIFIED_IN_TIME} are certified after a signal, any number after --until"
            result.diagnostics.append(Diagnostic("beyond-limit", message, hint=hint))
            return
        self.certificate, self.motion = certify(result, self.machine_path())
        result.findings["certificate"] = [each.as_dict() for each in self.certificate]

    def document(self, result: Result) -> Document:
        return Document([limits_table(self.certificate)])

    def conclusion(self, result: Result, *, width: int, colour: bool) -> str:
        if self.motion is None:
            return ""
        if not self.certificate or self.format != "text":
            return f"{conclusion_of(self.motion)}\n"
        return certificate_text(result, self.certificate, self.motion, self.machine_path())


def certify(result: Result, machine: str | None) -> tuple[list[CertifiedLimit], VerifiedMotion]:
    """Return the certificate of a run and its verified motion; violations become diagnostics of the run."""
    lines = certificate(result.controller, result.machine.settings, result.time)
    motion = verify_motion(result.controller, lines, result.time)
    result.diagnostics += motion.violations
    result.diagnostics += violations(result, lines, partial(missing_limits, result.source.name, machine))
    return lines, motion


def certificate_text(
    result: Result, lines: Sequence[CertifiedLimit], motion: VerifiedMotion, machine: str | None
) -> str:
    """Return the certificate as text for standard output."""
    width = width_of(sys.stdout) if is_terminal(sys.stdout) else 160
    text = _text_of(machine)
    made = certificate_lines(result, lines, motion, text, width=width, colour=wants_colour(sys.stdout))
    return "\n".join(made) + "\n"


def _text_of(machine: str | None) -> str:
    try:
        return "" if machine is None else Source.read(machine).text
    except OSError:
        return ""
