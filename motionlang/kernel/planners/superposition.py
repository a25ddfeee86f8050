"""Superposition of two motions of one axis.

An example is an offset on top of gearing.
"""

from __future__ import annotations

from math import inf

from motionlang.kernel.planners.curve import Profile, far_end, from_curve
from motionlang.kernel.planners.formula import plus
from motionlang.kernel.planners.pieces import position_in, recentred, velocity_in
from motionlang.kernel.planners.ramps import Piece


def added(first: Profile, second: Profile, shape: str) -> Profile:
    """Return the sum of two profiles; after its end the shorter one continues as it ended."""
    duration = max(first.duration, second.duration)
    knots = sorted({*first.knots, *second.knots, duration})
    pieces = tuple(plus(_piece(first, begin), _piece(second, begin)) for begin in knots[:-1])
    if duration < inf:
        end = first.position(duration) + second.position(duration)
    else:
        end = far_end(position_in(pieces[-1], 0.0), velocity_in(pieces[-1], 0.0))
    return from_curve(
        shape,
        first.start + second.start,
        end,
        (tuple(knots), pieces, ((shape, 0),) if pieces else ()),
        first.start_velocity + second.start_velocity,
        first.end_velocity + second.end_velocity,
    )


def _piece(profile: Profile, begin: float) -> Piece:
    """Return the piece in force from `begin` on, with local time counted from there."""
    if begin >= profile.duration:
        return (profile.position(begin), profile.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)
    return recentred(*profile.piece_at(begin))
