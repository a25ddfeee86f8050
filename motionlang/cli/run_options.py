"""The options of `motionlang run`."""

from __future__ import annotations

import argparse
import math
import os
import sys
from typing import TYPE_CHECKING

from motionlang.cli.certify import certify_folder
from motionlang.cli.complaints import refuse
from motionlang.cli.event_status import ALLOWED
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.options import PLOTS, RATE, REPORTS, SERVO_RATE, TRACES, TRAJECTORY_RATE, Options
from motionlang.cli.output_files import refused, wrong_target
from motionlang.cli.parser import add_command, either
from motionlang.cli.run import run_command
from motionlang.cli.world_options import add_world, world_of
from motionlang.errors import need
from motionlang.execution import ONE_SHIFT

if TYPE_CHECKING:
    from motionlang.cli.parser import Commands

HIGHEST_RATE = 10e6
# The options that --show-code and --show-tree use; the others are about a run.
FOR_CODE = frozenset(("help", "file", "dialect", "machine", "set", "show_code", "show_tree", "no_cache"))
RUN_EPILOG = """\
The language is told by the suffix: .mnt .mntx .prg are Mint, .mcl .mccl are MCCL.
Time is the machine's own: an hour of it takes a moment, unless --realtime is given.

exit status: 0 the program ran; 1 it is wrong or faulted, or an axis met a limit, a following error or a fault that
nobody handled (standard error says where, --allow accepts it); 2 the command line is wrong

examples:
  motionlang run pick.mnt --until 60 --trace pick.csv --rate 500
  motionlang run pick.mcl --trace pick.csv --trajectory-points
  motionlang run pick.mnt --set controller.axes=2 --set pitch=5
  motionlang run pick.mnt --show-code
  generate-program | motionlang run - --dialect mint --report json
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang run` and its options."""
    parser = add_command(commands, "run", summary, _run, RUN_EPILOG)
    parser.add_argument("file", metavar="FILE", help="the program; - reads standard input")
    add_machine(parser)
    add_world(parser)
    parser.add_argument(
        "--report",
        choices=REPORTS,
        default="table",
        help="what follows the program's own output: a table (the default), or nothing; "
        "json prints one JSON document and nothing else",
    )
    parser.add_argument("--all", action="store_true", help="the table with every move, phase and line")
    parser.add_argument(
        "--until",
        type=machine_time,
        metavar="S",
        help="end the run after S seconds of machine time; without it the machine file says when, or it ends after "
        f"one shift, {ONE_SHIFT:.0f} s = 8 h",
    )
    parser.add_argument(
        "--realtime",
        type=_factor,
        nargs="?",
        const=1.0,
        metavar="FACTOR",
        help="hold the run to the wall clock, FACTOR machine seconds a second (1 without a FACTOR)",
    )
    parser.add_argument("--trace", metavar="OUT", help=f"sample the motion into a file: {either(TRACES)}")
    parser.add_argument(
        "--rate",
        type=_rate,
        metavar="HZ",
        help=f"samples a second of the trace ({RATE:g}; with --trajectory-points {SERVO_RATE:g})",
    )
    parser.add_argument(
        "--columns",
        type=_columns,
        metavar="NAME,…",
        help="what the trace has besides the time, such as position,velocity.0: of every axis, or of one",
    )
    parser.add_argument(
        "--trajectory-points",
        action="store_true",
        help="trace the points that the trajectory generator computes and the straight lines between them, "
        "which is what the servo loop is told, instead of the exact curve",
    )
    parser.add_argument(
        "--trajectory-rate",
        type=_rate,
        metavar="HZ",
        help=f"points a second of --trajectory-points ({TRAJECTORY_RATE:g}, as PMC's MultiFlex boards have)",
    )
    parser.add_argument("--plot", metavar="OUT", help=f"draw the motion into a file: {either(PLOTS)}")
    parser.add_argument(
        "--from",
        dest="begin",
        type=machine_time,
        metavar="S",
        help="the first second that the picture of --plot shows; an .html page has the rest, too",
    )
    parser.add_argument(
        "--to", dest="end", type=machine_time, metavar="S", help="the last second that it shows"
    )
    parser.add_argument(
        "--axes", type=_axes, metavar="N,…", help="the axes that it shows, such as 0,2 (all that moved)"
    )
    parser.add_argument(
        "--path",
        type=_path,
        metavar="X,Y",
        help="draw the path of two or three axes, its colour the speed, instead of curves over time",
    )
    parser.add_argument(
        "--nv",
        metavar="FILE",
        help="keep what the program declares nv, and NVLONG and NVFLOAT, in FILE from one run to the next",
    )
    parser.add_argument(
        "--log-size",
        metavar="GB",
        type=lambda text: _number(text, 0.0, 1e6, "a number of gigabytes, 0 or more"),
        help="how much the log of the run may take on the disk before it ends (8)",
    )
    parser.add_argument(
        "--allow",
        metavar="KIND,…",
        type=_allowed,
        default=frozenset(),
        help="events that do not make the exit status 1: limit, soft-limit, following-error, fault, or all",
    )
    parser.add_argument(
        "--prove",
        action="store_true",
        help="hold the motion against what the program ordered, and say what was proved; status 1 where it is not so",
    )
    parser.add_argument(
        "--paths",
        action="store_true",
        help="list the paths of several axes: length, speed along the path, corner, and why it stops there",
    )
    parser.add_argument(
        "--profile",
        action="store_true",
        help="tell where the time goes: by cause, line and sub, along the chain of what the end waited for",
    )
    parser.add_argument(
        "--profile-to",
        metavar="FILE",
        help="write that into FILE: .json, .trace.json (Perfetto) or .speedscope.json",
    )
    parser.add_argument(
        "--certify",
        action="store_true",
        help="hold what each axis reached against the [axis.N.limits] of the machine file: a table to sign; status 1 "
        "where one is passed. FILE may be a folder. It proves the motion, too",
    )
    parser.add_argument(
        "--show-code",
        action="store_true",
        help="run nothing: print the Python that a Mint program is compiled to, next to the lines of the program; "
        "of MCCL, which is interpreted, the function that carries out each command",
    )
    parser.add_argument(
        "--show-tree", action="store_true", help="print the syntax tree of the program; do not run it"
    )
    parser.add_argument("--no-cache", action="store_true", help="compile anew, and do not keep the result")


def run_options(arguments: argparse.Namespace, parser: argparse.ArgumentParser) -> Options:
    """Return the options of a `run` line."""
    options = Options(arguments.file)
    for name in (
        "dialect",
        "machine",
        "report",
        "until",
        "realtime",
        "trace",
        "plot",
        "nv",
        "prove",
        "paths",
        "profile",
        "profile_to",
        "certify",
        "allow",
        "log_size",
        "show_code",
        "show_tree",
    ):
        setattr(options, name, getattr(arguments, name))
    options.prove = options.prove or options.certify
    options.points = (arguments.trajectory_rate or TRAJECTORY_RATE) if arguments.trajectory_points else None
    options.rate = arguments.rate or (SERVO_RATE if arguments.trajectory_points else RATE)
    options.window = (arguments.begin or 0.0, arguments.end, arguments.axes, arguments.path)
    options.columns, options.everything = arguments.columns, arguments.all
    options.cache = not arguments.no_cache
    options.world = world_of(arguments)
    set_values(arguments.set, options.settings, options.overrides, parser)
    return options


def _run(arguments: argparse.Namespace) -> int:
    parser = arguments.parser
    check_options(arguments, parser)
    for name in ("certify", "prove", "paths"):
        if getattr(arguments, name):
            need(f"--{name}", "numpy")
    options = run_options(arguments, parser)
    written = (("--trace", options.trace), ("--plot", options.plot), ("--profile-to", options.profile_to))
    for option, path in written:
        if path is not None:
            problem = wrong_target(option, path)
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
    """Reject options without an effect."""
    if arguments.show_code or arguments.show_tree:
        shown = "--show-code" if arguments.show_code else "--show-tree"
        for action in parser._actions:
            if action.dest not in FOR_CODE and getattr(arguments, action.dest, None) != action.default:
                parser.error(f"{action.option_strings[0]} is about a run: {shown} runs nothing")
    if arguments.trace is None:
        for name in ("rate", "columns", "trajectory_points"):
            if getattr(arguments, name):
                parser.error(f"--{name.replace('_', '-')} is about a trace: give --trace OUT")
    if arguments.plot is None:
        for option, name in (("from", "begin"), ("to", "end"), ("axes", "axes"), ("path", "path")):
            if getattr(arguments, name) is not None:
                parser.error(f"--{option} is about a picture: give --plot OUT")
    elif arguments.end is not None and arguments.end <= (arguments.begin or 0.0):
        parser.error("--to is not after --from: there is nothing in between")
    if arguments.report != "table":
        for name in ("all", "paths", "profile"):
            if getattr(arguments, name):
                instead = ": --profile-to FILE writes the profile" if name == "profile" else ""
                parser.error(
                    f"--{name} is about the table, which --report {arguments.report} leaves out{instead}"
                )
    if arguments.trajectory_rate and not arguments.trajectory_points:
        parser.error("--trajectory-rate is about --trajectory-points, which is missing")


def _columns(text: str) -> list[str]:
    from motionlang.log.trace import quantity_of

    columns = [each.strip() for each in text.split(",")]
    try:
        for column in columns:
            quantity_of(column)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return columns


def _number(text: str, low: float, high: float, what: str, *, open_low: bool = False) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (low < value <= high or (value == low and not open_low)):
        raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
    return value


def machine_time(text: str) -> float:
    """Return a time of the machine, s, for argparse."""
    return _number(text, 0.0, sys.float_info.max, "a time in seconds, 0 or more")


def _allowed(text: str) -> frozenset[str]:
    names = frozenset(each.strip() for each in text.split(","))
    if names == {"all"}:
        return frozenset(ALLOWED)
    unknown = sorted(names - ALLOWED.keys())
    if unknown:
        raise argparse.ArgumentTypeError(f"{unknown[0]!r} is no event to allow: {', '.join(ALLOWED)} or all")
    return names


def _axes(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(each) for each in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of axes such as 0,2") from None


def _path(text: str) -> tuple[int, ...]:
    axes = _axes(text)
    if len(axes) not in (2, 3) or len(set(axes)) != len(axes):
        raise argparse.ArgumentTypeError(f"{text!r} is not a path: two or three axes make one, such as 0,1")
    return axes


def _rate(text: str) -> float:
    what = f"a number of samples a second above 0, {HIGHEST_RATE:,.0f} at most"
    return _number(text, 0.0, HIGHEST_RATE, what, open_low=True)


def _factor(text: str) -> float:
    return _number(
        text, 0.0, sys.float_info.max, "a factor above 0: --realtime 10 is ten times as fast", open_low=True
    )
