"""Extremes at joins: a real jump gives an infinite derivative, rounding does not."""

from __future__ import annotations

from math import inf
from pathlib import Path

import pytest

from motionlang.execution import run
from motionlang.log.extremes import extremes
from motionlang.source import Source

GALLERY = Path(__file__).parents[2] / "scripts"


@pytest.mark.parametrize("axis", [0, 1])
def test_lines_and_arcs_that_join_have_no_infinite_acceleration(axis: int) -> None:
    """At speed 50, arcs of radius 10 need 250 of lateral acceleration, the ramps 500."""
    made = run(GALLERY / "mint" / "laser-contour.mnt")
    found = extremes(made.controller.axes[axis], made.time)
    assert found.acceleration.value == pytest.approx(500.0, rel=1e-4)
    assert found.jerk.value == inf  # a trapezoid has its acceleration at once


def test_a_cancel_has() -> None:
    made = run(Source("jump.mnt", "SPEED(0) = 50 : JOG(0) = 50\nWAIT(1000)\nCANCEL(0)\n"), cache=False)
    assert extremes(made.controller.axes[0], made.time).acceleration.value == inf
