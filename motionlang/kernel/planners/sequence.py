"""A sequence of profiles, joined when it is read."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate
from operator import attrgetter

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.ramps import Curve, Piece


class ProfileSequence(Profile):
    """A sequence of profiles, each beginning at the end of the one before: one phase of the name `shape`."""

    __slots__ = ("begins", "segments")

    is_large = True

    def __init__(self, shape: str, profiles: Sequence[Profile]) -> None:
        self.segments = tuple(profiles)
        self.begins = (0.0, *accumulate(each.duration for each in profiles))
        first, last = profiles[0], profiles[-1]
        ends = first.start_velocity, last.end_velocity
        super().__init__(shape, first.start, last.end, self.begins[-1], ends)

    def _made(self) -> Curve:
        knots, pieces = [0.0], list[Piece]()
        for begin, segment in zip(self.begins, self.segments, strict=False):
            knots += [begin + knot for knot in segment.knots[1:]]
            pieces += segment.pieces
        return tuple(knots), tuple(pieces), ((self.shape, 0),) if pieces else ()

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity; a profile is searched only if its upper bound exceeds those found so far."""
        peak = 0.0
        for segment in sorted(self.segments, key=attrgetter("speed_bound"), reverse=True):
            if segment.speed_bound <= peak:
                break
            peak = max(peak, segment.peak_speed)
        return peak

    def cut(self, time: float) -> Profile:
        """Return the first `time` seconds, exactly."""
        if not 0.0 < time < self.duration:
            return super().cut(time)
        i = bisect_right(self.begins, time) - 1
        last = self.segments[i].cut(time - self.begins[i])
        return ProfileSequence(
            self.shape, self.segments[:i] if last.duration == 0.0 else (*self.segments[:i], last)
        )
