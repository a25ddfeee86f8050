"""The demanded track as the trajectory generator sees it: one point for every trajectory cycle.

At the beginning of cycle i the generator gives the point for its end, from the profile that was in force just before:
a move shows from the first cycle that begins after its start, whether the whole track is known or only the past. The
loop interpolates between the points in straight lines (TN1069).
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from itertools import pairwise
from math import ceil, floor
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from motionlang.planners import Profile

    # The demand over trajectory cycles: the coefficients of 1, c, c² and c³, counts.
    Cubic = tuple[float, float, float, float]

SHORT = 200
"""Below this many points plain floats are quicker than making a table of the pieces."""
FOR_EVER = 1 << 62
"""The cycle at which what never ends does."""
_JUMP = 1e-6
_AT_ONCE = 1e-9


class Demanded(Protocol):
    """A history of motion: `starts[i]` is when `profiles[i]` began. An `Axis` is one."""

    @property
    def starts(self) -> Sequence[float]:
        """Times in seconds, rising."""

    @property
    def profiles(self) -> Sequence[Profile]:
        """What began then; the last one goes on for ever."""


class Track:
    """A history of motion that stands alone: `Track([0.0], [profile])`."""

    __slots__ = ("profiles", "starts")

    def __init__(self, starts: Sequence[float], profiles: Sequence[Profile]) -> None:
        if not profiles or len(starts) != len(profiles):
            raise ValueError("a track needs one start for each profile, and at least one profile")
        self.starts, self.profiles = list(starts), list(profiles)

    @property
    def end(self) -> float:
        """When the last profile is done, seconds."""
        return self.starts[-1] + self.profiles[-1].duration


class Generator:
    """Points of a track, cycle by cycle; `period` is the trajectory cycle in seconds.

    A track jumps where the program gives a position another name (POS = 0, DH): the motor does not move then, so
    the jump is kept in `offset` (counts to add to the track) and taken out of the points.
    """

    __slots__ = ("_at", "_known", "_offsets", "_since", "period", "track")

    def __init__(self, track: Demanded, period: float) -> None:
        self.track, self.period = track, period
        # The profile that was last found in force: the next one is near, and a long track is not searched.
        self._at = 0
        # The offsets, the profiles from which on they hold, and up to which profile they are known.
        self._offsets, self._since, self._known = array("d", [0.0]), array("q", [0]), 0

    def in_force(self, cycle: int) -> int:
        """The number of the profile that makes the point for the end of `cycle`."""
        return self.in_force_at((cycle - _AT_ONCE) * self.period)

    def in_force_at(self, time: float) -> int:
        """The number of the profile that is in force at a time; that of the first one before it."""
        starts = self.track.starts
        last = len(starts) - 1
        k, step = min(self._at, last), 1
        if starts[k] <= time:  # further and further on from there: it lies from `k` on, and before `past`
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
        """The first cycle whose point a later profile makes; `FOR_EVER` for the last one."""
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
        """Counts to add to the track while `profile` is in force."""
        if profile > self._known:
            self._get_to_know(profile)
        k = len(self._since) - 1
        while self._since[k] > profile:
            k -= 1
        return self._offsets[k]

    def offsets(self, first: int, past: int) -> NDArray[np.float64]:
        """Those of the profiles from one to another, not included."""
        import numpy as np

        self.offset(past - 1)
        places = np.searchsorted(np.array(self._since), np.arange(first, past), "right") - 1
        made: NDArray[np.float64] = np.array(self._offsets)[places]
        return made

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
        """The samples from `first` to `until` (not included) at which the offset changes, and what it is then.

        A sample at the very moment of a change comes before it.
        """
        starts = self.track.starts
        now = self.in_force_at((first - _AT_ONCE) / rate)
        if now + 1 == len(starts):
            return [(first, self.offset(now))]
        last = self.in_force_at((until - _AT_ONCE) / rate)
        while last > now and floor(starts[last] * rate + _AT_ONCE) + 1 >= until:
            last -= 1
        found = [(first, self.offset(now))]
        self.offset(last)  # makes known what there is to there
        for k in self._since[bisect_right(self._since, now) : bisect_right(self._since, last)]:
            if self.offset(k) != found[-1][1]:
                found.append((floor(starts[k] * rate + _AT_ONCE) + 1, self.offset(k)))
        return found

    def rebase(self, cycle: int, position: float, profile: int | None = None) -> None:
        """From now on the track's own position in `cycle` is `position`: the loop has been closed there.

        `profile` is the number of the one in force; without it the last one that began before the cycle.
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
        """The point at the beginning of `cycle`, before anything has moved."""
        k = self.in_force(cycle)
        return self.offset(k) + self.track.profiles[k].position(cycle * self.period - self.track.starts[k])

    def points(
        self, cycle: int, count: int, known: Sequence[float] = ()
    ) -> Sequence[float] | NDArray[np.float64]:
        """`known`, then the points at the ends of `count` cycles from `cycle` on; many of them as an array."""
        if count > SHORT:
            import numpy as np

            return np.concatenate((known, self.table(cycle, count)))
        k = self.in_force(cycle)
        if k != self.in_force(cycle + count - 1):
            return [*known, *(self.point(i) for i in range(cycle, cycle + count))]
        period, start, offset = self.period, self.track.starts[k], self.offset(k)
        times = [i * period - start for i in range(cycle + 1, cycle + count + 1)]
        return [*known, *(place + offset for place in self.track.profiles[k].positions(times))]

    def point(self, cycle: int) -> float:
        """The point for the end of a cycle."""
        k = self.in_force(cycle)
        time = (cycle + 1) * self.period - self.track.starts[k]
        return self.track.profiles[k].position(time) + self.offset(k)

    def table(self, cycle: int, count: int) -> NDArray[np.float64]:
        """The same points by NumPy."""
        import numpy as np

        from motionlang.planners.sample import PieceTable

        first, last = self.in_force(cycle), self.in_force(cycle + count - 1)
        begins, profiles = self.track.starts[first : last + 1], self.track.profiles[first : last + 1]
        starts, table = np.array(begins), PieceTable(begins, profiles)
        made = table.sample((cycle + 1) * self.period, self.period, count)
        offset = self.offset(last)
        if first == last:
            if offset:
                made += offset
            return made
        offsets = self.offsets(first, last + 1)
        if offsets.any():
            owners = (
                np.searchsorted(starts, np.arange(cycle + 1, cycle + count + 1) * self.period, "right") - 1
            )
            made += offsets[np.maximum(owners, 0)]
        # What begins in a cycle does not show at its end yet; where the zero moves, rounding must not decide.
        begun = starts[1:] / self.period - cycle
        near = np.rint(begun[np.diff(offsets) != 0.0])
        redone = np.unique(
            np.concatenate((np.floor(begun + _AT_ONCE), near - 2.0, near - 1.0, near, near + 1.0))
        )
        for i in redone[(redone >= 0.0) & (redone < count)].astype(int).tolist():
            k = max(bisect_right(begins, (cycle + i - _AT_ONCE) * self.period) - 1, 0)
            time = (cycle + i + 1) * self.period - begins[k]
            made[i] = profiles[k].position(time) + self.offset(first + k)
        return made
