"""Lines and arcs of one axis, as profiles over the distance along a path."""

from __future__ import annotations

from math import atan2, cos, floor, pi, radians, sin

from motionlang.kernel.planners.curve import Profile, from_curve
from motionlang.kernel.planners.ramps import Piece

# Exact rotations: degrees to cosine and sine.
_RIGHT = {0.0: (1.0, 0.0), 90.0: (0.0, 1.0), 180.0: (-1.0, 0.0), 270.0: (0.0, -1.0)}
# The sine of a multiple of pi is less than this, by the rounding of pi.
NO_SINE = 1e-15


def line_over(length: float, start: float, end: float) -> Profile:
    """Return the motion of one axis along a straight line, or the rise of a helix.

    The position goes from `start` to `end` over `length`.
    """
    slope = (end - start) / length
    piece = (start, slope, 0.0, 0.0, 0.0, 0.0, 0.0)
    return from_curve("line", start, end, ((0.0, length), (piece,), (("line", 0),)), slope, slope)


def arc_over(
    length: float, centre: float, radius: float, angle: float, sweep: float, end: float, cosine: bool
) -> Profile:
    """Return one axis of an arc: centre + radius cos(angle + sweep s / length).

    If `cosine` is false, sin replaces cos. Angles are in radians. `length` is in the unit of the path; `centre`,
    `radius` and `end` are in the unit of the axis. Each piece is at most a half wave.
    """
    phase = angle + (0.5 * pi if cosine else 0.0)
    if sweep < 0.0:  # sin(x) = sin(pi - x)
        phase = pi - phase
    omega = abs(sweep) / length
    knots = [0.0]
    pieces: list[Piece] = []
    half_turn = floor(phase / pi + 1e-12)
    while knots[-1] < length:
        local = phase + omega * knots[-1] - half_turn * pi
        sign = -1.0 if half_turn % 2 else 1.0
        pieces.append((centre, 0.0, 0.0, 0.0, sign * radius, omega, local))
        half_turn += 1
        finish = (half_turn * pi - phase) / omega
        knots.append(finish if finish < length * (1.0 - 1e-12) else length)
    sine = sin(phase)
    start = centre + (radius * sine if abs(sine) > NO_SINE else 0.0)
    velocities = (radius * omega * cos(phase), radius * omega * cos(phase + omega * length))
    return from_curve("arc", start, end, (tuple(knots), tuple(pieces), (("arc", 0),)), *velocities)


def rotated(x: float, y: float, degrees: float) -> tuple[float, float]:
    """Rotate a vector by an angle in degrees; multiples of 90 are exact."""
    exact = _RIGHT.get(degrees % 360.0)
    c, s = exact or (cos(radians(degrees)), sin(radians(degrees)))
    return x * c - y * s, x * s + y * c


def direction(x: float, y: float) -> float:
    """Return the direction of a vector, radians from -pi to pi."""
    return atan2(y, x)
