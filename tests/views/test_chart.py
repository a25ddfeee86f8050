"""The chart of velocity in braille dots."""

from __future__ import annotations

import pytest

from motionlang.controller.controller import Controller
from motionlang.views.chart import dots, velocity_chart, velocity_spans
from tests.views.runs import ballscrew, pick

TRAPEZOID = """\
       250 ┤⠀⠀⠀⢀⡞⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⢳⡀
           │⠀⢀⡴⠋⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠙⢦⡀
         0 ┼⡴⠋⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠀⠙⢦
            0                1.00005 s"""


def test_a_trapezoid() -> None:
    run = ballscrew()
    chart = velocity_chart(run.controller.axes[0], run.time, width=38, height=3)
    assert "\n".join(chart) == TRAPEZOID


def test_an_axis_that_runs_both_ways_has_its_zero_between() -> None:
    run = pick()
    labels = [
        line[:12].split() for line in velocity_chart(run.controller.axes[0], run.time, width=60, height=5)
    ]
    assert labels == [["250", "┤"], ["│"], ["0", "┼"], ["│"], ["-250", "┤"], []]


def test_an_axis_that_never_moved_has_no_chart() -> None:
    assert velocity_chart(Controller(1).axes[0], 1.0, width=60, height=5) == []


def test_no_short_move_is_lost_in_a_long_run() -> None:
    controller = Controller(1)
    controller.clock.advance(1000.0)
    controller.move_by(0, 40.0)
    controller.clock.advance(3600.0)
    axis = controller.axes[0]
    highest = max(high for _, high in velocity_spans(axis, 3600.0, 60))
    assert highest == pytest.approx(controller.log.moves[0].profile.peak_speed)  # type: ignore[union-attr]


def test_spans_hold_every_velocity() -> None:
    run = pick()
    for axis in run.controller.axes.values():
        spans = velocity_spans(axis, run.time, 23)
        for k in range(2000):
            time = run.time * k / 2000
            low, high = spans[int(time / run.time * 23)]
            assert low - 1e-6 <= axis.velocity(time) <= high + 1e-6


def test_dots_join_their_neighbours() -> None:
    assert dots([(0, 0), (3, 3)], 0, 3, 1) == ["⣸"]
