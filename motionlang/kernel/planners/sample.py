"""Sampling of profiles into NumPy columns.

It takes a few times as long as filling the columns. Long pieces are sampled block by block: the piece is
re-centred at the start of every block of K points, and one matrix product with the powers of the time inside
a block computes all blocks at once. Short pieces are sampled together on one grid of small blocks; the points
between a knot and the next block are then computed again.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.evaluate import evaluate
from motionlang.kernel.planners.table import piece_columns

Array = NDArray[np.float64]

ORDERS = {"position": 0, "velocity": 1, "acceleration": 2, "jerk": 3}
BLOCK = 256
GRID = 24
CHUNK = 262144
SLICE = 65000
LONG = 1024
"""From this many points a piece is worth a matrix product of its own."""


class PieceTable:
    """The pieces of a history as columns: start times and coefficients (7 x pieces).

    The columns have cubics for drawing in place of formulas; samples come from the formulas.
    """

    def __init__(self, starts: Sequence[float], profiles: Sequence[Profile]) -> None:
        origins, columns = piece_columns(starts, profiles)
        if profiles:
            before = np.zeros((7, 1))
            before[0] = profiles[0].start
            origins, columns = np.append(starts[0], origins), np.hstack((before, columns))
        self.origins = origins
        self.begins = origins.copy()
        self.begins[:1] = -np.inf
        self.columns = columns
        ends = [*starts[1:], np.inf]
        self._formulas = [
            (start, min(start + profile.duration, end), profile)
            for start, end, profile in zip(starts, ends, profiles, strict=False)
            if not profile.pieced
        ]

    @property
    def is_exact(self) -> bool:
        """True if no profile is a formula, which the columns only approximate."""
        return not self._formulas

    def sample(self, t0: float, dt: float, n: int, order: int = 0, out: Array | None = None) -> Array:
        """Return n values of derivative `order` at t0, t0 + dt, …

        They are written to `out` (n doubles) if it is given.
        """
        out = np.empty(n) if out is None else out
        if not len(self.begins):
            out.fill(0.0)
            return out
        edges = self._edges(t0, dt, n)
        used = np.flatnonzero(np.diff(edges))
        edges = np.append(edges[used], n)
        columns = _derivative(self.columns[:, used], order)
        origins = self.origins[used] - t0
        request = _Request(out, edges, origins, columns, dt)
        long = np.diff(edges) >= LONG
        _sample_short(request, _runs(~long))
        wavy = columns[4] != 0.0
        still = ~columns[1:5].any(axis=0)
        for k in np.flatnonzero(long & still):
            out[edges[k] : edges[k + 1]] = columns[0, k] + 0.0
        _sample_cubics(request, np.flatnonzero(long & ~wavy & ~still))
        for i in np.flatnonzero(long & wavy):
            _sample_wave(out[edges[i] : edges[i + 1]], columns[:, i], edges[i] * dt - origins[i], dt)
        for start, end, profile in self._formulas:
            _sample_formula(out, profile, start, end, (t0, dt, order))
        return out

    def _edges(self, t0: float, dt: float, n: int) -> NDArray[np.int64]:
        """Return the first point of each piece.

        A point at a knot, within rounding, belongs to the next piece.
        """
        rounding = min(1e-9, 1e-15 * (abs(t0) / dt + n))
        first = np.ceil((self.begins - t0) / dt - rounding)
        return np.append(np.clip(first, 0, n), n).astype(np.int64)


def _sample_formula(
    out: Array, profile: Profile, begin: float, finish: float, how: tuple[float, float, int]
) -> None:
    """Sample one formula at the points from `begin` up to `finish`, CHUNK at a time."""
    t0, dt, order = how
    rounding = min(1e-9, 1e-15 * (abs(t0) / dt + len(out)))
    edges = np.ceil((np.array([begin, finish]) - t0) / dt - rounding)
    first, last = np.clip(edges, 0, len(out)).astype(np.int64).tolist()
    for low in range(first, last, CHUNK):
        high = min(low + CHUNK, last)
        times = np.maximum(t0 + np.arange(low, high) * dt - begin, 0.0)
        out[low:high] = evaluate(profile, times, order)


def _derivative(columns: Array, order: int) -> Array:
    for _ in range(order):
        _, c1, c2, c3, amplitude, omega, phase = columns
        nothing = np.zeros_like(c1)
        columns = np.array([c1, 2 * c2, 3 * c3, nothing, amplitude * omega, omega, phase + np.pi / 2])
    return columns


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return begin and end of every run of True."""
    padded = np.concatenate(([False], mask, [False]))
    changes = np.flatnonzero(padded[1:] != padded[:-1])
    return [(int(a), int(b)) for a, b in zip(changes[::2], changes[1::2], strict=True)]


class _Request(NamedTuple):
    """The requested points: their output, each piece's first point, and the pieces."""

    out: Array
    edges: NDArray[np.int64]
    origins: Array
    columns: Array
    dt: float


def _sample_cubics(request: _Request, which: NDArray[np.int64]) -> None:
    """Sample the long cubic pieces.

    All their blocks are re-centred together; then each piece takes one matrix product.
    """
    if not len(which):
        return
    out, edges, origins, columns, dt = request
    blocks = -(-(edges[which + 1] - edges[which]) // BLOCK)
    ends = np.cumsum(blocks)
    piece = np.repeat(which, blocks)
    first = (np.arange(ends[-1]) - np.repeat(ends - blocks, blocks)) * BLOCK + edges[piece]
    local = _recentred(columns[:4].take(piece, axis=1), first * dt - origins[piece]).T.copy()
    basis = _powers(BLOCK, dt)
    for i, end, count in zip(which.tolist(), ends.tolist(), blocks.tolist(), strict=True):
        _blocks(local[end - count : end], basis, out[edges[i] : edges[i + 1]])


def _sample_wave(out: Array, piece: Array, x0: float, dt: float) -> None:
    """Sample one long sine piece as a matrix product.

    sin(a + b) = sin a cos b + cos a sin b.
    """
    c0, c1, _, _, amplitude, omega, phase = (float(c) for c in piece)
    inside = np.arange(BLOCK) * dt
    x = x0 + np.arange(-(-len(out) // BLOCK)) * (BLOCK * dt)
    angle = omega * x + phase
    local = np.stack(
        (c0 + c1 * x, np.full_like(x, c1), amplitude * np.sin(angle), amplitude * np.cos(angle)), axis=1
    )
    basis = np.stack((np.ones(BLOCK), inside, np.cos(omega * inside), np.sin(omega * inside)))
    _blocks(local, basis, out)


def _powers(count: int, dt: float) -> Array:
    """Return the rows 1, t, t^2, t^3 for `count` times t."""
    t = np.arange(count) * dt
    return np.stack((np.ones(count), t, t * t, t * t * t))


def _blocks(local: Array, basis: Array, out: Array) -> None:
    """Write local @ basis to all of `out`, which may cut the last block short."""
    size = basis.shape[1]
    full, rest = divmod(len(out), size)
    _multiply(local[:full], basis, out[: full * size].reshape(full, size))
    if rest:
        out[full * size :] = local[-1] @ basis[:, :rest]


def _multiply(local: Array, basis: Array, out: Array) -> None:
    """Write local @ basis to `out`, in slices too small for the BLAS to start threads.

    Threads gain little here, where memory is the bottleneck, and cost thirty times as much on a busy machine.
    """
    rows = SLICE // basis.shape[1]
    for i in range(0, len(out), rows):
        np.matmul(local[i : i + rows], basis, out=out[i : i + rows])


def _sample_short(request: _Request, runs: list[tuple[int, int]]) -> None:
    """Sample runs of short pieces, at most CHUNK points at a time.

    A longer run is split.
    """
    edges = request.edges
    together: list[tuple[int, int]] = []
    points = 0
    for begin, finish in runs:
        chunks = max(1, -(-int(edges[finish] - edges[begin]) // CHUNK))
        marks = [begin, finish]
        if chunks > 1:
            times = np.linspace(edges[begin], edges[finish], chunks + 1)[1:-1]
            marks[1:1] = (begin + np.searchsorted(edges[begin:finish], times)).tolist()
        for a, b in pairwise(marks):
            if a == b:
                continue
            count = int(edges[b] - edges[a])
            if together and points + count > CHUNK:
                _sample_runs(request, together)
                together, points = [], 0
            together.append((a, b))
            points += count
    if together:
        _sample_runs(request, together)


def _sample_runs(request: _Request, runs: list[tuple[int, int]]) -> None:
    """Sample runs on grids of small blocks, each by the piece of its first point.

    The points after a knot inside a block are then sampled again.
    """
    out, edges, origins, columns, dt = request
    piece = np.concatenate([np.arange(a, b) for a, b in runs])
    bounds = edges.take([a for a, _ in runs]), edges.take([b for _, b in runs])
    begins, ends, origins, columns = edges[piece], edges[piece + 1], origins[piece], columns[:, piece]
    # For each piece: where its run begins, and the first and last block of the run whose first point is in
    # it.
    run = np.repeat(bounds[0], [b - a for a, b in runs])
    first, last = -(-(begins - run) // GRID), -(-(ends - run) // GRID)
    counts = last - first
    block_piece = np.repeat(np.arange(len(piece)), counts)
    block = np.arange(len(block_piece)) - np.repeat(np.cumsum(counts) - last, counts)
    x = (run[block_piece] + block * GRID) * dt - origins[block_piece]
    local = _recentred(columns[:4].take(block_piece, axis=1), x).T
    basis, done = _powers(GRID, dt), 0
    for begin, end in zip(*(bound.tolist() for bound in bounds), strict=True):
        blocks = -(-(end - begin) // GRID)
        _blocks(local[done : done + blocks], basis, out[begin:end])
        done += blocks
    _set_points(out, begins, np.minimum(run + first * GRID, ends), origins, columns[:4], dt)
    _add_waves(out, (begins, ends), origins, columns, dt)


def _recentred(columns: Array, x: Array) -> Array:
    """Return cubic coefficients (4 x pieces) with the local times counted from `x`."""
    c0, c1, c2, c3 = columns
    local = np.empty_like(columns)
    np.multiply(c3, x, out=local[2])
    local[2] += c2
    local[1] = local[2] * x + c1
    local[0] = local[1] * x + c0
    local[1] += (local[2] + c3 * x) * x
    local[2] += 2.0 * c3 * x
    local[3] = c3
    return local


def _points(
    begins: NDArray[np.int64], ends: NDArray[np.int64], origins: Array, dt: float
) -> tuple[NDArray[np.int64], NDArray[np.int64], Array]:
    """Return the points of many index ranges in one row.

    Their counts per range and their local times are also returned.
    """
    counts = ends - begins
    total = int(counts.sum())
    index = np.repeat(begins - np.cumsum(counts) + counts, counts)
    index += np.arange(total)
    return index, counts, index * dt - np.repeat(origins, counts)


def _set_points(
    out: Array, begins: NDArray[np.int64], ends: NDArray[np.int64], origins: Array, columns: Array, dt: float
) -> None:
    index, counts, x = _points(begins, ends, origins, dt)
    value = np.repeat(columns[3], counts)
    for column in columns[2::-1]:
        value *= x
        value += np.repeat(column, counts)
    out[index] = value


def _add_waves(
    out: Array,
    edges: tuple[NDArray[np.int64], NDArray[np.int64]],
    origins: Array,
    columns: Array,
    dt: float,
) -> None:
    wavy = np.flatnonzero(columns[4])
    if not len(wavy):
        return
    amplitude, omega, phase = columns[4:, wavy]
    index, counts, x = _points(edges[0][wavy], edges[1][wavy], origins[wavy], dt)
    x *= np.repeat(omega, counts)
    x += np.repeat(phase, counts)
    np.sin(x, out=x)
    x *= np.repeat(amplitude, counts)
    out[index] += x
