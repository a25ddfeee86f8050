"""Motion mathematics: planners, and the `Profile` that each of them returns.

A `Profile` is position as an exact function of time. Planners are imported on first use, so a program without
motion does not load them. `sample` needs NumPy, and the modules of `pvt` serve drives. Import both by name, never
from here.

Units. The unit of length, L, is the caller's: counts for an axis, user units along a path.

    start, target, end, position, distance         L, signed
    velocity, v0, v1                               L/s, signed
    acceleration, a0                               L/s², signed
    speed, accel, decel                            L/s, L/s², magnitudes
    jerk, accel_jerk, decel_jerk                   L/s³; as limits magnitudes
    time, duration, knots                          s; times count from the start of the profile
    ramp, ratio                                    a fraction of the duration of a ramp, 0 to 0.5
    omega, phase of a sine piece                   rad/s, rad

Names:

    0 and 1 at the end of a name    at the beginning and at the end of a motion
    u, b                            velocity and acceleration in the direction of motion
    per_speed, per_square           distance per unit of a speed, and of its square
    x                               time since the knot at which a piece begins

Where a profile is a curve over a length (a path, a cam), its "time" is that length: user units of path, or
counts of the master. `pvt/` is in counts and seconds; the segments of `fit` last whole milliseconds.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.planners.curve import Phase, Profile, State, hold

if TYPE_CHECKING:
    from motionlang.kernel.planners.jerk import plan_jerk
    from motionlang.kernel.planners.parabolic import plan_parabolic
    from motionlang.kernel.planners.scurve import plan_ratio, plan_sinusoidal
    from motionlang.kernel.planners.shapes import plan
    from motionlang.kernel.planners.stop import plan_stop, plan_velocity
    from motionlang.kernel.planners.trapezoid import plan_trapezoid

_HOMES = {
    "plan_jerk": "jerk",
    "plan_parabolic": "parabolic",
    "plan": "shapes",
    "plan_ratio": "scurve",
    "plan_sinusoidal": "scurve",
    "plan_stop": "stop",
    "plan_velocity": "stop",
    "plan_trapezoid": "trapezoid",
}


def __getattr__(name: str) -> object:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    # Like `import_module`, whose package takes longer to import than most of these modules.
    return getattr(__import__(f"{__name__}.{home}", fromlist=[name]), name)


__all__ = [
    "Phase",
    "Profile",
    "State",
    "hold",
    "plan",
    "plan_jerk",
    "plan_parabolic",
    "plan_ratio",
    "plan_sinusoidal",
    "plan_stop",
    "plan_trapezoid",
    "plan_velocity",
]
