"""Transition from any velocity *and acceleration* to another velocity.

It respects limits on acceleration and jerk. If the present acceleration leads towards the new velocity, it continues
as part of the ramp. If not, it is ramped down first, at the jerk limit for speeding up or for slowing down as it
applies, and a ramp from zero acceleration follows. Own arithmetic. Velocities are in the direction of the motion.
"""

from __future__ import annotations

from math import fsum, inf, sqrt

from motionlang.kernel.planners.curve import Profile, from_curve, relabelled
from motionlang.kernel.planners.limits import too_large
from motionlang.kernel.planners.ramps import FALLING, Piece, Recipe, ramp_distance
from motionlang.kernel.planners.shapes import JerkRamps

# A sequence of sections of constant jerk: the jerk and the time of each.
Steps = tuple[tuple[float, float], ...]

# The beginning of a motion from rest, as `joined` takes it.
REST = (0.0, 0.0, (), 1.0)

# A velocity counts as zero if it is smaller than NOTHING times the velocity that a ramp-down from full
# acceleration gains, unless it exceeds HARDLY times the change itself: a ramp that has hardly begun is not
# rounding.
NOTHING, HARDLY = 1e-12, 1e-3


def initial_steps(ramps: JerkRamps, v0: float, a0: float, v1: float) -> tuple[Steps, float]:
    """Return the first steps from v0 >= 0 and a0 towards v1 >= 0, and the final speed.

    If the final speed is not v1, an ordinary ramp has to follow. It is negative if the acceleration cannot be ramped
    down before the motion reverses.
    """
    if a0 > 0.0:
        eased = v0 + 0.5 * a0 * a0 / ramps.accel_jerk
        if v1 > eased:
            return _ramp(v1 - v0, a0, ramps.accel, ramps.accel_jerk), v1
        return ((-ramps.accel_jerk, a0 / ramps.accel_jerk),), eased
    jerk = ramps.decel_jerk
    eased = v0 - 0.5 * a0 * a0 / jerk
    left = eased - v1
    if abs(left) <= NOTHING * (ramps.decel * ramps.decel / jerk + v0) and abs(left) <= HARDLY * abs(v0 - v1):
        return ((jerk, -a0 / jerk),), v1
    if v1 < eased:
        return tuple((-j, t) for j, t in _ramp(v0 - v1, -a0, ramps.decel, jerk)), v1
    return ((jerk, -a0 / jerk),), eased


def eased_speed(ramps: JerkRamps, v0: float, a0: float) -> float:
    """Return the velocity after an acceleration has been ramped down."""
    return v0 + 0.5 * a0 * abs(a0) / (ramps.accel_jerk if a0 > 0.0 else ramps.decel_jerk)


def distance_of_steps(v0: float, a0: float, steps: Steps) -> float:
    """Return the distance covered by steps."""
    distance, v, a = 0.0, v0, a0
    for jerk, time in steps:
        distance += ((jerk * time / 6.0 + 0.5 * a) * time + v) * time
        v += (0.5 * jerk * time + a) * time
        a += jerk * time
    return distance


def profile_of_steps(
    start: float, v0: float, a0: float, steps: Steps, v1: float, sign: float = 1.0
) -> Profile:
    """Return the profile of steps that end at velocity v1; `sign` -1 mirrors it."""
    knots, p, v, a = [0.0], start, v0 * sign, a0 * sign
    pieces: list[Piece] = []
    for jerk, time in steps:
        if knots[-1] + time <= knots[-1]:  # rounding may leave a negative duration
            continue
        jerk *= sign
        pieces.append((p, v, 0.5 * a, jerk / 6.0, 0.0, 0.0, 0.0))
        knots.append(knots[-1] + time)
        p += ((jerk * time / 6.0 + 0.5 * a) * time + v) * time
        v += (0.5 * jerk * time + a) * time
        a += jerk * time
    marks = (("accel" if abs(v1) > abs(v0) else "decel", 0),) if pieces else ()
    return from_curve("scurve", start, p, (tuple(knots), tuple(pieces), marks), v0 * sign, v1 * sign)


def joined(
    shape: str, start: float, end: float, head: tuple[float, float, Steps, float], recipe: Recipe
) -> Profile:
    """Return sections of constant jerk, then the ramps of a recipe to `end`.

    `head` is velocity and acceleration in the direction of the motion, the sections, and that direction.
    """
    duration = fsum(recipe[1::3])
    if not duration < inf:
        raise too_large()
    u, b, steps, sign = head
    if not steps:
        return Profile(shape, start, end, duration, recipe)
    made = profile_of_steps(start, u, b, steps, sign * recipe[0], sign)
    if not made.duration + duration < inf:
        raise too_large()
    if duration and not recipe[0]:
        made = relabelled(made, shape, "stop")
    return made.then(Profile(shape, made.end, end, duration, recipe)).ending_at(end)


def ease(start: float, v0: float, a0: float, jerk: float) -> Profile:
    """Return a ramp-down of an acceleration to zero at constant jerk.

    T = |a0|/J, dv = a0 T/2.
    """
    time = abs(a0) / jerk
    velocity = v0 + 0.5 * a0 * time
    end = start + ramp_distance(v0, time, FALLING, velocity)
    return Profile("scurve", start, end, time, (v0, time, FALLING, velocity))


def _ramp(change: float, a0: float, most: float, jerk: float) -> Steps:
    """Return the steps that increase the velocity by `change`, from acceleration a0.

    a0 is at least 0; the final acceleration is zero.
    """
    if a0 > most:
        hold = max(0.0, (change - 0.5 * (a0 * a0 / jerk)) / most)
        return ((-jerk, (a0 - most) / jerk), (0.0, hold), (-jerk, most / jerk))
    whole = change + 0.5 * a0 * a0 / jerk  # of the same ramp, begun without an acceleration
    peak = max(a0, min(most, sqrt(jerk * whole)))
    hold = max(0.0, (whole - peak * peak / jerk) / peak) if peak else 0.0
    return ((jerk, (peak - a0) / jerk), (0.0, hold), (-jerk, peak / jerk))
