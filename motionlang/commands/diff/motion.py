"""The divergence of the motion of two runs: the first time at which they differ, and the largest difference.

Between two knots of either axis both positions are cubics or sines, and so is their difference. It is compared at the
knots, just before them, and at the extremes of its cubic in between. A sine is divided into `WAVE` parts first, so that
its extremes are exact to a millionth of its amplitude.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Axis, Run
from motionlang.kernel.planners import PieceTable, piece_values
from motionlang.kernel.tools import bisected

Array = NDArray[np.float64]

# The parts of a sine.
WAVE = 8
# The relative rounding of a position; a hundredth of it, by which a table of pieces may differ in addition; and how far
# the cubics of a formula may be off.
ROUNDING, TABLE, FORMULA = 1e-9, 1e-11, 1e-7
# The relative difference by which a later distance must be larger than an earlier one.
LARGER = 1e-12
# Profiles that are compared at once.
TOGETHER = 50_000


@dataclass(eq=False, slots=True)
class Divergence:
    """The machine `time` at which `axis` first differs, and the largest distance, uu.

    The time of the largest distance is included.
    """

    axis: int
    time: float
    max_difference: float
    max_difference_at: float


def divergence(old: Run, new: Run, tolerance: float = 0.0) -> Divergence | None:
    """Return the first divergence of all common axes; None if there is none.

    Only the time before the first end of the two runs is compared.
    """
    end = min(old.time, new.time)
    found = [
        diverged
        for number, a in old.controller.axes.items()
        if number in new.controller.axes
        and (diverged := _of_axis(a, new.controller.axes[number], end, tolerance)) is not None
    ]
    return min(found, key=lambda each: (each.time, each.axis), default=None)


def _of_axis(a: Axis, b: Axis, end: float, tolerance: float) -> Divergence | None:
    def apart(time: float) -> float:
        one, other = a.scale.position_to_user(a.position(time)), b.scale.position_to_user(b.position(time))
        return max(abs(one - other) - ROUNDING * max(abs(one), abs(other), 1.0), 0.0)

    first: float | None = None
    largest = (0.0, 0.0)
    before = 0.0
    edges = _edges(a, b, end)
    for start in range(0, len(edges) - 1, TOGETHER):
        some = edges[start : start + TOGETHER + 1]
        tables = _table(a, some), _table(b, some)
        times = _times(tables, (a.scale.counts, b.scale.counts), np.array(some))
        far, apart_enough = _candidates((a, b), tables, times, tolerance)
        if first is None:
            for k in apart_enough:
                if apart(times[k]) > tolerance:
                    near = times[k - 1] if k else before
                    first = bisected(times[k], near, lambda time: apart(time) > tolerance)
                    break
        for k in far:
            distance = apart(times[k])
            if distance > largest[0] * (1.0 + LARGER):
                largest = (distance, times[k])
        before = times[-1]
    return None if first is None else Divergence(a.index, first, *largest)


def _table(axis: Axis, edges: Sequence[float]) -> PieceTable:
    some = slice(max(axis.index_at(edges[0]) - 1, 0), axis.index_at(edges[-1]) + 1)
    return PieceTable(axis.starts[some], axis.profiles[some])


def _times(tables: Sequence[PieceTable], counts: Sequence[float], edges: Array) -> list[float]:
    origins = np.concatenate([edges, *(table.origins for table in tables)])
    knots = np.unique(origins[(origins >= edges[0]) & (origins <= edges[-1])])
    if any(table.columns[4].any() for table in tables):
        parts = knots[:-1, None] + np.diff(knots)[:, None] * np.arange(WAVE) / WAVE
        knots = np.append(parts, knots[-1])
    halves, middles = 0.5 * np.diff(knots), 0.5 * (knots[:-1] + knots[1:])
    v, a, j = (
        _values(tables[0], middles, order) / counts[0] - _values(tables[1], middles, order) / counts[1]
        for order in (1, 2, 3)
    )
    with np.errstate(all="ignore"):  # without an extreme a root is no number
        q = -0.5 * (a + np.copysign(np.sqrt(a * a - 2.0 * j * v), a))
        roots = [(middles + x)[np.abs(x) < halves] for x in (2.0 * q / j, v / q)]
    # POS = sets a position at a knot, so that the largest distance may be just before it.
    before = np.nextafter(knots[1:], 0.0)
    times: list[float] = np.unique(np.concatenate([before, knots[1:], *roots])).tolist()
    return times


def _candidates(
    axes: tuple[Axis, Axis], tables: Sequence[PieceTable], times: Sequence[float], tolerance: float
) -> tuple[list[int], Sequence[int]]:
    """Return the times at which two axes may be farthest apart, or beyond tolerance.

    The positions come from tables that are nearly exact; a margin covers their error.
    """
    one, other = (
        (_values(table, np.asarray(times), 0) - axis.scale.zero) / axis.scale.counts
        for axis, table in zip(axes, tables, strict=True)
    )
    size = np.maximum(np.maximum(np.abs(one), np.abs(other)), 1.0)
    zeros = max(abs(each.scale.zero / each.scale.counts) for each in axes)
    error = TABLE if all(table.is_exact for table in tables) else FORMULA
    distance, doubt = np.abs(one - other) - ROUNDING * size, error * (size + zeros)
    far = np.flatnonzero((distance + 2.0 * doubt >= np.max(distance)) & (distance + doubt > 0.0))
    first_such: dict[tuple[float, float], int] = {}  # a cycle reaches the same positions repeatedly
    for k, positions in zip(
        far.tolist(), zip(one[far].tolist(), other[far].tolist(), strict=True), strict=True
    ):
        first_such.setdefault(positions, k)
    return list(first_such.values()), np.flatnonzero(distance + doubt > tolerance).tolist()


def _values(table: PieceTable, times: Array, order: int) -> Array:
    piece = np.clip(np.searchsorted(table.origins, times, "right") - 1, 0, None)
    return piece_values(table.columns, piece, times - table.origins[piece], order)


def _edges(a: Axis, b: Axis, end: float) -> list[float]:
    """Return the start times of both axes' profiles after their common beginning.

    Only starts up to `end` are included, and `end` itself.
    """
    same = 0
    pairs = zip(a.starts, a.profiles, b.starts, b.profiles, strict=False)
    for start, profile, other_start, other in pairs:
        if (start, profile.start, profile.end, profile.duration, profile._recipe) != (
            other_start, other.start, other.end, other.duration, other._recipe
        ):  # fmt: skip
            break
        same += 1
    same = max(same - 1, 0)
    starts = sorted({*a.starts[same:], *b.starts[same:], end})
    return starts[: bisect_right(starts, end)]
