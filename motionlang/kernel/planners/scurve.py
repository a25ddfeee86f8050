"""PMC's two S-curves: sinusoidal (aPS) and trapezoidal (aPSn) acceleration."""

from __future__ import annotations

from math import pi

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.feasibility import approach, from_rest, stretched
from motionlang.kernel.planners.limits import check_finite, check_ramp, check_rates
from motionlang.kernel.planners.ramps import SINE


def plan_sinusoidal(
    start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0
) -> Profile:
    """Plan a move with a half-sine acceleration: T_A = (pi/2) V/A (TN1069).

    A short move peaks below `speed`, with A and D unchanged. Raises ValueError like `plan_trapezoid`.
    """
    check_rates(speed, accel, decel)
    if v0 == 0.0:
        up, down = (0.5 * pi / accel, SINE), (0.5 * pi / decel, SINE)
        return from_rest("sinusoidal", start, target, speed, up, down, 0.5)
    check_finite(position=start, target=target, start_velocity=v0)
    return approach(stretched("sinusoidal", accel, decel, SINE, 0.5 * pi), start, target, speed, v0)


def plan_ratio(
    start: float, target: float, speed: float, accel: float, decel: float, ramp: float, v0: float = 0.0
) -> Profile:
    """Plan a move whose acceleration rises over `ramp` T_A, stays constant, and falls.

    T_A = V/(A (1 - ramp)). This is TN1069's trapezoidal S-curve, 0 < ramp <= 0.5; at 0.5 it is chapter 12's
    S-curve with triangular acceleration, T_A = 2V/A. (The note prints (1/RAMP) VEL/ACC, which contradicts its own
    table.)
    """
    check_rates(speed, accel, decel)
    check_ramp(ramp)
    if v0 == 0.0:
        stretch = 1.0 / (1.0 - ramp)
        return from_rest(
            "scurve", start, target, speed, (stretch / accel, ramp), (stretch / decel, ramp), 0.5
        )
    check_finite(position=start, target=target, start_velocity=v0)
    return approach(stretched("scurve", accel, decel, ramp, 1.0 / (1.0 - ramp)), start, target, speed, v0)
