"""Ramp of a speed reference with separate start and end times of its acceleration.

Drives specify a ramp by the time from rest to their highest speed and, separately, by the times in which the
acceleration builds up at its beginning and decays at its end. Over those times it changes linearly, and
between them it equals the rate: T = dv/A + (T_start + T_end)/2. If a change is too small to reach the rate, the
acceleration peaks where both slopes meet: A' = sqrt(2 dv A / (T_start + T_end)) (own arithmetic).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite, sqrt

from motionlang.kernel.planners.curve import Profile, far_end, relabelled
from motionlang.kernel.planners.limits import STILL, check_finite, check_positive, too_large
from motionlang.kernel.planners.ramps import FALLING, RISING, Recipe, ramp_distance
from motionlang.kernel.planners.transition import ease


@dataclass(eq=False, slots=True)
class Slope:
    """A rate, and the times, s, in which the acceleration builds up and decays."""

    rate: float
    begin: float = 0.0
    end: float = 0.0

    def key(self) -> tuple[float, float, float]:
        """Return a tuple that is equal for equal slopes."""
        return self.rate, self.begin, self.end

    def ramp(self, v0: float, v1: float) -> Recipe:
        """Return the ramp between two velocities, as durations, kinds and velocities."""
        change = v1 - v0
        size, edges = abs(change), self.begin + self.end
        share = min(1.0, sqrt(2.0 * size / (self.rate * edges))) if edges else 1.0
        begin, end = share * self.begin, share * self.end
        hold = max(size / self.rate - 0.5 * edges, 0.0) if share == 1.0 else 0.0
        bend = 0.5 * share * self.rate
        sign = 1.0 if change > 0.0 else -1.0
        return (begin, RISING, v0 + sign * bend * begin, hold, 0.0, v1 - sign * bend * end, end, FALLING)


def plan_reference(start: float, v0: float, v1: float, up: Slope, down: Slope, a0: float = 0.0) -> Profile:
    """Change from velocity `v0` to `v1` and continue endlessly.

    `up` applies away from rest, `down` towards rest and through it. An acceleration `a0` decays first, by the
    slope that it belongs to. Shape and end are those of a jog. Raises ValueError for numbers that no machine can
    follow.
    """
    check_positive(acceleration=up.rate, deceleration=down.rate)
    check_finite(position=start, start_velocity=v0, velocity=v1, start_acceleration=a0)
    own = up if a0 * v0 >= 0.0 else down
    if a0 and own.end:
        eased = ease(start, v0, a0, own.rate / own.end)
        return relabelled(eased.then(_run(eased.end, eased.end_velocity, v1, up, down)), "jog")
    return _run(start, v0, v1, up, down)


def _run(start: float, v0: float, v1: float, up: Slope, down: Slope) -> Profile:
    v0, v1 = (0.0 if -STILL < v < STILL else v for v in (v0, v1))
    if v0 * v1 < 0.0:
        change = (*down.ramp(v0, 0.0), 0.0, *up.ramp(0.0, v1))
    else:
        change = (down if abs(v1) < abs(v0) else up).ramp(v0, v1)
    recipe = (v0, *change, v1, inf, 0.0, v1)
    position = start
    for i in range(0, len(recipe) - 4, 3):
        position += ramp_distance(*recipe[i : i + 4])
    if not isfinite(position):
        raise too_large()
    return Profile("jog", start, far_end(position, v1), inf, recipe)
