"""Cubic approximation of a formula for drawing, refined until every piece fits."""

from __future__ import annotations

from itertools import pairwise
from math import inf

from motionlang.kernel.planners.curve import MotionState, Profile
from motionlang.kernel.planners.ramps import Curve, Piece

# How far a piece may be off in its middle, as a share of the size of the motion.
FIT = 1e-9
_DEPTH = 10
# Distance inside a piece, as a fraction, at which its ends are sampled.
_ASIDE = 1e-6
# Seconds too few to divide by the square of.
MOMENT = 1e-100


def cubics(profile: Profile) -> Curve:
    """Return knots, pieces and one phase mark of a cubic approximation.

    Position and velocity are exact at every knot.
    """
    low, high = profile.extrema()
    size = max(abs(x) for x in (low, high, high - low, 1e-30) if abs(x) < inf)
    knots = [0.0]
    pieces: list[Piece] = []
    given = profile.knots
    for begin, finish in pairwise(given):
        if finish == inf:
            last = profile.at(begin)
            pieces.append((last.position, last.velocity, 0.0, 0.0, 0.0, 0.0, 0.0))
            knots.append(inf)
        elif finish - begin > MOMENT:
            inwards = _ASIDE * (finish - begin)
            ends = _state_near(profile, begin, inwards), _state_near(profile, finish, -inwards)
            _fit(profile, (begin, finish), ends, FIT * size, knots, pieces, _DEPTH)
    return tuple(knots), tuple(pieces), ((profile.shape, 0),) if pieces else ()


def _state_near(profile: Profile, knot: float, inwards: float) -> MotionState:
    """Return the state at a knot as seen from one side, `inwards` from it.

    If the velocity jumps at the knot, rounding decides which side `knot` itself is on.
    """
    inside = profile.at(knot + inwards)
    velocity = inside.velocity - inwards * (inside.acceleration - 0.5 * inwards * inside.jerk)
    return MotionState(profile.at(knot).position, velocity, inside.acceleration, inside.jerk)


def _fit(
    profile: Profile,
    span: tuple[float, float],
    ends: tuple[MotionState, MotionState],
    slack: float,
    knots: list[float],
    pieces: list[Piece],
    depth: int,
) -> None:
    begin, finish = span
    piece = _hermite(ends[0], ends[1], finish - begin)
    half = 0.5 * (finish - begin)
    middle = profile.at(begin + half)
    guess = piece[0] + half * (piece[1] + half * (piece[2] + half * piece[3]))
    speed = piece[1] + half * (2.0 * piece[2] + half * 3.0 * piece[3])
    fits = abs(guess - middle.position) <= slack and abs(speed - middle.velocity) * half <= 100.0 * slack
    if fits or depth == 0 or not begin < begin + half < finish:
        knots.append(finish)
        pieces.append(piece)
        return
    _fit(profile, (begin, begin + half), (ends[0], middle), slack, knots, pieces, depth - 1)
    _fit(profile, (begin + half, finish), (middle, ends[1]), slack, knots, pieces, depth - 1)


def _hermite(first: MotionState, last: MotionState, h: float) -> Piece:
    """Return the cubic with these positions and velocities at its ends."""
    mean = (last.position - first.position) / h
    c2 = (3.0 * mean - 2.0 * first.velocity - last.velocity) / h
    c3 = (first.velocity + last.velocity - 2.0 * mean) / (h * h)
    return (first.position, first.velocity, c2, c3, 0.0, 0.0, 0.0)
