"""PVT points, the motion through them, and its segments and knots.

Lengths are counts, times seconds. A point gives position and velocity of the motor, and the time to the next
point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from motionlang.kernel.planners import Profile, acceleration_in, jerk_in, plan_pvt, velocity_in
from motionlang.kernel.tools import total

MAX_SEGMENT = 0.255
# The longest segment of a Copley drive, s: eight bits of milliseconds.
GRID = 0.001

MAX_POINTS = 1_000_000


@dataclass(frozen=True, slots=True)
class Point:
    """Position (counts), velocity (counts/s) and the seconds to the next point.

    A velocity of None is approached on a line; a time of 0 ends the move. A `relative` position counts from
    the point before it; the first one counts from the position of the motor.
    """

    position: float
    velocity: float | None
    time: float
    relative: bool = False


@dataclass(frozen=True, slots=True)
class Segment:
    """One segment of constant jerk, from `acceleration` to `end_acceleration`."""

    start_time: float
    duration: float
    jerk: float
    acceleration: float
    end_acceleration: float


@dataclass(frozen=True, slots=True)
class Knot:
    """The join of two segments: velocity and acceleration on both sides.

    They are 0 outside the motion.
    """

    time: float
    position: float
    velocity: float
    next_velocity: float
    acceleration: float
    next_acceleration: float

    @property
    def jump(self) -> float:
        """The jump of the acceleration at the knot."""
        return self.next_acceleration - self.acceleration


def points_from(
    positions: Sequence[float], velocities: Sequence[float | None], times: float | Sequence[float]
) -> list[Point]:
    """Return absolute points; the last one ends the move.

    `times` is one duration for all segments or one per segment.
    """
    count = len(positions) - 1
    spans = [float(times)] * count if isinstance(times, (int, float)) else list(times)
    return [Point(p, v, t) for p, v, t in zip(positions, velocities, [*spans, 0.0], strict=True)]


def until_end(points: Sequence[Point]) -> list[Point]:
    """Return the points up to the first one with time zero, which ends the move.

    Without such a point, return all.
    """
    for i, point in enumerate(points):
        if point.time == 0.0:
            return list(points[: i + 1])
    return list(points)


def absolute(points: Sequence[Point], start: float = 0.0) -> list[Point]:
    """Return the points with every position absolute, for a motor at `start`."""
    position, made = start, []
    for point in points:
        position = position + point.position if point.relative else point.position
        made.append(replace(point, position=position, relative=False))
    return made


def relative(points: Sequence[Point], start: float = 0.0) -> list[Point]:
    """Return the points with every position relative to the one before."""
    position, made = start, []
    for point in absolute(points, start):
        made.append(replace(point, position=point.position - position, relative=True))
        position = point.position
    return made


def plan_points(points: Sequence[Point], start: float = 0.0) -> Profile:
    """Return the motion through `points` up to the end of the move.

    Raises ValueError for points that a drive cannot follow.
    """
    moving = absolute(until_end(points), start)
    if not moving:
        raise ValueError("a PVT move needs at least one point")
    return plan_pvt([p.position for p in moving], [p.velocity for p in moving], [p.time for p in moving[:-1]])


def segments(profile: Profile) -> list[Segment]:
    """Return duration, jerk and acceleration of each piece of a motion."""
    table = []
    for piece, (begin, finish) in zip(profile.pieces, pairwise(profile.knots), strict=True):
        span = finish - begin
        table.append(
            Segment(
                begin, span, jerk_in(piece, 0.0), acceleration_in(piece, 0.0), acceleration_in(piece, span)
            )
        )
    return table


def knots(profile: Profile) -> list[Knot]:
    """Return each knot of a motion with velocity and acceleration on both sides.

    A cubic ends at the given velocity, with which the next cubic begins: there it is exact.
    """
    times, pieces, _ = profile.drawn
    table = []
    for i, time in enumerate(times):
        if i < len(pieces):
            position, after = pieces[i][0], (pieces[i][1], acceleration_in(pieces[i], 0.0))
        else:
            position, after = profile.end, (profile.end_velocity, 0.0)
        before = profile.start_velocity, 0.0
        if i:
            piece, span = pieces[i - 1], time - times[i - 1]
            joins = any(piece[2:]) and (i == len(pieces) or any(pieces[i][2:]))
            before = after[0] if joins else velocity_in(piece, span), acceleration_in(piece, span)
        table.append(Knot(time, position, before[0], after[0], before[1], after[1]))
    return table


def split_long(points: Sequence[Point]) -> list[Point]:
    """Return absolute points with no segment longer than `MAX_SEGMENT`.

    Long segments are cut on the curve, which does not change. If the length allows, the cuts are at whole
    milliseconds after the point, so that a drive can take them.
    """
    moving = until_end(absolute(points))
    duration = total(point.time for point in moving)
    if not duration <= MAX_POINTS * MAX_SEGMENT:
        raise ValueError(f"a move of {duration:.3g} s takes more than {MAX_POINTS} points")
    profile, made = plan_points(moving), list[Point]()
    for i, point in enumerate(moving):
        count = -int(-point.time // MAX_SEGMENT) if point.time else 1
        cuts = [round(point.time * n / count / GRID) * GRID for n in range(1, count)]
        marks = [0.0, *cuts, point.time]
        straight = i + 1 < len(moving) and moving[i + 1].velocity is None
        made.append(replace(point, time=marks[1] if count > 1 else point.time))
        for mark, following in pairwise(marks[1:]):
            state = profile.at(profile.knots[i] + mark)
            made.append(Point(state.position, None if straight else state.velocity, following - mark))
    return made
