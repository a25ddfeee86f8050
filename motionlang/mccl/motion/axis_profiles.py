"""From the profile along a path to the profile of each axis.

On a line an axis does what the path does, to scale: exactly. On an arc cubic pieces that meet the circle in position
and velocity at every knot stand for it; they are laid so closely that they stray less than a ten-thousandth of a count.
"""

from __future__ import annotations

from bisect import bisect_right
from math import ceil, sqrt

from motionlang.profile.curve import Profile, from_curve
from motionlang.profile.pieces import (
    acceleration_in,
    jerk_in,
    position_in,
    recentred,
    transformed,
    velocity_in,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.controller.scale import Scale
    from motionlang.mccl.motion.segment import Segment
    from motionlang.profile.ramps import Curve, Piece

# Counts by which a cubic may stray from the circle: for steps of angle d it is r d^4 / 384.
_STRAY = 1e-4
# Radians that one cubic may stand for, and cubics that one piece may become.
_WIDEST = 0.2
_MOST_STEPS = 20_000


class Course:
    """Paths that are run through as one: `segments`, and the length at which each begins and the last one ends."""

    __slots__ = ("marks", "segments")

    def __init__(self, segments: Sequence[Segment]) -> None:
        self.segments = list(segments)
        self.marks = [0.0]
        for segment in segments:
            self.marks.append(self.marks[-1] + segment.length)

    @property
    def length(self) -> float:
        """The length of the whole."""
        return self.marks[-1]

    def extend(self, segment: Segment) -> None:
        """Add a path at the end."""
        self.segments.append(segment)
        self.marks.append(self.marks[-1] + segment.length)

    def index(self, s: float) -> int:
        """The path that length s lies on."""
        return min(max(bisect_right(self.marks, s) - 1, 0), len(self.segments) - 1)

    def profile(self, path: Profile, axis: int, here: tuple[float, float] | None = None) -> Profile:
        """What the axis does while the path is run as `path` says, in counts.

        `here` is position and velocity of an axis that is on its way: within a stray of where the path has it.
        """
        knots, pieces, marks = _divided(path, self, axis)
        made: list[Piece] = []
        for begin, finish, piece, index in pieces:
            segment, offset = self.segments[index], self.marks[index]
            scale = segment.frame[axis]
            if segment.turns(axis):
                ends = [_state(segment, axis, piece, x, offset, scale) for x in (0.0, finish - begin)]
                if here is not None and not made:
                    ends[0] = here
                made.append(_hermite(*ends[0], *ends[1], finish - begin))
            else:
                factor = segment.factor(axis)
                zero = scale.position_to_counts(segment.start[axis] - factor * offset)
                made.append(transformed(piece, factor * scale.counts, zero))
        curve: Curve = (tuple(knots), tuple(made), marks)
        return _ends(path, self, axis, curve, here)


def _ends(
    path: Profile,
    course: Course,
    axis: int,
    curve: Curve,
    here: tuple[float, float] | None,
) -> Profile:
    def at(s: float, velocity: float) -> tuple[float, float]:
        index = course.index(s)
        scale = course.segments[index].frame[axis]
        position, factor = course.segments[index].at(axis, s - course.marks[index])
        return scale.position_to_counts(position), velocity * factor * scale.counts

    start, first = at(path.start, path.start_velocity)
    end, last = at(path.end, path.end_velocity)
    if here is not None:
        start, first = here
    elif path.start == 0.0:
        start = course.segments[0].frame[axis].position_to_counts(course.segments[0].start[axis])
    if path.end == course.length:
        end = course.segments[-1].end_counts(axis)
    return from_curve(path.shape, start, end, curve, first, last)


def _divided(
    path: Profile, course: Course, axis: int
) -> tuple[list[float], list[tuple[float, float, Piece, int]], tuple[tuple[str, int], ...]]:
    """The path's pieces, cut where one path ends and the next begins, and finely on arcs."""
    knots, pieces, marks = path.curve
    crossings = [time for mark in course.marks[1:-1] if (time := path.crossing(mark)) is not None]
    found: list[tuple[float, float, Piece, int]] = []
    firsts: list[int] = []
    for k, piece in enumerate(pieces):
        begin, finish = knots[k], knots[k + 1]
        firsts.append(len(found))
        inner = [time for time in crossings if begin < time < finish]
        for a, b in zip([begin, *inner], [*inner, finish], strict=True):
            middle = position_in(piece, 0.5 * (a + b) - begin)
            index = course.index(middle)
            count = _steps(course.segments[index], axis, piece, (a - begin, b - begin))
            for j in range(count):
                low, high = a + (b - a) * j / count, b if j + 1 == count else a + (b - a) * (j + 1) / count
                found.append((low, high, recentred(piece, low - begin), index))
    times = [each[0] for each in found] + [path.duration]
    return times, found, tuple((name, firsts[first]) for name, first in marks)


def _steps(segment: Segment, axis: int, piece: Piece, span: tuple[float, float]) -> int:
    """How many cubics one piece of the path needs on this axis.

    A cubic strays from x(t) by at most h^4/384 times the largest fourth derivative; for x = r cos(q(t)) that is at
    most r (q1^4 + 6 q1^2 q2 + 3 q2^2 + 4 q1 q3 + q4), qn being the nth derivative of the angle q.
    """
    if not segment.turns(axis):
        return 1
    radius = segment.radius
    places = (span[0], 0.5 * (span[0] + span[1]), span[1])
    q1, q2, q3 = (
        max(abs(value(piece, x)) for x in places) / radius
        for value in (velocity_in, acceleration_in, jerk_in)
    )
    q4 = abs(piece[4]) * piece[5] ** 4 / radius
    bend = (
        radius
        * abs(segment.frame[axis].counts)
        * (q1**4 + 6.0 * q1 * q1 * q2 + 3.0 * q2 * q2 + 4.0 * q1 * q3 + q4)
    )
    steps = (span[1] - span[0]) * max(sqrt(sqrt(bend / (384.0 * _STRAY))), q1 / _WIDEST)
    return min(max(1, ceil(steps)), _MOST_STEPS)


def _hermite(p0: float, v0: float, p1: float, v1: float, h: float) -> Piece:
    """The cubic that has given positions and velocities at both ends of a stretch of time h."""
    rise = (p1 - p0) / h
    return (p0, v0, (3.0 * rise - 2.0 * v0 - v1) / h, (v0 + v1 - 2.0 * rise) / (h * h), 0.0, 0.0, 0.0)


def _state(
    segment: Segment, axis: int, piece: Piece, x: float, offset: float, scale: Scale
) -> tuple[float, float]:
    position, factor = segment.at(axis, position_in(piece, x) - offset)
    return scale.position_to_counts(position), velocity_in(piece, x) * factor * scale.counts
