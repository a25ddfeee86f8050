"""`motionlang compare`: compare a real controller's recording with the run."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

from motionlang.cli.command import WrongOption, argument, option
from motionlang.cli.complaints import complain
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.signals import SIGNALS
from motionlang.commands.compare.options import Compared, is_recording
from motionlang.kernel import run


def tolerance(text: str) -> tuple[str, float]:
    """Return the largest residual of a quantity: WHAT=SIZE, or SIZE for positions."""
    what, equals, size = text.rpartition("=")
    try:
        value = float(size.removesuffix("/s").removesuffix("uu"))
    except ValueError:
        value = -1.0
    if not 0.0 <= value < inf:
        raise ValueError(f"{text!r} is not a tolerance such as position=0.05uu")
    return (what.strip() if equals else "position"), value


@dataclass
class Compare(Compared, ProgramOptions):
    """Compare a recording from a real controller with the run, or with another recording."""

    title: ClassVar[str] = "comparison"
    epilog: ClassVar[str] = """\
Use --map to assign the columns of the recording: one to time, the others to a
quantity and an axis. *FACTOR converts a column to seconds or user units.
Columns with the names of a trace need no --map. The delay is fitted by least
squares; scale, offset and lag are reported but not removed. The first line says
what was read: rows, times, gaps, columns.

exit status: 0 within the tolerance; 1 tolerance exceeded, or nothing to
compare; 2 the command line is invalid

examples:
  motionlang compare pick.mnt drive.csv --map time=t*0.001 \\
      --map position.0=PosAct --tolerance position=0.05uu
  motionlang compare pick.mnt scope.txt --map position.0=3 --plot both.html
  motionlang compare monday.csv friday.csv    two recordings of one machine
"""
    file: str = argument("FILE", "the program, or an older recording")
    recording: str = argument("REC", "the recording, as columns of text or Parquet; - reads standard input")
    tolerance: list[tuple[str, float]] = option(
        "WHAT=SIZE",
        "the largest residual allowed: position=0.05uu for every axis, position.0=0.05uu for one; may be repeated",
        read=tolerance,
        many=True,
    )

    def run(self) -> int:
        if self.lang is None and is_recording(self.file):
            if self.set or self.machine is not None or self.until is not None:
                raise WrongOption(
                    "--set, --machine and --until need a program, and both files are recordings"
                )
            return self.compare_with(self.file, self.recording, dict(self.tolerance))
        source, language = self.source(), self.known_language()
        result = run(
            source,
            dialect=language.name,
            machine=self.settings(),
            overrides=self.overrides(),
            until=self.until,
        )
        complain(result.diagnostics, result.source, self.file)
        SIGNALS.end_with(result)
        if not result.time > 0.0:
            return 1
        return self.compare_with(result, self.recording, dict(self.tolerance))
