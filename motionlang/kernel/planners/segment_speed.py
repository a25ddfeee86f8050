"""A segment of given length between two speeds, as fast as its limits allow.

The limits are its ramps and its highest speed.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign, nextafter, sqrt

from motionlang.kernel.planners.ramps import ramp_distance
from motionlang.kernel.planners.shapes import JerkRamps, Ramps
from motionlang.kernel.planners.transition import Steps, distance_of_steps, eased_speed, initial_steps
from motionlang.kernel.tools import bisected

# Initial speed, time, kind, final speed.
Ramp = tuple[float, float, float, float]


# How far a ramp may exceed the available distance, as a fraction of it, and still fit: rounding.
_SLACK = 1e-12
# The fraction of a distance that is too large to be the rounding of its sum.
_COARSE = 1e-11
# Secants before bisection takes over, and how close, relatively, they bring two numbers.
_SECANTS = 30
_NEAR = 1e-14


def entry_speed(ramps: Ramps, length: float, v1: float, most: float) -> float:
    """Return the highest speed, up to `most`, that brakes to v1 within `length`."""
    if ramps.squares is not None:
        return min(most, sqrt(v1 * v1 + 2.0 * length / ramps.squares[1]))
    return _farthest(v1, most, lambda u: _ramp_length(ramps, u, v1) - length) if v1 < most else most


def exit_speed(ramps: Ramps, length: float, v0: float, a0: float, most: float) -> float | None:
    """Return the highest speed, up to `most`, that can be reached within `length`.

    None if even the initial acceleration cannot be ramped down.
    """
    if ramps.squares is not None:
        return min(most, sqrt(v0 * v0 + 2.0 * length / ramps.squares[0]))
    low = _eased(ramps, v0, a0)
    if low < 0.0 or _lead_length(ramps, v0, a0, low) > length * (1.0 + _SLACK):
        return None
    return _farthest(low, most, lambda v: _lead_length(ramps, v0, a0, v) - length) if low < most else most


def reaches(ramps: Ramps, length: float, v0: float, a0: float, v1: float) -> bool:
    """True if one ramp reaches speed v1 within `length`."""
    return _eased(ramps, v0, a0) >= min(0.0, v1) and (
        _lead_length(ramps, v0, a0, v1) <= length * (1.0 + _SLACK)
    )


def between(
    ramps: Ramps, length: float, speed: float, v0: float, a0: float, v1: float
) -> tuple[Steps, list[Ramp]]:
    """Return the fastest motion from v0 and a0 to v1 <= `speed` over exactly `length`.

    It does not exceed `speed` in between. One ramp must lead from v0 to v1 within `length` (see
    `reaches`); a difference due to rounding is made to fit.
    """
    top = _top(ramps, length, speed, v0, a0, v1)
    steps, first, used = _lead(ramps, v0, a0, top)
    last = _ramp(ramps, top, v1)
    left = length - used - ramp_distance(*last)
    if left < 0.0 and not steps and top in (v0, v1):
        return (), [_fitting(last if top == v0 else first, length)]
    # If rates are very far apart, the last bit of the peak makes a noticeable distance. Choose a lower peak, and slew.
    step = top - nextafter(top, 0.0)
    while left < -_COARSE * length and top > max(v0, v1):
        top, step = max(v0, v1, top - step), 2.0 * step
        steps, first, used = _lead(ramps, v0, a0, top)
        last = _ramp(ramps, top, v1)
        left = length - used - ramp_distance(*last)
    slew = left / top if left > _SLACK * length and top else 0.0
    return steps, [first, (top, slew, 0.0, top), last]


def _top(ramps: Ramps, length: float, speed: float, v0: float, a0: float, v1: float) -> float:
    """Return the speed between the two ramps; it is `speed` if `length` allows."""
    if v0 == a0 == v1 == 0.0 and (peak := ramps.peak(length)) is not None:
        return min(peak, speed)
    if ramps.squares is not None:
        up, down = ramps.squares
        if v0 > speed:
            return max(speed, v1) if 0.5 * down * (v0 * v0 - v1 * v1) <= length else v1
        best = sqrt((2.0 * length + up * v0 * v0 + down * v1 * v1) / (up + down))
        return max(min(best, speed), v1)

    def beyond(v: float) -> float:
        return _lead_length(ramps, v0, a0, v) + _ramp_length(ramps, v, v1) - length

    if beyond(speed) <= 0.0:
        return speed
    eased = _eased(ramps, v0, a0)
    crest = max(eased, v1)
    if beyond(crest) <= 0.0:
        return _farthest(crest, speed, beyond)
    # Braking continues into the last ramp: a constant speed while braking uses the distance up.
    return _farthest(v1, min(eased, speed), beyond) if beyond(v1) <= 0.0 else v1


def _lead(ramps: Ramps, v0: float, a0: float, v: float) -> tuple[Steps, Ramp, float]:
    """Return the motion from v0 and a0 to speed v.

    It is returned as the sections that ramp the acceleration down, the ramp after them, and the distance of the
    complete motion.
    """
    if not a0 or not isinstance(ramps, JerkRamps):
        ramp = _ramp(ramps, v0, v)
        return (), ramp, ramp_distance(*ramp)
    steps, after = initial_steps(ramps, v0, a0, v)
    ramp = _ramp(ramps, after, v)
    rest = ramp_distance(*ramp) if after != v else 0.0
    return steps, ramp, distance_of_steps(v0, a0, steps) + rest


def _lead_length(ramps: Ramps, v0: float, a0: float, v: float) -> float:
    return _lead(ramps, v0, a0, v)[2]


def _eased(ramps: Ramps, v0: float, a0: float) -> float:
    return eased_speed(ramps, v0, a0) if a0 and isinstance(ramps, JerkRamps) else v0


def _ramp(ramps: Ramps, u: float, v: float) -> Ramp:
    return (u, *(ramps.up if v >= u else ramps.down)(u, v), v)


def _ramp_length(ramps: Ramps, u: float, v: float) -> float:
    return ramp_distance(*_ramp(ramps, u, v))


def _fitting(ramp: Ramp, length: float) -> Ramp:
    """Return the ramp with its duration adjusted to make it exactly `length` long."""
    long = ramp_distance(*ramp)
    return (ramp[0], ramp[1] * (length / long), *ramp[2:]) if long else ramp


def _farthest(low: float, high: float, beyond: Callable[[float], float]) -> float:
    """Return the number farthest from `low`, towards `high`, that still fits.

    A number fits if its `beyond` is 0 or less; `low` must fit. Secants between a number that fits and one that
    does not (Illinois: the value of an end that stays twice is halved) run until both are a few bits apart. Bisection
    finds the last bit.
    """
    over = beyond(high)
    if over <= 0.0:
        return high
    under, stays = beyond(low), 0.0
    for _ in range(_SECANTS):
        width = high - low
        if abs(width) <= _NEAR * abs(low):
            break
        x = low - under * (width / (over - under))
        # Go slightly towards the farther end, so that it moves up to the nearer one.
        x += copysign(0.25 * _NEAR * x, width if -under < over else -width)
        if not min(low, high) < x < max(low, high):
            x = 0.5 * (low + high)
        found = beyond(x)
        if found <= 0.0:
            low, under, over, stays = x, found, over * (0.5 if stays > 0.0 else 1.0), 1.0
        else:
            high, over, under, stays = x, found, under * (0.5 if stays < 0.0 else 1.0), -1.0
    return bisected(low, high, lambda x: beyond(x) <= 0.0)
