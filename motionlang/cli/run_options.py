"""The options of `motionlang run`."""

from __future__ import annotations

import argparse
import os

from motionlang.cli.certify import certify_folder
from motionlang.cli.complaints import refuse
from motionlang.cli.event_status import ALLOWED
from motionlang.cli.format_options import add_format
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.numbers import machine_time, quantity_names, real
from motionlang.cli.options import CPU, PLOTS, RATE, REPORTS, SERVO_RATE, TRACES, TRAJECTORY_RATE, Options
from motionlang.cli.output_files import refused, wrong_target
from motionlang.cli.parser import Commands, add_all, add_command, arrange, either, flag, option
from motionlang.cli.run import run_command
from motionlang.cli.world_options import add_world, world_of
from motionlang.errors import need
from motionlang.execution import ONE_SHIFT, language_of

HIGHEST_RATE = 10e6
_RATE = real(
    f"a rate above 0 and up to {HIGHEST_RATE:,.0f} samples per second", 0.0, HIGHEST_RATE, above=True
)
# The options that --show-tree uses; the others are about a run.
FOR_TREE = frozenset(("help", "file", "dialect", "machine", "set", "show_tree"))
RUN_EPILOG = """\
The language is chosen by file extension: .mnt, .mntx and .prg are Mint, .mcl and .mccl are MCCL.
Time is machine time: an hour takes a moment, unless you give --realtime.

exit status: 0 success; 1 the program has an error or a fault, or an axis met an unhandled limit, following error or
fault (standard error has the line, --allow accepts it); 2 the command line is invalid

examples:
  motionlang run pick.mnt --until 60 --trace pick.csv --rate 500
  motionlang run pick.mcl --trace pick.csv --trajectory-points
  motionlang run pick.mnt --set controller.axes=2 --set pitch=5
  generate-program | motionlang run - --dialect mint --format json
"""

GROUPS = {
    "program": "dialect machine set",
    "report": "format quiet output all keep paths profile profile-to",
    "time": "until cpu realtime",
    "checks": "prove certify allow",
    "trace": "trace rate columns trajectory-points trajectory-rate",
    "pictures": "plot from to axes path",
    "syntax and files": "show-tree nv log-size",
}


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang run` and its options."""
    add_run(commands, "run", summary, RUN_EPILOG)


def add_run(
    commands: Commands,
    name: str,
    summary: str,
    epilog: str,
    *,
    what: str = "the program; - reads standard input",
    out: tuple[str, str] | None = None,
) -> argparse.ArgumentParser:
    """Add a command with the options of `run`.

    If `out` is given, the command has a second argument, which sets that option.
    """
    parser = add_command(commands, name, summary, _run, epilog)
    parser.add_argument("file", metavar="FILE", help=what)
    if out is not None:
        parser.add_argument(out[0], metavar="OUT", help=out[1])
    add_machine(parser)
    add_world(parser)
    add_format(parser, REPORTS, "the report after the program's output, which json replaces")
    add_all(parser, [row for row in _OPTIONS if out is None or row[0] != [f"--{out[0]}"]])
    arrange(parser, GROUPS)
    return parser


def _columns(text: str) -> list[str]:
    from motionlang.log.trace import quantity_of

    columns = [each.strip() for each in text.split(",")]
    try:
        for column in columns:
            quantity_of(column)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return columns


def _allowed(text: str) -> frozenset[str]:
    names = frozenset(each.strip() for each in text.split(","))
    if names == {"all"}:
        return frozenset(ALLOWED)
    unknown = sorted(names - ALLOWED.keys())
    if unknown:
        raise argparse.ArgumentTypeError(
            f"{unknown[0]!r} is no event that a run can accept: choose from {', '.join(ALLOWED)} or all"
        )
    return names


def _axes(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(each) for each in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of axes such as 0,2") from None


def _path(text: str) -> tuple[int, ...]:
    axes = _axes(text)
    if len(axes) not in (2, 3) or len(set(axes)) != len(axes):
        raise argparse.ArgumentTypeError(f"{text!r} is not a path: give two or three axes, such as 0,1")
    return axes


_OPTIONS = (
    flag("--all", "list every move, phase and line in the table"),
    option("--until", "S", "end the run after S seconds of machine time; default: run.until of the machine file, or "
           f"{ONE_SHIFT:.0f} s = 8 h", machine_time),
    option("--cpu", "S", "end the run after S seconds of processor time if neither --until nor run.until ends it "
           f"({CPU:.10g}); 0 means no limit", real("a number of seconds, 0 or more", 0.0, 1e9), default=CPU),
    option("--realtime", "FACTOR", "run at FACTOR × real time; FACTOR defaults to 1",
           real("a factor above 0: --realtime 10 is ten times as fast", 0.0, above=True), nargs="?", const=1.0),
    option("--trace", "OUT", f"sample the motion into a file: {either(TRACES)}"),
    option("--rate", "HZ", f"samples per second of the trace ({RATE:.10g}; with --trajectory-points {SERVO_RATE:.10g})",
           _RATE),
    option("--columns", "NAME,…", "columns of the trace in addition to time, for every axis or for one, such as "
           "position,velocity.0", _columns),
    flag("--trajectory-points", "trace the controller's trajectory points, joined by straight lines, as the servo "
         "loop receives them, instead of the exact curve"),
    option("--trajectory-rate", "HZ", f"trajectory points per second ({TRAJECTORY_RATE:.10g}, as on PMC's MultiFlex "
           "boards)", _RATE),
    option("--plot", "OUT", f"draw the motion into a file: {either(PLOTS)}"),
    option("--from", "S", "start of the time span that --plot shows, s; an .html page also has the rest",
           machine_time, dest="begin"),
    option("--to", "S", "end of the time span that --plot shows, s", machine_time, dest="end"),
    option("--axes", "N,…", "the axes that --plot shows, such as 0,2; default: all that moved", _axes),
    option("--path", "X,Y", "draw the path of two or three axes, coloured by speed, instead of curves over time",
           _path),
    option("--nv", "FILE", "keep nv variables, NVLONG and NVFLOAT in FILE between runs"),
    option("--log-size", "GB", "disk space that the log may take before the run ends, GB (8)",
           real("a number of gigabytes, 0 or more", 0.0, 1e6)),
    option("--allow", "KIND,…", "events that do not make the exit status 1: limit, soft-limit, following-error, fault "
           "or all", _allowed, default=frozenset()),
    flag("--prove", "verify the motion against the commanded limits; exit 1 on a violation"),
    option("--keep", "NAME,…", "quantities to report, such as peak.0 or cycle(12), the median time between moves of "
           "line 12; motionlang sweep --help lists all", quantity_names, default=()),
    flag("--paths", "list the paths of several axes: length, path speed, corner angle and the reason for each stop"),
    flag("--profile", "show where the time goes, by cause, line and sub, along the critical path"),
    option("--profile-to", "FILE", "write the time profile into FILE: .json, or .speedscope.json, which speedscope "
           "and Perfetto open"),
    flag("--certify", "check what each axis reached against [axis.N.limits] of the machine file and print a table to "
         "sign; exit 1 if a limit is exceeded. FILE may be a folder. Includes --prove"),
    flag("--show-tree", "print the syntax tree of the program; do not run it"),
)  # fmt: skip


def run_options(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> Options:
    """Return the options of a `run` line."""
    options = Options(arguments.file)
    for name in vars(options).keys() & vars(arguments).keys():
        setattr(options, name, getattr(arguments, name))
    options.prove = options.prove or options.certify
    options.points = (arguments.trajectory_rate or TRAJECTORY_RATE) if arguments.trajectory_points else None
    options.rate = arguments.rate or (SERVO_RATE if arguments.trajectory_points else RATE)
    options.window = (arguments.begin or 0.0, arguments.end, arguments.axes, arguments.path)
    options.columns, options.everything = arguments.columns, arguments.all
    options.report = arguments.format
    options.world = world_of(arguments)
    language = language_of(options.dialect, options.file)
    set_values(arguments.set, options.settings, options.overrides, parser, language)
    return options


def _run(arguments: argparse.Namespace) -> int:
    parser = arguments.parser
    check_options(arguments, parser)
    for name in ("certify", "prove", "paths"):
        if getattr(arguments, name):
            need(f"--{name}", "numpy")
    options = run_options(arguments, parser)
    written = (("--trace", options.trace), ("--plot", options.plot), ("--profile-to", options.profile_to))
    for name, path in written:
        if path is not None:
            problem = wrong_target(name, path)
            if problem is not None:
                parser.error(problem)
            diagnostic = refused(path, options)
            if diagnostic is not None:
                return refuse(options, [diagnostic], None, 1)
    options.given = arguments.given
    if options.certify and os.path.isdir(options.file):
        return certify_folder(options.file, options)
    return run_command(options)


def check_options(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> None:
    """Reject options that would have no effect."""
    if arguments.show_tree:
        for action in parser._actions:
            if action.dest not in FOR_TREE and getattr(arguments, action.dest, None) != action.default:
                parser.error(f"{action.option_strings[0]} has no effect with --show-tree, which runs nothing")
    if arguments.trace is None:
        for name in ("rate", "columns", "trajectory_points"):
            if getattr(arguments, name):
                parser.error(f"--{name.replace('_', '-')} needs --trace OUT")
    if arguments.plot is None:
        for spelling, name in (("from", "begin"), ("to", "end"), ("axes", "axes"), ("path", "path")):
            if getattr(arguments, name) is not None:
                parser.error(f"--{spelling} needs --plot OUT")
    elif arguments.end is not None and arguments.end <= (arguments.begin or 0.0):
        parser.error("--to must be after --from")
    if arguments.format != "table":
        for name in ("all", "paths", "profile"):
            if getattr(arguments, name) and (name, arguments.format) != ("profile", "json"):
                parser.error(f"--{name} needs the table, which --format {arguments.format} omits")
    if arguments.trajectory_rate and not arguments.trajectory_points:
        parser.error("--trajectory-rate needs --trajectory-points")
