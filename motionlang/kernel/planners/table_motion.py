"""Curves of straight lines through tables, and the slopes of splines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from motionlang.kernel.planners.curve import Profile, from_curve


def table_curve(positions: Sequence[float], values: Sequence[float]) -> Profile:
    """Return the curve with `values` at `positions`, which rise from 0.

    Raises ValueError for an invalid table.
    """
    if len(positions) != len(values) or len(positions) < 2:
        raise ValueError("a table needs two points or more, and a value for each")
    if positions[0] != 0.0 or not all(a < b for a, b in pairwise(positions)):
        raise ValueError("the positions of a table must rise from 0")
    if not all(abs(x) < 1e300 for x in (*positions, *values)):
        raise ValueError("the numbers of a table must be finite")
    slopes = [(d - c) / (b - a) for (a, b), (c, d) in zip(pairwise(positions), pairwise(values), strict=True)]
    pieces = [(value, slope, 0.0, 0.0, 0.0, 0.0, 0.0) for value, slope in zip(values, slopes, strict=False)]
    curve = (tuple(positions), tuple(pieces), tuple(("segment", i) for i in range(len(pieces))))
    return from_curve("table", values[0], values[-1], curve, slopes[0], slopes[-1])


def spline_slopes(widths: Sequence[float], rises: Sequence[float], cyclic: bool) -> list[float]:
    """Return the slopes of a cubic spline with continuous curvature.

    Its end slopes are zero, or equal if it is `cyclic`.

    m[i-1]/h[i-1] + 2 m[i] (1/h[i-1] + 1/h[i]) + m[i+1]/h[i] = 3 (r[i-1]/h[i-1] + r[i]/h[i]).
    """
    still = [0.0, *_inner(widths, rises, 0.0), 0.0]
    if not cyclic:
        return still
    # The slope at the seam is free. The curvature there is linear in it, so two solutions give the third.
    flat = [0.0] * len(widths)
    unit = [1.0, *_inner(widths, flat, 1.0), 1.0]
    jump = _seam(widths, rises, still)
    change = _seam(widths, flat, unit)
    seam = -jump / change
    return [a + seam * b for a, b in zip(still, unit, strict=True)]


def _seam(widths: Sequence[float], rises: Sequence[float], slopes: Sequence[float]) -> float:
    """Return half the jump of the curvature from the end to the beginning."""
    after = (3.0 * rises[0] - 2.0 * slopes[0] - slopes[1]) / widths[0]
    before = (slopes[-2] + 2.0 * slopes[-1] - 3.0 * rises[-1]) / widths[-1]
    return after - before


def _inner(widths: Sequence[float], rises: Sequence[float], end: float) -> list[float]:
    """Return the slopes between two ends with one slope, by tridiagonal elimination."""
    diagonal: list[float] = []
    right: list[float] = []
    for i, (h, k) in enumerate(pairwise(widths)):
        d = 2.0 * (1.0 / h + 1.0 / k)
        r = 3.0 * (rises[i] / h + rises[i + 1] / k)
        if i == 0:
            r -= end / h
        else:
            factor = 1.0 / h / diagonal[-1]
            d -= factor / h
            r -= factor * right[-1]
        diagonal.append(d)
        right.append(r)
    found: list[float] = []
    following = end
    for i in range(len(diagonal) - 1, -1, -1):
        following = (right[i] - following / widths[i + 1]) / diagonal[i]
        found.append(following)
    return found[::-1]
