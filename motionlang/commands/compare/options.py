"""Comparing a run with a recording of a real controller: what `compare` and `diff` share."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from sys import float_info
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import Command, Refused, flag, option
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.option_groups import OutputOptions, read
from motionlang.cli.output_files import written
from motionlang.cli.readers import machine_time, real
from motionlang.commands.compare.view import comparison_document, render_comparison
from motionlang.commands.scope import write_comparison
from motionlang.kernel import ProgramError, Run, Source
from motionlang.views.terminal import table_width, wants_colour

if TYPE_CHECKING:  # which needs numpy
    from motionlang.commands.compare.comparison import Mapped


def mapped(text: str) -> Mapped:
    """Return the column that is assigned to a quantity: WHAT=COLUMN or WHAT=COLUMN*FACTOR."""
    from motionlang.commands.compare.comparison import Mapped

    what, equals, column = text.partition("=")
    name, star, factor = column.rpartition("*")
    if not equals or not column:
        raise ValueError(f"{text!r} is not WHAT=COLUMN, such as position.0=PosAct")
    if not star:
        return Mapped(what.strip(), column.strip(), None)
    try:
        return Mapped(what.strip(), name.strip(), float(factor))
    except ValueError:
        raise ValueError(f"{text!r}: {factor!r} is not a number to multiply by") from None


def recorded(path: str) -> Source:
    """Return the text of a recording, also of a Parquet or MCAP file; Refused if it cannot be read."""
    from motionlang.commands.compare.recording import BINARY, text_of

    if os.path.splitext(path)[1].lower() not in BINARY:
        return read(path)
    try:
        return text_of(path)
    except OSError as error:
        raise Refused([unreadable(path, error)], file=path) from None
    except ProgramError as error:
        raise Refused(error.diagnostics, file=path) from None


@dataclass
class Recording(Command):
    """The columns of a recording, and its delay."""

    title: ClassVar[str] = "recording"
    map: list[Mapped] = option(
        "WHAT=COLUMN",
        "assign a column, by name or number, to time, position.0, velocity.1 …; may be repeated",
        read=mapped,
        many=True,
    )
    delay: float | None = option(
        "S",
        "the delay of the recording behind the run, s; default: fitted",
        read=real("a number of seconds", -float_info.max),
    )


@dataclass
class Compared(OutputOptions, Recording):
    """A comparison that is printed, and drawn on request."""

    all: bool = flag("list everything, not only the first rows of each kind")
    plot: str | None = option("PAGE", "draw both into a page", suffixes=(".html",))
    until: float | None = option("S", "end the runs after S seconds of machine time", read=machine_time)

    def compare_with(self, result: Run, path: str, tolerances: Mapping[str, float]) -> int:
        """Compare a recording with a run, print the result, and return the exit status."""
        from motionlang.commands.compare.comparison import compare

        recording = recorded(path)
        try:
            made = compare(result, recording, self.map, tolerances=tolerances, delay=self.delay)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=recording, file=path) from None
        width, colour = table_width(sys.stdout), wants_colour(sys.stdout)
        text = render_comparison(made, width=width, colour=colour, everything=self.all)
        self.show(comparison_document(made, path), text)
        complain(made.remarks, recording, path)
        page = self.plot
        status = 0 if page is None else written(page, lambda: write_comparison(made, page))
        return 1 if made.is_within is False else status
