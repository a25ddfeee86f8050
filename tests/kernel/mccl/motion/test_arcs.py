"""Contour arcs: the middle and the end of each kind of description, by hand."""

from __future__ import annotations

from math import sqrt

import pytest

from tests.cases import cases
from tests.mccl_runs import Runner

START = 300, -200
HEAD = "1MN,2MN,1DH300,2DH-200,1CM1,2CM1,1VV200,1VA100000,1VD100000\n"
# 100 cos 45°.
C = 50.0 * sqrt(2.0)

# The points are those from the start. Half the time is half the angle, because both ramps are equal.
ARCS = [
    # Centre 100, 0: the start is at 180°. Clockwise over 90°, anticlockwise over 270°.
    ("1CP2,1CR100,2CR0,1MR200,2MR0", (100.0, 100.0), (200.0, 0.0)),
    ("1CP3,1CR100,2CR0,1MR200,2MR0", (100.0, -100.0), (200.0, 0.0)),
    # Radius 100 to 100, 100: clockwise the short way is about 100, 0, anticlockwise about 0, 100.
    ("1CP2,1RR100,1MR100,2MR100", (100.0 - C, C), (100.0, 100.0)),
    ("1CP3,1RR100,1MR100,2MR100", (C, 100.0 - C), (100.0, 100.0)),
    # The long way is about the other centre, 270°.
    ("1CP2,1RR-100,1MR100,2MR100", (-C, 100.0 + C), (100.0, 100.0)),
    ("1CP3,1RR-100,1MR100,2MR100", (100.0 + C, -C), (100.0, 100.0)),
    # A chord of just two radii is a half circle.
    ("1CP3,1RR100,1MR0,2MR200", (100.0, 100.0), (0.0, 200.0)),
    # Centre -100, 0: the start is at 0°. By angle: absolute, relative, and whole circles.
    ("1CP3,1CR-100,2CR0,1EA90", (C - 100.0, C), (-100.0, 100.0)),
    ("1CP2,1CR-100,2CR0,1EA90", (-C - 100.0, -C), (-100.0, 100.0)),
    ("1CP3,1CR-100,2CR0,1EA450", (C - 100.0, C), (-100.0, 100.0)),
    ("1CP2,1CR-100,2CR0,1ER90", (C - 100.0, -C), (-100.0, -100.0)),
    ("1CP2,1CR-100,2CR0,1ER-90", (C - 100.0, -C), (-100.0, -100.0)),
    ("1CP3,1CR-100,2CR0,1ER180", (-100.0, 100.0), (-200.0, 0.0)),
    ("1CP3,1CR-100,2CR0,1EA0", (-200.0, 0.0), (0.0, 0.0)),
    ("1CP2,1CR-100,2CR0,1EA-360", (-200.0, 0.0), (0.0, 0.0)),
    ("1CP2,1CR0,2CR100,1MR0,2MR0", (0.0, 200.0), (0.0, 0.0)),
    ("1CP2,1RR1,1MR1,2MR1", (1.0 - 0.01 * C, 0.01 * C), (1.0, 1.0)),
    # One degree: 100 sin 1° and 100 (1 - cos 1°).
    ("1CP3,1CR0,2CR100,1ER1", (0.8726535, 0.0038077), (1.7452406, 0.0152305)),
]  # fmt: skip


@cases("path, middle, end", ARCS)
def test_an_arc_goes_through_its_middle_to_its_end(
    path: str, middle: tuple[float, float], end: tuple[float, float], mccl: Runner
) -> None:
    result = mccl(f"{HEAD}{path}\n1WS")
    assert result.diagnostics == []
    first = result.controller.log.moves[0]
    assert first.profile is not None
    time = first.start_time + 0.5 * first.profile.duration
    for at, expected in ((time, middle), (result.time, end)):
        controller = result.controller
        there = [
            controller.axes[axis].at(at).position - here for axis, here in zip((1, 2), START, strict=True)
        ]
        assert there == pytest.approx(expected, abs=1e-5)
