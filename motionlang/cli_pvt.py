"""`motionlang pvt`: points to motion, velocities for points, exports for a drive, and a stream to a simulated one.

`add_parser` registers the commands; each handler takes the parsed arguments and returns the exit status.
"""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING

from motionlang.cli_pvt_input import Move, SourceError, UsageError, diagnose, read_move, spans_of
from motionlang.errors import Diagnostic, ProgramError
from motionlang.profile.pvt_points import absolute, plan_points, relative, until_end
from motionlang.profile.pvt_velocities import METHODS, compare_velocities, knot_accelerations

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Sequence
    from typing import TypeVar

    from motionlang.profile.curve import Profile
    from motionlang.profile.pvt_points import Point
    from motionlang.source import Source

    _N = TypeVar("_N", int, float)
    Handler = Callable[[argparse.Namespace], int]

OK, WRONG, USAGE = 0, 1, 2
SCHEMA = "motionlang.pvt/1"


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Register `pvt` and its commands; the chosen handler is `args.handler`."""
    pvt = subparsers.add_parser("pvt", help="position-velocity-time moves for Copley drives")
    commands = pvt.add_subparsers(
        dest="pvt_command", required=True, metavar="plot | refine | export | stream"
    )
    for name, help_text, handler in (
        ("plot", "what a drive makes of points, segment by segment, and as a picture", plot),
        ("refine", "velocities for positions, and the acceleration jumps they leave", refine),
        ("export", "a move, or the motion of a program, as CSV, serial words or CAN frames", export),
        ("stream", "send a move to a simulated drive over CANopen and compare the motion", stream),
    ):
        parser = commands.add_parser(name, help=help_text, description=help_text)
        _add_input(parser)
        _OPTIONS[name](parser)
        parser.set_defaults(handler=_guarded(handler))


def plot(args: argparse.Namespace) -> int:
    """Print the segments of the motion that a drive makes of the points, and draw it."""
    from motionlang.views.pvt import segment_lines

    move = _checked(args, strict=False)
    profile = _planned(move.points, args.start)
    if args.report == "json":
        _print_json({"move": move.name, **_motion_json(move.points, args.start)})
    elif args.report == "table":
        _print(segment_lines(profile))
    if args.plot:
        _draw([profile], [move.name], args.plot)
    return OK


def refine(args: argparse.Namespace) -> int:
    """Print the ways to choose velocities side by side; write the points with the chosen ones."""
    from motionlang.copley.table import write_points
    from motionlang.views.pvt import comparison_lines

    move = _checked(args, strict=False)
    moving = until_end(absolute(move.points, args.start or 0.0))
    positions, spans = [p.position for p in moving], spans_of(moving)
    try:
        rows = compare_velocities(positions, spans, args.compare)
    except (ValueError, OverflowError) as problem:
        raise ProgramError([Diagnostic("range", str(problem))]) from None
    if args.report == "json":
        table = [{"velocities": name, "largest_jump": jump, "values": v} for name, v, jump in rows]
        _print_json({"move": move.name, "methods": table})
    elif args.report == "table":
        sides = knot_accelerations(positions, rows[0][1], spans)
        _print(comparison_lines(rows, [a for pair in sides for a in pair]))
    if args.output:
        _write(args.output, write_points(moving))
    if args.plot:
        _draw(
            [plan_points(_replaced(moving, v)) for _, v, _ in rows], [name for name, _, _ in rows], args.plot
        )
    return OK


def export(args: argparse.Namespace) -> int:
    """Write the move in a format for a drive, with the error that the format's rounding leaves."""
    from motionlang.copley.export import Unwritable
    from motionlang.copley.export import export as written
    from motionlang.copley.point import from_wire, to_wire

    move = _checked(args, strict=True)
    points = relative(move.points, args.start or 0.0) if args.relative else move.points
    try:
        made = written(to_wire(points), args.format, args.node)
    except Unwritable as problem:
        raise ProgramError([Diagnostic("range", str(problem))]) from None
    error, when = _error(move, from_wire(made.read_back), args.start or 0.0)
    span = sum(p.time for p in points)
    head = f"# {move.name}: {len(points) - 1} segments, {span:.3f} s, largest error {error:.3g} counts at {when:.3f} s"
    _write(args.output, [head, *made.lines])
    if args.plot:
        _draw([_planned(from_wire(made.read_back), args.start)], [move.name], args.plot)
    return OK


def stream(args: argparse.Namespace) -> int:
    """Stream the move to a drive and print what came of it."""
    from motionlang.cli_pvt_stream import run_stream

    move = _checked(args, strict=True)
    status = run_stream(args, move)
    if args.plot:
        _draw([_planned(move.points, args.start)], [move.name], args.plot)
    return status


# ------------------------------------------------------------------------------------------------ arguments


def _add_input(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "file", nargs="?", help="points (.csv: position, velocity, time), or a program whose motion is fitted"
    )
    add("--positions", type=_numbers, metavar="P,P,…", help="points instead of a file, counts")
    add(
        "--time",
        type=_numbers,
        metavar="MS[,MS…]",
        help="milliseconds between two points, or of each segment",
    )
    add("--scurve", type=_number, metavar="COUNTS", help="an S-curve of this distance instead of a file")
    add("--jerk", type=_positive, metavar="J", help="its jerk, counts/s3 (or --time, of its four segments)")
    add("--accel", type=_positive, metavar="A", help="its largest acceleration, counts/s2")
    add("--speed", type=_positive, metavar="V", help="its largest velocity, counts/s")
    add("--velocities", choices=["given", *METHODS], help="choose the velocities anew")
    add("--sweeps", type=_count, metavar="N", help="how often refine goes through the points")
    add("--linear", action="store_true", help="leave out the velocities: linear interpolation")
    add("--start", type=_number, metavar="COUNTS", help="where the motor stands before the move")
    add("--axis", type=int, metavar="N", help="of a program: the axis to fit")
    add(
        "--tolerance",
        type=_positive,
        metavar="COUNTS",
        help="of a program: how closely to fit it",
    )
    add("--dialect", choices=["mint", "mccl"], help="of a program: its language")
    add(
        "--plot", type=_picture, metavar="OUT", help="draw the motion with its knots into a .png or .svg file"
    )


def _add_plot(parser: argparse.ArgumentParser) -> None:
    _add_report(parser)


def _add_refine(parser: argparse.ArgumentParser) -> None:
    _add_report(parser)
    parser.add_argument(
        "--compare", type=_counts, default=[1, 2], metavar="N,N…", help="numbers of sweeps to show"
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="write the points with their velocities as CSV"
    )


def _add_export(parser: argparse.ArgumentParser) -> None:
    formats = ["csv", "serial", "pdo", "sdo", "record"]
    parser.add_argument("--format", choices=formats, default="csv", help="what to write (csv)")
    parser.add_argument("--relative", action="store_true", help="write distances instead of positions")
    parser.add_argument("--node", type=_node, default=1, metavar="ID", help="CANopen node of the drive (1)")
    parser.add_argument("-o", "--output", metavar="FILE", help="write to a file instead of standard output")


def _add_stream(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    _add_report(parser)
    add(
        "--by",
        default="pdo",
        choices=["pdo", "sdo", "0", "-1", "-2", "-3"],
        help="object 0x2010, or a sub-mode",
    )
    add("--node", type=_node, default=1, metavar="ID", help="CANopen node of the drive (1)")
    add(
        "--look",
        type=_positive,
        default=1.0,
        metavar="MS",
        help="milliseconds between two looks of the master",
    )
    add("--relative", action="store_true", help="send distances instead of positions")
    add("--interface", default="virtual", metavar="NAME", help="python-can interface (virtual)")
    add("--channel", default="", metavar="NAME", help="its channel, vcan0 for instance")
    add("--real", action="store_true", help="a real drive answers on the bus: simulate none, move it")


def _add_report(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--report", choices=["table", "json", "none"], default="table")


_OPTIONS: dict[str, Callable[[argparse.ArgumentParser], None]] = {
    "plot": _add_plot,
    "refine": _add_refine,
    "export": _add_export,
    "stream": _add_stream,
}


def _numbers(text: str) -> list[float]:
    """Numbers with commas between them; what they may be is for the points to say, by index."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise _refused(text, "numbers with commas between them") from None


def _number(text: str) -> float:
    return _between(text, float, -1e300, 1e300)


def _positive(text: str) -> float:
    return _between(text, float, 1e-9, 1e300)


def _picture(text: str) -> str:
    if not text.lower().endswith((".png", ".svg")):
        raise _refused(text, "a .png or an .svg file")
    return text


def _counts(text: str) -> list[int]:
    return [_count(part) for part in text.split(",")]


def _count(text: str) -> int:
    return _between(text, int, 1, 1000)


def _node(text: str) -> int:
    return _between(text, int, 1, 127)


def _between(text: str, kind: Callable[[str], _N], least: _N, most: _N) -> _N:
    try:
        value = kind(text)
    except ValueError:
        raise _refused(text, "a number") from None
    if not least <= value <= most:
        raise _refused(text, f"from {least:g} to {most:g}")
    return value


def _refused(text: str, wanted: str) -> Exception:
    from argparse import ArgumentTypeError

    return ArgumentTypeError(f"{text!r} is not {wanted}")


# ------------------------------------------------------------------------------------------------ in and out


def _guarded(handler: Handler) -> Handler:
    """The handler with every mistake of a user answered as a diagnostic."""

    def run(args: argparse.Namespace) -> int:
        try:
            return handler(args)
        except UsageError as problem:
            print(f"motionlang pvt: {problem}", file=sys.stderr)
            return USAGE
        except SourceError as error:
            _complain(error.diagnostics, error.source)
        except ProgramError as error:
            _complain(error.diagnostics, None)
        except OSError as error:
            _complain([Diagnostic("file", f"{error.filename or args.file}: {error.strerror or error}")], None)
        except ImportError as error:
            extra = "plot" if "matplotlib" in str(error) else "can"
            hint = f"install motionlang with the extra {extra}"
            _complain([Diagnostic("file", f"{error.name} is not installed", hint=hint)], None)
        return WRONG

    return run


def _checked(args: argparse.Namespace, *, strict: bool) -> Move:
    """The move, its troubles told; `ProgramError` where they do not allow to go on."""
    move = read_move(args)
    found = diagnose(move, args.start, strict=strict)
    if any(d.severity == "error" for d in found):
        raise SourceError(move.source, found) if move.source else ProgramError(found)
    _complain(found, move.source)
    return move


def _planned(points: Sequence[Point], start: float | None) -> Profile:
    try:
        return plan_points(points, start or 0.0)
    except (ValueError, OverflowError) as problem:
        raise ProgramError([Diagnostic("range", str(problem))]) from None


def _replaced(points: Sequence[Point], velocities: Sequence[float]) -> list[Point]:
    from dataclasses import replace

    return [replace(p, velocity=v) for p, v in zip(points, velocities, strict=True)]


def _error(move: Move, sent: Sequence[Point], start: float) -> tuple[float, float]:
    """How far the motion that is sent departs from the one that was meant, counts, and when."""
    from motionlang.profile.pvt_fit import motion_error

    if move.track is not None:
        track = move.track
        return motion_error(track.starts, track.profiles, sent, track.begin, start)
    return motion_error([0.0], [_planned(move.points, start)], sent, 0.0, start)


def _motion_json(points: Sequence[Point], start: float | None) -> dict[str, object]:
    from motionlang.profile.pvt_points import knots, segments

    profile = _planned(points, start)
    return {
        "duration": profile.duration,
        "knots": [
            {
                "time": k.time,
                "position": k.position,
                "velocity": k.velocity,
                "acceleration_before": k.acceleration,
                "acceleration_after": k.next_acceleration,
                "jump": k.jump,
            }
            for k in knots(profile)
        ],
        "segments": [
            {"time": s.duration, "jerk": s.jerk, "acceleration": s.acceleration, "to": s.end_acceleration}
            for s in segments(profile)
        ],
    }


def _draw(profiles: Sequence[Profile], titles: Sequence[str], path: str) -> None:
    from motionlang.views.pvt_plot import write_pvt_plot

    write_pvt_plot(profiles, titles, path)


def _complain(diagnostics: Sequence[Diagnostic], source: Source | None) -> None:
    from motionlang.views.diagnostics import render

    for diagnostic in diagnostics:
        sys.stderr.write(render(diagnostic, source if diagnostic.line else None))


def _write(path: str | None, lines: Sequence[str]) -> None:
    text = "\n".join(lines) + "\n"
    if path is None or path == "-":
        sys.stdout.write(text)
        return
    from motionlang.views.files import replacing

    with replacing(path) as file:
        file.write(text.encode("utf-8"))


def _print(lines: Sequence[str]) -> None:
    _write(None, lines)


def _print_json(content: dict[str, object]) -> None:
    print(json.dumps({"schema": SCHEMA, **content}, indent=2))
