"""Points of a spline by its mode, from SPLINESTART to SPLINEEND.

The table has 10, 30, 45 and 50; a unit has 4 counts, and the axis is at 100 when the spline begins.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

SPLINE = """\
Dim way(5) As Float = 4, 10, 30, 45, 50
SCALEFACTOR(0) = 4 : POS(0) = 100
SPLINETABLE(0, way)
SPLINETIME(0) = 200 : SPLINESTART(0) = {} : SPLINEEND(0) = {}
SPLINE(0) = {}
GO(0)
PAUSE IDLE(0)
"""
DISTANCES, FROM_THE_START, POSITIONS = 0, 1, 2


@pytest.mark.parametrize(
    ("first", "last", "mode", "points"),
    [
        (1, 0, DISTANCES, [110.0, 140.0, 185.0, 235.0]),
        (2, 3, DISTANCES, [130.0, 175.0]),
        (4, 4, DISTANCES, [150.0]),
        (1, 0, FROM_THE_START, [110.0, 130.0, 145.0, 150.0]),
        (2, 0, FROM_THE_START, [120.0, 135.0, 140.0]),  # from 10, where the first segment ends
        (3, 4, FROM_THE_START, [115.0, 120.0]),  # from 30
        (1, 0, POSITIONS, [10.0, 30.0, 45.0, 50.0]),
        (3, 3, POSITIONS, [45.0]),
    ],
)
def test_the_points_of_a_spline(first: int, last: int, mode: int, points: list[float]) -> None:
    """Each segment takes 200 ms."""
    result = run(Source("spline.mnt", SPLINE.format(first, last, mode)), cache=False)
    assert [each.message for each in result.diagnostics] == []
    axis = result.controller.axes[0]
    begun = next(
        start for start, each in zip(axis.starts, axis.profiles, strict=True) if each.shape != "hold"
    )
    found = [axis.scale.position_to_user(axis.position(begun + 0.2 * (n + 1))) for n in range(len(points))]
    assert found == pytest.approx(points)
    assert axis.profiles[-1].start == pytest.approx(axis.scale.position_to_counts(points[-1]))
