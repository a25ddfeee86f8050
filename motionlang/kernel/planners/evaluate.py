"""NumPy evaluation of a profile, or of pieces, at many times."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.formula import Chain
from motionlang.kernel.planners.ramps import Piece

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def evaluate(profile: Profile, times: Array, order: int) -> Array:
    """Evaluate derivative `order` (0 to 3) at `times`, which may lie beyond the end."""
    inside = (times >= 0.0) & (times < profile.duration)
    out = _outside(profile, times, order)
    if inside.any():
        knots = np.array(profile.knots)
        which = np.clip(np.searchsorted(knots, times[inside], "right") - 1, 0, len(profile.pieces) - 1)
        out[inside] = _values(profile.pieces, which, times[inside] - knots[which], order)
    return out


def _outside(profile: Profile, times: Array, order: int) -> Array:
    out = np.zeros_like(times)
    if order == 0:
        out[:] = profile.start
        late = times >= profile.duration
        if late.any():
            out[late] = profile.end + profile.end_velocity * (times[late] - profile.duration)
    elif order == 1:
        out[:] = np.where(times < 0.0, profile.start_velocity, profile.end_velocity)
    return out


def _values(pieces: Sequence[Piece], which: Indices, x: Array, order: int) -> Array:
    """Evaluate derivative `order` at local times; `which` is the piece of each."""
    kinds = {piece.__class__ for piece in pieces}
    if len(kinds) > 1:
        out = np.empty_like(x)
        for kind in kinds:
            own = [i for i, piece in enumerate(pieces) if piece.__class__ is kind]
            place = np.full(len(pieces), -1)
            place[own] = np.arange(len(own))
            mine = place[which] >= 0
            out[mine] = _values([pieces[i] for i in own], place[which[mine]], x[mine], order)
        return out
    (kind,) = kinds
    if kind is tuple:
        return piece_values(np.array(pieces).T, which, x, order)
    if kind is Chain:
        inner, outer = [piece.inner for piece in pieces], [piece.outer for piece in pieces]  # type: ignore[union-attr]
        s, *moving = (_values(inner, which, x, n) for n in range(order + 1))
        f = [_values(outer, which, s, n) for n in range(order + 1)]
        if order < 2:
            return f[1] * moving[0] if order else f[0]
        v, a = moving[:2]
        if order == 2:
            return f[2] * v * v + f[1] * a
        return (f[3] * v * v + 3.0 * f[2] * a) * v + f[1] * moving[2]
    first, second = [piece.first for piece in pieces], [piece.second for piece in pieces]  # type: ignore[union-attr]
    return _values(first, which, x, order) + _values(second, which, x, order)


def piece_values(columns: Array, piece: Indices, x: Array, order: int) -> Array:
    """Evaluate derivative `order` of pieces (7 x pieces) at local times; `piece` is the column of each x.

    A piece is p(x) = c0 + c1 x + c2 x^2 + c3 x^3 + a sin(w x + f).
    """
    c0, c1, c2, c3, amplitude, omega, phase = columns
    first, *others = [(c3, c2, c1, c0), (3.0 * c3, 2.0 * c2, c1), (6.0 * c3, 2.0 * c2), (6.0 * c3,)][order]
    values: Array = first[piece]
    for each in others:
        values *= x
        values += each[piece]
    if amplitude.any():
        height = amplitude * omega**order
        values += height[piece] * np.sin(omega[piece] * x + (phase + order * np.pi / 2.0)[piece])
    return values
