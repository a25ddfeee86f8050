"""Arcs as MCCL describes them: by centre, radius, end point or angles, in user units; to centre and angle, degrees.

Points are those of the two axes that go round, in the order of their numbers; `turn` is +1 anticlockwise.
"""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, radians, sin, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    Point = tuple[float, float]

# How far, as a part of the radius, an arc may miss its end point: more is a mistake in the program.
_MISS = 1e-3
# The part of it that is none.
_EVEN = 1e-13
# Degrees that are none.
_NONE = 1e-7


def radius_of(start: Point, centre: Point) -> float:
    """The radius of an arc; ValueError where it has none."""
    radius = hypot(start[0] - centre[0], start[1] - centre[1])
    if radius == 0.0:
        raise ValueError("the centre of the arc is its starting point")
    return radius


def centre_between(start: Point, end: Point, centre: Point, turn: int) -> Point:
    """The place nearest to a centre from which start and end are equally far, so that one circle has both.

    ValueError where the end misses the circle about the centre by too much, or where it misses it near the start of
    nearly a whole turn: that would take the circle elsewhere.
    """
    radius, reach = radius_of(start, centre), hypot(end[0] - centre[0], end[1] - centre[1])
    distances = f"the end point is {reach:g} from the centre, the starting point {radius:g}"
    if abs(reach - radius) > _MISS * radius:
        raise ValueError(distances)
    dx, dy = end[0] - start[0], end[1] - start[1]
    if abs(reach - radius) <= _EVEN * radius:
        return centre
    share = 0.5 * (reach - radius) * (reach + radius) / (dx * dx + dy * dy)
    if abs(angle_to(start, end, centre, turn)) > 180.0 and abs(share) * hypot(dx, dy) > _MISS * radius:
        raise ValueError(
            f"{distances}, and on nearly a whole turn that is too much; EA or ER ends it at an angle"
        )
    return centre[0] + share * dx, centre[1] + share * dy


def angle_to(start: Point, end: Point, centre: Point, turn: int) -> float:
    """The angle to an end point; start and end alike is a full circle."""
    return _round(_direction(end, centre) - _direction(start, centre), turn)


def angle_until(start: Point, centre: Point, direction: float, turn: int) -> float:
    """The angle to an absolute direction, degrees."""
    return _round(direction - _direction(start, centre), turn)


def end_of(start: Point, centre: Point, angle: float) -> Point:
    """Where an arc ends, without the rounding of sine and cosine: a quarter circle ends on the axis."""
    radius = radius_of(start, centre)
    last = radians(_direction(start, centre)) + radians(angle)
    return (
        round((centre[0] + radius * cos(last)) / radius, 12) * radius,
        round((centre[1] + radius * sin(last)) / radius, 12) * radius,
    )


def centre_by_radius(start: Point, end: Point, radius: float, turn: int) -> Point:
    """The centre of the arc of a radius between two points, the shorter way round, or the longer if it is negative."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    chord = hypot(dx, dy)
    if chord == 0.0:
        raise ValueError("a full circle needs a centre, not a radius")
    if chord > 2.0 * abs(radius) * (1.0 + 1e-9):
        raise ValueError(f"a radius of {abs(radius):g} does not reach over {chord:g}")
    height = sqrt(max(radius * radius - 0.25 * chord * chord, 0.0))
    side = turn if radius > 0.0 else -turn
    mx, my = 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])
    return mx - side * height * dy / chord, my + side * height * dx / chord


def _direction(point: Point, centre: Point) -> float:
    return degrees(atan2(point[1] - centre[1], point[0] - centre[0]))


def _round(angle: float, turn: int) -> float:
    """The same direction, reached by turning; a whole turn rather than none."""
    found = angle * turn % 360.0
    return turn * (360.0 if found < _NONE or found > 360.0 - _NONE else found)
