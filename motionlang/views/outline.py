"""A motion as the few points that a picture of it needs, taken from its pieces: no peak and no jump is lost.

Every piece gives its ends, its quarters and its middle, and the points of an even grid that fall into it. A knot is
there twice, once as the end of one piece and once as the begin of the next, so that a jump is drawn upright. Where
there are more points than a picture has columns, each column keeps its lowest and its highest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motionlang.planners.evaluate import piece_values
from motionlang.planners.sample import ORDERS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from motionlang.log.trace import Trace

    Array = NDArray[np.float64]

GRID = 1000
_PARTS = np.array([0.0, 0.25, 0.5, 0.75, 1.0])


def outline(
    trace: Trace, axis: int, quantity: str, span: tuple[float, float] | None = None, bins: int = GRID
) -> tuple[Array, Array]:
    """Times (s) and values (user units) of one quantity of one axis, at most about eight points a bin.

    All of the run, or a `span` of it (s).
    """
    span = span or (0.0, trace.end)
    piece, inside = _points(trace, axis, span, bins)
    table = trace.table(axis)
    values = piece_values(table.columns[:, piece], inside, ORDERS[quantity])
    times = np.maximum.accumulate(table.origins[piece] + inside)
    trace.to_user(axis, quantity, values)
    return thinned(times, values, span, bins)


def thinned(times: Array, values: Array, span: tuple[float, float], bins: int = GRID) -> tuple[Array, Array]:
    """The points in `span`, or of very many of them the lowest and the highest of each of `bins` stretches.

    The last point before it is kept, too, so that a line comes in from the left.
    """
    begin, end = span
    first = max(0, int(np.searchsorted(times, begin, "left")) - 1) if begin > 0.0 else 0
    last = int(np.searchsorted(times, end, "right"))
    times, values = times[first:last], np.array(values[first:last])
    if len(times) > 8 * bins and end > begin:
        return _extremes(times, values, span, bins)
    return times, values


def _points(trace: Trace, axis: int, span: tuple[float, float], bins: int) -> tuple[NDArray[np.int64], Array]:
    """Which piece each point lies in, and its time since the begin of the piece, in the order of time."""
    begins, (begin, end) = trace.table(axis).origins, span
    skipped = np.maximum(begin - begins, 0.0)
    lengths = np.minimum(np.append(begins[1:], end), end) - begins
    used = np.flatnonzero((lengths > skipped) & (begins < end))
    if not len(used):
        used = np.flatnonzero(begins <= end)[-1:]
        return used, end - begins[used] if begin > 0.0 else np.zeros(1)
    inside = (skipped[used, None] + (lengths - skipped)[used, None] * _PARTS).ravel()
    piece = np.repeat(used, len(_PARTS))
    grid = np.linspace(begin, end, bins + 1)
    owner = used[np.clip(np.searchsorted(begins[used], grid, "right") - 1, 0, None)]
    piece = np.concatenate((piece, owner))
    inside = np.concatenate((inside, np.clip(grid - begins[owner], skipped[owner], lengths[owner])))
    order = np.lexsort((inside, piece))
    return piece[order], inside[order]


def _extremes(times: Array, values: Array, span: tuple[float, float], bins: int) -> tuple[Array, Array]:
    """The lowest and the highest value of each bin, in the order in which they come."""
    begin, end = span
    bin_of = np.minimum(((times - begin) * (bins / (end - begin))).astype(np.int64), bins - 1)
    firsts = np.flatnonzero(np.diff(bin_of, prepend=-1))
    lowest = _positions(values, firsts)
    highest = _positions(-values, firsts)
    chosen = np.sort(np.concatenate((lowest, highest, [0, len(values) - 1])))
    return times[chosen], values[chosen]


def _positions(values: Array, firsts: NDArray[np.int64]) -> NDArray[np.int64]:
    """Where the lowest value of each stretch stands."""
    lowest = np.minimum.reduceat(values, firsts)
    counts = np.diff(np.append(firsts, len(values)))
    hits = np.flatnonzero(values == np.repeat(lowest, counts))
    return hits[np.searchsorted(hits, firsts)]
