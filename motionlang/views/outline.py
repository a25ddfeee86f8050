"""A reduced set of points of a motion for a picture, with every peak and jump.

The points come from the pieces of the motion. Every piece contributes its ends, quarters and middle, and the points
of an even grid inside it. A knot occurs twice, as the end of one piece and the start of the next, so that a
jump is drawn vertically. If there are more points than a picture has columns, each column keeps only its
lowest and its highest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Trace
from motionlang.kernel.planners import ORDERS, piece_values

Array = NDArray[np.float64]

GRID = 1000
_FRACTIONS = np.array([0.0, 0.25, 0.5, 0.75, 1.0])


def outline(
    trace: Trace, axis: int, quantity: str, span: tuple[float, float] | None = None, bins: int = GRID
) -> tuple[Array, Array]:
    """Return times (s) and values (user units) of one quantity of one axis.

    There are at most about eight points per bin. They cover the whole run, or a `span` of it (s).
    """
    span = span or (0.0, trace.end)
    piece, inside = _points(trace, axis, span, bins)
    table = trace.table(axis)
    values = piece_values(table.columns, piece, inside, ORDERS[quantity])
    times = np.maximum.accumulate(table.origins[piece] + inside)
    trace.to_user(axis, quantity, times, values)
    return thinned(times, values, span, bins)


def thinned(times: Array, values: Array, span: tuple[float, float], bins: int = GRID) -> tuple[Array, Array]:
    """Return the points in `span`; if there are many, only the extremes of each bin.

    The bins divide the span equally. The last point before the span is included, so that a line enters from
    the left.
    """
    begin, end = span
    first = max(0, int(np.searchsorted(times, begin, "left")) - 1) if begin > 0.0 else 0
    last = int(np.searchsorted(times, end, "right"))
    times, values = times[first:last], np.array(values[first:last])
    if len(times) > 8 * bins and end > begin:
        return _extremes(times, values, span, bins)
    return times, values


def _points(trace: Trace, axis: int, span: tuple[float, float], bins: int) -> tuple[NDArray[np.int64], Array]:
    """Return the piece of each point and the time since it began, in time order."""
    begins, (begin, end) = trace.table(axis).origins, span
    skipped = np.maximum(begin - begins, 0.0)
    lengths = np.minimum(np.append(begins[1:], end), end) - begins
    used = np.flatnonzero((lengths > skipped) & (begins < end))
    if not len(used):
        used = np.flatnonzero(begins <= end)[-1:]
        return used, end - begins[used] if begin > 0.0 else np.zeros(1)
    inside = (skipped[used, None] + (lengths - skipped)[used, None] * _FRACTIONS).ravel()
    piece = np.repeat(used, len(_FRACTIONS))
    grid = np.linspace(begin, end, bins + 1)
    owner = used[np.clip(np.searchsorted(begins[used], grid, "right") - 1, 0, None)]
    piece = np.concatenate((piece, owner))
    inside = np.concatenate((inside, np.clip(grid - begins[owner], skipped[owner], lengths[owner])))
    order = np.lexsort((inside, piece))
    return piece[order], inside[order]


def _extremes(times: Array, values: Array, span: tuple[float, float], bins: int) -> tuple[Array, Array]:
    """Return the lowest and highest value of each bin, in time order."""
    begin, end = span
    bin_of = np.minimum(((times - begin) * (bins / (end - begin))).astype(np.int64), bins - 1)
    firsts = np.flatnonzero(np.diff(bin_of, prepend=-1))
    lowest = _positions(values, firsts)
    highest = _positions(-values, firsts)
    chosen = np.sort(np.concatenate((lowest, highest, [0, len(values) - 1])))
    return times[chosen], values[chosen]


def _positions(values: Array, firsts: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the index of the lowest value of each bin."""
    lowest = np.minimum.reduceat(values, firsts)
    counts = np.diff(np.append(firsts, len(values)))
    hits = np.flatnonzero(values == np.repeat(lowest, counts))
    return hits[np.searchsorted(hits, firsts)]
