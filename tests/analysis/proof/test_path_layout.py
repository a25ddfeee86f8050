"""Each axis's share of a path's speed and rates in a proof, by hand."""

from __future__ import annotations

from math import cos, hypot, inf, pi, sin

import pytest

from motionlang.analysis.proof.path_layout import PathLayout
from motionlang.log.order import PathOrder

FREE = (inf, inf)


def arc(angle: float) -> PathOrder:
    return PathOrder(
        (0, 1), (1.0, 1.0), 0.0, 0, False, (), (0.0, 0.0), angle, (), (0, 1), None, FREE, FREE, FREE, 0.0
    )  # fmt: skip


def test_a_quarter_of_a_circle_has_the_whole_acceleration_in_each_axis() -> None:
    layout = PathLayout(arc(90.0), [10.0, 0.0])
    assert layout.length == pytest.approx(5.0 * pi)
    assert layout.rates(0.0, layout.length, 3.0, 20.0) == pytest.approx([hypot(3.0, 40.0)] * 2)


def test_a_segment_of_an_arc_has_the_slopes_of_its_ends() -> None:
    begin, end = 30.0 * pi / 180.0, 50.0 * pi / 180.0
    layout = PathLayout(arc(20.0), [10.0 * cos(begin), 10.0 * sin(begin)])
    assert layout.slopes(0.0, layout.length) == pytest.approx([sin(end), cos(begin)])
    assert layout.ends == pytest.approx([10.0 * cos(end), 10.0 * sin(end)])
