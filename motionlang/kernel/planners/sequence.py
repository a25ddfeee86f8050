"""A sequence of profiles that includes at least one formula."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from operator import itemgetter

from motionlang.kernel.planners.curve import MotionState, Phase, Profile
from motionlang.kernel.planners.formula import FormulaProfile

# The first of a pair.
_BOUND = itemgetter(0)


class ProfileSequence(FormulaProfile):
    """A sequence of profiles, each beginning at the end of the one before.

    With a `name` the sequence is one phase of that name.
    """

    __slots__ = ("begins", "name", "segments")

    def __init__(self, shape: str, profiles: Sequence[Profile], name: str = "") -> None:
        self.segments = tuple(profiles)
        self.name = name
        begins, time = [], 0.0
        for segment in profiles:
            begins.append(time)
            time += segment.duration
        self.begins = tuple(begins)
        first, last = profiles[0], profiles[-1]
        super().__init__(shape, first.start, last.end, time, first.start_velocity, last.end_velocity)

    def state(self, time: float) -> MotionState:
        i = self._segment_index(time)
        return self.segments[i].at(time - self.begins[i])

    @property
    def knots(self) -> tuple[float, ...]:
        """The knots of all profiles."""
        found = [0.0]
        for begin, segment in zip(self.begins, self.segments, strict=True):
            found += [begin + knot for knot in segment.knots[1:]]
        return (*found[:-1], self.duration)

    @property
    def phases(self) -> tuple[Phase, ...]:
        """The phases of all profiles, or one phase if the sequence has a name."""
        if self.name:
            return (Phase(self.name, self.duration, self.distance, self.start_velocity, self.end_velocity),)
        return tuple(phase for segment in self.segments for phase in segment.phases)

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity.

        A profile is searched only if its upper bound exceeds the largest value found so far.
        """
        peak = 0.0
        for bound, segment in sorted(
            ((segment.speed_bound, segment) for segment in self.segments), key=_BOUND, reverse=True
        ):
            if bound <= peak:
                break
            peak = max(peak, segment.peak_speed)
        return peak

    @property
    def speed_bound(self) -> float:
        """An upper bound of the absolute velocity, found without a search."""
        return max(segment.speed_bound for segment in self.segments)

    @property
    def peak_acceleration(self) -> float:
        """The largest absolute acceleration."""
        return max(segment.peak_acceleration for segment in self.segments)

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `position`, or None if there is none."""
        return self._first_in_segments(lambda segment, low: segment.crossing(position, low), after)

    def velocity_crossing(self, velocity: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `velocity`, or None if there is none."""
        return self._first_in_segments(lambda segment, low: segment.velocity_crossing(velocity, low), after)

    def velocity_check(self, velocity: float, after: float) -> float:
        """Return when to compare the velocity again: at `velocity` or at the next knot."""
        i = self._segment_index(after)
        segment, begin = self.segments[i], self.begins[i]
        return begin + min(segment.velocity_check(velocity, after - begin), segment.duration)

    def _first_in_segments(
        self, crossing: Callable[[Profile, float], float | None], after: float
    ) -> float | None:
        """Return the first time >= `after` that `crossing` finds in any of the profiles.

        A time counts only before the next profile begins.
        """
        after = max(after, 0.0)
        last = len(self.segments) - 1
        for i in range(self._segment_index(after), last + 1):
            segment, begin = self.segments[i], self.begins[i]
            found = crossing(segment, max(after - begin, 0.0))
            if found is not None and (i == last or found <= segment.duration):
                return begin + found
        return None

    def extrema(self) -> tuple[float, float]:
        """Return the smallest and the largest position, including extrema inside."""
        ends = [segment.extrema() for segment in self.segments]
        return min(low for low, _ in ends), max(high for _, high in ends)

    def cut(self, time: float) -> Profile:
        """Return the first `time` seconds, exactly."""
        if time >= self.duration:
            return self
        i = self._segment_index(max(time, 0.0))
        last = self.segments[i].cut(time - self.begins[i])
        retained = self.segments[:i] if last.duration == 0.0 and i else (*self.segments[:i], last)
        return (
            retained[0]
            if len(retained) == 1 and not self.name
            else ProfileSequence(self.shape, retained, self.name)
        )

    def after(self, time: float) -> Profile:
        """Return the rest after `time` seconds, with its clock starting at 0."""
        if time <= 0.0:
            return self
        if time >= self.duration:
            return self.segments[-1].after(time - self.begins[-1])
        i = self._segment_index(time)
        rest = (self.segments[i].after(time - self.begins[i]), *self.segments[i + 1 :])
        return rest[0] if len(rest) == 1 and not self.name else ProfileSequence(self.shape, rest, self.name)

    def scaled(self, start: float, factor: float) -> Profile:
        """Return the same motion from `start`, with every distance times `factor`."""
        made = []
        for segment in self.segments:
            made.append(segment.scaled(start, factor))
            start = made[-1].end
        return ProfileSequence(self.shape, made, self.name)

    def _segment_index(self, time: float) -> int:
        return max(0, bisect_right(self.begins, time) - 1)


def chained(first: Profile, second: Profile) -> Profile:
    """Return `first` followed by `second`; both take time (see `Profile.then`)."""
    name = first.name if isinstance(first, ProfileSequence) else ""
    profiles = [*(first.segments if isinstance(first, ProfileSequence) else (first,))]
    profiles += second.segments if isinstance(second, ProfileSequence) and not second.name else (second,)
    return ProfileSequence(first.shape, profiles, name)
