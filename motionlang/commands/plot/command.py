"""`motionlang plot`: draw the motion of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import WrongOption, argument, option
from motionlang.cli.readers import axes, machine_time, path
from motionlang.cli.run_to_file import Drawn
from motionlang.commands.scope import write_scope
from motionlang.kernel.result import Run as Result
from motionlang.kernel.tools import need
from motionlang.views.figure_files import write_figure
from motionlang.views.window import Window

if TYPE_CHECKING:
    from motionlang.kernel.servo.trace import ServoTrace

PLOTS = (".png", ".svg", ".html")


@dataclass
class Plot(Drawn):
    """Draw the motion of a run into a file."""

    title: ClassVar[str] = "picture"
    epilog: ClassVar[str] = """\
examples:
  motionlang plot pick.mnt pick.html
  motionlang plot pick.mnt path.svg --path 0,1
"""
    out: str = argument("OUT", "the file to draw", suffixes=PLOTS)
    from_: float | None = option(
        "S", "start of the time span, s; an .html page also has the rest", read=machine_time
    )
    to: float | None = option("S", "end of the time span, s", read=machine_time)
    axes: tuple[int, ...] | None = option(
        "N,…", "the axes to show, such as 0,2; default: all that moved", read=axes
    )
    path: tuple[int, ...] | None = option(
        "X,Y", "draw the path of two or three axes, coloured by speed, instead of curves over time", read=path
    )

    def prepare(self) -> None:
        super().prepare()
        if not self.out.lower().endswith(".html"):  # a page has the profiles themselves
            need("motionlang plot", "numpy")

    def check(self) -> None:
        super().check()
        if self.to is not None and self.to <= (self.from_ or 0.0):
            raise WrongOption("--to must be after --from")

    def write(self, result: Result) -> None:
        servos, window = _motors(result), Window(self.from_ or 0.0, self.to, self.axes, self.path)
        if self.out.lower().endswith(".html"):
            write_scope(result, self.out, servos, window)
        else:
            from motionlang.commands.plot.view import run_figure

            write_figure(run_figure(result, servos, window), self.out)


def _motors(result: Result) -> dict[int, ServoTrace]:
    """Return the traces of the simulated motors of a run, by axis."""
    if all(axis.feedback is None for axis in result.controller.axes.values()):
        return {}
    from motionlang.kernel.log.history import servo_traces

    return servo_traces(result.controller)
