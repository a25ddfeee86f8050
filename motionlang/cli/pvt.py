"""`motionlang pvt`: points to motion, velocities, exports and streams for a drive.

`add_parser` registers the commands; each handler takes the parsed arguments and returns the exit status.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence

from motionlang.cli.output_files import need_writer
from motionlang.cli.parser import Commands, add_all, arrange, sentence
from motionlang.cli.pvt_input import Move, SourceError, UsageError, diagnose, read_move, spans_of
from motionlang.cli.pvt_options import INPUT, OPTIONS
from motionlang.errors import Diagnostic, ProgramError, count_of, need
from motionlang.files import reason
from motionlang.planners.curve import Profile
from motionlang.planners.pvt.points import Point, absolute, plan_points, relative, until_end
from motionlang.planners.pvt.velocities import compare_velocities, knot_accelerations
from motionlang.planners.total import total
from motionlang.source import Source

Handler = Callable[[argparse.Namespace], int]

OK, WRONG, USAGE = 0, 1, 2
SCHEMA = "motionlang.pvt/2"
NOISE = 1e-6
"""Counts below which a difference is rounding."""
GROUPS = {
    "points": "positions time scurve jerk accel speed velocities sweeps linear start",
    "fit to a program": "axis tolerance dialect",
    "output": "report plot output format compare",
}


def add_parser(family: Commands, summary: str) -> None:
    """Add `motionlang pvt` and its commands."""
    pvt = family.add_parser("pvt", help=summary, description=sentence(summary))
    commands = pvt.add_subparsers(
        dest="pvt_command", required=True, metavar="plot | refine | export | stream"
    )
    for name, help_text, handler in (
        ("plot", "show the motion that a drive makes of points, segment by segment, or as a picture", plot),
        ("refine", "choose velocities for positions, and show the remaining acceleration jumps", refine),
        ("export", "write a move, or the motion of a program, as CSV, serial words or CAN frames", export),
        ("stream", "send a move to a simulated drive over CANopen and compare the motion", stream),
    ):
        parser = commands.add_parser(name, help=help_text, description=sentence(help_text))
        add_all(parser, INPUT)
        OPTIONS[name](parser)
        arrange(parser, GROUPS)
        parser.set_defaults(command=_guarded(handler))


def plot(args: argparse.Namespace) -> int:
    """Print and draw the segments of the motion that a drive makes from the points."""
    from motionlang.views.pvt import segment_lines

    move = _checked(args, strict=False)
    profile = _planned(move.points, args.start)
    if args.format == "json":
        _print_json({"move": move.name, **_motion_json(move.points, args.start)})
    elif args.format == "table":
        _print(segment_lines(profile))
    if args.plot:
        _draw([profile], [move.name], args.plot)
    return OK


def refine(args: argparse.Namespace) -> int:
    """Compare methods for velocities; write the points with the chosen ones."""
    from motionlang.copley.table import write_points
    from motionlang.views.pvt import comparison_lines

    move = _checked(args, strict=False)
    moving = until_end(absolute(move.points, args.start or 0.0))
    positions, spans = [p.position for p in moving], spans_of(moving)
    try:
        rows = compare_velocities(positions, spans, args.compare)
    except (ValueError, OverflowError) as problem:
        raise ProgramError.of("range", str(problem)) from None
    if args.format == "json":
        table = [{"velocities": name, "largest_jump": jump, "values": v} for name, v, jump in rows]
        _print_json({"move": move.name, "methods": table})
    elif args.format == "table":
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
    """Write the move in the format of a drive, and print the rounding error."""
    from motionlang.copley.export import Unwritable
    from motionlang.copley.export import export as written
    from motionlang.copley.point import from_wire, to_wire

    move = _checked(args, strict=True)
    points = relative(move.points, args.start or 0.0) if args.relative else move.points
    try:
        made = written(to_wire(points), args.format, args.node)
    except Unwritable as problem:
        raise ProgramError.of("range", str(problem)) from None
    error, when = _error(move, from_wire(made.read_back), args.start or 0.0)
    span = total(p.time for p in points)
    worst = f"largest error {error:.3g} counts at {when:.3f} s" if error > NOISE else "no error"
    head = f"# {move.name}: {count_of(len(points) - 1, 'segment')}, {span:.3f} s, {worst}"
    _write(args.output, [head, *made.lines])
    if args.plot:
        _draw([_planned(from_wire(made.read_back), args.start)], [move.name], args.plot)
    return OK


def stream(args: argparse.Namespace) -> int:
    """Stream the move to a drive and print the result; MissingExtra without CAN."""
    need("motionlang pvt stream", "can", "canopen")
    from motionlang.cli.pvt_stream import run_stream

    move = _checked(args, strict=True)
    status = run_stream(args, move)
    if args.plot:
        _draw([_planned(move.points, args.start)], [move.name], args.plot)
    return status


# ------------------------------------------------------------------------------------------- input and output


def _guarded(handler: Handler) -> Handler:
    """Wrap a handler so that every user error is reported as a diagnostic."""

    def run(args: argparse.Namespace) -> int:
        if args.plot:
            need_writer("--plot", args.plot)
        try:
            return handler(args)
        except UsageError as problem:
            hint = "motionlang pvt --help lists the options"
            print(f"motionlang pvt: error: {problem}\n  hint: {hint}", file=sys.stderr)
            return USAGE
        except SourceError as error:
            _complain(error.diagnostics, error.source)
        except ProgramError as error:
            _complain(error.diagnostics, None)
        except OSError as error:
            if error.filename is None:  # of standard output: `main` reports it
                raise
            _complain([Diagnostic("file", f"{error.filename}: {reason(error)}")], None)
        return WRONG

    return run


def _checked(args: argparse.Namespace, *, strict: bool) -> Move:
    """Return the move and report its errors; `ProgramError` if they prevent it."""
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
        raise ProgramError.of("range", str(problem)) from None


def _replaced(points: Sequence[Point], velocities: Sequence[float]) -> list[Point]:
    from dataclasses import replace

    return [replace(p, velocity=v) for p, v in zip(points, velocities, strict=True)]


def _error(move: Move, sent: Sequence[Point], start: float) -> tuple[float, float]:
    """Return the largest position error of the sent motion, counts, and its time, s."""
    from motionlang.planners.pvt.fit import motion_error

    if move.track is not None:
        track = move.track
        return motion_error(track.starts, track.profiles, sent, track.begin, start)
    return motion_error([0.0], [_planned(move.points, start)], sent, 0.0, start)


def _motion_json(points: Sequence[Point], start: float | None) -> dict[str, object]:
    from motionlang.planners.pvt.points import knots, segments

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
    from motionlang.files import replacing

    with replacing(path) as file:
        file.write(text.encode("utf-8"))


def _print(lines: Sequence[str]) -> None:
    _write(None, lines)


def _print_json(content: dict[str, object]) -> None:
    print(json.dumps({"schema": SCHEMA, **content}, indent=2))
