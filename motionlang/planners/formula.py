"""Profiles that are formulas rather than pieces: exact at any time, their crossings found in brackets.

What a path, a cam or an offset on a geared axis makes of other profiles cannot always be written as cubics. A subclass
says where it is smooth (`knots`) and gives position, velocity and acceleration; all else is done here.
"""

from __future__ import annotations

from itertools import pairwise
from math import inf, nextafter

from motionlang.planners.cubics import cubics
from motionlang.planners.curve import Phase, Profile, State
from motionlang.planners.root import bracketed_root

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from motionlang.planners.ramps import Curve

STEPS = 24
"""Brackets between two knots: two turning points inside one of them would not be seen."""

PEAK_STEPS = 8
"""The same where a peak is looked for: it is broad, and improved afterwards."""

PEAK_SHARE = 0.9
"""The part of the highest value on the grid that a summit beside it must have to be the highest after all."""


class Formula(Profile):
    """A profile without pieces of its own; beyond its last finite knot it is a straight line."""

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

    # -- what a subclass gives

    def state(self, time: float) -> State:
        """The state at a time from 0 up to the duration."""
        raise NotImplementedError

    @property
    def knots(self) -> tuple[float, ...]:
        """Times between which the profile is smooth, from 0.0 to the duration."""
        raise NotImplementedError

    # -- the figures of the whole move

    @property
    def curve(self) -> Curve:
        """Cubic pieces close enough to draw; nothing that must be exact asks for them."""
        try:
            return self._curve
        except AttributeError:
            self._curve = cubics(self)
            return self._curve

    @property
    def phases(self) -> tuple[Phase, ...]:
        """The whole as one phase."""
        if self.duration == 0.0:
            return ()
        return (Phase(self.shape, self.duration, self.distance, self.start_velocity, self.end_velocity),)

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity."""
        return self._peak_of(self.velocity)

    @property
    def speed_bound(self) -> float:
        """What its largest absolute velocity does not exceed, found without a search."""
        return inf

    @property
    def peak_acceleration(self) -> float:
        """The largest absolute acceleration."""
        return self._peak_of(self.acceleration)

    # -- at a time

    def position(self, time: float) -> float:
        """Position at `time`."""
        if time >= self.duration:
            return self._beyond(time)
        return self.state(time).position if time > 0.0 else self.start

    def velocity(self, time: float) -> float:
        """Velocity at `time`."""
        if time >= self.duration:
            return self.end_velocity
        return self.state(time).velocity if time > 0.0 else self.start_velocity

    def acceleration(self, time: float) -> float:
        """Acceleration at `time`; 0 before the beginning and after the end."""
        return self.state(time).acceleration if 0.0 <= time < self.duration else 0.0

    # -- the time of something

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """The first time >= `after` at which the profile is at `position`, or None if it never is."""
        found = self._first(self.position, self.velocity, position, max(after, 0.0))
        return found if found is not None else self._line_crossing(position, max(after, 0.0))

    def velocity_crossing(self, velocity: float, after: float = 0.0) -> float | None:
        """The first time >= `after` at which the profile runs at `velocity`, or None if it never does."""
        after = max(after, 0.0)
        found = self._first(self.velocity, self.acceleration, velocity, after)
        if found is None and velocity == self.end_velocity and self.duration != inf:
            return max(after, self.duration)
        return found

    def extrema(self) -> tuple[float, float]:
        """The smallest and the largest position of the profile, turning points included."""
        seen = [self.start, self.end]
        for begin, finish in self._brackets(0.0):
            seen += [self.position(begin), self.position(finish)]
            turn = self._turn(self.velocity, self.acceleration, begin, finish)
            if turn is not None:
                seen.append(self.position(turn))
        return min(seen), max(seen)

    def stretches(self, after: float) -> Iterator[tuple[float, float]]:
        """When each stretch without a turn begins, from `after` on, and how far it goes; the last may have no end."""
        for begin, finish in self._brackets(after):
            turn = self._turn(self.velocity, self.acceleration, begin, finish)
            for low, high in ((begin, finish),) if turn is None else ((begin, turn), (turn, finish)):
                yield low, self.position(high) - self.position(low)
        if self.duration == inf:
            yield max(after, self.knots[-2]), self.end_velocity * inf if self.end_velocity else 0.0

    # -- inside

    def _brackets(self, after: float) -> Iterator[tuple[float, float]]:
        """Stretches of time from `after` on, up to the last finite knot."""
        knots = self.knots
        for begin, finish in pairwise(knots):
            if finish <= after or finish == inf:
                continue
            step = (finish - begin) / STEPS
            for i in range(STEPS):
                low, high = begin + i * step, finish if i == STEPS - 1 else begin + (i + 1) * step
                if high > after:
                    yield max(low, after), high

    def _turn(
        self, slope: Callable[[float], float], bend: Callable[[float], float], begin: float, finish: float
    ) -> float | None:
        """The time inside a bracket at which `slope` changes its sign."""
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
    ) -> float | None:
        for begin, finish in self._brackets(after):
            turn = self._turn(slope, lambda _: 0.0, begin, finish)
            for low, high in ((begin, finish),) if turn is None else ((begin, turn), (turn, finish)):
                y_low, y_high = value(low), value(high)
                if y_low == wanted:
                    return low
                if y_high == wanted:
                    return high
                if (y_low < wanted) is not (y_high < wanted):
                    return bracketed_root(lambda t: (value(t) - wanted, slope(t)), low, high, y_high > y_low)
        return None

    def _line_crossing(self, position: float, after: float) -> float | None:
        """Where the straight line beyond the last finite knot, or the end, is at `position`."""
        begin = self.knots[-2] if self.duration == inf else self.duration
        begin = max(begin, after)
        here, velocity = self.position(begin), self.end_velocity
        if position == here:
            return begin
        if velocity == 0.0 or (position - here) * velocity < 0.0:
            return None
        return begin + (position - here) / velocity

    def _peak_of(self, value: Callable[[float], float]) -> float:
        """The largest absolute value: the summits of a grid between every two knots, improved between neighbours."""
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
    """The largest value of a function with one summit."""
    return value(summit(value, low, high))


def summit(value: Callable[[float], float], low: float, high: float) -> float:
    """Where a function with one summit is largest, by golden section."""
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
