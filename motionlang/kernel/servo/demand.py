"""The commanded track as the trajectory generator sees it: one point per cycle.

At the beginning of cycle i the generator gives the point for its end, from the profile that was in force just
before. So a move takes effect in the first cycle that begins after its start, whether the complete track is
known or only the past. The loop interpolates linearly between the points (TN1069).
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Sequence
from copy import copy
from itertools import pairwise
from math import ceil, floor
from typing import Protocol

from motionlang.kernel.planners import Profile

# The last cycle of an endless profile.
FOR_EVER = 1 << 62
_JUMP = 1e-6
_AT_ONCE = 1e-9


class Demanded(Protocol):
    """A history of motion, such as an `Axis`: `profiles[i]` began at `starts[i]`."""

    @property
    def starts(self) -> Sequence[float]:
        """Times in seconds, rising."""

    @property
    def profiles(self) -> Sequence[Profile]:
        """The profiles that began at `starts`; the last one never ends."""


class Track:
    """A history of motion that is not an axis: `Track([0.0], [profile])`."""

    __slots__ = ("profiles", "starts")

    def __init__(self, starts: Sequence[float], profiles: Sequence[Profile]) -> None:
        if not profiles or len(starts) != len(profiles):
            raise ValueError("a track needs one start for each profile, and at least one profile")
        self.starts, self.profiles = list(starts), list(profiles)


class Generator:
    """Points of a track, cycle by cycle; `period` is the trajectory cycle in seconds.

    A track jumps when the program redefines the position (POS = 0, DH). The motor does not move then, so the
    jump is accumulated in `offset` (counts to add to the track) and removed from the points.
    """

    __slots__ = ("_at", "_known", "_offsets", "_since", "period", "track")

    def __init__(self, track: Demanded, period: float) -> None:
        self.track, self.period = track, period
        # The profile last found in force: the next one is near, so a long track is not searched.
        self._at = 0
        # The offsets, the profiles from which on they apply, and the profile up to which they are known.
        self._offsets, self._since, self._known = array("d", [0.0]), array("q", [0]), 0

    def in_force(self, cycle: int) -> int:
        """Return the index of the profile that determines the end point of `cycle`."""
        return self.in_force_at((cycle - _AT_ONCE) * self.period)

    def in_force_at(self, time: float) -> int:
        """Return the index of the profile in force at a time; 0 before the first one."""
        starts = self.track.starts
        last = len(starts) - 1
        k, step = min(self._at, last), 1
        if starts[k] <= time:  # galloping search: it lies from `k` on, and before `past`
            past = k + 1
            while past <= last and starts[past] <= time:
                k, past, step = past, past + step, 2 * step
        else:
            past = k
            while k > 0 and starts[k] > time:
                k, past, step = max(k - step, 0), k, 2 * step
        if k + 1 < past:
            k = max(bisect_right(starts, time, k, min(past, last + 1)) - 1, 0)
        self._at = k
        return k

    def past(self, profile: int) -> int:
        """Return the first cycle whose point is from a later profile, or `FOR_EVER`."""
        starts = self.track.starts
        if profile + 1 >= len(starts):
            return FOR_EVER
        until = ceil(starts[profile + 1] / self.period)
        while self.in_force(until) <= profile:
            until += 1
        while self.in_force(until - 1) > profile:
            until -= 1
        return until

    def offset(self, profile: int) -> float:
        """Return the counts to add to the track while `profile` is in force."""
        if profile > self._known:
            self._get_to_know(profile)
        k = len(self._since) - 1
        while self._since[k] > profile:
            k -= 1
        return self._offsets[k]

    def _get_to_know(self, profile: int) -> None:
        known = self._known
        starts = self.track.starts[known : profile + 1]
        pairs = pairwise(zip(starts, self.track.profiles[known : profile + 1], strict=True))
        for k, ((begun, before), (start, after)) in enumerate(pairs, known + 1):
            gap = after.start - before.position(start - begun)
            if abs(gap) > _JUMP + 1e-12 * abs(after.start):
                self._since.append(k)
                self._offsets.append(self._offsets[-1] - gap)
        self._known = profile

    def shifts(self, first: int, until: int, rate: float) -> list[tuple[int, float]]:
        """Return the offset at sample `first`, and its changes before `until`.

        Each is a sample and the offset from there on. A sample exactly at the time of a change precedes it.
        """
        starts = self.track.starts
        now = self.in_force_at((first - _AT_ONCE) / rate)
        if now + 1 == len(starts):
            return [(first, self.offset(now))]
        last = self.in_force_at((until - _AT_ONCE) / rate)
        while last > now and floor(starts[last] * rate + _AT_ONCE) + 1 >= until:
            last -= 1
        found = [(first, self.offset(now))]
        self.offset(last)  # computes the offsets up to there
        for k in self._since[bisect_right(self._since, now) : bisect_right(self._since, last)]:
            if self.offset(k) != found[-1][1]:
                found.append((floor(starts[k] * rate + _AT_ONCE) + 1, self.offset(k)))
        return found

    def copy(self) -> Generator:
        """Return a generator of the same track that knows as much."""
        made = copy(self)
        made._offsets, made._since = self._offsets[:], self._since[:]
        return made

    def drop(self, count: int) -> None:
        """Continue on the track without its first `count` profiles, which it drops next."""
        self.offset(count)
        self._at, self._known = max(self._at - count, 0), self._known - count
        old = bisect_right(self._since, count) - 1
        del self._offsets[:old], self._since[:old]
        self._since = array("q", [max(since - count, 0) for since in self._since])

    def rebase(self, cycle: int, position: float, profile: int | None = None) -> None:
        """Let `position` be the track's position in `cycle`, in which the loop is closed.

        `profile` is the index of the profile in force, by default the last one that began before the cycle.
        """
        k = self.in_force(cycle) if profile is None else profile
        self.offset(k)
        track = self.track
        here = track.profiles[k].position(cycle * self.period - track.starts[k])
        while self._since and self._since[-1] >= k:
            self._since.pop()
            self._offsets.pop()
        self._since.append(k)
        self._offsets.append(position - here)
        self._known = k

    def first(self, cycle: int = 0) -> float:
        """Return the point at the beginning of `cycle`, where a run begins."""
        k = self.in_force(cycle)
        return self.offset(k) + self.track.profiles[k].position(cycle * self.period - self.track.starts[k])

    def points(self, cycle: int, count: int) -> list[float]:
        """Return the points at the ends of `count` cycles from `cycle`."""
        made: list[float] = []
        until = cycle + count
        while cycle < until:
            k = self.in_force(cycle)
            past, start, offset = min(self.past(k), until), self.track.starts[k], self.offset(k)
            position = self.track.profiles[k].position
            made += [position((i + 1) * self.period - start) + offset for i in range(cycle, past)]
            cycle = past
        return made
