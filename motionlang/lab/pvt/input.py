"""The input of `motionlang pvt`: a file, positions, an S-curve, or a program."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.option_groups import Language
from motionlang.cli.picture import Picture
from motionlang.cli.readers import integer, real, whole
from motionlang.cli.signals import SIGNALS
from motionlang.kernel import Diagnostic, ProgramError, Source, run
from motionlang.kernel.planners import VELOCITY_METHODS, Profile, pvt_velocities
from motionlang.lab.pvt.drive.point import check_points
from motionlang.lab.pvt.points import (
    Point,
    absolute,
    plan_points,
    points_from,
    relative,
    split_long,
    until_end,
)
from motionlang.lab.pvt.scurve import limited_scurve, scurve
from motionlang.lab.pvt.table import read_points
from motionlang.views.figure import Figure

GRID = 0.001
MAX_REPORTED = 20
TOLERANCE = 1.0
# The files of points; others are programs.
TABLES = (".csv", ".txt", "")
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
    "lang": ("program",),
}
POSITIVE = real("a number greater than zero", 0.0, 1e300, above=True)
NUMBER = real("a number from -1e300 to 1e300", -1e300, 1e300)


@dataclass(slots=True)
class PointSource:
    """Points and their source; for a program also the motion that they were fitted to.

    `lines` are the line numbers in the source.
    """

    name: str
    points: list[Point]
    source: Source | None = None
    lines: Sequence[int] = ()
    track: FittedMotion | None = None


@dataclass(slots=True)
class FittedMotion:
    """The motion of one axis between two times, to which points are fitted."""

    starts: list[float]
    profiles: list[Profile]
    begin: float
    end: float


def _numbers(text: str) -> list[float]:
    """Parse numbers with commas between them; `check_points` validates them."""
    try:
        return [float(item) for item in text.split(",")]
    except ValueError:
        raise ValueError(f"{text!r} is not numbers with commas between them") from None


def _times(text: str) -> list[float]:
    return [POSITIVE(item) for item in text.split(",")]


@dataclass
class Fitted(Language):
    """A program whose motion is fitted."""

    title: ClassVar[str] = "program"
    axis: int | None = option("N", "the axis to fit", read=integer)
    tolerance: float | None = option("COUNTS", "the tolerance of the fit (1)", read=POSITIVE)


@dataclass
class Points(Fitted, Picture):
    """The points of a move: a file, positions, an S-curve, or a program whose motion is fitted."""

    title: ClassVar[str] = "points"
    file: str = argument(
        "FILE",
        "points (.csv: position, velocity, time), or a program to fit",
        default="",
    )
    positions: list[float] | None = option("P,P,…", "points in counts, instead of a file", read=_numbers)
    time: list[float] | None = option(
        "MS[,MS…]", "time between points, ms: one for all, or one for each segment", read=_times
    )
    scurve: float | None = option("COUNTS", "an S-curve of this distance, instead of a file", read=NUMBER)
    jerk: float | None = option("J", "its jerk, counts/s³, or --time for its four segments", read=POSITIVE)
    accel: float | None = option("A", "its acceleration limit, counts/s²", read=POSITIVE)
    speed: float | None = option("V", "its velocity limit, counts/s", read=POSITIVE)
    velocities: str | None = option("", "how to choose the velocities", choices=("given", *VELOCITY_METHODS))
    sweeps: int | None = option(
        "N", "passes over the points by refine", read=whole("a whole number from 1 to 1000", 1, 1000)
    )
    linear: bool = flag("omit the velocities and interpolate linearly")
    start_: float | None = option("COUNTS", "position of the motor before the move", read=NUMBER)

    def check(self) -> None:
        """Raise WrongOption unless there is one source of points and each option has an effect."""
        super().check()
        given = [name for name in ("positions", "scurve") if getattr(self, name) is not None]
        given += ["program" if self._is_program else "table"] if self.file else []
        if len(given) != 1:
            raise WrongOption("give one of: a file of points or a program, --positions, --scurve")
        for name, sources in SERVES.items():
            if getattr(self, name) is not None and given[0] not in sources:
                homes = " or ".join(NAMES[each] for each in sources)
                raise WrongOption(f"--{name} has no effect here: it needs {homes}")
        if self.sweeps is not None and self.velocities != "refine":
            raise WrongOption("--sweeps has no effect here: it needs --velocities refine")
        if self.linear and self.velocities:
            raise WrongOption("--linear omits the velocities that --velocities chooses")

    def move(self, *, strict: bool) -> PointSource:
        """Return the move; Refused if errors prevent it.

        What a drive would misinterpret is an error if the points must be sent as they are (`strict`), else reported as
        a warning.
        """
        move = self._read()
        found = _diagnose(move, self.start_, strict=strict)
        if any(each.severity == "error" for each in found):
            raise Refused(found, source=move.source, file=self.file)
        complain(found, move.source, self.file)
        return move

    def planned(self, points: Sequence[Point]) -> Profile:
        """Return the motion that a drive makes of points."""
        try:
            return plan_points(points, self.start_ or 0.0)
        except (ValueError, OverflowError) as problem:
            raise _out_of_range(problem) from None

    def draw(self, profiles: Sequence[Profile], titles: Sequence[str]) -> int:
        """Draw motions, if wished; return the exit status."""

        def figure() -> Figure:
            from motionlang.lab.pvt.plot import pvt_figure

            return pvt_figure(profiles, titles)

        return self.drawn(figure)

    @property
    def _is_program(self) -> bool:
        return os.path.splitext(self.file)[1].lower() not in TABLES

    def _read(self) -> PointSource:
        if self.positions is not None:
            move = self._from_positions(self.positions)
        elif self.scurve is not None:
            move = self._from_scurve(self.scurve)
        else:
            move = self._from_program() if self._is_program else self._from_table()
        if self.velocities:
            self._choose_velocities(move, self.velocities)
        if self.linear:
            move.points = [replace(point, velocity=None) for point in move.points]
        return move

    def _from_positions(self, positions: list[float]) -> PointSource:
        if self.time is None:
            raise WrongOption("--positions needs --time, the milliseconds between two points")
        if len(positions) < 2:
            raise WrongOption("--positions needs at least two positions")
        times = self.time if len(self.time) > 1 else self.time * (len(positions) - 1)
        if len(times) != len(positions) - 1:
            wanted = "1 time" if len(positions) == 2 else f"1 or {len(positions) - 1} times"
            raise WrongOption(f"{len(positions)} positions need {wanted}, not {len(times)}")
        spans = [time / 1000.0 for time in times]
        velocities = self._velocities(positions, spans, self.velocities or "exact")
        return PointSource("points", points_from(positions, velocities, spans))

    def _from_scurve(self, distance: float) -> PointSource:
        limits = self.accel or inf, self.speed or inf
        try:
            if self.time is not None and self.jerk is None:
                if limits != (inf, inf) or len(self.time) != 1:
                    raise WrongOption(
                        "--scurve with --time has four equal segments: no --accel, no --speed, one time"
                    )
                points = scurve(distance, self.time[0] / 1000.0)
            elif self.jerk is not None and self.time is None:
                points = split_long(limited_scurve(distance, self.jerk, *limits, grid=GRID))
            else:
                either = "needs" if self.time is None else "takes either"
                raise WrongOption(
                    f"--scurve {either} --time (of one of its four segments, ms) or --jerk (counts/s³)"
                )
        except ArithmeticError:
            raise _out_of_range("no finite move is possible within these limits") from None
        except WrongOption:
            raise
        except ValueError as problem:
            raise _out_of_range(problem) from None
        return PointSource(f"S-curve, {distance:.10g} counts", points)

    def _from_table(self) -> PointSource:
        source = self.source()
        try:
            table = read_points(source)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        points = table.points
        if "time" not in table.has:
            if self.time is None or len(self.time) != 1:
                raise WrongOption(
                    f"{source.name} has no times: give --time, the milliseconds between two points"
                )
            points = [replace(p, time=self.time[0] / 1000.0) for p in points[:-1]] + [
                replace(points[-1], time=0.0)
            ]
        elif self.time is not None:
            raise WrongOption(f"{source.name} has its own times: --time has no effect")
        move = PointSource(source.name, points, source, table.lines)
        if "velocity" not in table.has and not self.velocities:
            self._choose_velocities(move, "exact")
        return move

    def _from_program(self) -> PointSource:
        """Run the program and fit the motion of one axis."""
        from motionlang.lab.pvt.fit import OutOfTolerance, fit_track, least_tolerance

        try:
            result = run(self.file, dialect=self.known_language())
        except OSError as error:
            raise Refused([unreadable(error.filename or self.file, error)]) from None
        SIGNALS.end_with(result)
        if result.status == "fault":
            raise Refused(result.diagnostics, source=result.source, file=self.file)
        name = result.source.name
        moved = sorted({move.axis for move in result.controller.log.moves})
        if not moved:
            raise Refused([Diagnostic("values", f"no axis moves in {name}")])
        if self.axis is None and len(moved) > 1:
            many = ", ".join(map(str, moved))
            raise WrongOption(f"axes {many} move in {name}: choose one with --axis")
        number = moved[0] if self.axis is None else self.axis
        if number not in moved:
            raise WrongOption(f"axis {number} does not move in {name}")
        axis = result.controller.axes[number]
        starts, profiles = list(axis.starts), list(axis.profiles)
        track = FittedMotion(starts, profiles, *_span(starts, profiles))
        columns = track.starts, track.profiles
        tolerance = TOLERANCE if self.tolerance is None else self.tolerance
        try:
            fit = fit_track(*columns, tolerance, track.begin, track.end)
        except OutOfTolerance as problem:
            least = least_tolerance(*columns, tolerance, track.begin, track.end)
            hint = f"a tolerance of {least:.3g} counts can be met" if least else "the motion jumps there"
            raise _out_of_range(problem, hint) from None
        except ValueError as problem:
            raise _out_of_range(problem) from None
        return PointSource(f"{name}, axis {number}", fit.points, track=track)

    def _choose_velocities(self, move: PointSource, method: str) -> None:
        """Replace the velocities of a move; the points that prevent it are named with their lines."""
        if method == "given":
            return
        try:
            moving = until_end(absolute(move.points))
            spans = [p.time for p in moving[:-1]]
            velocities = self._velocities([p.position for p in moving], spans, method)
        except Refused:
            if move.source is None:
                raise
            found = _diagnose(move, None, strict=True)
            raise Refused(found, source=move.source, file=self.file) from None
        made = [replace(p, velocity=v) for p, v in zip(moving, velocities, strict=True)]
        move.points = [*made, *move.points[len(moving) :]]

    def _velocities(self, positions: Sequence[float], spans: Sequence[float], method: str) -> list[float]:
        try:
            method = "exact" if method == "given" else method
            return pvt_velocities(method, positions, spans, self.sweeps or 1)
        except (ValueError, OverflowError) as problem:
            raise _out_of_range(problem) from None


@dataclass
class Sent(Points):
    """The points of a move that a drive receives."""

    title: ClassVar[str] = "drive"
    relative: bool = flag("send distances instead of positions")
    node: int = option(
        "ID", "CANopen node of the drive (1)", read=whole("a node from 1 to 127", 1, 127), default=1
    )

    def sent(self, points: Sequence[Point], start: float) -> Sequence[Point]:
        """Return the points as they are sent."""
        return relative(points, start) if self.relative else points


def _out_of_range(problem: object, hint: str = "") -> Refused:
    return Refused([Diagnostic("range", str(problem), hint=hint)])


def _diagnose(move: PointSource, start: float | None, *, strict: bool) -> list[Diagnostic]:
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


def _span(starts: Sequence[float], profiles: Sequence[Profile]) -> tuple[float, float]:
    """Return the time of the first motion and the end of the last, pauses included."""
    moving = [i for i, profile in enumerate(profiles) if profile.shape != "hold"]
    last = moving[-1]
    ends = starts[last] + profiles[last].duration
    return starts[moving[0]], min(ends, starts[last + 1]) if last + 1 < len(starts) else ends


def spans_of(points: Sequence[Point]) -> list[float]:
    """Return the segment times of a move, seconds."""
    return [point.time for point, _ in pairwise(until_end(points))]
