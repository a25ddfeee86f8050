"""The trapezoidal profile: constant acceleration, slew, constant deceleration."""

from __future__ import annotations

from math import inf, sqrt

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.feasibility import approach, stretched
from motionlang.kernel.planners.limits import LARGEST, SMALLEST, check_finite, check_rates


def plan_trapezoid(
    start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0
) -> Profile:
    """Plan a trapezoidal move from `start` (moving at `v0`) to rest at `target`.

    Units are any length, length/s and length/s². A short move peaks below `speed`. T_A = V/A, S_A = V T_A/2
    (TN1069, AN00115). Raises ValueError for numbers that no machine can follow.
    """
    if v0 == 0.0:
        ramps = from_rest(target - start, speed, accel, decel)
        if ramps is not None:
            return Profile("trapezoid", start, target, *ramps)
    check_rates(speed, accel, decel)
    check_finite(position=start, target=target, start_velocity=v0)
    # From rest nearly every program uses the numbers alone.

    return approach(stretched("trapezoid", accel, decel, 0.0, 1.0), start, target, speed, v0)


def from_rest(
    distance: float, speed: float, accel: float, decel: float
) -> tuple[float, tuple[float, ...]] | None:
    """Return duration and recipe of a move from rest; None if no machine can follow.

    The arithmetic is inlined because the running program calls it for nearly every move.
    """
    if not (
        speed >= SMALLEST and accel >= SMALLEST and decel >= SMALLEST and speed + accel + decel <= LARGEST
    ):
        return None
    size = distance if distance >= 0.0 else -distance
    per_square = 0.5 / accel + 0.5 / decel
    ramps = speed * speed * per_square
    if size >= ramps:
        v = speed
        slew = (size - ramps) / speed
    else:
        v = sqrt(size / per_square)
        slew = 0.0
    rise = v / accel
    fall = v / decel
    duration = rise + slew + fall
    if not duration < inf:
        return None
    if distance < 0.0:
        v = -v
    return duration, (0.0, rise, 0.0, v, slew, 0.0, v, fall, 0.0, 0.0)
