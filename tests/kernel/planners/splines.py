"""Cubic splines through tables: smooth curves for tests, which no language makes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from motionlang.kernel.planners import Profile, from_curve
from motionlang.kernel.planners.table_motion import spline_slopes


def cubic_table(positions: Sequence[float], values: Sequence[float], cyclic: bool = False) -> Profile:
    """Return the spline with `values` at `positions`, of continuous curvature.

    At its ends the slope is zero; if it is `cyclic`, its end continues into its beginning instead.
    """
    rises = [(d - c) / (b - a) for (a, b), (c, d) in zip(pairwise(positions), pairwise(values), strict=True)]
    widths = [b - a for a, b in pairwise(positions)]
    slopes = spline_slopes(widths, rises, cyclic)
    pieces = [
        (value, m, (3.0 * rise - 2.0 * m - n) / h, (m + n - 2.0 * rise) / (h * h), 0.0, 0.0, 0.0)
        for value, rise, h, (m, n) in zip(values, rises, widths, pairwise(slopes), strict=False)
    ]
    curve = (tuple(positions), tuple(pieces), tuple(("segment", i) for i in range(len(pieces))))
    return from_curve("table", values[0], values[-1], curve, slopes[0], slopes[-1])
