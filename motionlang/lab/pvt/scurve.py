"""Copley's S-curve: four segments of constant jerk, or more under limits.

The limits are on velocity and acceleration. J is the jerk, T the time of a jerk segment. Without limits the
move is four segments of T: pos = [0, 1/6, 1, 11/6, 2] J T^3, vel = [0, 1/2, 1, 1/2, 0] J T^2, and the
distance is D = 2 J T^3.
"""

from __future__ import annotations

from math import ceil, copysign, inf, sqrt

from motionlang.kernel.planners import check_finite, check_positive
from motionlang.lab.pvt.points import Point

POSITIONS = (0.0, 1.0 / 6.0, 1.0, 11.0 / 6.0, 2.0)
VELOCITIES = (0.0, 0.5, 1.0, 0.5, 0.0)


def scurve(distance: float, time: float) -> list[Point]:
    """Return the five points of a move in four segments of `time` seconds.

    J = D / (2 T^3).
    """
    check_finite(distance=distance)
    check_positive(segment_time=time)
    jerk = distance / (2.0 * time**3)
    positions = [jerk * time**3 * factor for factor in POSITIONS]
    positions[-1] = distance
    speeds = [jerk * time**2 * factor for factor in VELOCITIES]
    return [Point(p, v, t) for p, v, t in zip(positions, speeds, (time,) * 4 + (0.0,), strict=True)]


def scurve_time(distance: float, jerk: float) -> float:
    """Return the segment time of the four-segment S-curve: T = (D / 2J)^(1/3)."""
    check_finite(distance=distance)
    check_positive(jerk=jerk)
    return float((abs(distance) / (2.0 * jerk)) ** (1.0 / 3.0))


def limited_scurve(
    distance: float, jerk: float, accel: float = inf, speed: float = inf, grid: float = 0.0
) -> list[Point]:
    """Return the points of a move by `distance` within limits: four to seven segments.

    With a `grid` (seconds) every segment time is rounded up to a multiple of it, and the jerk is lowered until
    the distance is met. All limits remain respected, since each quantity falls as any of the times grows: V = D
    / (2Tj + Ta + Tv), A = V / (Tj + Ta), J = A / Tj.
    """
    check_finite(distance=distance)
    check_positive(jerk=jerk)
    for name, limit in (("acceleration", accel), ("speed", speed)):
        if limit != inf:
            check_positive(**{name: limit})
    if distance == 0.0:
        return [Point(0.0, 0.0, 0.0)]
    t_jerk, t_accel, t_speed = (
        ceil(time / grid - 1e-9) * grid if grid else time
        for time in limited_times(abs(distance), jerk, accel, speed)
    )
    peak = abs(distance) / (2.0 * t_jerk + t_accel + t_speed)
    level = peak / (t_jerk + t_accel)
    slope = level / t_jerk
    pattern = (
        (t_jerk, slope),
        (t_accel, 0.0),
        (t_jerk, -slope),
        (t_speed, 0.0),
        (t_jerk, -slope),
        (t_accel, 0.0),
        (t_jerk, slope),
    )
    return _integrated(distance, [step for step in pattern if step[0] > 0.0])


def limited_times(distance: float, jerk: float, accel: float, speed: float) -> tuple[float, float, float]:
    """Return the times at constant jerk (per segment), acceleration and speed.

    `distance` must be positive. From D = V (2Tj + Ta + Tv), V = A (Tj + Ta), A = J Tj: the limit that is reached
    first shortens the rest.
    """
    t_jerk = min(scurve_time(distance, jerk), sqrt(speed / jerk), accel / jerk)
    level = jerk * t_jerk
    # The highest speed at which constant acceleration fits the distance: V^2 / A + V Tj = D.
    reach = 0.5 * level * (sqrt(t_jerk**2 + 4.0 * distance / level) - t_jerk)
    peak = min(speed, reach)
    t_accel = max(peak / level - t_jerk, 0.0)
    t_speed = max(distance / peak - 2.0 * t_jerk - t_accel, 0.0)
    least = 1e-12 * (t_jerk + t_accel + t_speed)
    return t_jerk, t_accel if t_accel > least else 0.0, t_speed if t_speed > least else 0.0


def _integrated(distance: float, steps: list[tuple[float, float]]) -> list[Point]:
    sign = copysign(1.0, distance)
    position = velocity = acceleration = 0.0
    points = []
    for time, jerk in steps:
        points.append(Point(sign * position, sign * velocity, time))
        position += time * (velocity + time * (0.5 * acceleration + time * jerk / 6.0))
        velocity += time * (acceleration + 0.5 * time * jerk)
        acceleration += time * jerk
    return [*points, Point(distance, 0.0, 0.0)]
