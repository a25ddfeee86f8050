"""PMC's parabolic profile (aPP): acceleration falls linearly to zero at slew."""

from __future__ import annotations

from math import sqrt

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.feasibility import Ramps, approach, from_rest
from motionlang.kernel.planners.limits import check_finite, check_rates
from motionlang.kernel.planners.ramps import FALLING, RISING


def plan_parabolic(
    start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0
) -> Profile:
    """Plan a parabolic move: T_A = 2V/A, S_A = 2/3 T_A V (TN1069).

    Deceleration mirrors it in time. A short move peaks below `speed`: V' = sqrt(3 A S/8) for A = D from rest.
    Raises ValueError like `plan_trapezoid`.
    """
    check_rates(speed, accel, decel)
    if v0 == 0.0:
        up, down = (2.0 / accel, FALLING), (2.0 / decel, RISING)
        return from_rest("parabolic", start, target, speed, up, down, 2.0 / 3.0)
    check_finite(position=start, target=target, start_velocity=v0)
    return approach(parabolic_ramps(accel, decel), start, target, speed, v0)


def parabolic_ramps(accel: float, decel: float) -> Ramps:
    """Return ramps of duration 2 |dv|/A.

    From v1 up to v2 they cover 2/3 (v2 - v1)(v1 + 2 v2)/A.
    """
    up = 2.0 / accel
    down = 2.0 / decel

    def peak(u: float, size: float) -> float:
        # (up/3)(v - u)(u + 2v) + (down/3) 2 v^2 = size, the positive root
        a = 2.0 * (up + down)
        b = up * u
        return (b + sqrt(b * b + 4.0 * a * (b * u + 3.0 * size))) / (2.0 * a)

    return Ramps(
        "parabolic", lambda a, b: ((b - a) * up, FALLING), lambda a, b: ((a - b) * down, RISING), peak
    )
