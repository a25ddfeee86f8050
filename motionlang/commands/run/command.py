"""`motionlang run`: run a program and report what it did."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import flag, option
from motionlang.cli.readers import real
from motionlang.cli.run_command import Pace, Simulated, pacer
from motionlang.kernel import STDIN, CheckedSettings, Outside, Program
from motionlang.kernel import Run as Result


def _quantities(text: str) -> tuple[str, ...]:
    from motionlang.commands.quantities import quantity_names

    return quantity_names(text)


@dataclass
class RunCommand(Simulated):
    """Run a program and report what it did."""

    title: ClassVar[str] = "run"
    epilog: ClassVar[str] = """\
The language is chosen by file extension: .mnt, .mntx and .prg are Mint, .mcl
and .mccl are MCCL. Time is machine time: an hour takes a moment, unless you
give --realtime. To draw a run, sample it, see where its time goes or verify it:
plot, trace, profile and certify.

exit status: 0 success; 1 the program has an error or waits for what can never
happen, an axis met a limit or a following error, or a fault was not handled
(standard error has the line, --allow accepts it); 2 the command line is invalid

examples:
  motionlang run pick.mnt --until 60
  motionlang run pick.mnt --set controller.axes=2 --set pitch=5
  generate-program | motionlang run - --lang mint --format json
"""
    all: bool = flag("list every move, phase and line in the table")
    keep: tuple[str, ...] = option(
        "NAME,…",
        "quantities to report, such as peak.0 or cycle(12); sweep --help lists all",
        read=_quantities,
        default=(),
    )
    realtime: float | None = option(
        "FACTOR",
        "run at FACTOR × real time; FACTOR defaults to 1",
        const=1.0,
        read=real("a factor above 0: --realtime 10 is ten times as fast", 0.0, above=True),
    )

    @property
    def lists_all(self) -> bool:
        return self.all

    def simulated(
        self,
        program: Program,
        settings: CheckedSettings,
        outside: Outside | None = None,
        pace: Pace | None = None,
    ) -> Result:
        if self.realtime is None:
            return super().simulated(program, settings)
        simulate, pace = super().simulated, pacer(self.realtime)
        if self.file != STDIN and sys.stdin.isatty():
            from motionlang.commands.run.keyboard import run_live

            return run_live(lambda keyboard: simulate(program, settings, keyboard, pace), self.realtime)
        return simulate(program, settings, None, pace)

    def extend(self, result: Result) -> None:
        log = result.machine.log
        if (
            result.status == "ended"
            and result.program is not None
            and not (log.moves or log.prints or log.outputs)
        ):
            from motionlang.commands.check import check

            result.diagnostics += check(result.program)  # why nothing came of it
        if any(key.startswith("budget.") for key in result.machine.settings):
            from motionlang.commands.profile.budget import within_budget

            within_budget(result)
        if self.keep:
            from motionlang.commands.quantities import no_cycle_notes, values_of

            result.quantities = values_of(result, self.keep)
            result.notes += no_cycle_notes(result, result.quantities)
