"""The options of a command that draws its result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, option
from motionlang.cli.output_files import written
from motionlang.views.figure import Figure
from motionlang.views.figure_files import write_figure


@dataclass
class Picture(Command):
    """A picture of the result."""

    title: ClassVar[str] = "picture"
    plot: str | None = option("FILE", "draw the result into a file", suffixes=(".png", ".svg"))

    def drawn(self, figure: Callable[[], Figure]) -> int:
        """Write a figure into the file, if wished; return the exit status."""
        path = self.plot
        return 0 if path is None else written(path, lambda: write_figure(figure(), path))
