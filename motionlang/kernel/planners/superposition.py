"""Superposition of two motions of one axis.

An example is an offset on top of gearing.
"""

from __future__ import annotations

from math import copysign, inf, isnan

from motionlang.kernel.planners.curve import Profile, from_curve
from motionlang.kernel.planners.formula import plus
from motionlang.kernel.planners.pieces import recentred
from motionlang.kernel.planners.ramps import Piece


def added(first: Profile, second: Profile, shape: str) -> Profile:
    """Return the sum of two profiles; after its end the shorter one continues as it ended."""
    duration = max(first.duration, second.duration)
    knots = sorted({*first.knots, *second.knots, duration})
    pieces = tuple(plus(_piece(first, begin), _piece(second, begin)) for begin in knots[:-1])
    return from_curve(
        shape,
        first.start + second.start,
        _end_of_sum(first, second, duration),
        (tuple(knots), pieces, ((shape, 0),) if pieces else ()),
        first.start_velocity + second.start_velocity,
        first.end_velocity + second.end_velocity,
    )


def _piece(profile: Profile, begin: float) -> Piece:
    """Return the piece in force from `begin` on, with local time counted from there."""
    if begin >= profile.duration:
        return (profile.position(begin), profile.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)
    return recentred(*profile.piece_at(begin))


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
