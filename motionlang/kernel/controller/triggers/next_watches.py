"""Watches of an axis at a new profile: only the nearest are solved, others later.

Passes have the same times, order and directions as if all watches were solved at once: an axis reaches the far
ones after the near ones, and each has its order number from the start of the profile.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from math import inf

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.controller.triggers.watch import (
    Watch,
    arm,
    side_of,
    solve_reserved,
    take_side,
    watched_position,
)
from motionlang.kernel.controller.watches import Key
from motionlang.kernel.planners import Profile

# Shapes without jumps of the position. Others (tables, points, sums) may jump, so all watches are solved on
# them.
_UNBROKEN = {"trapezoid", "sinusoidal", "scurve", "parabolic", "jog", "hold", "reference"}
# Counts and seconds, far above rounding, within which two watches may be passed in either order.
_NEAR, _SOON = 1e-3, 1e-9
_RELATIVE = 1e-9
# Solving all of up to this many watches is faster than finding the next ones.
_MAX_SOLVED = 6


class NextWatches:
    """The next watches above (`direction` 1) or below (-1) an axis.

    Solved are the first watch, those that may coincide with it, and one that is certainly later.
    """

    __slots__ = ("_axis", "_base", "_clock", "_datum", "_direction", "_here", "_keys", "_last", "_over", "_profile",
                 "_start", "_waiting")  # fmt: skip

    def __init__(
        self, axis: Axis, clock: Clock, keys: list[Key], direction: int, datum: float, begin: int, base: int
    ) -> None:
        self._axis, self._clock, self._keys, self._direction, self._base = axis, clock, keys, direction, base
        self._start, self._profile, self._datum = axis.starts[-1], axis.profiles[-1], datum
        self._here = self._profile.position(0.0)
        self._waiting: list[tuple[float, float, Watch]] = []  # time, position
        self._over = False
        # The last one checked, or the next one the other way; the first one to check follows it.
        before = begin - direction
        self._last = keys[before][:2] if 0 <= before < len(keys) else (-direction * inf, -direction)

    def leave(self, watch: Watch) -> None:
        """Remove a watch that is passed, ended or solved elsewhere; the next ones move up."""
        watch.front = None
        self._waiting = [each for each in self._waiting if each[2] is not watch]
        self.extend()

    def extend(self) -> bool:
        """Solve as many watches as needed; True if one of them has an event."""
        while not self._over and not self._enough():
            watch = self._following()
            if watch is None:
                self._over = True
            elif watch not in self._axis.watches.loose:
                self._solve(watch)
        return bool(self._waiting)

    def _enough(self) -> bool:
        if not self._waiting:
            return False
        time, position, _ = self._waiting[-1]
        soonest, nearest = min(self._waiting, key=lambda each: each[0])[0], self._waiting[0][1]
        gap = _NEAR + _RELATIVE * (abs(nearest) + abs(self._datum))
        return time > soonest + _SOON and abs(position - nearest) > gap

    def _following(self) -> Watch | None:
        keys = self._keys
        if self._direction > 0:
            k = bisect_right(keys, self._last, key=_sorted_by)
        else:
            k = bisect_left(keys, self._last, key=_sorted_by) - 1
        if not 0 <= k < len(keys):
            return None
        self._last = keys[k][:2]
        return keys[k][2]

    def _solve(self, watch: Watch) -> None:
        axis = self._axis
        axis.watches.loose[watch] = None
        at = watch.position + self._datum if watch.physical else watch.position
        solve_reserved(axis, watch, self._clock, self._start, self._profile, at, -self._direction,
                   self._base + watch.order)  # fmt: skip
        if watch.event is not None:
            watch.front = self
            self._waiting.append((watch.event.time, watch.position, watch))
        elif self._misses(watch.position):
            self._over = True

    def _misses(self, position: float) -> bool:
        """True if an unreached watch is so far away that those beyond are not reached."""
        if self._waiting:
            near = self._waiting[0][1]
        else:
            near = self._here - self._datum
        return abs(position - near) > _NEAR + _RELATIVE * (abs(near) + abs(self._datum))


def _sorted_by(key: Key) -> tuple[float, int]:
    return key[:2]


def follow(axis: Axis, clock: Clock) -> None:
    """Solve the next watches on a new profile; passes due now happen first."""
    watches, now = axis.watches, clock.now
    if len(watches.all) <= _MAX_SOLVED:
        _each(axis, clock)
        return
    for watch in watches.loose:
        event = watch.event
        if event is not None and event.call is not None and event.time <= now:
            _each(axis, clock)
            return
    profile, start, datum = axis.profiles[-1], axis.starts[-1], axis.datum
    here = profile.position(now - start)
    loose = watches.loose
    for watch in loose:
        watch.front = None
        if watch.event is not None:
            watch.event.cancel()
            watch.event = None
        take_side(axis, watch, here)
    watches.loose = {}
    band = 1e-5 + 1e-10 * (abs(here) + abs(datum))
    spans = []
    for keys, offset, k in ((watches.program, 0.0, 0), (watches.machine, datum, 1)):
        if not keys:
            continue
        at, before = here - offset, watches.seen[k]
        watches.seen[k] = at
        reach = band + 1e-10 * abs(before)
        low, high = bisect_left(keys, (at - band,)), bisect_right(keys, (at + band, inf))
        first = bisect_left(keys, (min(at, before) - reach,))
        last = bisect_right(keys, (max(at, before) + reach, inf))
        for _, _, watch in keys[first:last]:
            if watch not in loose:
                take_side(axis, watch, here)
        spans.append((keys, offset, low, high))
    if profile.shape == "hold":
        return
    base = clock.reserve(watches.count)
    whole = type(profile) is not Profile or profile.shape not in _UNBROKEN
    waits = False
    for keys, offset, low, high in spans:
        for _, _, watch in keys if whole else keys[low:high]:
            watches.loose[watch] = None
            at = watched_position(axis, watch)
            solve_reserved(axis, watch, clock, start, profile, at, side_of(here - at, at), base + watch.order)
            waits = waits or watch.event is not None
        if not whole:
            for direction, begin in ((1, high), (-1, low - 1)):
                waits = NextWatches(axis, clock, keys, direction, offset, begin, base).extend() or waits
    if waits:
        clock.made += 1


def _each(axis: Axis, clock: Clock) -> None:
    """Solve every watch in order of creation; a pass due now may end others."""
    every, now = axis.watches.all, clock.now
    each = tuple(every)
    for watch in each:
        watch.front = None
    axis.watches.loose = every.copy()
    for watch in each:
        if watch in every:
            arm(axis, watch, clock, now)
