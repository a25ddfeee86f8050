"""The pieces of a history of moves as columns, expanded from all recipes at once.

The arithmetic is that of `ramps.expand`, with an array in place of each number. For a shift of 20 000 moves this
takes less time than making the pieces one by one. Axes of the arrays: profile, ramp, third of a ramp.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.ramps import FALLING, MOMENT, RISING, SINE, Piece

Array = NDArray[np.float64]

MIN_PROFILES = 24
"""Below this many profiles the arrays cost more than they save."""


def piece_columns(starts: Sequence[float], profiles: Sequence[Profile]) -> tuple[Array, Array]:
    """Return the start times and coefficients (7 x pieces) of profiles.

    The profiles begin at `starts`. Each ends where the next begins; if one is over before that, a piece at its end
    position follows.
    """
    if not profiles:
        return np.empty(0), np.empty((7, 0))
    following = np.append(np.asarray(starts[1:], dtype=np.float64), np.inf)
    with_recipe = [i for i, profile in enumerate(profiles) if len(profile._recipe) > 2]
    if len(with_recipe) < MIN_PROFILES:
        with_recipe = []
    without = sorted(set(range(len(profiles))) - set(with_recipe))
    groups = [
        _of_recipes(starts, profiles, with_recipe),
        _of_curves(starts, profiles, without),
        _of_standstills(starts, profiles),
    ]
    owners = np.concatenate([owner for owner, _, _ in groups])
    begins = np.concatenate([begin for _, begin, _ in groups])
    columns = np.concatenate([column for _, _, column in groups], axis=1)
    used = np.flatnonzero(begins < following[owners])
    # A stable sort with rests last preserves the order within a profile.
    used = used[np.argsort(owners[used], kind="stable")]
    return begins[used], columns[:, used]


PieceColumns = tuple["NDArray[np.int64]", "Array", "Array"]


def _of_recipes(starts: Sequence[float], profiles: Sequence[Profile], rows: list[int]) -> PieceColumns:
    if not rows:
        return np.empty(0, np.int64), np.empty(0), np.empty((7, 0))
    ramps = _matrix([profiles[i]._recipe for i in rows])
    positions = np.array([profiles[i].start for i in rows])
    begins, columns, present = _expand(positions, *ramps)
    owners = np.broadcast_to(np.array(rows)[:, None, None], present.shape)
    begins += np.array([starts[i] for i in rows])[:, None, None]
    return owners[present], begins[present], columns[:, present]


def _of_curves(starts: Sequence[float], profiles: Sequence[Profile], rows: list[int]) -> PieceColumns:
    """Return the pieces of profiles without a recipe: cut, joined or given as pieces.

    It is also faster for a few profiles.
    """
    owners: list[int] = []
    begins: list[float] = []
    found: list[Piece] = []
    for i in rows:
        knots, pieces, _ = profiles[i].curve
        owners.extend([i] * len(pieces))
        begins.extend([starts[i] + knot for knot in knots[: len(pieces)]])
        found.extend(pieces)
    columns = np.array(found, dtype=np.float64).reshape(-1, 7).T
    return np.array(owners, dtype=np.int64), np.array(begins, dtype=np.float64), columns


def _of_standstills(starts: Sequence[float], profiles: Sequence[Profile]) -> PieceColumns:
    durations = np.array([profile.duration for profile in profiles])
    owners = np.flatnonzero(np.isfinite(durations))
    columns = np.zeros((7, len(owners)))
    columns[0] = [profiles[i].end for i in owners.tolist()]
    columns[1] = [profiles[i].end_velocity for i in owners.tolist()]
    return owners, np.asarray(starts, dtype=np.float64)[owners] + durations[owners], columns


def _matrix(recipes: list[tuple[float, ...]]) -> tuple[Array, Array, Array, Array]:
    """Return first velocity, duration, kind and last velocity of every ramp.

    Short recipes are padded with ramps of zero duration.
    """
    lengths = np.array([len(recipe) for recipe in recipes])
    shape = (len(recipes), (int(lengths.max()) - 1) // 3)
    v_from, time, kind, v_to = np.zeros(shape), np.zeros(shape), np.zeros(shape), np.zeros(shape)
    for length in np.unique(lengths).tolist():
        rows = np.flatnonzero(lengths == length)
        block = np.array([recipes[i] for i in rows.tolist()])
        count = (length - 1) // 3
        v_from[rows, :count] = block[:, 0:-1:3]
        time[rows, :count] = block[:, 1::3]
        kind[rows, :count] = block[:, 2::3]
        v_to[rows, :count] = block[:, 3::3]
    return v_from, time, kind, v_to


def _expand(
    start: Array, v_from: Array, time: Array, kind: Array, v_to: Array
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return start times, columns (7, ...) and a presence mask of the thirds of ramps.

    Times count from the start of the profile.
    """
    takes_time = time >= MOMENT
    span = np.where(takes_time & np.isfinite(time), time, 1.0)
    change = v_to - v_from
    share = np.select([kind == FALLING, kind == RISING], [2.0 / 3.0, 1.0 / 3.0], 0.5)
    distance = np.where(takes_time & np.isfinite(time), (v_from + share * change) * span, 0.0)
    begin = np.zeros_like(time)
    np.cumsum(time[:, :-1], axis=1, out=begin[:, 1:])
    position = np.repeat(start[:, None], time.shape[1], axis=1)
    position[:, 1:] += np.cumsum(distance[:, :-1], axis=1)

    begins = np.repeat(begin[:, :, None], 3, axis=2)
    columns = np.zeros((7, *begins.shape))
    present = np.zeros(begins.shape, dtype=bool)
    present[:, :, 0] = takes_time
    c0, c1, c2, c3, amplitude, omega, _ = columns
    c0[:, :, 0] = position
    c1[:, :, 0] = np.where(kind == SINE, 0.5 * (v_from + v_to), v_from)
    c2[:, :, 0] = np.select([kind == 0.0, kind == FALLING], [0.5 * change / span, change / span], 0.0)
    cubic = change / (3.0 * span * span)
    c3[:, :, 0] = np.select([kind == FALLING, kind == RISING], [-cubic, cubic], 0.0)
    amplitude[:, :, 0] = np.where(kind == SINE, -0.5 * change * span / np.pi, 0.0)
    omega[:, :, 0] = np.where(kind == SINE, np.pi / span, 0.0)

    _thirds(
        np.nonzero(takes_time & (kind > 0.0) & (change != 0.0)), begins, columns, present, (span, kind, v_to)
    )
    return begins, columns, present


def _thirds(
    at: tuple[NDArray[np.int64], ...],
    begins: Array,
    columns: Array,
    present: NDArray[np.bool_],
    ramps: tuple[Array, Array, Array],
) -> None:
    """Fill in the thirds of the ramps at index `at`.

    The thirds have rising, constant and falling acceleration.
    """
    span, ratio, v_to = (values[at] for values in ramps)
    first, second, third = ((*at, np.full(len(span), i)) for i in range(3))
    c0, c1, c2, c3 = columns[:4]
    rise = ratio * span
    hold = span - 2.0 * rise
    peak = (v_to - c1[first]) / (span - rise)
    sixth = peak / (6.0 * rise)
    bend = 0.5 * peak * rise
    v = c1[first] + bend
    c3[first] = sixth
    c0[second] = c0[first] + c1[first] * rise + sixth * rise**3
    c1[second] = v
    c2[second] = c2[third] = 0.5 * peak
    c0[third] = c0[second] + (v + 0.5 * peak * hold) * hold
    c1[third] = v_to - bend
    c3[third] = -sixth
    begins[second] += rise
    begins[third] += span - rise
    present[second] = hold > 0.0
    present[third] = True
