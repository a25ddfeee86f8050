"""Profiles towards a velocity: stops, and endless jogs."""

from __future__ import annotations

from math import copysign, inf, isfinite

from motionlang.kernel.planners.curve import Profile, far_end, relabelled
from motionlang.kernel.planners.limits import STILL, check_finite, check_positive, too_large
from motionlang.kernel.planners.ramps import Recipe, ramp_distance
from motionlang.kernel.planners.shapes import JerkRamps, Ramps, ramps_of
from motionlang.kernel.planners.transition import initial_steps, profile_of_steps
from motionlang.kernel.tools import total


def plan_stop(
    shape: str,
    start: float,
    v0: float,
    decel: float,
    ramp: float = 0.0,
    decel_jerk: float = inf,
    a0: float = 0.0,
    accel_jerk: float = inf,
) -> Profile:
    """Come to rest from `v0` at `decel` in the ramps of `shape`; the phase is "stop".

    `ramp` > 0 and a finite `decel_jerk` select between the two S-curves, as in `plan_velocity`. An
    acceleration `a0` that speeds up is ramped down at `accel_jerk` (default: `decel_jerk`). Raises ValueError
    for numbers that no machine can follow.
    """
    taken_back = decel_jerk if accel_jerk == inf else accel_jerk
    made = plan_velocity(shape, start, v0, 0.0, decel, decel, ramp, taken_back, decel_jerk, a0)
    return relabelled(made.cut(made.knots[-2]), shape, "stop")


def plan_velocity(
    shape: str,
    start: float,
    v0: float,
    v1: float,
    accel: float,
    decel: float,
    ramp: float = 0.0,
    accel_jerk: float = inf,
    decel_jerk: float = inf,
    a0: float = 0.0,
) -> Profile:
    """Change from velocity `v0` to `v1` and continue endlessly.

    If their signs are opposite, it brakes to zero first. The shape of the result is "jog", its duration infinite, its
    `end` infinite too (or its rest position). For "scurve" a finite `accel_jerk` selects Mint's S-ramp, which
    continues from the acceleration `a0`; without one, `ramp` is PMC's ramp ratio. Raises ValueError for
    numbers that no machine can follow.
    """
    check_positive(acceleration=accel, deceleration=decel)
    check_finite(position=start, start_velocity=v0, velocity=v1, start_acceleration=a0)
    ramps = ramps_of(shape, accel, decel, ramp, accel_jerk, decel_jerk)
    if a0 and isinstance(ramps, JerkRamps):
        sign = copysign(1.0, v0 or a0)
        steps, after = initial_steps(ramps, sign * v0, sign * a0, max(0.0, sign * v1))
        transition = profile_of_steps(start, sign * v0, sign * a0, steps, after, sign)
        return relabelled(transition.then(_run(transition.end, ramps, sign * after, v1)), "jog")
    return _run(start, ramps, v0, v1)


def running(start: float, velocity: float) -> Profile:
    """Return an endless motion at the constant `velocity` (not 0)."""
    return Profile("jog", start, far_end(start, velocity), inf, (velocity, inf, 0.0, velocity))


def _run(start: float, ramps: Ramps, v0: float, v1: float) -> Profile:
    v0, v1 = (0.0 if -STILL < v < STILL else v for v in (v0, v1))
    recipe: Recipe = (v0, *_change(ramps, v0, v1), v1, inf, 0.0, v1)
    position = start
    for i in range(0, len(recipe) - 4, 3):
        position += ramp_distance(*recipe[i : i + 4])
    if not (isfinite(position) and isfinite(total(recipe[1:-4:3]))):
        raise too_large()
    return Profile("jog", start, far_end(position, v1), inf, recipe)


def _change(ramps: Ramps, v0: float, v1: float) -> Recipe:
    """Return ramps from v0 to v1, a recipe without its first and last velocity."""
    if v0 * v1 < 0.0:
        return (*ramps.down(abs(v0), 0.0), 0.0, *ramps.up(0.0, abs(v1)))
    if abs(v1) < abs(v0):
        return ramps.down(abs(v0), abs(v1))
    return ramps.up(abs(v0), abs(v1))
