"""NumPy evaluation of a profile, or a column of pieces, at many times."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.reparametrised import AT_END, Reparametrised
from motionlang.kernel.planners.sequence import ProfileSequence
from motionlang.kernel.planners.superposition import Superposed

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def evaluate(profile: Profile, times: Array, order: int) -> Array:
    """Evaluate derivative `order` (0 to 3) at `times`, which may lie beyond the end."""
    inside = (times >= 0.0) & (times < profile.duration)
    out = _outside(profile, times, order)
    if inside.any():
        out[inside] = _inside(profile, times[inside], order)
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


def _inside(profile: Profile, times: Array, order: int) -> Array:
    if isinstance(profile, Reparametrised):
        return _composed(profile, times, order)
    if isinstance(profile, Superposed):
        return evaluate(profile.first, times, order) + evaluate(profile.second, times, order)
    if isinstance(profile, ProfileSequence):
        return _chain(profile, times, order)
    return _pieces(profile, times, order)


def _pieces(profile: Profile, times: Array, order: int) -> Array:
    knots = np.array(profile.knots)
    which = np.clip(np.searchsorted(knots, times, "right") - 1, 0, len(profile.pieces) - 1)
    return piece_values(np.array(profile.pieces).T, which, times - knots[which], order)


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


def _composed(profile: Reparametrised, times: Array, order: int) -> Array:
    """Apply the chain rule, up to the third derivative."""
    s = evaluate(profile.along, times, 0)
    if order == 0:
        return _curve(profile.path, s, 0) + profile.lift
    v = evaluate(profile.along, times, 1)
    if order == 1:
        return _curve(profile.path, s, 1) * v
    a = evaluate(profile.along, times, 2)
    if order == 2:
        return _curve(profile.path, s, 2) * v * v + _curve(profile.path, s, 1) * a
    jerk = evaluate(profile.along, times, 3)
    bends = _curve(profile.path, s, 3) * v * v + 3.0 * _curve(profile.path, s, 2) * a
    return bends * v + _curve(profile.path, s, 1) * jerk


def _curve(path: Profile, distances: Array, order: int) -> Array:
    """Evaluate a curve at distances along it.

    Before its beginning and beyond its end it is a straight line. Exactly at an end it has the curvature that it has
    inside.
    """
    length = path.duration
    if order == 2 and length < np.inf:
        near = (distances >= -AT_END * length) & (distances <= length * (1.0 + AT_END))
        distances = np.where(near, np.clip(distances, 0.0, np.nextafter(length, 0.0)), distances)
    out = evaluate(path, distances, order)
    before = distances < 0.0
    if order == 0 and before.any():
        out[before] = path.start + path.start_velocity * distances[before]
    return out


def _chain(profile: ProfileSequence, times: Array, order: int) -> Array:
    out = np.empty_like(times)
    owner = np.searchsorted(np.array(profile.begins), times, "right") - 1
    for i in np.unique(owner).tolist():
        mine = owner == i
        out[mine] = evaluate(profile.segments[i], times[mine] - profile.begins[i], order)
    return out
