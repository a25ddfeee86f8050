"""One contour path: a straight line, or an arc in the plane of two axes, in user units along its length."""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, pi, radians, sin, sqrt

from motionlang.controller.scale import Scale
from motionlang.profile.arc import arc_over, line_over

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.profile import Profile

    Point = Mapping[int, float]

# How far, as a part of the radius, an arc may miss its end point: more is a mistake in the program.
_MISS = 1e-3


class VectorMotion:
    """The limits along a path, user units and seconds, and the profile's shape."""

    __slots__ = ("accel", "decel", "ramp", "shape", "speed")

    def __init__(self, shape: str, ramp: float, speed: float, accel: float, decel: float) -> None:
        self.shape, self.ramp, self.speed, self.accel, self.decel = shape, ramp, speed, accel, decel

    def key(self) -> tuple[str, float, float, float, float]:
        """What two paths must share to be run through as one."""
        return self.shape, self.ramp, self.speed, self.accel, self.decel


class Segment:
    """From `start` to `end`, points by axis number. `length` is what the vector velocity counts.

    `frame` is what turned user units into counts, by axis, when the path was described: units that change later
    leave the path where it is.
    """

    __slots__ = ("end", "frame", "length", "motion", "start")

    def __init__(self, start: Point, end: Point, length: float, motion: VectorMotion) -> None:
        self.start, self.end, self.length, self.motion = start, end, length, motion
        self.frame: dict[int, Scale] = {}

    def fix(self, scales: Mapping[int, Scale]) -> None:
        """The path is described in these units."""
        self.frame = {axis: Scale(scales[axis].counts, zero=scales[axis].zero) for axis in self.end}

    def start_counts(self, axis: int) -> float:
        """Where the axis is at the start, counts."""
        return self.frame[axis].position_to_counts(self.start[axis])

    def end_counts(self, axis: int) -> float:
        """Where the axis is at the end, counts."""
        return self.frame[axis].position_to_counts(self.end[axis])

    def shift(self, axis: int, by: float) -> None:
        """The axis counts from another zero: the same place has another position, `by` counts higher."""
        if axis in self.frame:
            self.frame[axis].zero += by

    is_arc = False
    radius = 0.0

    def factor(self, axis: int) -> float:
        """How far the axis moves per unit of length; for the axes of an arc it changes on the way."""
        return (self.end[axis] - self.start[axis]) / self.length if self.length else 0.0

    def turns(self, axis: int) -> bool:
        """Whether the axis is one of the two that go round."""
        return False

    def curve(self, axis: int) -> Profile:
        """The axis over the length of the path, counts."""
        return line_over(self.length, self.start_counts(axis), self.end_counts(axis))

    def at(self, axis: int, s: float) -> tuple[float, float]:
        """Position of an axis at length s, and its change per length."""
        factor = self.factor(axis)
        return self.start[axis] + factor * s, factor

    def direction(self, s: float) -> dict[int, float]:
        """The unit tangent at length s."""
        return {axis: self.at(axis, s)[1] for axis in self.end}


class Arc(Segment):
    """An arc about `center` in the plane of axes `x` and `y`; other axes go along evenly."""

    __slots__ = ("angle", "center", "radius", "sweep", "x", "y")

    is_arc = True

    def __init__(
        self,
        start: Point,
        end: Point,
        motion: VectorMotion,
        plane: tuple[int, int],
        center: tuple[float, float],
        sweep: float,
    ) -> None:
        self.x, self.y = plane
        self.center, self.sweep = center, sweep
        dx, dy = start[self.x] - center[0], start[self.y] - center[1]
        self.radius, self.angle = hypot(dx, dy), atan2(dy, dx)
        super().__init__(start, end, self.radius * abs(sweep), motion)

    def turns(self, axis: int) -> bool:
        return axis in (self.x, self.y)

    def curve(self, axis: int) -> Profile:
        """The same; of an axis that goes round, exactly."""
        if not self.turns(axis):
            return super().curve(axis)
        scale, along_x = self.frame[axis], axis == self.x
        centre = scale.position_to_counts(self.center[0 if along_x else 1])
        radius, end = self.radius * scale.counts, self.end_counts(axis)
        return arc_over(self.length, centre, radius, self.angle, self.sweep, end, along_x)

    def at(self, axis: int, s: float) -> tuple[float, float]:
        """Position and direction of an axis after a length `s`, counts, of the arc."""
        if not self.turns(axis):
            return super().at(axis, s)
        sign = 1.0 if self.sweep > 0.0 else -1.0
        angle = self.angle + sign * s / self.radius
        if axis == self.x:
            return self.center[0] + self.radius * cos(angle), -sign * sin(angle)
        return self.center[1] + self.radius * sin(angle), sign * cos(angle)


def line(start: Point, end: Point, motion: VectorMotion, length: float | None = None) -> Segment:
    """A straight line; `length` where the program says what it counts as."""
    if length is None:
        length = hypot(*(end[axis] - start[axis] for axis in end))
    return Segment(start, end, length, motion)


def arc_to(
    start: Point,
    end: Point,
    motion: VectorMotion,
    plane: tuple[int, int],
    center: tuple[float, float],
    turn: int,
) -> Arc:
    """An arc about a centre to an end point; end and start alike is a full circle. ValueError where it misses."""
    x, y = plane
    dx, dy = start[x] - center[0], start[y] - center[1]
    ex, ey = end[x] - center[0], end[y] - center[1]
    radius = hypot(dx, dy)
    if radius == 0.0:
        raise ValueError("the centre of the arc is its starting point")
    if abs(hypot(ex, ey) - radius) > _MISS * radius:
        raise ValueError(f"the end point is {hypot(ex, ey):g} from the centre, the starting point {radius:g}")
    sweep = (atan2(ey, ex) - atan2(dy, dx)) * turn % (2.0 * pi)
    if sweep < 1e-9 or 2.0 * pi - sweep < 1e-9:
        sweep = 2.0 * pi
    return Arc(start, end, motion, plane, center, turn * sweep)


def arc_by_angle(
    start: Point,
    end: Point,
    motion: VectorMotion,
    plane: tuple[int, int],
    center: tuple[float, float],
    sweep: float,
) -> Arc:
    """An arc about a centre through an angle, radians; its end follows from it."""
    made = Arc(start, end, motion, plane, center, sweep)
    if made.radius == 0.0:
        raise ValueError("the centre of the arc is its starting point")
    x, y = plane
    made.end = {**end, **{axis: _clean(made.at(axis, made.length)[0], made.radius) for axis in (x, y)}}
    return made


def _clean(position: float, radius: float) -> float:
    """A position without the rounding of sine and cosine, so that a quarter circle ends on the axis."""
    return round(position / radius, 12) * radius


def center_by_radius(
    start: Point, end: Point, plane: tuple[int, int], radius: float, turn: int
) -> tuple[float, float]:
    """The centre of the arc of a radius between two points, the shorter way round, or the longer if it is negative."""
    x, y = plane
    dx, dy = end[x] - start[x], end[y] - start[y]
    chord = hypot(dx, dy)
    if chord == 0.0:
        raise ValueError("a full circle needs a centre, not a radius")
    if chord > 2.0 * abs(radius) * (1.0 + 1e-9):
        raise ValueError(f"a radius of {abs(radius):g} does not reach over {chord:g}")
    height = sqrt(max(radius * radius - 0.25 * chord * chord, 0.0))
    side = turn if radius > 0.0 else -turn
    mx, my = 0.5 * (start[x] + end[x]), 0.5 * (start[y] + end[y])
    return mx - side * height * dy / chord, my + side * height * dx / chord


def sweep_to_angle(
    start: Point, plane: tuple[int, int], center: tuple[float, float], angle: float, turn: int
) -> float:
    """The sweep from the starting point to an absolute angle in degrees, in the direction of `turn`, radians."""
    x, y = plane
    first = degrees(atan2(start[y] - center[1], start[x] - center[0]))
    sweep = (angle - first) * turn % 360.0
    return turn * radians(sweep if sweep > 1e-9 else 360.0)


def join_smoothly(first: Segment, second: Segment) -> bool:
    """Whether one path goes on in the direction of the other, so that it can be run through."""
    if first.motion.key() != second.motion.key() or first.end.keys() != second.end.keys():
        return False
    if any(first.frame[axis].counts != second.frame[axis].counts for axis in first.end):
        return False
    before, after = first.direction(first.length), second.direction(0.0)
    return all(abs(before[axis] - after[axis]) <= 1e-6 for axis in before)
