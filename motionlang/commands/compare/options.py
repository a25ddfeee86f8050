"""Comparing a run with a recording of a real controller: what `compare` and `diff` share."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from sys import float_info
from typing import TYPE_CHECKING, ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, flag, option
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.option_groups import OutputOptions, read
from motionlang.cli.output_files import written
from motionlang.cli.readers import machine_time, real
from motionlang.commands.compare.view import comparison_document, render_comparison
from motionlang.commands.scope import write_comparison
from motionlang.kernel import STDIN, ProgramError, Run, dialect_of
from motionlang.views.terminal import table_width, wants_colour

if TYPE_CHECKING:  # which needs numpy
    from motionlang.commands.recording import Mapped, RecordedTable

# The extensions of a recording.
RECORDED = (".csv", ".tsv", ".dat", ".parquet")


def mapped(text: str) -> Mapped:
    """Return the column that is assigned to a quantity: WHAT=COLUMN or WHAT=COLUMN*FACTOR."""
    from motionlang.commands import recording

    return recording.mapped(text)


def recorded(path: str) -> RecordedTable:
    """Return the table of a recording; Refused if it cannot be read."""
    from motionlang.commands.recording import read_file, table_of

    try:
        return table_of(read(path)) if path == STDIN else read_file(path)
    except OSError as error:
        raise Refused([unreadable(path, error)], file=path) from None
    except ProgramError as error:
        raise Refused(error.diagnostics, file=path) from None


@contextmanager
def refusing(table: RecordedTable, path: str) -> Iterator[None]:
    """Refuse a recording in which there is nothing to read."""
    try:
        yield
    except ProgramError as error:
        raise Refused(error.diagnostics, source=table.source, file=path) from None


def is_recording(path: str) -> bool:
    """True if a file is a recording by its extension."""
    return path.lower().endswith(RECORDED) and dialect_of(path) is None


@dataclass
class RecordingOptions(Command):
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
class Compared(OutputOptions, RecordingOptions):
    """A comparison that is printed, and drawn on request."""

    all: bool = flag("list everything, not only the first rows of each kind")
    plot: str | None = option("PAGE", "draw both into a page", suffixes=(".html",))
    until: float | None = option("S", "end the runs after S seconds of machine time", read=machine_time)

    def compare_with(self, made: Run | str, path: str, tolerances: Mapping[str, float]) -> int:
        """Compare a recording with a run or an older recording, print the result, and return the exit status."""
        from motionlang.commands.compare.baseline import baseline_of, read_compared
        from motionlang.commands.compare.comparison import compare

        if isinstance(made, str):
            if self.plot is not None:
                raise WrongOption("--plot draws a run, and both files are recordings")
            older = recorded(made)
            with refusing(older, made):
                baseline = baseline_of(read_compared(older, self.map))
        else:
            baseline = baseline_of(made)
        table = recorded(path)
        with refusing(table, path):
            recording = read_compared(table, self.map, baseline)
            try:
                found = compare(baseline, recording, tolerances=tolerances, delay=self.delay)
            except ProgramError:
                if self.format == "text":
                    sys.stdout.write(f"{recording.sentence}\n")
                complain(recording.remarks, table.source, path)
                raise
        width, colour = table_width(sys.stdout), wants_colour(sys.stdout)
        text = render_comparison(found, width=width, colour=colour, everything=self.all)
        self.show(comparison_document(found, path), text)
        complain(found.remarks, table.source, path)
        page = self.plot
        status = 0 if page is None else written(page, lambda: write_comparison(found, page))
        return 1 if found.is_within is False else status
