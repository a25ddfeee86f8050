"""A profile: position as an exact function of time, sampled only on request."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from itertools import chain, islice
from math import copysign, inf
from typing import cast

from motionlang.kernel.planners import crossing as _crossing
from motionlang.kernel.planners.pieces import (
    acceleration_in,
    all_in,
    crest_points,
    even_points,
    position_in,
    recentred,
    still_points,
    transformed,
    velocity_in,
)
from motionlang.kernel.planners.ramps import (
    Curve,
    Marks,
    Piece,
    Plain,
    PlainCurve,
    Recipe,
    expand,
    named_ramps,
)

_Value = Callable[[Piece, float], float]
_Extrema = Callable[[Piece, float], tuple[float, ...]]


# The recipe of standstill. Such a profile makes its one piece on demand, as those of ramps do.
_AT_REST = (0.0, 0.0)


@dataclass(eq=False, slots=True)
class MotionState:
    """Position, velocity, acceleration and jerk at one time (length unit, seconds)."""

    position: float
    velocity: float
    acceleration: float
    jerk: float

    def __repr__(self) -> str:
        return f"State({self.position!r}, {self.velocity!r}, {self.acceleration!r}, {self.jerk!r})"


@dataclass(eq=False, slots=True)
class Phase:
    """A named section of a profile.

    The names are accel, slew, decel, stop, hold and segment.
    """

    name: str
    duration: float
    distance: float
    start_velocity: float
    end_velocity: float

    def __repr__(self) -> str:
        return f"Phase({self.name!r}, duration={self.duration!r}, distance={self.distance!r})"


class Profile:
    """Position from `start` to `end` over `duration` seconds, in the caller's unit.

    `shape` names the planner: trapezoid, sinusoidal, scurve, parabolic, pvt, jog or hold. Planners return a
    recipe of velocity ramps (see `ramps`); its pieces are computed on first use. `duration` is infinite
    for a jog or a hold. A profile is immutable.
    """

    __slots__ = ("_curve", "_recipe", "duration", "end", "shape", "start")

    _curve: Curve

    # The running program calls this for every move: five stores, nothing computed. `_curve` stays unset.
    def __init__(self, shape: str, start: float, end: float, duration: float, recipe: Recipe) -> None:
        self.shape = shape
        self.start = start
        self.end = end
        self.duration = duration
        self._recipe = recipe

    def __repr__(self) -> str:
        return f"<Profile {self.shape} {self.start:g} -> {self.end:g} in {self.duration:g} s>"

    # -- the figures of the whole move

    @property
    def start_velocity(self) -> float:
        """Velocity at time 0."""
        return self._recipe[0]

    @property
    def end_velocity(self) -> float:
        """Velocity at the end; 0 if the profile comes to rest."""
        return self._recipe[-1]

    @property
    def has_ramps(self) -> bool:
        """True if it consists of monotone velocity ramps without jumps between them."""
        return len(self._recipe) > 2

    @property
    def direction(self) -> float:
        """1.0 or -1.0 if it consists of ramps and never reverses, otherwise 0.0."""
        recipe = self._recipe
        if len(recipe) <= 2:
            return 0.0
        velocities = recipe[::3]
        return 1.0 if min(velocities) >= 0.0 else -1.0 if max(velocities) <= 0.0 else 0.0

    @property
    def distance(self) -> float:
        """Signed distance from start to end."""
        return self.end - self.start

    @property
    def phases(self) -> tuple[Phase, ...]:
        """The phases of the profile, in order."""
        if self.has_ramps:
            return tuple(Phase(*ramp) for ramp in named_ramps(self._recipe))
        _, pieces, marks = self.curve
        lasts = [*(first for _, first in marks[1:]), len(pieces)]
        return tuple(
            self._phase(name, first, last) for (name, first), last in zip(marks, lasts, strict=False)
        )

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity."""
        if self.has_ramps:
            return max(map(abs, self._recipe[::3]))
        return self._peak(velocity_in, even_points)

    @property
    def speed_bound(self) -> float:
        """An upper bound of the absolute velocity, found without a search."""
        return self.peak_speed

    @property
    def peak_acceleration(self) -> float:
        """The largest absolute acceleration."""
        return self._peak(acceleration_in, crest_points)

    @property
    def is_large(self) -> bool:
        """True if it has more than its recipe: pieces that have been computed, or a curve."""
        return hasattr(self, "_curve")

    @property
    def pieced(self) -> bool:
        """True if it consists of cubics and half waves."""
        return self.has_ramps or all(isinstance(piece, tuple) for piece in self.pieces)

    # -- the curve

    @property
    def curve(self) -> Curve:
        """Knots (one more than pieces), pieces, and phase marks, computed on first use."""
        try:
            return self._curve
        except AttributeError:
            self._curve = self._made()
            return self._curve

    def _made(self) -> Curve:
        if self._recipe is _AT_REST:
            piece = (self.start, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
            return (0.0, self.duration), (piece,), (("hold", 0),)
        return _ending_at(expand(self.start, self._recipe), self.start, self.duration)

    @property
    def drawn(self) -> PlainCurve:
        """The curve with cubics close enough for drawing in place of formulas; no exact result uses them."""
        if self.pieced:
            return cast(PlainCurve, self.curve)
        from motionlang.kernel.planners.cubics import cubics

        return cubics(self)

    @property
    def knots(self) -> tuple[float, ...]:
        """Times at which one piece ends and the next begins, from 0.0 to the duration."""
        return self.curve[0]

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The pieces between the knots, in the form described in `ramps`."""
        return self.curve[1]

    # -- at a time

    def at(self, time: float) -> MotionState:
        """Return the state at `time`.

        Before time 0 the profile is at rest; after its end it rests or continues at its end velocity.
        """
        if time >= self.duration:
            return MotionState(self._beyond(time), self.end_velocity, 0.0, 0.0)
        if time < 0.0:
            return MotionState(self.start, self.start_velocity, 0.0, 0.0)
        return self.state(time)

    def state(self, time: float) -> MotionState:
        """Return the state at a time from 0 up to the duration."""
        return state_in(*self.piece_at(time))

    def piece_at(self, time: float) -> tuple[Piece, float]:
        """Return the piece in force at a time from 0 up to the duration.

        The second value is the time since its knot.
        """
        knots, pieces, _ = self.curve
        i = min(bisect_right(knots, time), len(pieces)) - 1
        return pieces[i], time - knots[i]

    def position(self, time: float) -> float:
        if time >= self.duration:
            return self._beyond(time)
        return position_in(*self.piece_at(time)) if time > 0.0 else self.start

    def velocity(self, time: float) -> float:
        if time >= self.duration:
            return self.end_velocity
        return velocity_in(*self.piece_at(time)) if time > 0.0 else self.start_velocity

    def cubic(self, time: float) -> tuple[float, float, tuple[float, float, float, float]] | None:
        """Return start and end of the cubic in force at `time`, and its coefficients.

        They count from its start. None outside the profile, in a half wave of a sine, and in a `Formula`.
        """
        if not 0.0 <= time < self.duration:
            return None
        knots, pieces, _ = self.curve
        i = self._index(time)
        piece = pieces[i]
        return None if not isinstance(piece, tuple) or piece[4] else (knots[i], knots[i + 1], piece[:4])

    def acceleration(self, time: float) -> float:
        """Return the acceleration at `time`.

        At a knot it is the acceleration of the piece that begins there; after the end it is 0.
        """
        if time >= self.duration or time < 0.0:
            return 0.0
        return acceleration_in(*self.piece_at(time))

    # -- times of events

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `position`, or None if there is none."""
        return _crossing.position_crossing(self, position, after)

    def velocity_crossing(self, velocity: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `velocity`, or None if there is none."""
        return _crossing.velocity_crossing(self, velocity, after)

    def next_knot(self, after: float) -> float:
        """Return the first knot after a time, or the last one."""
        knots = self.knots
        return knots[min(bisect_right(knots, after), len(knots) - 1)]

    def velocity_check(self, velocity: float, after: float) -> float:
        """Return when to compare the velocity again: at `velocity` or at the next knot."""
        until = self.next_knot(after)
        found = self.velocity_crossing(velocity, after)
        return until if found is None else min(found, until)

    def extrema(self) -> tuple[float, float]:
        """Return the smallest and the largest position, including extrema inside pieces."""
        knots, pieces, _ = self.curve
        seen = [self.start, self.end]
        for piece, begin, finish in zip(pieces, knots, knots[1:], strict=False):
            seen.append(position_in(piece, 0.0))
            seen.extend(position_in(piece, x) for x in still_points(piece, finish - begin))
        return min(seen), max(seen)

    # -- other profiles made from this one

    def cut(self, time: float) -> Profile:
        """Return the first `time` seconds, exactly; the phase at the cut is shortened."""
        if time >= self.duration:
            return self
        if time <= 0.0:
            return _at_constant_velocity(self.shape, self.start, self.start_velocity)
        knots, pieces, marks = self.curve
        i = self._index(time)
        count = i + 1 if time > knots[i] else i
        marks_before = tuple([mark for mark in marks if mark[1] < count])
        curve = ((*knots[:count], time), pieces[:count], marks_before)
        piece, x = pieces[i], time - knots[i]
        end, end_velocity = position_in(piece, x), velocity_in(piece, x)
        return from_curve(self.shape, self.start, end, curve, self.start_velocity, end_velocity)

    def ending_at(self, end: float) -> Profile:
        """Return the same motion with `end`, known exactly, as its end."""
        if end == self.end:
            return self
        made = copy(self)
        made.end = end
        return made

    def after(self, time: float) -> Profile:
        """Return the rest after `time` seconds, with its clock starting at 0."""
        if time <= 0.0:
            return self
        if time >= self.duration:
            return _at_constant_velocity(self.shape, self.end, self.end_velocity)
        knots, pieces, marks = self.curve
        i = self._index(time)
        rest = (recentred(pieces[i], time - knots[i]), *pieces[i + 1 :])
        begun = [name for name, first in marks if first <= i][-1]
        later = tuple((name, first - i) for name, first in marks if first > i)
        curve = ((0.0, *(knot - time for knot in knots[i + 1 :])), rest, ((begun, 0), *later))
        return from_curve(
            self.shape, self.position(time), self.end, curve, self.velocity(time), self.end_velocity
        )

    def then(self, other: Profile) -> Profile:
        """Return this profile followed by `other`, which must begin where this one ends."""
        gap = abs(other.start - self.end)
        assert gap <= 1e-9 * max(1.0, abs(self.end), abs(self.distance)), f"a jump of {gap} between profiles"
        if self.duration == 0.0:
            return other
        if other.duration == 0.0:
            return self
        knots, pieces, marks = self.curve
        more_knots, more_pieces, more_marks = other.curve
        curve = (
            knots + tuple(self.duration + knot for knot in more_knots[1:]),
            pieces + more_pieces,
            _joined_marks(marks, more_marks, len(pieces)),
        )
        return from_curve(self.shape, self.start, other.end, curve, self.start_velocity, other.end_velocity)

    def shifted(self, offset: float) -> Profile:
        """Return the same motion displaced by `offset`."""
        return self.scaled(self.start + offset, 1.0)

    def scaled(self, start: float, factor: float) -> Profile:
        """Return the same motion from `start`, with every distance times `factor`.

        A negative factor reverses it.
        """
        end = start + self.distance * factor if self.distance and factor else start
        recipe = self._recipe
        if len(recipe) > 2:
            ramps = list(recipe)
            ramps[::3] = [velocity * factor for velocity in recipe[::3]]
            made = Profile(self.shape, start, end, self.duration, tuple(ramps))
            if not hasattr(self, "_curve"):
                return made
        else:
            made = Profile(self.shape, start, end, self.duration, (recipe[0] * factor, recipe[-1] * factor))
        knots, pieces, marks = self.curve
        moved = tuple(transformed(piece, factor, self.start, start) for piece in pieces)
        made._curve = (knots, moved, marks)
        return made

    # -- inside

    def _index(self, time: float) -> int:
        knots, pieces, _ = self.curve
        return min(bisect_right(knots, time), len(pieces)) - 1

    def _beyond(self, time: float) -> float:
        velocity = self.end_velocity
        return self.end + velocity * (time - self.duration) if velocity and time > self.duration else self.end

    def _phase(self, name: str, first: int, last: int) -> Phase:
        begin, finish = self.knots[first], self.knots[last]
        moved = self.position(finish) - self.position(begin)
        piece = self.pieces[last - 1]
        velocity = velocity_in(piece, finish - self.knots[last - 1])
        return Phase(name, finish - begin, moved, velocity_in(self.pieces[first], 0.0), velocity)

    def _peak(self, value: _Value, extrema: _Extrema) -> float:
        knots, pieces, _ = self.curve
        peak = 0.0
        for piece, begin, finish in zip(pieces, knots, knots[1:], strict=False):
            span = finish - begin
            for x in (0.0, *extrema(piece, span), span):
                peak = max(peak, abs(value(piece, x)))
        return peak


def state_in(piece: Piece, x: float) -> MotionState:
    """Return the state at local time x of a piece."""
    return MotionState(*all_in(piece, x))


def from_curve(
    shape: str, start: float, end: float, curve: Curve, start_velocity: float, end_velocity: float
) -> Profile:
    """Return a profile of ready-made pieces; its recipe has only the end velocities."""
    made = Profile(shape, start, end, curve[0][-1], (start_velocity, end_velocity))
    made._curve = curve
    return made


def hold(position: float, duration: float = inf) -> Profile:
    """Return a standstill at `position`."""
    return Profile("hold", position, position, duration, _AT_REST)


def relabelled(profile: Profile, shape: str, name: str = "") -> Profile:
    """Return the same motion with another shape name.

    If `name` is given, the motion becomes one phase of that name.
    """
    made = copy(profile)
    made.shape = shape
    if name:
        knots, pieces, marks = profile.curve
        made._recipe = profile.start_velocity, profile.end_velocity
        made._curve = (knots, pieces, ((name, 0),) if marks else marks)
    return made


def pieces_of(starts: Sequence[float], profiles: Sequence[Profile]) -> tuple[list[float], list[Plain]]:
    """Return the times at which the pieces of profiles begin, and the pieces.

    Each is valid until the next one begins. The first one is the standstill before the first profile; if a profile
    ends before the next one begins, a piece for the time after its end follows.
    """
    begins: list[float] = []
    pieces: list[Plain] = []
    following = chain(islice(starts, 1, None), (inf,))
    for start, end, profile in zip(starts, following, profiles, strict=False):
        if not pieces:
            begins.append(start)
            pieces.append((profile.start, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
        knots, curve, _ = profile.drawn
        for knot, piece in zip(knots, curve, strict=False):
            if start + knot < end:
                begins.append(start + knot)
                pieces.append(piece)
        if start + profile.duration < end:
            begins.append(start + profile.duration)
            pieces.append((profile.end, profile.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0))
    return begins, pieces


def far_end(position: float, velocity: float) -> float:
    """Return the end of a profile that continues endlessly at `velocity`.

    It is infinite, or `position` at velocity 0.
    """
    return copysign(inf, velocity) if velocity else position


def _joined_marks(marks: Marks, more: Marks, count: int) -> Marks:
    """Join the phase marks of two profiles; a phase that continues stays one phase."""
    goes_on = marks[-1][0] == more[0][0] != "segment"
    return marks + tuple((name, first + count) for name, first in (more[1:] if goes_on else more))


def _at_constant_velocity(shape: str, position: float, velocity: float) -> Profile:
    return from_curve(shape, position, position, ((0.0,), (), ()), velocity, velocity)


def _ending_at(curve: Curve, start: float, duration: float) -> Curve:
    # The planner's total and the sum of the ramps may differ in the last bit; the planner's takes precedence.
    knots, pieces, marks = curve
    if pieces:
        last = duration if duration > knots[-2] else knots[-1]
        return (*knots[:-1], last), pieces, marks
    if duration == 0.0:
        return curve
    # every ramp was too short to count
    return (0.0, duration), ((start, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),), (("slew", 0),)
