"""Arc geometry: from MCCL's descriptions to centre and angle in degrees.

MCCL describes arcs by centre, radius, end point or angles, in user units. Points have the coordinates of the
two axes of the arc, in the order of the axis numbers. `sense` is +1 anticlockwise, -1 clockwise.
"""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, radians, sin, sqrt

Point = tuple[float, float]

# The largest miss of an end point, as a fraction of the radius; a larger one is a mistake in the program.
_MISS = 1e-3
# The largest fraction that counts as exact.
_EVEN = 1e-13
# The largest angle, in degrees, that counts as 0.
_NONE = 1e-7


def radius_of(start: Point, centre: Point) -> float:
    """Return the radius of an arc; raise ValueError if it is 0."""
    radius = hypot(start[0] - centre[0], start[1] - centre[1])
    if radius == 0.0:
        raise ValueError("the centre of the arc is its starting point")
    return radius


def centre_between(start: Point, end: Point, centre: Point, sense: int) -> Point:
    """Return the point nearest to `centre` at equal distances from start and end.

    One circle then passes through both. Raises ValueError if the end misses the circle about the centre by
    too much, or misses it near the start of an almost full circle, because correcting that would shift
    the circle too far.
    """
    radius, reach = radius_of(start, centre), hypot(end[0] - centre[0], end[1] - centre[1])
    distances = f"the end point is {reach:g} from the centre, the starting point {radius:g}"
    if abs(reach - radius) > _MISS * radius:
        raise ValueError(distances)
    dx, dy = end[0] - start[0], end[1] - start[1]
    if abs(reach - radius) <= _EVEN * radius:
        return centre
    share = 0.5 * (reach - radius) * (reach + radius) / (dx * dx + dy * dy)
    if abs(angle_to(start, end, centre, sense)) > 180.0 and abs(share) * hypot(dx, dy) > _MISS * radius:
        raise ValueError(
            f"{distances}, too much for nearly a full circle; use EA or ER to end it at an angle"
        )
    return centre[0] + share * dx, centre[1] + share * dy


def angle_to(start: Point, end: Point, centre: Point, sense: int) -> float:
    """Return the angle to an end point; equal start and end give a full circle."""
    return _round(_direction(end, centre) - _direction(start, centre), sense)


def angle_until(start: Point, centre: Point, direction: float, sense: int) -> float:
    """Return the angle to an absolute direction, degrees."""
    return _round(direction - _direction(start, centre), sense)


def end_of(start: Point, centre: Point, angle: float) -> Point:
    """Return the end of an arc without the rounding errors of sine and cosine.

    A quarter circle ends exactly on the axis.
    """
    radius = radius_of(start, centre)
    last = radians(_direction(start, centre)) + radians(angle)
    return (
        round((centre[0] + radius * cos(last)) / radius, 12) * radius,
        round((centre[1] + radius * sin(last)) / radius, 12) * radius,
    )


def centre_by_radius(start: Point, end: Point, radius: float, sense: int) -> Point:
    """Return the centre of the arc of a given radius between two points.

    A positive radius gives the shorter arc, a negative one the longer.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    chord = hypot(dx, dy)
    if chord == 0.0:
        raise ValueError("a full circle needs a centre, not a radius")
    if chord > 2.0 * abs(radius) * (1.0 + 1e-9):
        raise ValueError(f"a radius of {abs(radius):g} is too small for a chord of {chord:g}")
    height = sqrt(max(radius * radius - 0.25 * chord * chord, 0.0))
    side = sense if radius > 0.0 else -sense
    mx, my = 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])
    return mx - side * height * dy / chord, my + side * height * dx / chord


def _direction(point: Point, centre: Point) -> float:
    return degrees(atan2(point[1] - centre[1], point[0] - centre[0]))


def _round(angle: float, sense: int) -> float:
    """Return an equal angle in the direction of `sense`; 0 becomes a full circle."""
    found = angle * sense % 360.0
    return sense * (360.0 if found < _NONE or found > 360.0 - _NONE else found)
