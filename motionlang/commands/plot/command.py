"""`motionlang plot`: draw the motion of a run."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import WrongOption, argument, option
from motionlang.cli.readers import axes, machine_time, path
from motionlang.cli.run_to_file import RunToFile
from motionlang.commands.scope import write_scope
from motionlang.kernel import STDIN
from motionlang.kernel import Run as Result
from motionlang.kernel.tools import need
from motionlang.views.figure_files import write_figure
from motionlang.views.window import Window

if TYPE_CHECKING:
    from motionlang.kernel.servo import ServoTrace

PLOTS = (".png", ".svg", ".html")


@dataclass
class Plot(RunToFile):
    """Draw the motion of a run into a file."""

    title: ClassVar[str] = "picture"
    epilog: ClassVar[str] = """\
examples:
  motionlang plot pick.mnt
  motionlang plot pick.mnt path.svg --path 0,1
"""
    out: str = argument(
        "OUT", "the file to draw, by default pick.html for pick.mnt", suffixes=PLOTS, default=""
    )
    from_: float | None = option(
        "S", "start of the time span, s; an .html page also has the rest", read=machine_time
    )
    to: float | None = option("S", "end of the time span, s", read=machine_time)
    axes: tuple[int, ...] | None = option(
        "N,…", "the axes to show, such as 0,2; default: all that moved", read=axes
    )
    path: tuple[int, ...] | None = option(
        "X,Y",
        "draw the path of two axes, in an .html page also of three, coloured by speed, instead of curves over time",
        read=path,
    )

    def prepare(self) -> None:
        super().prepare()
        if not self.out.lower().endswith(".html"):  # a page has the profiles themselves
            need("motionlang plot", "numpy")

    _names_file: bool = field(default=False, init=False, repr=False)

    def check(self) -> None:
        if not self.out and self.output is not None and self.output.lower().endswith(PLOTS):
            self.out, self.output = self.output, None
        super().check()
        if not self.out:
            if self.file == STDIN:
                raise WrongOption("a program from standard input needs an OUT, such as motion.html")
            self.out, self._names_file = f"{os.path.splitext(self.file)[0]}.html", True
        if self.path is not None and len(self.path) > 2 and not self.out.lower().endswith(".html"):
            raise WrongOption("--path draws three axes in an .html page only")
        if self.to is not None and self.to <= (self.from_ or 0.0):
            raise WrongOption("--to must be after --from")

    def after(self, result: Result) -> int:
        status = super().after(result)
        if self._names_file and not status:
            sys.stderr.write(f"note: wrote {self.out}\n")
        return status

    def write(self, result: Result) -> None:
        servos, window = _motors(result), Window(self.from_ or 0.0, self.to, self.axes, self.path)
        if self.out.lower().endswith(".html"):
            write_scope(result, self.out, servos, window)
        else:
            from motionlang.commands.plot.view import run_figure

            write_figure(run_figure(result, servos, window), self.out)


def _motors(result: Result) -> dict[int, ServoTrace]:
    if all(axis.feedback is None for axis in result.controller.axes.values()):
        return {}
    from motionlang.kernel.tracks import servo_traces

    return servo_traces(result.controller)
