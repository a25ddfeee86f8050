"""`motionlang compare`: compare a real controller's recording with the run."""

from __future__ import annotations

import argparse
import json
import sys
from math import inf
from sys import float_info
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain, no_dialect, unreadable
from motionlang.cli.format_options import add_format
from motionlang.cli.input_files import read_machine_file, read_source
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.numbers import machine_time, real
from motionlang.cli.options import Options
from motionlang.cli.output_files import written
from motionlang.cli.parser import add_all, add_command, arrange, flag, option
from motionlang.cli.signals import SIGNALS
from motionlang.errors import ProgramError
from motionlang.execution import language_of, machine_of, run

if TYPE_CHECKING:
    from motionlang.analysis.compare.comparison import Comparison, Mapped
    from motionlang.cli.parser import Commands
    from motionlang.result import Run

GROUPS = {
    "program": "dialect machine set until",
    "recording": "map delay",
    "report": "format output all tolerance",
    "pictures": "plot",
}
EPILOG = """\
Use --map to assign the columns of the recording: one to time, the others to a quantity and an axis. *FACTOR converts a
column to seconds or user units. Columns with the names of --trace need no --map. The delay is fitted by least squares;
scale, offset and lag are reported but not removed.

exit status: 0 within the tolerance; 1 tolerance exceeded, or nothing to compare; 2 the command line is invalid

examples:
  motionlang compare pick.mnt drive.csv --map time=t*0.001 --map position.0=PosAct --tolerance position=0.05uu
  motionlang compare pick.mnt scope.txt --map position.0=3 --map velocity.0=4 --plot both.html
"""


def _mapped(text: str) -> Mapped:
    from motionlang.analysis.compare.comparison import Mapped

    what, equals, column = text.partition("=")
    name, star, factor = column.rpartition("*")
    if not equals or not column:
        raise argparse.ArgumentTypeError(f"{text!r} is not WHAT=COLUMN, such as position.0=PosAct")
    if not star:
        return Mapped(what.strip(), column.strip(), None)
    try:
        return Mapped(what.strip(), name.strip(), float(factor))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r}: {factor!r} is not a number to multiply by") from None


def _tolerance(text: str) -> tuple[str, float]:
    what, equals, size = text.rpartition("=")
    try:
        value = float(size.removesuffix("/s").removesuffix("uu"))
    except ValueError:
        value = -1.0
    if not 0.0 <= value < inf:
        raise argparse.ArgumentTypeError(f"{text!r} is not a tolerance such as position=0.05uu")
    return (what.strip() if equals else "position"), value


_OPTIONS = (
    option("--tolerance", "WHAT=SIZE", "the largest residual allowed: position=0.05uu for every axis, "
           "position.0=0.05uu for one; may be repeated", _tolerance, action="append", default=[]),
    option("--until", "S", "end the run after S seconds of machine time", machine_time),
    option("--plot", "PAGE", "draw both into an .html page"),
    flag("--all", "list every move with its phases"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang compare` and its options."""
    parser = add_command(commands, "compare", summary, _command, EPILOG)
    parser.add_argument("file", metavar="FILE", help="the program")
    parser.add_argument("recording", metavar="CSV", help="the recording, in columns; - reads standard input")
    add_machine(parser)
    add_mapping(parser)
    add_all(parser, _OPTIONS)
    add_format(parser)
    arrange(parser, GROUPS)


_MAPPING = (
    option("--map", "WHAT=COLUMN", "assign a column, by name or number, to time, position.0, velocity.1 …; may be "
           "repeated", _mapped, action="append", default=[]),
    option("--delay", "S", "the delay of the recording behind the run, s; default: fitted",
           real("a number of seconds", -float_info.max)),
)  # fmt: skip


def add_mapping(parser: argparse.ArgumentParser) -> None:
    """Add the options for the columns of a recording and for its delay."""
    add_all(parser, _MAPPING)


def _command(arguments: argparse.Namespace) -> int:
    parser = arguments.parser
    if arguments.plot is not None and not arguments.plot.lower().endswith(".html"):
        parser.error("--plot writes .html files here")
    result = _ran(arguments, parser)
    if result is None:
        return 1
    return compare_with(result, arguments.recording, dict(arguments.tolerance), arguments)


def compare_with(result: Run, path: str, tolerances: dict[str, float], arguments: argparse.Namespace) -> int:
    """Compare a recording with a run, print the result, and return the exit status.

    The other arguments are `map`, `delay`, `plot`, `all` and `json`, as in `compare` and `diff`.
    """
    from motionlang.analysis.compare.comparison import compare

    try:
        recording = read_source(path)
    except OSError as error:
        complain([unreadable(path, error)], None, path)
        return 1
    try:
        made = compare(result, recording, arguments.map, tolerances=tolerances, delay=arguments.delay)
    except ProgramError as error:
        complain(error.diagnostics, recording, path)
        return 1
    _show(made, arguments)
    complain(made.remarks, recording, path)
    status = _plot(made, arguments.plot) if arguments.plot is not None else 0
    return 1 if made.is_within is False else status


def _ran(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> Run | None:
    """Return the run, or None if there is none to compare with."""
    settings: dict[str, object] = {}
    overrides: dict[str, float | str] = {}
    language = language_of(arguments.dialect, arguments.file)
    set_values(arguments.set, settings, overrides, parser, language)
    if language is None:
        complain([no_dialect(arguments.file)], None, arguments.file)
        return None
    options = Options(arguments.file)
    options.dialect = arguments.dialect
    options.machine = machine_of(arguments.file, arguments.machine)
    if options.machine is not None and read_machine_file(options, settings):
        return None
    try:
        source = read_source(arguments.file)
    except OSError as error:
        complain([unreadable(arguments.file, error)], None, arguments.file)
        return None
    result = run(
        source, dialect=arguments.dialect, machine=settings, overrides=overrides, until=arguments.until
    )
    complain(result.diagnostics, result.source, arguments.file)
    SIGNALS.end_with(result)
    return result if result.time > 0.0 else None


def _show(made: Comparison, arguments: argparse.Namespace) -> None:
    if arguments.format == "json":
        sys.stdout.write(json.dumps(made.report(), indent=1) + "\n")
        return
    from motionlang.views.comparison import render_comparison
    from motionlang.views.terminal import draws, plain, table_width, wants_colour

    width = table_width(sys.stdout)
    text = render_comparison(made, width=width, colour=wants_colour(sys.stdout), everything=arguments.all)
    sys.stdout.write(text if draws(sys.stdout) else plain(text))


def _plot(made: Comparison, path: str) -> int:
    from motionlang.views.scope import write_comparison

    return written(path, lambda: write_comparison(made, path))
