"""`motionlang sweep`: run a program in many variants and show all and the best.

Each row is written as soon as it is computed.
"""

from __future__ import annotations

import os
import sys
import textwrap
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, unreadable, unwritten
from motionlang.cli.option_groups import Jobs, OutputOptions, ProgramOptions, WorldOptions, forms, with_world
from motionlang.cli.readers import whole
from motionlang.cli.signals import SIGNALS
from motionlang.commands import sweep as sweeps
from motionlang.commands.quantities import ROWS
from motionlang.commands.sweep.job import Result
from motionlang.commands.sweep.journal import OtherSweep, RowJournal, read
from motionlang.commands.sweep.report import SweepReport
from motionlang.commands.sweep.table import write_rows
from motionlang.commands.sweep.variants import Variants
from motionlang.commands.sweep.worlds import SUFFIX
from motionlang.kernel import STDIN, CheckedSettings, Diagnostic, ProgramError, Terminated
from motionlang.views.progress import Progress

# The suffix of --rows-to for the rows of an incomplete sweep.
PARTIAL_SUFFIX = ".part"
# Rows of the table without --rows.
MAX_ROWS = 20


def _quantities() -> str:
    """Return the quantities of a run, a line or two each."""
    return "\n".join(
        textwrap.fill(
            f"{row.help}{f', {row.unit}' if row.unit else ''}",
            78,
            initial_indent=f"  {row.name:<13} ",
            subsequent_indent=" " * 16,
        )
        for row in ROWS
    )


@dataclass
class SweepCommand(Variants, OutputOptions, Jobs, WorldOptions, ProgramOptions):
    """Run many variants of a program and find the best."""

    title: ClassVar[str] = "rows"
    epilog: ClassVar[str] = f"""\
Each variant is a complete run. Quantities for --keep:
{_quantities()}

Expressions may use these names, the varied names, numbers, + - * / % **,
comparisons, and, or, not, abs, min, max. Ctrl-C keeps the finished rows;
--resume continues.

exit status: 0 all variants succeeded; 1 some failed; 2 the command line is
invalid; 130 Ctrl-C

examples:
  motionlang sweep pick.mnt --vary rate=500:5000:10 --vary gain=1,2,4 \\
      --keep time,peak.0
  motionlang sweep pick.mnt --vary rate=500:5000 --latin 200 \\
      --minimise time --where "peak.0 < 400"
  motionlang sweep pick.mnt --scenarios pick.scenarios --rows-to worlds.csv
"""
    file: str = argument("FILE", "the program; pick.sweep.toml next to pick.mnt has defaults for the options")
    format: str = forms("text", "json", "csv", "none", what="the printed rows (json and csv have all)")
    rows: int = option(
        "N",
        f"rows of the table ({MAX_ROWS}); 0 for all",
        read=whole("a whole number, 0 or more", 0, 999_999_999),
        default=MAX_ROWS,
    )
    rows_to: str | None = option("ROWS", "write every row into a file", suffixes=(".csv", ".parquet"))
    resume: bool = flag("continue an interrupted sweep")

    def check(self) -> None:
        super().check()
        if self.resume and self.rows_to is None:
            raise WrongOption("--resume needs --rows-to, next to which the unfinished rows are stored")
        if self.minimise is not None and self.maximise is not None:
            raise WrongOption("give either --minimise or --maximise, not both")

    def unnamed_files(self) -> list[str]:
        return [*super().unnamed_files(), os.path.splitext(self.file)[0] + SUFFIX]

    def run(self) -> int:
        try:
            if self.file != STDIN:
                self.read_file_of(self.file)
            sweep, report = self._made()
            rows = self._earlier(sweep)
        except OSError as error:
            raise Refused([unreadable(str(error.filename or self.file), error)], file=self.file) from None
        except ValueError as error:
            raise WrongOption(str(error)) from None
        return self._compute(sweep, report, rows)

    def _made(self) -> tuple[sweeps.Sweep, SweepReport]:
        source, language = self.source(), self.known_language()
        settings = with_world(self.settings(), self.entries())
        try:
            worlds = self.worlds()
            space = self.space(worlds)
            report = SweepReport(self, space.names)
            sweep = sweeps.Sweep(
                source,
                space,
                keep=report.keep,
                dialect=language.name,
                machine=CheckedSettings(settings),
                overrides=self.overrides(),
                worlds=worlds,
                until=self.until,
                certify=self.certify,
                allow=self.allow,
            )
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        return sweep, report

    def _earlier(self, sweep: sweeps.Sweep) -> dict[int, Result]:
        """Return the rows of the sweep to resume, by variant number."""
        if not self.resume:
            return {}
        partial = f"{self.rows_to}{PARTIAL_SUFFIX}"
        if not os.path.exists(partial):
            sys.stderr.write(
                f"{partial} does not exist: nothing to resume, so all {len(sweep)} variants run\n"
            )
            return {}
        try:
            return {row[0]: row for row in read(partial, _digest(sweep)) if 0 <= row[0] < len(sweep)}
        except OtherSweep:
            what = f"{partial} has the rows of another sweep: the program or the sweep has changed"
            found = Diagnostic("file", what, hint="run without --resume to start again")
            raise Refused([found], file=self.file, status=2) from None

    def _compute(self, sweep: sweeps.Sweep, report: SweepReport, rows: dict[int, Result]) -> int:
        journal = None
        if self.rows_to is not None:
            path = self.rows_to + PARTIAL_SUFFIX
            try:
                journal = RowJournal(path, _digest(sweep), resume=bool(rows))
            except OSError as error:
                raise Refused([unwritten(path, error)], file=self.file) from None
        progress, ended = Progress(sys.stderr, os.path.basename(self.file)), False
        results = sweep.results(jobs=self.jobs or None, done=frozenset(rows))
        try:
            for result in results:
                rows[result[0]] = result
                if journal is not None:
                    journal.add(result)
                progress(len(rows) / len(sweep))
        except (KeyboardInterrupt, Terminated):
            ended = True
        finally:
            close = getattr(results, "close", None)
            if close is not None:
                close()
            progress.done()
        with SIGNALS.deferred:
            status = report.report(self, sweep, rows)
            if journal is not None:
                status = max(status, self._finish(sweep, report, rows, journal))
        if ended:
            on = "; --resume continues" if journal is not None else ""
            sys.stderr.write(f"ended after {len(rows)} of {len(sweep)} variants{on}\n")
            return SIGNALS.status
        return status

    def _finish(
        self, sweep: sweeps.Sweep, report: SweepReport, rows: dict[int, Result], journal: RowJournal
    ) -> int:
        """Write --rows-to completely, and delete the journal if no variant remains."""
        assert self.rows_to is not None
        try:
            write_rows(self.rows_to, report.table(sweep, rows))
            if len(rows) == len(sweep):
                journal.remove()
            else:
                journal.close()
        except OSError as error:
            complain([unwritten(self.rows_to, error)], None, self.file)
            return 1
        return 0


def _digest(sweep: sweeps.Sweep) -> str:
    """Return the identity of a sweep: program, machine, results, and variants.

    The variants are represented by their number and by the first, middle and last of them.
    """
    count = len(sweep)
    return f"{sweep.job.digest} {count} {[sweep.space[n] for n in (0, count // 2, count - 1)]!r}"
