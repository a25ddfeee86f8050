"""The first time from which a profile moves in a given direction."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.pieces import position_in, still_points, velocity_in

# The travel in one direction, in length units, that counts as motion; rounding is smaller.
_MIN_TRAVEL = 1e-6


def sets_off(profile: Profile, sign: int, after: float) -> float | None:
    """Return the first time >= `after` from which the profile moves in a direction.

    The direction is forward (`sign` +1) or reverse (-1). Standstill has no direction: a profile that rests
    first sets off when it leaves its position. None if it never moves that way.
    """
    after = max(after, 0.0)
    begun, travelled = after, 0.0
    for begin, distance in _stretches(profile, after):
        if distance * sign <= 0.0:
            travelled = 0.0 if distance else travelled
            continue
        begun = begin if not travelled else begun
        travelled += abs(distance)
        if travelled > _MIN_TRAVEL:
            return begun
    return None


def _stretches(profile: Profile, after: float) -> Iterator[tuple[float, float]]:
    """Yield the beginning and the signed travel of each monotone section from `after`.

    The last section may have no end.
    """
    yield from _spans(profile, after)
    velocity = profile.end_velocity
    if velocity and profile.duration < inf:
        yield max(after, profile.duration), velocity * inf


def _spans(profile: Profile, after: float) -> Iterator[tuple[float, float]]:
    knots = profile.knots
    for piece, begin, finish in zip(profile.pieces, knots, knots[1:], strict=False):
        if finish <= after:
            continue
        low = max(after - begin, 0.0)
        extrema = [x for x in still_points(piece, finish - begin) if x > low]
        for x in (*extrema, finish - begin):
            if x == inf:
                velocity = velocity_in(piece, low + 1.0)
                yield begin + low, velocity * inf if velocity else 0.0
            else:
                yield begin + low, position_in(piece, x) - position_in(piece, low)
            low = x
