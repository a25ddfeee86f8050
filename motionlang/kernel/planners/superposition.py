"""Superposition of two motions of one axis.

An example is an offset on top of gearing.
"""

from __future__ import annotations

from math import copysign, inf, isnan

from motionlang.kernel.planners.curve import MotionState, Profile, from_curve
from motionlang.kernel.planners.formula import FormulaProfile
from motionlang.kernel.planners.pieces import recentred
from motionlang.kernel.planners.ramps import Piece


class Superposed(FormulaProfile):
    """The sum of two profiles; after its end the shorter one continues as it ended."""

    __slots__ = ("first", "second")

    def __init__(self, first: Profile, second: Profile, shape: str) -> None:
        self.first, self.second = first, second
        duration = max(first.duration, second.duration)
        super().__init__(
            shape,
            first.start + second.start,
            _end_of_sum(first, second, duration),
            duration,
            first.start_velocity + second.start_velocity,
            first.end_velocity + second.end_velocity,
        )

    def state(self, time: float) -> MotionState:
        """Return the sum of the states of both profiles."""
        a, b = self.first.at(time), self.second.at(time)
        return MotionState(
            a.position + b.position,
            a.velocity + b.velocity,
            a.acceleration + b.acceleration,
            a.jerk + b.jerk,
        )

    @property
    def knots(self) -> tuple[float, ...]:
        """The knots of both profiles."""
        return tuple(sorted({*self.first.knots, *self.second.knots, self.duration}))

    def cut(self, time: float) -> Profile:
        """Return the first `time` seconds, exactly."""
        if time >= self.duration:
            return self
        return Superposed(self.first.cut(time), self.second.cut(time), self.shape)

    def after(self, time: float) -> Profile:
        """Return the rest after `time` seconds, with its clock starting at 0."""
        if time <= 0.0:
            return self
        return added(_from(self.first, time), _from(self.second, time), self.shape)

    def scaled(self, start: float, factor: float) -> Profile:
        """Return the same motion from `start`, with every distance times `factor`."""
        first = self.first.scaled(start - self.second.start * factor, factor)
        return Superposed(first, self.second.scaled(self.second.start * factor, factor), self.shape)


def added(first: Profile, second: Profile, shape: str) -> Profile:
    """Return the sum of two profiles.

    The sum consists of pieces if both profiles do and no two sine waves overlap; if not, it is a `Superposed`.
    """
    if first.pieced and second.pieced:
        made = _in_pieces(first, second, shape)
        if made is not None:
            return made
    return Superposed(first, second, shape)


def _in_pieces(first: Profile, second: Profile, shape: str) -> Profile | None:
    duration = max(first.duration, second.duration)
    knots = sorted({*first.knots, *second.knots, duration})
    pieces: list[Piece] = []
    if duration == 0.0:
        return None
    for begin in knots[:-1]:
        piece = _both(_piece(first, begin), _piece(second, begin))
        if piece is None:
            return None
        pieces.append(piece)
    end = _end_of_sum(first, second, duration)
    return from_curve(
        shape,
        first.start + second.start,
        end,
        (tuple(knots), tuple(pieces), ((shape, 0),)),
        first.start_velocity + second.start_velocity,
        first.end_velocity + second.end_velocity,
    )


def _piece(profile: Profile, begin: float) -> Piece:
    """Return the piece in force from `begin` on, with local time counted from there."""
    if begin >= profile.duration:
        return (profile.position(begin), profile.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)
    piece, x = profile.piece_at(begin)
    return recentred(piece, x)


def _both(a: Piece, b: Piece) -> Piece | None:
    if a[4] and b[4]:
        return None
    wave = a if a[4] else b
    c0, c1, c2, c3 = (a[i] + b[i] for i in range(4))
    if wave[4] and (c2 or c3):
        return None
    return (c0, c1, c2, c3, *wave[4:])


def _end_of_sum(first: Profile, second: Profile, time: float) -> float:
    """Return the end of a sum; infinite, with the sign of its velocity, if it runs on."""
    end = _end(first, time) + _end(second, time)
    if not isnan(end):
        return end
    # Both run on in opposite directions.
    velocity = first.end_velocity + second.end_velocity
    if velocity:
        return copysign(inf, velocity)
    last = max(knot for knot in (*first.knots, *second.knots) if knot < inf)
    return first.position(last) + second.position(last)


def _end(profile: Profile, time: float) -> float:
    return profile.end if time == inf and profile.duration == inf else _later(profile, time)


def _later(profile: Profile, time: float) -> float:
    if time == inf:
        velocity = profile.end_velocity
        return velocity * inf if velocity else profile.end
    return profile.position(time)


def _from(profile: Profile, time: float) -> Profile:
    """Return the rest of a profile from `time` on.

    A profile that is over rests or continues at its end velocity; the rest of a sum does so by itself.
    """
    rest = profile.after(time)
    late = profile.position(time) - rest.start if time > profile.duration else 0.0
    return rest.shifted(late) if late else rest
