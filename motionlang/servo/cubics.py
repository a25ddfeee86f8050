"""The command of a servo as cubics over its trajectory cycles."""

from __future__ import annotations

from bisect import bisect_right
from math import ceil, inf
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.planners import Profile
    from motionlang.servo.demand import Cubic, Generator

# The first time after the beginning of a profile.
_BEGUN = 5e-324


def cubic_behind(generator: Generator, cycle: int, least: int = 1) -> tuple[Cubic | None, int]:
    """Return the cubic that the end point of `cycle` lies on, and where it ends.

    The cubic counts time from the beginning of `cycle`, in cycles. Its end is the first cycle whose end point is on
    another one. None if the point is on no cubic, or on one for less than `least` cycles.
    """
    period, track = generator.period, generator.track
    k = generator.in_force(cycle)
    start, until = track.starts[k], generator.past(k)
    piece, origin, end = _piece(track.profiles[k], (cycle + 1) * period - start)
    if end < inf:
        over = ceil((start + end) / period) - 1
        while (over + 1) * period - start < end:
            over += 1
        while over * period - start >= end:
            over -= 1
        until = min(until, over)
    if piece is None or until - cycle < least:
        return None, until
    c0, c1, c2, c3 = moved(piece, cycle * period - start - origin)
    return (c0 + generator.offset(k), c1 * period, c2 * period**2, c3 * period**3), until


def _piece(profile: Profile, time: float) -> tuple[Cubic | None, float, float]:
    """Return the cubic of a profile at a time, and its start and end.

    All times are in s of the profile.
    """
    if not profile.pieced:
        return None, 0.0, inf
    if time >= profile.duration:
        return (profile.end, profile.end_velocity, 0.0, 0.0), profile.duration, inf
    if time <= 0.0:
        return (profile.start, 0.0, 0.0, 0.0), 0.0, _BEGUN
    knots, pieces, _ = profile.curve
    k = min(bisect_right(knots, time), len(pieces)) - 1
    c0, c1, c2, c3, amplitude, _, _ = pieces[k]
    end = knots[k + 1] if k + 1 < len(pieces) else profile.duration
    return None if amplitude else (c0, c1, c2, c3), knots[k], end


def moved(cubic: Cubic, by: float) -> Cubic:
    """Return the same cubic with its time counted from `by` later."""
    _, c1, c2, c3 = cubic
    return value(cubic, by), (3.0 * c3 * by + 2.0 * c2) * by + c1, 3.0 * c3 * by + c2, c3


def value(cubic: Cubic, at: float) -> float:
    """Evaluate the cubic at a time."""
    c0, c1, c2, c3 = cubic
    return ((c3 * at + c2) * at + c1) * at + c0
