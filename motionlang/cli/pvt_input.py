"""The input of `motionlang pvt`: a file, positions, an S-curve, or a program."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf

from motionlang.cli.input_files import read_source
from motionlang.cli.signals import SIGNALS
from motionlang.copley.point import check_points
from motionlang.errors import Diagnostic, ProgramError
from motionlang.log.track import WholeTrack
from motionlang.planners.curve import Profile
from motionlang.planners.pvt.points import Point, absolute, points_from, split_long, until_end
from motionlang.planners.pvt.velocities import pvt_velocities
from motionlang.source import Source

GRID = 0.001
MAX_REPORTED = 20
TOLERANCE = 1.0
NAMES = {
    "table": "a file of points",
    "program": "a program",
    "positions": "--positions",
    "scurve": "--scurve",
}
# Each option and the kinds of input that it applies to.
SERVES: dict[str, tuple[str, ...]] = {
    "time": ("positions", "scurve", "table"),
    "jerk": ("scurve",),
    "accel": ("scurve",),
    "speed": ("scurve",),
    "velocities": ("positions", "scurve", "table"),
    "axis": ("program",),
    "tolerance": ("program",),
    "dialect": ("program",),
}


@dataclass(slots=True)
class Move:
    """Points and their source; for a program also the motion that they were fitted to.

    `lines` are the line numbers in the source.
    """

    name: str
    points: list[Point]
    source: Source | None = None
    lines: Sequence[int] = ()
    track: Track | None = None


@dataclass(slots=True)
class Track:
    """The motion of one axis between two times, to which points are fitted."""

    starts: list[float]
    profiles: list[Profile]
    begin: float
    end: float


def read_move(args: argparse.Namespace) -> Move:
    """Return the move of the command line; may raise `ProgramError` and OSError."""
    given = [name for name in ("file", "positions", "scurve") if getattr(args, name) is not None]
    if len(given) != 1:
        raise UsageError("give one of: a file of points or a program, --positions, --scurve")
    _refuse_strangers(args, given[0])
    if args.positions is not None:
        move = _from_positions(args)
    elif args.scurve is not None:
        move = _from_scurve(args)
    else:
        move = _from_file(args)
    if args.velocities:
        _choose_velocities(move, args.velocities, args.sweeps or 1)
    if args.linear:
        move.points = [replace(point, velocity=None) for point in move.points]
    return move


class UsageError(Exception):
    """The command line contradicts itself."""


def _refuse_strangers(args: argparse.Namespace, source: str) -> None:
    """Reject an option that would have no effect."""
    if source == "file":
        source = "program" if _is_program(args.file) else "table"
    for option, sources in SERVES.items():
        if getattr(args, option) is not None and source not in sources:
            homes = " or ".join(NAMES[name] for name in sources)
            raise UsageError(f"--{option} has no effect here: it needs {homes}")
    if args.sweeps is not None and args.velocities != "refine":
        raise UsageError("--sweeps has no effect here: it needs --velocities refine")
    if args.linear and args.velocities:
        raise UsageError("--linear omits the velocities that --velocities chooses")


def _is_program(file: str) -> bool:
    return os.path.splitext(file)[1].lower() not in (".csv", ".txt", "")


def diagnose(move: Move, start: float | None, *, strict: bool) -> list[Diagnostic]:
    """Return as diagnostics what a drive would misinterpret.

    They are errors if the points must be sent as they are (`strict`), else warnings.
    """
    found = []
    troubles = check_points(move.points, start)
    for bad in troubles[:MAX_REPORTED]:
        line = move.lines[bad.index] if bad.index < len(move.lines) else 0
        severity = "error" if bad.severe and strict else "warning"
        message = f"point {bad.index}: {bad.reason}" if move.points else bad.reason
        found.append(Diagnostic("range", message, line, hint=bad.consequence, severity=severity))
    if len(troubles) > MAX_REPORTED:
        rest = f"{len(troubles) - MAX_REPORTED} more points like these"
        found.append(Diagnostic("range", rest, severity=found[-1].severity))
    return found


def _from_positions(args: argparse.Namespace) -> Move:
    if args.time is None:
        raise UsageError("--positions needs --time, the milliseconds between two points")
    if len(args.positions) < 2:
        raise UsageError("--positions needs at least two positions")
    times = args.time if len(args.time) > 1 else args.time * (len(args.positions) - 1)
    if len(times) != len(args.positions) - 1:
        wanted = "1 time" if len(args.positions) == 2 else f"1 or {len(args.positions) - 1} times"
        raise UsageError(f"{len(args.positions)} positions need {wanted}, not {len(times)}")
    spans = [time / 1000.0 for time in times]
    velocities = _velocities(args.positions, spans, args.velocities or "exact", args.sweeps or 1)
    return Move("points", points_from(args.positions, velocities, spans))


def _from_scurve(args: argparse.Namespace) -> Move:
    from motionlang.planners.pvt.scurve import limited_scurve, scurve

    if (args.time is None) == (args.jerk is None):
        either = "needs" if args.time is None else "takes either"
        raise UsageError(f"--scurve {either} --time (of one of its four segments, ms) or --jerk (counts/s³)")
    limits = args.accel or inf, args.speed or inf
    try:
        if args.time is not None:
            if limits != (inf, inf) or len(args.time) != 1:
                raise UsageError(
                    "--scurve with --time has four equal segments: no --accel, no --speed, one time"
                )
            points = scurve(args.scurve, args.time[0] / 1000.0)
        else:
            points = split_long(limited_scurve(args.scurve, args.jerk, *limits, grid=GRID))
    except ArithmeticError:
        raise ProgramError.of("range", "no finite move is possible within these limits") from None
    except ValueError as problem:
        raise ProgramError.of("range", str(problem)) from None
    return Move(f"S-curve, {args.scurve:.10g} counts", points)


def _from_file(args: argparse.Namespace) -> Move:
    if _is_program(args.file):
        return _from_program(args)
    from motionlang.copley.table import read_points

    source = read_source(args.file)
    try:
        table = read_points(source)
    except ProgramError as error:
        raise SourceError(source, error.diagnostics) from None
    points = table.points
    if "time" not in table.has:
        if args.time is None or len(args.time) != 1:
            raise UsageError(f"{source.name} has no times: give --time, the milliseconds between two points")
        points = [replace(p, time=args.time[0] / 1000.0) for p in points[:-1]] + [
            replace(points[-1], time=0.0)
        ]
    elif args.time is not None:
        raise UsageError(f"{source.name} has its own times: --time has no effect")
    move = Move(source.name, points, source, table.lines)
    if "velocity" not in table.has and not args.velocities:
        _choose_velocities(move, "exact", args.sweeps or 1)
    return move


class SourceError(Exception):
    """Errors in an input file, with its path."""

    def __init__(self, source: Source, diagnostics: list[Diagnostic]) -> None:
        super().__init__(source.name)
        self.source, self.diagnostics = source, diagnostics


def _from_program(args: argparse.Namespace) -> Move:
    """Run the program and fit the motion of one axis."""
    from motionlang.execution import run
    from motionlang.planners.pvt.fit import OutOfTolerance, fit_track, least_tolerance

    try:
        result = run(args.file, dialect=args.dialect)
    except ValueError as problem:
        raise UsageError(str(problem)) from None
    SIGNALS.end_with(result)
    if result.status == "fault":
        raise SourceError(result.source, result.diagnostics)
    axes = result.controller.axes
    moved = sorted({move.axis for move in result.controller.log.moves})
    if not moved:
        raise ProgramError.of("values", f"no axis moves in {result.source.name}")
    if args.axis is None and len(moved) > 1:
        many = ", ".join(map(str, moved))
        raise UsageError(f"axes {many} move in {result.source.name}: choose one with --axis")
    number = moved[0] if args.axis is None else args.axis
    if number not in moved:
        raise UsageError(f"axis {number} does not move in {result.source.name}")
    axis = axes[number]
    whole = WholeTrack(axis)
    starts, profiles = list(whole.starts), list(whole.profiles)
    track = Track(starts, profiles, *_span(starts, profiles))
    columns = track.starts, track.profiles
    tolerance = TOLERANCE if args.tolerance is None else args.tolerance
    try:
        fit = fit_track(*columns, tolerance, track.begin, track.end)
    except OutOfTolerance as problem:
        least = least_tolerance(*columns, tolerance, track.begin, track.end)
        hint = f"a tolerance of {least:.3g} counts can be met" if least else "the motion jumps there"
        raise ProgramError.of("range", str(problem), hint=hint) from None
    except ValueError as problem:
        raise ProgramError.of("range", str(problem)) from None
    return Move(f"{result.source.name}, axis {number}", fit.points, track=track)


def _span(starts: Sequence[float], profiles: Sequence[Profile]) -> tuple[float, float]:
    """Return the time of the first motion and the end of the last, pauses included."""
    moving = [i for i, profile in enumerate(profiles) if profile.shape != "hold"]
    last = moving[-1]
    ends = starts[last] + profiles[last].duration
    return starts[moving[0]], min(ends, starts[last + 1]) if last + 1 < len(starts) else ends


def _choose_velocities(move: Move, method: str, sweeps: int) -> None:
    """Replace the velocities of a move.

    The points that prevent it are named with their lines.
    """
    try:
        move.points = _with_velocities(move.points, method, sweeps)
    except ProgramError:
        if move.source is None:
            raise
        raise SourceError(move.source, diagnose(move, None, strict=True)) from None


def _with_velocities(points: Sequence[Point], method: str, sweeps: int) -> list[Point]:
    if method == "given":
        return list(points)
    moving = until_end(absolute(points))
    velocities = _velocities([p.position for p in moving], [p.time for p in moving[:-1]], method, sweeps)
    made = [replace(p, velocity=v) for p, v in zip(moving, velocities, strict=True)]
    return [*made, *points[len(moving) :]]


def _velocities(positions: Sequence[float], spans: Sequence[float], method: str, sweeps: int) -> list[float]:
    try:
        return pvt_velocities("exact" if method == "given" else method, positions, spans, sweeps)
    except (ValueError, OverflowError) as problem:
        raise ProgramError.of("range", str(problem)) from None


def spans_of(points: Sequence[Point]) -> list[float]:
    """Return the segment times of a move, seconds."""
    return [point.time for point, _ in pairwise(until_end(points))]
