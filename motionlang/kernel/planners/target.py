"""Move to a target: from any velocity and acceleration to rest there, in the ramps of any shape.

Problem. Move to a target and come to rest there, within limits on speed and rates, and for an S-ramp on jerk. The move
may begin at any velocity, and an S-ramp with any acceleration, since a program may give a new target in motion. Nearly
every move is planned while the program runs, so planning must be cheap.

Idea. A move ahead is a ramp up, a slew and a ramp down, so the whole move follows from its top speed. That is the set
speed or, if the distance is too short, the peak at which both ramps fill the distance exactly, which the shape states
(`shapes.py`). Without an acceleration there are three cases.
1. Towards the target with enough distance to stop: the move ahead. A start above the set speed brakes to it first.
2. Away from the target: stop, then the move ahead from rest.
3. Too fast to stop at the target: stop beyond it, then move back from rest.

With an acceleration, sections of constant jerk come first (`transition.py`). An acceleration that leads to the top
speed continues as part of the ramp up: it is the rest of a ramp that began earlier, at zero acceleration, and the peak
is that of a move from there. Any other is ramped down first, in cases 2 and 3 as part of the stop. A search finds the
speed in between only where the move must brake twice (`between` of `segment_speed.py`).

Data. The result is a `Profile` with a recipe (`ramps.py`), or a `JerkLimited`: sections of constant jerk, then a
recipe. Both become polynomials only when the curve is read. `u` and `b` are velocity and acceleration in the direction
of motion.

Invariants.
- The profile ends at rest at the target, and its duration is finite.
- Speed, rates and jerk stay within their limits. A start above a limit returns within it.
- A reversal is at rest and without acceleration, unless the initial acceleration carries the motion through zero speed.
  A faster reversal would keep its acceleration; see `docs/contributing/decisions.md`.
- Figures too many orders of magnitude apart raise ValueError.

Cost. 2 µs from rest, some 8 µs from a velocity and an acceleration, and 80 µs where the search is necessary.
"""

from __future__ import annotations

from math import copysign, fsum, inf

from motionlang.kernel.planners.curve import Profile, relabelled
from motionlang.kernel.planners.limits import LARGEST, STILL, check_finite, check_rates, too_large
from motionlang.kernel.planners.pieces import position_in
from motionlang.kernel.planners.ramps import Curve, Recipe, ramp_distance
from motionlang.kernel.planners.segment_speed import between
from motionlang.kernel.planners.shapes import JerkRamps, Ramps, ramps_of
from motionlang.kernel.planners.transition import (
    Steps,
    distance_of_steps,
    ease,
    initial_steps,
    profile_of_steps,
)
from motionlang.kernel.tools import total

# How far from its target a plan may end, as a fraction of the distance, before its figures count as too far
# apart.
_ASTRAY = 1e-9
# Rates as far apart as this may miss the target by rounding; their plans are checked.
_FAR_APART = 1e9


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

    Units are any length, length/s and so on. For "scurve" a finite `accel_jerk` selects Mint's S-ramp (`decel_jerk`
    defaults to it); without one, `ramp` is PMC's ramp ratio. Only the S-ramp uses `a0`; the other shapes may begin
    with a jump of the acceleration. A short move peaks below `speed`. Raises ValueError for another name, and for
    numbers that no machine can follow.
    """
    check_rates(speed, accel, decel)
    ramps = ramps_of(shape, accel, decel, ramp, accel_jerk, decel_jerk)
    if not abs(start) + abs(target) + abs(v0) + abs(a0) <= LARGEST:  # also NaN
        check_finite(position=start, target=target, start_velocity=v0, start_acceleration=a0)
    if a0 and isinstance(ramps, JerkRamps):
        return _from_acceleration(ramps, start, target, speed, v0, a0)
    return approach(ramps, start, target, speed, v0)


def plan_trapezoid(
    start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0
) -> Profile:
    """Plan a trapezoidal move from `start` (moving at `v0`) to rest at `target`.

    Units are any length, length/s and length/s². Raises ValueError for numbers that no machine can follow.
    """
    return plan("trapezoid", start, target, speed, accel, decel, v0)


def approach(ramps: Ramps, start: float, target: float, speed: float, v0: float) -> Profile:
    """Return the move from `start` at velocity `v0`, without an acceleration, to rest at `target`."""
    if -STILL < v0 < STILL:
        v0 = 0.0
    distance = target - start
    sign = -1.0 if distance < 0.0 or (distance == 0.0 and v0 < 0.0) else 1.0
    size, u = abs(distance), sign * v0
    if u == 0.0:
        return finish(ramps.shape, start, target, (0.0, *_travel(ramps, size, speed, 0.0, sign)))
    time, kind = ramps.down(abs(u), 0.0)
    stopping = ramp_distance(abs(u), time, kind, 0.0)
    beyond = stopping - size
    recipe: Recipe = (v0, time, kind, 0.0)
    if u < 0.0:
        recipe = (*recipe, *_travel(ramps, size + stopping, speed, 0.0, sign))
    elif not is_rounding(beyond, stopping, start, target):
        if beyond > 0.0:
            recipe = (*recipe, *_travel(ramps, beyond, speed, 0.0, -sign))
        else:
            recipe = (v0, *_travel(ramps, size, speed, u, sign))
    return finish(ramps.shape, start, target, recipe)


def is_rounding(beyond: float, stopping: float, start: float, target: float) -> bool:
    """True if a stop overshoots its target by no more than rounding.

    `stopping` is its length, `beyond` the overshoot.
    """
    return abs(beyond) <= 1e-12 * stopping + 2.3e-16 * (abs(start) + abs(target)) < inf


def finish(shape: str, start: float, target: float, recipe: Recipe) -> Profile:
    """Return the profile of a recipe that ends at rest at `target`.

    Raises ValueError if its duration is not finite.
    """
    duration = fsum(recipe[1::3])
    if not duration < inf:
        raise too_large()
    return Profile(shape, start, target, duration, recipe)


def _travel(ramps: Ramps, size: float, speed: float, u: float, sign: float) -> Recipe:
    """Return ramps that cover `size` in direction `sign`, from speed u >= 0 to rest."""
    _, rows = between(ramps, size, speed, u, 0.0, 0.0)
    return tuple(value for _, time, kind, v in rows for value in (time, kind, sign * v))


def _from_acceleration(
    ramps: JerkRamps, start: float, target: float, speed: float, v0: float, a0: float
) -> Profile:
    """Return the move from velocity v0 and acceleration a0 (not 0) to rest at `target`."""
    made = _continued(ramps, start, target, speed, v0, a0)
    rates = ramps.accel, ramps.decel, ramps.accel_jerk, ramps.decel_jerk
    far_apart = max(rates) > _FAR_APART * min(rates)
    if made is not None and not (far_apart and _is_astray(made)):
        return made
    eased = ease(start, v0, a0, ramps.accel_jerk if a0 * v0 >= 0.0 else ramps.decel_jerk)
    made = eased.then(approach(ramps, eased.end, target, speed, eased.end_velocity))
    if _is_astray(made):
        raise too_large()
    return made


def _continued(
    ramps: JerkRamps, start: float, target: float, speed: float, v0: float, a0: float
) -> Profile | None:
    """Return the move that continues the acceleration where it serves the move.

    None if the figures are so many orders of magnitude apart that rounding misses the target.
    """
    sign = copysign(1.0, v0 or a0)
    u, b, size = sign * v0, sign * a0, sign * (target - start)
    steps, after = initial_steps(ramps, u, b, 0.0)
    covered, head = distance_of_steps(u, b, steps), (u, b, steps, sign)
    if after >= 0.0:
        time, kind = ramps.down(after, 0.0)
        stopping = covered + ramp_distance(after, time, kind, 0.0)
        if is_rounding(stopping - size, stopping, start, target):
            return _arriving(start, target, head, covered, (sign * after, time, kind, 0.0))
        if stopping < size:
            return _ahead(ramps, start, target, speed, u, b, sign)
    if not abs(covered) < inf:
        raise too_large()
    rest = approach(ramps, 0.0, sign * (size - covered), speed, sign * after)
    duration = _time(steps) + rest.duration
    if not duration < inf:
        raise too_large()
    return JerkLimited(start, target, duration, head, rest._recipe, "" if after else "stop")


def _ahead(
    ramps: JerkRamps, start: float, target: float, speed: float, u: float, b: float, sign: float
) -> Profile | None:
    """Return the move if the target lies beyond the shortest stop."""
    size = sign * (target - start)
    steps, rows = between(ramps, size, speed, u, b, 0.0)
    recipe = [value if i else value * sign for row in rows for i, value in enumerate(row[:3])]
    return _arriving(start, target, (u, b, steps, sign), distance_of_steps(u, b, steps), (*recipe, 0.0))


def _time(steps: Steps) -> float:
    time = 0.0
    for _, each in steps:
        time += each
    return time


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


def _is_astray(made: Profile) -> bool:
    """True if the last piece misses the profile's end by over 1e-7 of its positions."""
    if not made.pieces:
        return False
    reached = position_in(made.pieces[-1], made.knots[-1] - made.knots[-2])
    return not abs(reached - made.end) <= 1e-7 * max(map(abs, made.extrema()))


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
        # What `Profile.__init__` assigns, since a running program plans in motion.
        self.shape = "scurve"
        self.start = start
        self.end = end
        self.duration = duration
        self._recipe = (head[0] * head[3], tail[-1])
        self._head = head
        self._tail = tail
        self._name = name

    def _made(self) -> Curve:
        v0, a0, steps, sign = self._head
        head = profile_of_steps(self.start, v0, a0, steps, sign * self._tail[0], sign)
        if self._name:
            head = relabelled(head, "scurve", self._name)
        time = total(self._tail[1::3])
        rest = Profile("scurve", head.end, self.end, time, self._tail) if time else None
        knots, pieces, marks = (head if rest is None else head.then(rest)).curve
        if len(knots) > 1 and self.duration > knots[-2]:
            knots = (*knots[:-1], self.duration)
        return knots, pieces, marks
