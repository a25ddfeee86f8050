"""`motionlang sweep`: run a program in many variants and show all and the best.

Each row is written as soon as it is computed.
"""

from __future__ import annotations

import argparse
import os
import sys

from motionlang.analysis.sweeps import KEEP, Sweep
from motionlang.analysis.sweeps.description import SUFFIX, Description, read_description
from motionlang.analysis.sweeps.job import Result
from motionlang.analysis.sweeps.journal import Journal, OtherSweep, read
from motionlang.analysis.sweeps.space import dimension
from motionlang.cli.complaints import complain, no_dialect, unreadable, unwritten
from motionlang.cli.input_files import read_machine_file, read_source
from motionlang.cli.machine_options import set_values
from motionlang.cli.options import Options
from motionlang.cli.output_files import need_writer
from motionlang.cli.parser import Commands, add_command
from motionlang.cli.signals import SIGNALS
from motionlang.cli.sweep_options import EPILOG, add_options
from motionlang.cli.sweep_report import Report
from motionlang.cli.world_options import with_world, world_of
from motionlang.errors import Diagnostic, ProgramError, Terminated, need
from motionlang.execution import dialect_of, language_of, machine_of
from motionlang.files import unwritable
from motionlang.source import STDIN, Source
from motionlang.views.progress import Progress

OUT, PLOT = (".csv", ".parquet"), (".png", ".svg")
# The suffix of --rows-to for the rows of an incomplete sweep.
PARTIAL_SUFFIX = ".part"


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang sweep` and its options."""
    add_options(add_command(commands, "sweep", summary, sweep_command, EPILOG))


def sweep_command(arguments: argparse.Namespace) -> int:
    """Run the sweep, show its results, and return the exit status."""
    parser = arguments.parser
    problem = _wrong_files(arguments)
    if problem is not None:
        parser.error(problem)
    try:
        description = _description(arguments)
        made = _made(arguments, description)
    except OSError as error:
        complain([unreadable(str(error.filename or arguments.file), error)], None, arguments.file)
        return 1
    except ValueError as error:
        parser.error(str(error))
    if isinstance(made, int):
        return made
    sweep, report = made
    try:
        done = _earlier(arguments, sweep)
    except OtherSweep:
        why = "the program or the sweep has changed"
        what = f"{arguments.out}{PARTIAL_SUFFIX} has the rows of another sweep: {why}"
        complain([Diagnostic("file", what, hint="run without --resume to start again")], None, arguments.file)
        return 2
    return _run(arguments, sweep, report, done)


def _wrong_files(arguments: argparse.Namespace) -> str | None:
    """Return the error of the output files, if it can be detected beforehand."""
    for option, path, suffixes in (("--rows-to", arguments.out, OUT), ("--plot", arguments.plot, PLOT)):
        if path is None:
            continue
        suffix = os.path.splitext(path)[1].lower()
        if suffix not in suffixes:
            return f"{option} writes {' and '.join(suffixes)} files, not {suffix or path}"
        need_writer(option, path)
        problem = unwritable(path)
        if problem is not None:
            return problem
    if arguments.resume and arguments.out is None:
        return "--resume needs --rows-to, next to which the unfinished rows are stored"
    return None


def _description(arguments: argparse.Namespace) -> Description:
    """Return the options, completed by the description file next to the program."""
    default_path = os.path.splitext(arguments.file)[0] + SUFFIX
    if arguments.file != STDIN and os.path.isfile(default_path):
        try:
            description = read_description(default_path)
        except ProgramError as error:
            complain(error.diagnostics, Source.read(default_path), default_path)
            raise SystemExit(1) from None
    else:
        description = Description()
    if arguments.vary or arguments.machines or arguments.scenarios:
        description.dimensions = [dimension(each) for each in arguments.vary]
        description.machines, description.scenarios = arguments.machines, arguments.scenarios
    if arguments.random or arguments.latin:
        description.random, description.latin = arguments.random, arguments.latin
    if arguments.minimise or arguments.maximise or arguments.pareto:
        description.minimise, description.maximise = arguments.minimise, arguments.maximise
        description.pareto = arguments.pareto
    for name in ("seed", "until", "where"):
        if getattr(arguments, name) is not None:
            setattr(description, name, getattr(arguments, name))
    if arguments.keep is not None:
        description.keep = [each.strip() for each in arguments.keep.split(",") if each.strip()]
    description.prove = description.prove or arguments.prove
    description.certify = description.certify or arguments.certify
    for name in ("certify", "prove"):
        if getattr(description, name):
            need(f"--{name}", "numpy")
    if description.minimise is not None and description.maximise is not None:
        raise ValueError("give either --minimise or --maximise, not both")
    return description


def _made(arguments: argparse.Namespace, description: Description) -> tuple[Sweep, Report] | int:
    """Return the sweep and its report, or the exit status after a reported file error."""
    source = read_source(arguments.file)
    language = language_of(arguments.dialect, arguments.file)
    if language is None:
        complain([no_dialect(arguments.file)], None, arguments.file)
        return 2
    options = Options(arguments.file)
    options.dialect = arguments.dialect
    options.machine = machine_of(arguments.file, arguments.machine)
    set_values(arguments.set, options.settings, options.overrides, arguments.parser, language)
    settings = dict(options.settings)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    laid = with_world(settings, world_of(arguments), arguments.file)
    if laid is None:
        return 2
    settings = laid
    try:
        worlds = description.worlds()
        space = description.space(worlds)
        report = Report(description, space.names, tuple(description.keep) or KEEP)
        sweep = Sweep(
            source,
            space,
            keep=report.keep,
            dialect=arguments.dialect or dialect_of(arguments.file),
            machine=settings,
            overrides=options.overrides,
            worlds=worlds,
            until=description.until,
            prove=description.prove,
            certify=description.certify,
        )
    except ProgramError as error:
        complain(error.diagnostics, source, arguments.file)
        return 1
    return sweep, report


def _earlier(arguments: argparse.Namespace, sweep: Sweep) -> dict[int, Result]:
    """Return the rows of the sweep to resume, by variant number."""
    if not arguments.resume:
        return {}
    partial = arguments.out + PARTIAL_SUFFIX
    if not os.path.exists(partial):
        sys.stderr.write(f"{partial} does not exist: nothing to resume, so all {len(sweep)} variants run\n")
        return {}
    return {row[0]: row for row in read(partial, _digest(sweep)) if 0 <= row[0] < len(sweep)}


def _digest(sweep: Sweep) -> str:
    """Return the identity of a sweep: program, machine, results, and variants.

    The variants are represented by their number and by the first, middle and last of them.
    """
    count = len(sweep)
    return f"{sweep.job.digest} {count} {[sweep.space[n] for n in (0, count // 2, count - 1)]!r}"


def _run(arguments: argparse.Namespace, sweep: Sweep, report: Report, done: dict[int, Result]) -> int:
    journal, rows = None, done
    if arguments.out is not None:
        try:
            journal = Journal(arguments.out + PARTIAL_SUFFIX, _digest(sweep), resume=bool(done))
        except OSError as error:
            complain([unwritten(arguments.out + PARTIAL_SUFFIX, error)], None, arguments.file)
            return 1
    progress = Progress(sys.stderr, os.path.basename(arguments.file))
    ended = False
    results = sweep.results(jobs=arguments.jobs, done=frozenset(done))
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
        status = report.report(arguments, sweep, rows)
        if journal is not None:
            status = max(status, _finish(arguments, sweep, report, rows, journal))
    if ended:
        on = "; --resume continues" if journal is not None else ""
        sys.stderr.write(f"ended after {len(rows)} of {len(sweep)} variants{on}\n")
        return SIGNALS.status
    return status


def _finish(
    arguments: argparse.Namespace, sweep: Sweep, report: Report, rows: dict[int, Result], journal: Journal
) -> int:
    """Write --rows-to completely, and delete the journal if no variant remains."""
    from motionlang.views.sweep_files import write_rows

    try:
        write_rows(arguments.out, report.columns, report.cells(sweep, rows))
        if len(rows) == len(sweep):
            journal.remove()
        else:
            journal.close()
    except OSError as error:
        complain([unwritten(arguments.out, error)], None, arguments.file)
        return 1
    return 0
