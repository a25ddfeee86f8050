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

Data. The result is a `Profile` with a recipe (`ramps.py`), which becomes polynomials only when the curve is read. With
an acceleration it is a list of pieces from the beginning: sections of constant jerk, then those of a recipe. `u` and
`b` are velocity and acceleration in the direction of motion.

Invariants.
- The profile ends at rest at the target, and its duration is finite.
- Speed, rates and jerk stay within their limits. A start above a limit returns within it.
- A reversal is at rest and without acceleration, unless the initial acceleration carries the motion through zero speed.
  A faster reversal would keep its acceleration; see `docs/contributing/decisions.md`.
- Figures too many orders of magnitude apart raise ValueError.

Cost. 4 µs from rest, 16 µs from a velocity and an acceleration, and 80 µs where the search is necessary.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import copysign, inf

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.limits import LARGEST, STILL, check_finite, check_rates, too_large
from motionlang.kernel.planners.pieces import position_in
from motionlang.kernel.planners.ramps import Recipe, ramp_distance
from motionlang.kernel.planners.segment_speed import Ramp, between
from motionlang.kernel.planners.shapes import JerkRamps, Ramps, ramps_of
from motionlang.kernel.planners.transition import REST, distance_of_steps, ease, initial_steps, joined

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
    if not a0 or not isinstance(ramps, JerkRamps):
        return approach(ramps, start, target, speed, v0)
    made = approach(ramps, start, target, speed, v0, a0)
    rates = accel, decel, ramps.accel_jerk, ramps.decel_jerk
    if max(rates) > _FAR_APART * min(rates) and _is_astray(made):
        eased = ease(start, v0, a0, ramps.accel_jerk if a0 * v0 >= 0.0 else ramps.decel_jerk)
        made = eased.then(approach(ramps, eased.end, target, speed, eased.end_velocity))
        if _is_astray(made):
            raise too_large()
    return made


def plan_trapezoid(
    start: float, target: float, speed: float, accel: float, decel: float, v0: float = 0.0
) -> Profile:
    """Plan a trapezoidal move from `start` (moving at `v0`) to rest at `target`.

    Units are any length, length/s and length/s². Raises ValueError for numbers that no machine can follow.
    """
    return plan("trapezoid", start, target, speed, accel, decel, v0)


def approach(ramps: Ramps, start: float, target: float, speed: float, v0: float, a0: float = 0.0) -> Profile:
    """Return the move from `start` at velocity `v0` and acceleration `a0` to rest at `target`."""
    if -STILL < v0 < STILL:
        v0 = 0.0
    sign = copysign(1.0, v0 or a0 or target - start)
    if not v0 and not a0:  # the case of nearly every move
        rows = between(ramps, sign * (target - start), speed, 0.0, 0.0, 0.0)[1]
        return joined(ramps.shape, start, target, REST, _recipe(rows, sign))
    u, b, size = sign * v0, sign * a0, sign * (target - start)
    steps, after = initial_steps(ramps, u, b, 0.0) if b else ((), u)  # type: ignore[arg-type]
    covered = distance_of_steps(u, b, steps)
    if after >= 0.0:
        time, kind = ramps.down(after, 0.0)
        stopping = covered + ramp_distance(after, time, kind, 0.0)
        tail = (sign * after, time, kind, 0.0)
        if stopping < size and not is_rounding(stopping - size, stopping, start, target):
            steps, rows = between(ramps, size, speed, u, b, 0.0)
            return joined(ramps.shape, start, target, (u, b, steps, sign), _recipe(rows, sign))
        if is_rounding(stopping - size, stopping, start, target):
            return joined(ramps.shape, start, target, (u, b, steps, sign), tail)
        rows = between(ramps, stopping - size, speed, 0.0, 0.0, 0.0)[1]
        return joined(ramps.shape, start, target, (u, b, steps, sign), (*tail, *_recipe(rows, -sign)[1:]))
    if not abs(covered) < inf:
        raise too_large()
    rest = approach(ramps, 0.0, sign * (size - covered), speed, sign * after)
    return joined(ramps.shape, start, target, (u, b, steps, sign), rest._recipe)


def _recipe(rows: Sequence[Ramp], sign: float) -> Recipe:
    flat: list[float] = []
    speed, velocity = 0.0, 0.0
    for u, time, kind, _ in rows:
        if u != speed:  # equal velocities are one object, since the log keeps each recipe
            speed, velocity = u, sign * u
        flat += velocity, time, kind
    last = rows[-1][3]
    return (*flat, sign * last if last else 0.0)


def is_rounding(beyond: float, stopping: float, start: float, target: float) -> bool:
    """True if a stop overshoots its target by no more than rounding.

    `stopping` is its length, `beyond` the overshoot.
    """
    return abs(beyond) <= 1e-12 * stopping + 2.3e-16 * (abs(start) + abs(target)) < inf


def _is_astray(made: Profile) -> bool:
    """True if the last piece misses the profile's end by over 1e-7 of its positions."""
    if not made.pieces:
        return False
    reached = position_in(made.pieces[-1], made.knots[-1] - made.knots[-2])
    return not abs(reached - made.end) <= 1e-7 * max(map(abs, made.extrema()))
