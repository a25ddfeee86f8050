"""A stretch of a path from one speed to another, for paths that are run through without coming to rest."""

from __future__ import annotations

from math import inf, sqrt

from motionlang.profile.curve import Profile
from motionlang.profile.ramps import ramp_distance
from motionlang.profile.shapes import plan
from motionlang.profile.stop import ramps_of
from motionlang.profile.total import total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.profile.approach import Ramps
    from motionlang.profile.ramps import Recipe


class Pace:
    """How fast a path may be run: `shape`, speed, rates, and what the S-curves need beside."""

    __slots__ = ("accel", "accel_jerk", "decel", "decel_jerk", "ramp", "shape", "speed")

    def __init__(
        self,
        shape: str,
        speed: float,
        accel: float,
        decel: float,
        ramp: float = 0.1,
        accel_jerk: float = inf,
        decel_jerk: float = inf,
    ) -> None:
        self.shape, self.speed, self.accel, self.decel = shape, speed, accel, decel
        self.ramp, self.accel_jerk, self.decel_jerk = ramp, accel_jerk, decel_jerk

    def key(self) -> tuple[object, ...]:
        """What two stretches must share to be run through as one."""
        return (
            self.shape,
            self.speed,
            self.accel,
            self.decel,
            self.ramp,
            self.accel_jerk,
            self.decel_jerk,
        )

    def ramps(self) -> Ramps:
        """The ramps of its shape."""
        return ramps_of(self.shape, self.accel, self.decel, self.ramp, self.accel_jerk, self.decel_jerk)


def plan_between(pace: Pace, start: float, end: float, v0: float, v1: float, a0: float = 0.0) -> Profile:
    """From `start` at speed v0 >= 0 to `end` at speed v1 >= 0; ValueError for numbers no machine can follow.

    A v1 that cannot be reached on the way by the rates of `pace` (which `entry_speed` rules out, but for rounding) is
    reached by one ramp that just fits.
    """
    if v1 <= 0.0:
        rates = pace.speed, pace.accel, pace.decel
        return plan(pace.shape, start, end, *rates, v0, pace.ramp, pace.accel_jerk, pace.decel_jerk, a0)
    ramps, length = pace.ramps(), end - start
    top = _top_speed(ramps, length, pace.speed, v0, v1)
    if top is None:
        recipe: Recipe = (v0, 2.0 * length / (v0 + v1), 0.0, v1)
    else:
        first, kind = (ramps.up if top >= v0 else ramps.down)(v0, top)
        last, last_kind = (ramps.down if top >= v1 else ramps.up)(top, v1)
        left = length - ramp_distance(v0, first, kind, top) - ramp_distance(top, last, last_kind, v1)
        slew = max(left, 0.0) / top
        recipe = (v0, first, kind, top, slew, 0.0, top, last, last_kind, v1)
    return Profile(pace.shape, start, end, total(recipe[1::3]), recipe)


def entry_speed(pace: Pace, length: float, v1: float) -> float:
    """The highest speed, up to that of `pace`, from which speed v1 can be reached within `length`."""
    if pace.shape == "trapezoid":
        return min(pace.speed, sqrt(v1 * v1 + 2.0 * pace.decel * length))
    ramps = pace.ramps()
    return _largest(v1, pace.speed, lambda u: _distance(ramps, u, v1) <= length)


def _top_speed(ramps: Ramps, length: float, speed: float, v0: float, v1: float) -> float | None:
    """The speed between the two ramps: `speed` where there is room for it, None where there is room for none."""

    def fits(v: float) -> bool:
        return _distance(ramps, v0, v) + _distance(ramps, v, v1) <= length

    low = max(v0, v1)
    if low > speed:
        return speed if fits(speed) else None
    if fits(speed):
        return speed
    return _largest(low, speed, fits) if fits(low) else None


def _distance(ramps: Ramps, u: float, v: float) -> float:
    time, kind = (ramps.up if v >= u else ramps.down)(u, v)
    return ramp_distance(u, time, kind, v)


def _largest(low: float, high: float, fits: object) -> float:
    """The largest number from `low`, which fits, to `high`, that fits, by bisection to the last bit."""
    assert callable(fits)
    if fits(high):
        return high
    while True:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            return low
        low, high = (middle, high) if fits(middle) else (low, middle)
