"""Motion mathematics: planners that return a `Profile`, position as an exact function of time.

`sample` and `verify` use NumPy, the `pvt` modules serve drives: they are imported by name, never from here,
because running a program needs none of them.
"""

from __future__ import annotations

from motionlang.profile.curve import Phase, Profile, State, hold
from motionlang.profile.halted import halted, rest
from motionlang.profile.jerk import plan_jerk
from motionlang.profile.joint import on_line, path_length, scaled
from motionlang.profile.parabolic import plan_parabolic
from motionlang.profile.plan import plan
from motionlang.profile.scurve import plan_ratio, plan_sinusoidal
from motionlang.profile.stop import plan_stop, plan_velocity
from motionlang.profile.trapezoid import plan_trapezoid

__all__ = [
    "Phase",
    "Profile",
    "State",
    "halted",
    "hold",
    "on_line",
    "path_length",
    "plan",
    "plan_jerk",
    "plan_parabolic",
    "plan_ratio",
    "plan_sinusoidal",
    "plan_stop",
    "plan_trapezoid",
    "plan_velocity",
    "rest",
    "scaled",
]
