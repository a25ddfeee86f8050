"""Planning of position moves by the name of their shape."""

from __future__ import annotations

from math import inf

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.jerk import plan_jerk
from motionlang.kernel.planners.parabolic import plan_parabolic
from motionlang.kernel.planners.scurve import plan_ratio, plan_sinusoidal
from motionlang.kernel.planners.trapezoid import plan_trapezoid


def plan(
    shape: str,
    start: float,
    target: float,
    speed: float,
    accel: float,
    decel: float,
    v0: float = 0.0,
    ramp: float = 0.0,
    accel_jerk: float = inf,
    decel_jerk: float = inf,
    a0: float = 0.0,
) -> Profile:
    """Plan a "trapezoid", "sinusoidal", "scurve" or "parabolic" move.

    For "scurve" a finite `accel_jerk` selects Mint's S-ramp (`decel_jerk` defaults to it); without one, `ramp`
    is PMC's ramp ratio. Only the S-ramp uses `a0`; the other shapes may begin with a jump of the
    acceleration. Raises ValueError for another name, and like `plan_trapezoid`, whose units apply.
    """
    if shape == "trapezoid":
        return plan_trapezoid(start, target, speed, accel, decel, v0)
    # The other shapes are rare: a program without them starts without loading them.
    if shape == "sinusoidal":
        return plan_sinusoidal(start, target, speed, accel, decel, v0)
    if shape == "parabolic":
        return plan_parabolic(start, target, speed, accel, decel, v0)
    if shape != "scurve":
        raise ValueError(f"there is no profile shape {shape!r}")
    if accel_jerk == inf:
        return plan_ratio(start, target, speed, accel, decel, ramp, v0)

    braking = accel_jerk if decel_jerk == inf else decel_jerk
    return plan_jerk(start, target, speed, accel, decel, accel_jerk, braking, v0, a0)
