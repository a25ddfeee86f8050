"""Times and distances of ramps, stops and moves: a second implementation, by bisection.

It shares nothing with the planners. A move is as fast as the rules of `docs/contributing/decisions.md` allow: it
reverses at rest, and velocities of opposite signs meet there. Velocities and accelerations are counted in one
direction; rates and jerks are pairs, for speeding up and for slowing down.
"""

from __future__ import annotations

from collections.abc import Callable
from math import fsum, inf, isclose, pi, sqrt
from typing import NamedTuple

# A time, and the signed distance in it.
Leg = tuple[float, float]

# Bisections of an interval of speeds after which nothing changes any more.
_HALVES = 70
# The relative rounding of a distance, and of the positions at its ends. These are the sum of up to seven sections, so
# they are rounded nine times, by 2**-53 each.
_ROUNDING, _EPSILON = 1e-13, 9.0 * 2.0**-53


class Law(NamedTuple):
    """The law of a change of velocity: rates, jerks, or a shape.

    A shape takes `stretch` times as long as a linear ramp. `heavy` is the fraction of the distance of a ramp
    that is due to the higher of its two speeds.
    """

    rates: tuple[float, float]
    jerks: tuple[float, float] = (inf, inf)
    stretch: float = 1.0
    heavy: float = 0.5

    @property
    def smooth(self) -> bool:
        """True if the slope of the acceleration is bounded."""
        return self.jerks[0] < inf


def law(shape: str, rates: tuple[float, float], jerks: tuple[float, float], ramp: float) -> Law:
    """Return the law of a shape.

    The shapes of TN1069 take T = (pi/2) V/A, V/(A (1 - n)), and 2 V/A with two thirds of V T.
    """
    if jerks[0] < inf or shape == "trapezoid":
        return Law(rates, jerks)
    if shape == "sinusoidal":
        return Law(rates, stretch=0.5 * pi)
    if shape == "parabolic":
        return Law(rates, stretch=2.0, heavy=2.0 / 3.0)
    return Law(rates, stretch=1.0 / (1.0 - ramp))


def ramp(u: float, v: float, by: Law) -> Leg:
    """Return a ramp from speed u >= 0 to v >= 0, with zero acceleration at both ends."""
    side = 0 if v > u else 1
    rate, jerk, change = by.rates[side], by.jerks[side], abs(v - u)
    if jerk < inf:
        time = change / rate + rate / jerk if change >= rate * rate / jerk else 2.0 * sqrt(change / jerk)
    else:
        time = by.stretch * change / rate
    return time, time * (by.heavy * max(u, v) + (1.0 - by.heavy) * min(u, v))


def lead(v0: float, a0: float, v1: float, by: Law) -> Leg:
    """Return a ramp from velocity v0, acceleration a0 to velocity v1, acceleration 0."""
    if v0 < 0.0 or (v0 == 0.0 and (a0 < 0.0 or (not a0 and v1 < 0.0))):
        time, covered = lead(-v0, -a0, -v1, by)
        return time, -covered
    if v1 < 0.0:
        if reverses(v0, a0, by):  # it is already accelerating that way when its acceleration is ramped down
            back = _steps(v0, a0, [(-a0, -a0 / by.jerks[1])])
            return _both(back, lead(v0 - 0.5 * a0 * a0 / by.jerks[1], 0.0, v1, by))
        return _both(lead(v0, a0, 0.0, by), lead(0.0, 0.0, v1, by))
    if not a0 or not by.smooth:
        return ramp(v0, v1, by)
    side = 0 if a0 > 0.0 else 1
    rate, jerk, size = by.rates[side], by.jerks[side], abs(a0)
    eased = 0.5 * size * size / jerk
    gain = v1 - v0 if a0 > 0.0 else v0 - v1
    if gain < eased:  # it does not help: it is ramped down first
        return _both(
            _steps(v0, a0, [(-a0, size / jerk)]), lead(v0 + (eased if side == 0 else -eased), 0.0, v1, by)
        )
    sign = 1.0 if side == 0 else -1.0
    if size > rate:  # above the present limit: it is ramped down to that first
        hold = (gain - eased) / rate
        return _steps(
            v0, a0, [(-sign * (size - rate), (size - rate) / jerk), (0.0, hold), (-sign * rate, rate / jerk)]
        )
    peak = min(rate, sqrt(jerk * (gain + eased)))
    hold = max(0.0, (gain + eased) / peak - peak / jerk) if peak else 0.0
    return _steps(
        v0, a0, [(sign * (peak - size), (peak - size) / jerk), (0.0, hold), (-sign * peak, peak / jerk)]
    )


def _steps(v: float, a: float, steps: list[tuple[float, float]]) -> Leg:
    """Return time and distance of a sequence of linear changes of acceleration.

    Each step is a change and its duration.
    """
    covered = 0.0
    for change, time in steps:
        covered += time * (v + time * (0.5 * a + change / 6.0))
        v += time * (a + 0.5 * change)
        a += change
    return fsum(time for _, time in steps), covered


def _both(first: Leg, second: Leg) -> Leg:
    return first[0] + second[0], first[1] + second[1]


def move_time(v0: float, a0: float, distance: float, speed: float, by: Law, rounding: float = 0.0) -> float:
    """Return the time from a velocity and an acceleration to rest after `distance`.

    The speed is at most `speed`. A distance of up to `rounding` at the top speed takes no time, because that
    speed may be near zero by rounding.
    """
    if v0 < 0.0 or (v0 == 0.0 and (a0 < 0.0 or (not a0 and distance < 0.0))):
        v0, a0, distance = -v0, -a0, -distance
    if reverses(
        v0, a0, by
    ):  # it moves the other way when its acceleration is ramped down, possibly towards the target
        change = -a0 / by.jerks[1]
        time, covered = _steps(v0, a0, [(-a0, change)])
        return time + move_time(v0 + 0.5 * a0 * change, 0.0, distance - covered, speed, by, rounding)
    time, covered = lead(v0, a0, 0.0, by)
    if covered > distance:
        return time + _travel(0.0, 0.0, abs(distance - covered), speed, by, rounding)
    return _travel(v0, a0, distance, speed, by, rounding)


def rounding(distance: float, *positions: float) -> float:
    """Return the possible rounding error of a distance between positions."""
    return _ROUNDING * abs(distance) + _EPSILON * max(map(abs, positions))


def move_times(
    v0: float, a0: float, distance: float, speed: float, by: Law, rounded: float
) -> tuple[float, float]:
    """Return the shortest and longest time of a move over a rounded distance.

    If the distance is barely enough for a stop, the difference is covered from standstill: its time grows
    with its square root, or cube root.
    """
    if not (v0 or a0):
        whole = move_time(v0, a0, distance, speed, by)
        return min(whole, move_time(v0, a0, distance, speed, by, rounded)), whole
    times = [move_time(v0, a0, distance + d, speed, by) for d in (-rounded, 0.0, rounded)]
    least = min(*times, move_time(v0, a0, distance, speed, by, rounded))
    time, covered = lead(v0, a0, 0.0, by)
    if abs(covered - distance) <= rounded:
        least = min(least, time, ends_together(v0, a0, by))
    return least, max(times)


def ends_together(v0: float, a0: float, by: Law) -> float:
    """Return when velocity and acceleration become zero together, within rounding.

    inf if they do not.
    """
    together = by.smooth and a0 * v0 < 0.0 and isclose(0.5 * a0 * a0 / by.jerks[1], abs(v0))
    return abs(a0) / by.jerks[1] if together else inf


def reverses(v0: float, a0: float, by: Law, margin: float = 1e-9) -> bool:
    """True if a velocity changes sign before its acceleration can be ramped down.

    It has to do so by a fraction `margin` of v0; with a negative one, just reaching zero counts, too.
    """
    return by.smooth and a0 < 0.0 and 0.5 * a0 * a0 / by.jerks[1] > v0 * (1.0 + margin)


def _travel(v0: float, a0: float, distance: float, speed: float, by: Law, rounding: float) -> float:
    """Return the time of a move whose distance suffices for a stop."""
    top, left = _top(v0, a0, distance, speed, by)
    hold = max(0.0, left - rounding) / top if top > 0.0 else 0.0
    return lead(v0, a0, top, by)[0] + ramp(top, 0.0, by)[0] + hold


def _top(v0: float, a0: float, distance: float, speed: float, by: Law) -> Leg:
    """Return the top speed, and the distance left for it."""

    def room(v: float) -> float:
        return distance - lead(v0, a0, v, by)[1] - ramp(v, 0.0, by)[1]

    jerk = by.jerks[0 if a0 > 0.0 else 1]
    eased = v0 + (0.5 * a0 * abs(a0) / jerk if by.smooth else 0.0)
    if room(speed) >= 0.0:
        top = speed
    elif eased <= speed:
        crest = room(eased) >= 0.0
        top = _last(eased if crest else 0.0, speed if crest else eased, room)
    elif room(eased) >= 0.0:  # two brakings need more distance than one; a higher speed between needs less
        top = _last(eased, speed, room)
    else:
        top = _last(0.0, speed, room)
    return top, max(0.0, room(top))


def _last(fits: float, other: float, room: Callable[[float], float]) -> float:
    """Return the speed farthest from `fits`, towards `other`, that still fits."""
    for _ in range(_HALVES):
        middle = 0.5 * (fits + other)
        if middle in (fits, other):
            break
        fits, other = (middle, other) if room(middle) >= 0.0 else (fits, middle)
    return fits
