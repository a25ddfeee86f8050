"""Profiles that are formulas, not pieces.

They are exact at any time; their crossings are found by bracketing. They are needed because paths, cams and offsets
on geared axes derive profiles from other profiles, and the result is not always a sequence of cubics. A subclass
states where it is smooth (`knots`) and gives position, velocity and acceleration; the base class does the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from math import inf, nextafter

from motionlang.kernel.planners.cubics import cubics
from motionlang.kernel.planners.curve import MotionState, Phase, Profile
from motionlang.kernel.planners.ramps import Curve
from motionlang.kernel.planners.root import bracketed_root

# Brackets between two knots; two extrema inside one bracket would be missed.
STEPS = 24

# Brackets for a peak, which is broad and is refined afterwards.
PEAK_STEPS = 8

# Share of the highest grid value from which a neighbouring peak is refined.
PEAK_SHARE = 0.9


class FormulaProfile(Profile):
    """A profile without pieces of its own, linear beyond its last finite knot."""

    __slots__ = ()

    pieced = False

    def __init__(
        self,
        shape: str,
        start: float,
        end: float,
        duration: float,
        start_velocity: float,
        end_velocity: float,
    ) -> None:
        super().__init__(shape, start, end, duration, (start_velocity, end_velocity))

    # -- provided by a subclass

    def state(self, time: float) -> MotionState:
        """Return the state at a time from 0 up to the duration."""
        raise NotImplementedError

    @property
    def knots(self) -> tuple[float, ...]:
        """Times between which the profile is smooth, from 0.0 to the duration."""
        raise NotImplementedError

    # -- the figures of the whole move

    @property
    def curve(self) -> Curve:
        """Cubic pieces close enough for drawing; no exact result uses them."""
        try:
            return self._curve
        except AttributeError:
            self._curve = cubics(self)
            return self._curve

    @property
    def phases(self) -> tuple[Phase, ...]:
        """The complete profile as one phase."""
        if self.duration == 0.0:
            return ()
        return (Phase(self.shape, self.duration, self.distance, self.start_velocity, self.end_velocity),)

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity."""
        return self._peak_of(self.velocity)

    @property
    def speed_bound(self) -> float:
        """An upper bound of the absolute velocity, found without a search."""
        return inf

    @property
    def peak_acceleration(self) -> float:
        """The largest absolute acceleration."""
        return self._peak_of(self.acceleration)

    # -- at a time

    def position(self, time: float) -> float:
        if time >= self.duration:
            return self._beyond(time)
        return self.state(time).position if time > 0.0 else self.start

    def velocity(self, time: float) -> float:
        if time >= self.duration:
            return self.end_velocity
        return self.state(time).velocity if time > 0.0 else self.start_velocity

    def acceleration(self, time: float) -> float:
        """Return the acceleration at `time`; 0 before the beginning and after the end."""
        return self.state(time).acceleration if 0.0 <= time < self.duration else 0.0

    # -- times of events

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `position`, or None if there is none."""
        found = self._first(self.position, self.velocity, position, max(after, 0.0))
        return found if found is not None else self._line_crossing(position, max(after, 0.0))

    def velocity_crossing(self, velocity: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `velocity`, or None if there is none."""
        after = max(after, 0.0)
        found = self._first(self.velocity, self.acceleration, velocity, after)
        if found is None and velocity == self.end_velocity and self.duration != inf:
            return max(after, self.duration)
        return found

    def velocity_check(self, velocity: float, after: float) -> float:
        """Return when to compare the velocity again: at `velocity` or at the next knot."""
        until = self.next_knot(after)
        found = self._first(self.velocity, self.acceleration, velocity, max(after, 0.0), until)
        return until if found is None else found

    def extrema(self) -> tuple[float, float]:
        """Return the smallest and the largest position, including extrema inside."""
        seen = [self.start, self.end]
        for begin, finish in self._brackets(0.0):
            seen += [self.position(begin), self.position(finish)]
            extremum = self._extremum(self.velocity, self.acceleration, begin, finish)
            if extremum is not None:
                seen.append(self.position(extremum))
        return min(seen), max(seen)

    def stretches(self, after: float) -> Iterator[tuple[float, float]]:
        """Yield the beginning and the signed travel of each monotone section from `after`.

        The last section may have no end.
        """
        for begin, finish in self._brackets(after):
            for low, high in self._monotone(self.velocity, self.acceleration, begin, finish):
                yield low, self.position(high) - self.position(low)
        if self.duration == inf:
            yield max(after, self.knots[-2]), self.end_velocity * inf if self.end_velocity else 0.0

    # -- inside

    def _brackets(self, after: float, until: float = inf) -> Iterator[tuple[float, float]]:
        """Yield intervals of time from `after` to the knot `until` or the last finite one."""
        knots = self.knots
        for begin, finish in pairwise(knots):
            if finish <= after or finish == inf:
                continue
            if begin >= until:
                break
            step = (finish - begin) / STEPS
            for i in range(STEPS):
                low, high = begin + i * step, finish if i == STEPS - 1 else begin + (i + 1) * step
                if high > after:
                    yield max(low, after), high

    def _monotone(
        self, slope: Callable[[float], float], bend: Callable[[float], float], begin: float, finish: float
    ) -> tuple[tuple[float, float], ...]:
        """Return the sections of a bracket in which `slope` does not change sign."""
        extremum = self._extremum(slope, bend, begin, finish)
        return ((begin, finish),) if extremum is None else ((begin, extremum), (extremum, finish))

    def _extremum(
        self, slope: Callable[[float], float], bend: Callable[[float], float], begin: float, finish: float
    ) -> float | None:
        """Return the time inside a bracket at which `slope` changes sign."""
        first, last = slope(begin), slope(finish)
        if first * last >= 0.0:
            return None
        return bracketed_root(lambda t: (slope(t), bend(t)), begin, finish, last > 0.0)

    def _first(
        self,
        value: Callable[[float], float],
        slope: Callable[[float], float],
        wanted: float,
        after: float,
        until: float = inf,
    ) -> float | None:
        reached, y_reached, slope_reached = after - 1.0, 0.0, 0.0
        for begin, finish in self._brackets(after, until):
            if begin != reached:  # the last bracket did not end here
                y_reached, slope_reached = value(begin), slope(begin)
            low, y_low = begin, y_reached
            reached, y_reached, before = finish, value(finish), slope_reached
            slope_reached = slope(finish)
            ends = [(finish, y_reached)]
            if before * slope_reached < 0.0:
                extremum = bracketed_root(lambda t: (slope(t), 0.0), begin, finish, slope_reached > 0.0)
                ends.insert(0, (extremum, value(extremum)))
            for high, y_high in ends:
                if y_low == wanted:
                    return low
                if y_high == wanted:
                    return high
                if (y_low < wanted) is not (y_high < wanted):
                    return bracketed_root(lambda t: (value(t) - wanted, slope(t)), low, high, y_high > y_low)
                low, y_low = high, y_high
        return None

    def _line_crossing(self, position: float, after: float) -> float | None:
        """Return when the straight line beyond the last finite knot is at `position`."""
        begin = self.knots[-2] if self.duration == inf else self.duration
        begin = max(begin, after)
        here, velocity = self.position(begin), self.end_velocity
        if position == here:
            return begin
        if velocity == 0.0 or (position - here) * velocity < 0.0:
            return None
        return begin + (position - here) / velocity

    def _peak_of(self, value: Callable[[float], float]) -> float:
        """Return the largest absolute value of a function of time.

        Between knots it is sampled on a grid; peaks of the grid are refined between their neighbours.
        """
        peak = abs(self.end_velocity) if value == self.velocity else 0.0
        summits: list[tuple[float, float, float]] = []
        for begin, finish in pairwise(self.knots):
            if finish == inf:
                continue
            step = (finish - begin) / PEAK_STEPS
            times = [
                begin,
                *(begin + i * step for i in range(1, PEAK_STEPS)),
                nextafter(finish, begin),
            ]
            sizes = [abs(value(t)) for t in times]
            for i, size in enumerate(sizes):
                before, after = max(i - 1, 0), min(i + 1, PEAK_STEPS)
                if sizes[before] <= size >= sizes[after]:
                    summits.append((size, times[before], times[after]))
        peak = max([peak, *(size for size, _, _ in summits)])
        for size, low, high in summits:
            if size >= PEAK_SHARE * peak:
                peak = max(peak, _best(lambda t: abs(value(t)), low, high))
        return peak


def _best(value: Callable[[float], float], low: float, high: float) -> float:
    """Return the largest value of a function with one maximum."""
    return value(summit(value, low, high))


def summit(value: Callable[[float], float], low: float, high: float) -> float:
    """Return the argument at which a function with one maximum is largest.

    The search is by golden section.
    """
    share = 0.6180339887498949
    a, b = high - share * (high - low), low + share * (high - low)
    y_a, y_b = value(a), value(b)
    for _ in range(34):
        if y_a > y_b:
            high, b, y_b = b, a, y_a
            a = high - share * (high - low)
            y_a = value(a)
        else:
            low, a, y_a = a, b, y_b
            b = low + share * (high - low)
            y_b = value(b)
    return a if y_a > y_b else b
