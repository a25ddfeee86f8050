"""Curves of straight lines through tables, and the slopes of splines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, pairwise

from motionlang.kernel.planners.curve import Profile, from_curve
from motionlang.kernel.planners.pvt.velocities import smooth_velocities


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
    """
    points = [0.0, *accumulate(h * r for h, r in zip(widths, rises, strict=True))]
    still = smooth_velocities(points, widths)
    if not cyclic:
        return still
    # The slope at the seam is free. The curvature there is linear in it, so two solutions give the third.
    flat = [0.0] * len(points)
    unit = smooth_velocities(flat, widths, 1.0, 1.0)
    seam = -_seam(widths, rises, still) / _seam(widths, flat, unit)
    return [a + seam * b for a, b in zip(still, unit, strict=True)]


def _seam(widths: Sequence[float], rises: Sequence[float], slopes: Sequence[float]) -> float:
    """Return half the jump of the curvature from the end to the beginning."""
    after = (3.0 * rises[0] - 2.0 * slopes[0] - slopes[1]) / widths[0]
    before = (slopes[-2] + 2.0 * slopes[-1] - 3.0 * rises[-1]) / widths[-1]
    return after - before
