"""Extremes of an axis in a run: position, speed, acceleration and jerk.

Positions are those of the machine: they count from the zero that the last homing of the run gave the axis, or from that
of power-up if it is never homed. A zero that the program sets moves nothing, so it changes none of them.

Nothing is sampled. Each piece of a profile is a polynomial or a wave, so its extremes are at its ends and
stationary points.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import inf
from operator import itemgetter

from motionlang.kernel import Axis
from motionlang.kernel.planners import (
    MotionState,
    Profile,
    crest_points,
    even_points,
    state_in,
    still_points,
    summit,
)


@dataclass(eq=False, slots=True)
class Extreme:
    """A figure in user units and the machine time at which it was reached.

    The extreme of a magnitude is the largest one.
    """

    value: float
    time: float

    def __repr__(self) -> str:
        return f"Extreme({self.value:g}, {self.time:g})"


class Extremes:
    """The extremes of one axis: `lowest` and `highest` position, peak derivatives."""

    def __init__(self, position: float) -> None:
        self.lowest, self.highest = Extreme(position, 0.0), Extreme(position, 0.0)
        self.speed, self.acceleration, self.jerk = (Extreme(0.0, 0.0) for _ in range(3))

    def take(self, time: float, state: MotionState) -> None:
        """Include a state, in user units, at a time."""
        position = state.position
        if position < self.lowest.value:
            self.lowest = Extreme(position, time)
        if position > self.highest.value:
            self.highest = Extreme(position, time)
        if abs(state.velocity) > self.speed.value:
            self.speed = Extreme(abs(state.velocity), time)
        if abs(state.acceleration) > self.acceleration.value:
            self.acceleration = Extreme(abs(state.acceleration), time)
        if abs(state.jerk) > self.jerk.value:
            self.jerk = Extreme(abs(state.jerk), time)


def extremes(a: Axis, until: float) -> Extremes:
    """Return the extremes of the commanded motion of an axis up to a time.

    They are in the user units in force at their times, positions from the zero of the homed machine. Where the velocity
    jumps, the acceleration is infinite; where the acceleration jumps, the jerk is.
    """
    found: Extremes | None = None
    before: MotionState | None = None
    zeros = _Zeros(a)
    for begin, length, profile in _track(a, until):
        zero = zeros.at(begin)
        if found is None:
            found = Extremes((profile.start - zero) / a.scales[0][1])
        first_scale = bisect_left(a.scales, begin, 1, key=itemgetter(0))
        for k in range(first_scale, bisect_right(a.scales, begin + length, 1, key=itemgetter(0))):
            since = a.scales[k][0]
            for _, counts, _ in a.scales[k - 1 : k + 1]:
                found.take(since, _in_units(counts, profile.at(since - begin), zero))
        for points in _stretches(profile, length):
            first, last = points[0][1], points[-1][1]
            if before is not None:
                _jump(found, begin + points[0][0], before, first)
            before = last
            for time, state in points:
                found.take(begin + time, _in_units(a.scale_at(begin + time)[0], state, zero))
    return found or Extremes((a.position(until) - zeros.at(until)) / a.scale_at(until)[0])


class _Zeros:
    """The position that an axis had at the zero of its homed machine, from time to time, counts."""

    def __init__(self, a: Axis) -> None:
        self._a = a
        self._changes = (each for each in a.controller.log.zeros if each.axis == a.index)
        self._next = next(self._changes, None)

    def at(self, time: float) -> float:
        """Return the position at a time, which is not before the last one asked for."""
        while self._next is not None and self._next.time <= time:
            self._next = next(self._changes, None)
        datum = self._a.datum if self._next is None else self._next.datum
        return datum + (self._a.home or 0.0)


def peak_speed(a: Axis, until: float) -> float:
    """Return only the highest speed of `extremes`, in a tenth of the time.

    Most profiles store their highest speed.
    """
    if len(a.scales) > 1:
        return extremes(a, until).speed.value
    peak = 0.0
    for begin, length, profile in _track(a, until):
        if profile.shape != "hold":
            whole = profile.duration <= length + 4e-16 * (begin + length)  # within the rounding of its end
            peak = max(peak, (profile if whole else profile.cut(length)).peak_speed)
    return peak / abs(a.scale.counts)


def _track(a: Axis, until: float) -> Iterator[tuple[float, float, Profile]]:
    """Yield the start of each profile, how long it was in force, and the profile."""
    starts = iter(a.starts)
    begin = next(starts)
    for profile in a.profiles:
        end = min(next(starts, inf), until)
        if end > begin:
            yield begin, end - begin, profile
        begin = end


def _stretches(profile: Profile, length: float) -> Iterator[list[tuple[float, MotionState]]]:
    """Yield the smooth stretches of the first `length` seconds.

    Each stretch is the states at its ends and at the extrema in between. Velocity and jerk of a sine have none: its
    piece is within half a wave.
    """
    within = min(profile.duration, length)
    knots = profile.knots
    for k in range(len(knots) - 1):
        begin, span = knots[k], min(knots[k + 1], within) - knots[k]
        if span <= 0.0:
            break
        piece = profile.pieces[k]
        if isinstance(piece, tuple):
            extrema: set[float] = set()
            for where in (still_points, even_points, crest_points):
                extrema.update(where(piece, span))
            yield [(begin + x, state_in(piece, x)) for x in (0.0, *sorted(extrema), span)]
        else:
            yield _searched(profile, begin, begin + span)
    if within < length:
        yield [(time, profile.at(time)) for time in (within, length)]


# Points between two knots of a formula that are sampled; the best are refined.
_SAMPLES = 48


def _searched(profile: Profile, begin: float, end: float) -> list[tuple[float, MotionState]]:
    """Return the extrema of a formula, found by search."""
    end_inside = end - (end - begin) * 1e-12
    times = [begin + (end_inside - begin) * n / _SAMPLES for n in range(_SAMPLES + 1)]
    measures: tuple[Callable[[float], float], ...] = (
        lambda t: profile.at(t).position,
        lambda t: -profile.at(t).position,
        lambda t: abs(profile.at(t).velocity),
        lambda t: abs(profile.at(t).acceleration),
        lambda t: abs(profile.at(t).jerk),
    )
    for value in measures:
        best = max(range(_SAMPLES + 1), key=lambda n: value(times[n]))
        times.append(summit(value, times[max(best - 1, 0)], times[min(best + 1, _SAMPLES)]))
    return [(time, profile.at(time)) for time in sorted(times)]


# A jump smaller than this fraction of a velocity or an acceleration is rounding.
_ROUNDING = 1e-9
# Seconds before the end of a stretch that may be missing from it.
_MOMENT = 1e-10


def _jump(found: Extremes, now: float, left: MotionState, right: MotionState) -> None:
    """Record an infinite derivative where the state jumps."""
    jumps = _differ(left.velocity, right.velocity, left.acceleration, right.acceleration)
    if jumps and found.acceleration.value < inf:
        found.acceleration = Extreme(inf, now)
    if found.jerk.value < inf and (
        jumps or _differ(left.acceleration, right.acceleration, left.jerk, right.jerk)
    ):
        found.jerk = Extreme(inf, now)


def _differ(left: float, right: float, slope: float, slope_after: float) -> bool:
    """True if two values differ by more than rounding near the end of a formula."""
    rounding = _ROUNDING * max(abs(left), abs(right), 1.0)
    return abs(right - left) > rounding + _MOMENT * max(abs(slope), abs(slope_after))


def _in_units(counts: float, state: MotionState, zero: float) -> MotionState:
    size = abs(counts)
    return MotionState(
        (state.position - zero) / counts,
        state.velocity / size,
        state.acceleration / size,
        state.jerk / size,
    )


def motor_peak(a: Axis, until: float, column: str, *, rms: bool = False) -> Extreme | None:
    """Return the largest magnitude of a motor column, or its root mean square.

    `column` is one of a `ServoTrace`: "error" in user units, "torque", "output". The root mean square has the
    time `until`. Returns None if no motor is simulated.
    """
    if a.feedback is None:
        return None
    from motionlang.kernel.tracks import chunks, units_at

    largest, when, squares, count = 0.0, 0.0, 0.0, 0
    for first, chunk in chunks(a, until):
        values = abs(getattr(chunk, column))
        if column == "error":
            values /= abs(units_at(a, first + chunk.time)[0])
        if not len(values):
            continue
        index = int(values.argmax())
        if values[index] > largest:
            largest, when = float(values[index]), first + index * chunk.loop.period
        squares, count = squares + float(values @ values), count + len(values)
    if rms:
        return Extreme((squares / count) ** 0.5 if count else 0.0, until)
    return Extreme(largest, when)
