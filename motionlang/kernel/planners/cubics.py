"""Cubic approximation of formulas for drawing, refined until every piece fits."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import inf

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.pieces import Formula, State
from motionlang.kernel.planners.ramps import Plain, PlainCurve

# How far a piece may be off in its middle, as a share of the size of the motion.
FIT = 1e-9
_DEPTH = 10


def cubics(profile: Profile) -> PlainCurve:
    """Return knots, pieces and one phase mark of a cubic approximation.

    Position and velocity are exact at every knot.
    """
    low, high = profile.extrema()
    slack = FIT * max(abs(x) for x in (low, high, high - low, 1e-30) if abs(x) < inf)
    knots: list[float] = [0.0]
    pieces: list[Plain] = []
    for piece, (begin, finish) in zip(profile.pieces, pairwise(profile.knots), strict=True):
        if isinstance(piece, tuple):
            knots.append(finish)
            pieces.append(piece)
        elif begin < finish:
            ends = piece.state(0.0), piece.state(finish - begin)
            for x, made in _fitted(piece, 0.0, finish - begin, ends, slack, _DEPTH):
                knots.append(begin + x)
                pieces.append(made)
            knots[-1] = finish
    return tuple(knots), tuple(pieces), ((profile.shape, 0),) if pieces else ()


def _fitted(
    formula: Formula, begin: float, finish: float, ends: tuple[State, State], slack: float, depth: int
) -> Iterator[tuple[float, Plain]]:
    """Yield cubics, each with its end."""
    piece = _hermite(*ends, finish - begin)
    half = 0.5 * (finish - begin)
    middle = formula.state(begin + half)
    guess = piece[0] + half * (piece[1] + half * (piece[2] + half * piece[3]))
    speed = piece[1] + half * (2.0 * piece[2] + half * 3.0 * piece[3])
    fits = abs(guess - middle[0]) <= slack and abs(speed - middle[1]) * half <= 100.0 * slack
    if fits or depth == 0 or not begin < begin + half < finish:
        yield finish, piece
        return
    yield from _fitted(formula, begin, begin + half, (ends[0], middle), slack, depth - 1)
    yield from _fitted(formula, begin + half, finish, (middle, ends[1]), slack, depth - 1)


def _hermite(first: State, last: State, h: float) -> Plain:
    """Return the cubic with these positions and velocities at its ends."""
    mean = (last[0] - first[0]) / h
    c2 = (3.0 * mean - 2.0 * first[1] - last[1]) / h
    c3 = (first[1] + last[1] - 2.0 * mean) / (h * h)
    return (first[0], first[1], c2, c3, 0.0, 0.0, 0.0)
