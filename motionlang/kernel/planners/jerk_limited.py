"""Jerk-limited move to a target from any velocity and acceleration."""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, inf

from motionlang.kernel.planners.curve import Profile, relabelled
from motionlang.kernel.planners.feasibility import Ramps, is_rounding
from motionlang.kernel.planners.limits import too_large
from motionlang.kernel.planners.ramps import Curve, Recipe, ramp_distance
from motionlang.kernel.planners.segment_speed import between
from motionlang.kernel.planners.transition import (
    Bounds,
    Steps,
    distance_of_steps,
    eased_speed,
    initial_steps,
    profile_of_steps,
)
from motionlang.kernel.tools import total

# How far from its target a plan may end, as a fraction of the distance, before its figures count as too far
# apart.
_ASTRAY = 1e-9


# Velocity and acceleration in the direction of the motion, the sections, and that direction.
Head = tuple[float, float, Steps, float]


class JerkLimited(Profile):
    """Sections of constant jerk from v0 and a0, then the ramps of a recipe to `end`.

    The pieces are computed on first use, like those of a recipe, because most plans are only read for their end.
    `name` makes the sections one phase of that name if they are not part of a ramp.
    """

    __slots__ = ("_head", "_name", "_tail")

    def __init__(
        self, start: float, end: float, duration: float, head: Head, tail: Recipe, name: str = ""
    ) -> None:
        # The stores of `Profile`, inlined because the running program plans in motion.
        self.shape = "scurve"
        self.start = start
        self.end = end
        self.duration = duration
        self._recipe = (head[0] * head[3], tail[-1])
        self._head = head
        self._tail = tail
        self._name = name

    @property
    def curve(self) -> Curve:
        """Knots, pieces and phase marks."""
        try:
            return self._curve
        except AttributeError:
            v0, a0, steps, sign = self._head
            head = profile_of_steps(self.start, v0, a0, steps, sign * self._tail[0], sign)
            if self._name:
                head = relabelled(head, "scurve", self._name)
            time = total(self._tail[1::3])
            rest = Profile("scurve", head.end, self.end, time, self._tail) if time else None
            knots, pieces, marks = (head if rest is None else head.then(rest)).curve
            if len(knots) > 1 and self.duration > knots[-2]:
                knots = (*knots[:-1], self.duration)
            self._curve = knots, pieces, marks
            return self._curve


def jerk_limited_approach(
    ramps: Ramps,
    start: float,
    target: float,
    speed: float,
    v0: float,
    a0: float,
    straight: Callable[[float, float], Profile],
) -> Profile | None:
    """Return the move from v0 and acceleration a0 (not 0) to rest at `target`.

    `straight` plans a move to that target from a position and a velocity, without an acceleration. If the move
    cannot stop at the target, or moves away from it, it stops first and then moves there from rest. None if
    the figures are so many orders of magnitude apart that rounding misses the target.
    """
    assert ramps.bounds is not None
    sign = copysign(1.0, v0 or a0)
    u, b = sign * v0, sign * a0
    steps, after = initial_steps(ramps.bounds, u, b, 0.0)
    ahead, covered = sign * (target - start), distance_of_steps(u, b, steps)
    time, kind = ramps.down(after, 0.0) if after >= 0.0 else (0.0, 0.0)
    stopping = covered + ramp_distance(after, time, kind, 0.0)
    rounding = is_rounding(stopping - ahead, stopping, start, target)
    if after >= 0.0 and stopping < ahead and not rounding:
        return _ahead(ramps, start, target, speed, u, b, sign)
    end, head = start + sign * covered, (u, b, steps, sign)
    if not abs(end) < inf:
        raise too_large()
    if after >= 0.0 and rounding:
        return _arriving(start, target, head, covered, (sign * after, time, kind, 0.0))
    rest = straight(end, sign * after)
    duration = _time(steps) + rest.duration
    if not duration < inf:
        raise too_large()
    return JerkLimited(start, target, duration, head, rest._recipe, "" if after else "stop")


def _ahead(
    ramps: Ramps, start: float, target: float, speed: float, u: float, b: float, sign: float
) -> Profile | None:
    """Return the move if the target lies beyond the shortest stop."""
    assert ramps.bounds is not None
    size = sign * (target - start)
    top = _peak(ramps, ramps.bounds, size, u, b)
    if top is None or speed <= eased_speed(ramps.bounds, u, b):
        steps, rows = between(ramps, size, speed, u, b, 0.0)
        recipe = [value if i else value * sign for row in rows for i, value in enumerate(row[:3])]
        covered = distance_of_steps(u, b, steps)
        return _arriving(start, target, (u, b, steps, sign), covered, (*recipe, 0.0))
    top = min(top, speed)
    steps, after = initial_steps(ramps.bounds, u, b, top)
    first, kind = ramps.up(after, top)
    last, last_kind = ramps.down(top, 0.0)
    covered = distance_of_steps(u, b, steps)
    left = size - covered - ramp_distance(after, first, kind, top) - ramp_distance(top, last, last_kind, 0.0)
    slew = left / top if top == speed and left > 0.0 else 0.0
    v = sign * top
    recipe_up = (sign * after, first, kind, v, slew, 0.0, v, last, last_kind, 0.0)
    return _arriving(start, target, (u, b, steps, sign), covered, recipe_up)


def _time(steps: Steps) -> float:
    time = 0.0
    for _, each in steps:
        time += each
    return time


def _peak(ramps: Ramps, bounds: Bounds, size: float, u: float, b: float) -> float | None:
    """Return the highest speed from which the axis can still stop at the target.

    None if the axis must not accelerate. A ramp in progress is treated as the rest of a ramp that began earlier, at
    zero acceleration.
    """
    jerk = bounds.accel_jerk if b > 0.0 else bounds.decel_jerk
    time = abs(b) / jerk
    if b > bounds.accel:
        return None
    rest = u - 0.5 * b * time
    if b < 0.0:
        rest = u + 0.5 * b * time
        room = size - (rest + jerk * time * time / 6.0) * time
        if rest <= 0.0 or room <= 0.5 * rest * ramps.down(rest, 0.0)[0]:
            return None
        return ramps.peak(rest, room)
    eased = u + 0.5 * b * time
    top = ramps.peak(rest, size + (rest + jerk * time * time / 6.0) * time)
    return top if top >= eased else None


def _arriving(start: float, target: float, head: Head, covered: float, recipe: Recipe) -> Profile | None:
    """Return initial sections, then the ramps of a recipe that end at `target`.

    `covered` is the distance of the sections. None if the ramps end elsewhere.
    """
    time = total(recipe[1::3])
    if not time < inf:
        raise too_large()
    far = target - start - head[3] * covered
    distances = [ramp_distance(*recipe[i : i + 4]) for i in range(0, len(recipe) - 1, 3)]
    if abs(total(distances) - far) > _ASTRAY * max(abs(target), abs(start), abs(far), *map(abs, distances)):
        return None
    return JerkLimited(start, target, _time(head[2]) + time, head, recipe)
