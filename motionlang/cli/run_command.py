"""The base of the commands that run one program and report on the run."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from time import monotonic, sleep
from typing import ClassVar

from motionlang import kernel
from motionlang.cli.command import Refused, WrongOption, argument, option
from motionlang.cli.complaints import complain, run_status
from motionlang.cli.crash import CRASHED, UNAVAILABLE, crash
from motionlang.cli.option_groups import OutputOptions, ProgramOptions, WorldOptions, accepted_events, forms
from motionlang.cli.readers import machine_time, real
from motionlang.cli.run_progress import reported
from motionlang.cli.signals import SIGNALS, status_of
from motionlang.kernel import (
    DEFAULT_AXES,
    ONE_SHIFT,
    STDIN,
    CheckedSettings,
    Diagnostic,
    Machine,
    Outside,
    Program,
    ProgramError,
    Run,
    Source,
    Terminated,
    end_of,
    lang,
    missing_axes,
    name_of,
    run,
    who_ended,
)
from motionlang.kernel.report import assumptions, failure, pieces, remembered
from motionlang.kernel.tools import MissingExtra, listed
from motionlang.views.formatting import clock_time
from motionlang.views.questions import ask
from motionlang.views.report import render, run_document
from motionlang.views.table import Document
from motionlang.views.terminal import draws, is_terminal, plain, printable, table_width, wants_colour

# Seconds of processor time of a run that no machine time ends.
CPU = 20.0


Pace = Callable[[float], None]


@dataclass
class Prepared(WorldOptions, ProgramOptions):
    """A program, its machine and its world, made ready for a run."""

    title: ClassVar[str] = "program"

    def prepared(self, *, is_debug: bool = False) -> tuple[Program, CheckedSettings]:
        """Return the program with the values of `--set`, and the settings with the entries of its world.

        Refused for a wrong machine file or entry. The program may have errors.
        """
        source, language = self.source(), self.known_language()
        settings = self.settings()
        program = language.program(source, settings, is_debug=is_debug).with_values(self.overrides())
        given = self.entries()
        if given:
            try:
                lang.check_inputs_are_read(program, language, settings, kernel.entries(settings, **given))
                settings = CheckedSettings(kernel.with_entries(settings, **given))
            except kernel.WrongEntry as error:
                wrong = Diagnostic("option", error.message, hint=error.hint)
                raise Refused([wrong], file=self.file, status=2) from None
        axes: int = settings.get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
        missing = missing_axes(settings, axes, language.first_axis) if settings else []
        if missing:
            machine = self.machine_path()
            of_file = Source(machine, "") if machine else None
            raise Refused(missing, file=machine or self.file, source=of_file)
        return program, settings


@dataclass
class Simulated(OutputOptions, Prepared):
    """A command that runs one program: it prints the program's output, its answer, and the report of the run."""

    title: ClassVar[str] = "run"
    file: str = argument("FILE", "the program; - reads standard input")
    format: str = forms("text", "json", "csv", "none", what="the report")
    until: float | None = option(
        "S",
        f"end the run after S seconds of machine time (run.until of the machine file, or {ONE_SHIFT:.0f})",
        read=machine_time,
    )
    cpu: float = option(
        "S",
        f"end a run without such an end after S seconds of processor time ({CPU:.10g}; 0: never)",
        read=real("a number of seconds, 0 or more", 0.0, 1e9),
        default=CPU,
    )
    nv: str | None = option("FILE", "keep nv variables, NVLONG and NVFLOAT in FILE between runs", writes=True)
    allow: frozenset[str] = accepted_events()

    _is_reported: bool = field(default=False, init=False, repr=False)

    def perform(self) -> int:
        """Run the command; there is exactly one complete report, however the run ends."""
        try:
            return super().perform()
        except (KeyboardInterrupt, Terminated) as error:
            if self._is_reported:
                raise
            SIGNALS.defer()
            ended = Diagnostic("interrupted", f"the run was ended {who_ended(error)}")
            return self.refuse(Refused([ended], file=self.file, status=status_of(error)), "interrupted")
        except (OSError, ProgramError, Refused, WrongOption, MissingExtra):
            raise
        except Exception as error:
            if self._is_reported:
                raise
            found = crash(error, self.given)
            status = UNAVAILABLE if found.code == "extra" else CRASHED
            return self.refuse(Refused([found], file=self.file, status=status))

    def run(self) -> int:
        self.prepare()
        result = self._result()
        with SIGNALS.deferred:  # a signal during the output waits until it is written
            status = self._report_outcome(result)
            self._is_reported = True
        return self.after(result) or status

    def prepare(self) -> None:
        """Refuse, before the run, what cannot be done after it."""

    def extend(self, result: Run) -> None:
        """Compute what else the command reports of a run."""

    def print_json(self, result: Run) -> None:
        """Print the JSON document of a run: its report, which has a schema of its own."""
        sys.stdout.writelines(pieces(result))

    def document(self, result: Run) -> Document:
        """Return the tables of a run, for CSV."""
        return run_document(result)

    def conclusion(self, result: Run, *, width: int, colour: bool) -> str:
        """Return what the command prints before the report of the run."""
        return ""

    def after(self, result: Run) -> int:
        """Write the files of the command; return the exit status, 0 for success."""
        return 0

    # -------------------------------------------------------------------------------------------- before the run

    def refuse(self, refused: Refused, outcome: str = "fault") -> int:
        if self.format == "json":
            document = failure(name_of(self.file), self.lang or "", refused.diagnostics, outcome)
            sys.stdout.write(document)
        return super().refuse(refused)

    def _result(self) -> Run:
        return self.simulated(*self.prepared())

    # ---------------------------------------------------------------------------------------------------- the run

    def simulated(
        self,
        program: Program,
        settings: CheckedSettings,
        outside: Outside | None = None,
        pace: Pace | None = None,
    ) -> Run:
        """Return the run of a program; its output and the progress are shown meanwhile."""

        def warn(diagnostic: Diagnostic) -> None:
            complain([diagnostic], program.source, self.file)

        def simulate(show: Callable[[str], object], begun: Callable[[Machine], None]) -> Run:
            return self._unreported(program, settings, outside, pace, show, begun)

        def line_of(at: int) -> int:
            return self.known_language().locate(program.source, at)[0]

        return reported(
            simulate,
            warn,
            line_of if pace is None and self._is_endless(settings) else None,
            program=program,
            homes=self.known_language().table().homes,
            until=end_of(settings) if self.until is None else self.until,
        )

    def _is_endless(self, settings: Mapping[str, object]) -> bool:
        """True if no time of the user's ends the run, only a limit of processor time."""
        return self.until is None and "run.until" not in settings

    def _unreported(
        self,
        program: Program,
        settings: CheckedSettings,
        outside: Outside | None,
        pace: Pace | None,
        show: Callable[[str], object],
        begun: Callable[[Machine], None],
    ) -> Run:
        def prepare(machine: Machine) -> None:
            begun(machine)
            if outside is None and self.file != STDIN:
                machine.ask = lambda: ask(machine)

        with SIGNALS.limited(self.cpu if self._is_endless(settings) else 0.0):
            return run(
                program,
                machine=settings,
                until=self.until,
                overrides=self.overrides(),
                show=None if self.format in ("json", "csv") else show,
                pace=pace,
                outside=outside,
                begun=prepare,
                nv=self.nv,
                keep_crash=True,
            )

    # ----------------------------------------------------------------------------------------------- after the run

    def _report_outcome(self, result: Run) -> int:
        """Print report and complaints, and return the exit status."""
        if isinstance(result.crash, OSError):  # of the program's output, which `main` handles
            raise result.crash
        if result.crash is not None:
            of_stdin = result.source if self.file == STDIN else None
            result.diagnostics.append(crash(result.crash, self.given, of_stdin))
        self.extend(result)
        if self.format == "json":
            self.print_json(result)
        elif self.format == "csv":
            self.show(self.document(result), "")
        else:
            self._print_text(result)
        if result.diagnostics:
            warned = result.machine.warned
            left = [each for each in result.diagnostics if not any(each is other for other in warned)]
            complain(left, result.source, self.file)
            if any(each.code == "never" and "the machine file" in each.hint for each in left):
                self._point_to_init()
        _note_remembered(result)
        if result.status == "until":
            if self.format in ("none", "csv"):
                sys.stderr.writelines(f"note: {printable(each)}\n" for each in result.wait_notes)
            _note_axes_in_motion(result)
            if self._is_endless(result.machine.settings) and result.time >= ONE_SHIFT:
                sys.stderr.write(
                    "note: nothing but the length of a shift ends it; --until 60 runs a minute\n"
                )
        sys.stdout.flush()
        if result.crash is not None:
            return UNAVAILABLE if result.diagnostics[-1].code == "extra" else CRASHED
        if result.status == "interrupted":
            return SIGNALS.status
        return run_status(result, self.allow)

    def _print_text(self, result: Run) -> None:
        seen, drawn = is_terminal(sys.stdout), draws(sys.stdout)
        width, colour = table_width(sys.stdout), wants_colour(sys.stdout)
        sections = [self.conclusion(result, width=width, colour=colour)]
        if self.shows(result):
            report = render(
                result, width=width, colour=colour, charts=seen and drawn, everything=self.lists_all
            )
            if self.lists_all:
                count = len(assumptions(result))
                note = f"{count} unconfirmed assumptions; motionlang check --evidence {self.file} lists them"
                report += f"\nnote: depends on {note}\n"
            sections.append(report)
        text = "\n".join(filter(None, sections))
        if text and result.machine.log.prints and self.format == "text":
            text = "\n" + text
        sys.stdout.write(text if drawn else plain(text))

    def shows(self, result: Run) -> bool:
        """True if the format has a report, and there is a run to report."""
        began = result.status != "fault" or result.time or result.controller.log.moves
        return self.format != "none" and bool(began)

    @property
    def lists_all(self) -> bool:
        """True if tables have all their rows."""
        return False

    def _point_to_init(self) -> None:
        """Name `init` after a run whose machine nothing describes."""
        if self.machine_path() is None and not self.set and not self.entries() and self.file != STDIN:
            sys.stderr.write(f"note: motionlang init {self.file} writes a first machine file\n")


def _note_remembered(result: Run) -> None:
    """Name the commands that moved an axis by a meaning that no document states."""
    found = remembered(result)
    if found:
        act = f"{listed(found)} {'act' if len(found) > 1 else 'acts'}"
        sys.stderr.write(f"note: {act} as remembered, not as printed: motionlang help {found[0]}\n")


def _note_axes_in_motion(result: Run) -> None:
    """Name the axes that moved at the time limit, and those that a suspension or a speed of 0 held."""
    found: dict[str, list[int]] = {"moving": [], "held": []}
    for axis in result.controller.moving():
        a = result.controller.axes[axis]
        is_held = a.profiles[-1].shape == "suspend" and not a.velocity(result.time)
        found["held" if is_held else "moving"].append(axis)
    for what, axes in found.items():
        if axes:
            were = f"axes {listed(axes)} were" if len(axes) > 1 else f"axis {axes[0]} was"
            limit = clock_time(result.time)
            sys.stderr.write(f"note: {were} still {what} at the time limit of {limit}\n")


def pacer(factor: float) -> Pace:
    """Return a function that waits until a machine time at `factor` × real time.

    It flushes the output, even if the program is too slow for a wait.
    """
    began = monotonic()

    def pace(time: float) -> None:
        sys.stdout.flush()
        ahead = time / factor - (monotonic() - began)
        if ahead > 0.0:
            sleep(ahead)

    return pace
