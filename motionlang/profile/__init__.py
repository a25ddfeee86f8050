"""Motion mathematics: planners that return a `Profile`, position as an exact function of time.

The planners are brought in when they are first asked for: a program that moves nothing should not wait for them.
`sample` and `verify` use NumPy, the `pvt` modules serve drives: they are imported by name, never from here.
"""

from __future__ import annotations

from motionlang.profile.curve import Phase, Profile, State, hold

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.profile.jerk import plan_jerk
    from motionlang.profile.joint import on_line, path_length, scaled
    from motionlang.profile.parabolic import plan_parabolic
    from motionlang.profile.scurve import plan_ratio, plan_sinusoidal
    from motionlang.profile.shapes import plan
    from motionlang.profile.stop import plan_stop, plan_velocity
    from motionlang.profile.trapezoid import plan_trapezoid

_HOMES = {
    "plan_jerk": "jerk",
    "on_line": "joint",
    "path_length": "joint",
    "scaled": "joint",
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
    # As `import_module` does, whose package takes longer to import than most of these modules.
    return getattr(__import__(f"{__name__}.{home}", fromlist=[name]), name)


__all__ = [
    "Phase",
    "Profile",
    "State",
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
    "scaled",
]
