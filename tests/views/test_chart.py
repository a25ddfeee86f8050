"""The chart of velocity in braille dots."""

from __future__ import annotations

import pytest

from motionlang.kernel import Axis, Controller
from motionlang.views.chart import chart, dots, velocity_chart, velocity_panel, velocity_spans
from motionlang.views.figure import Curve, Panel
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


@pytest.mark.parametrize(
    ("height", "marks"),
    [(5, ["250 ┤", "│", "0 ┼", "│", "-250 ┤"]), (6, ["250 ┤", "│", "│", "0 ┼", "│", "-250 ┤"])],
)
def test_an_axis_that_runs_both_ways_has_its_zero_between(height: int, marks: list[str]) -> None:
    """Zero is in the middle of 20 or 24 dots: dot 10 is in row 2, and dot 12 in row 3."""
    run = pick()
    chart = velocity_chart(run.controller.axes[0], run.time, width=60, height=height)
    assert [line[:12].strip() for line in chart] == [*marks, ""]


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


def moved(stop: float | None) -> Axis:
    """Return an axis that has moved 300 counts from 1 s on.

    Its speed is 100 counts/s, and its acceleration 100 counts/s².
    It ramps up until 2 s and down from 4 to 5 s; `stop` is the time of a command that stops it.
    """
    controller = Controller(1)
    for name in ("speed", "accel", "decel"):
        controller.configure(0, name, 100.0)
    controller.clock.advance(1.0)
    controller.move_by(0, 300.0)
    if stop is not None:
        controller.clock.advance(stop)
        controller.stop(0)
    controller.clock.advance(10.0)
    return controller.axes[0]


REST, UP, SLEW = (0.0, 0.0), (0.0, 100.0), (100.0, 100.0)


@pytest.mark.parametrize(
    ("end", "stop", "spans"),
    [
        (8.0, None, [REST, UP, SLEW, SLEW, UP, REST, REST, REST]),
        (8.0, None, [UP, SLEW, UP, REST]),
        (10.0, None, [UP]),
        (5.0, None, [REST, UP, SLEW, SLEW, UP]),
        (1.5, None, [REST, (0.0, 50.0)]),  # the ramp has come to 50 counts/s
        (2.0, None, [REST, UP]),
        (8.0, 1.5, [REST, (0.0, 50.0), REST, REST, REST, REST, REST, REST]),  # from 50 counts/s to 0 at 2 s
        (10.0, 1.5, [(0.0, 50.0)]),
        (1.5, 1.5, [REST, REST, (0.0, 50.0)]),
        (6.0, 1.75, [(0.0, 75.0), (0.0, 50.0), REST]),  # 75 counts/s at 1.75 s, 50 at 2 s, 0 at 2.5 s
    ],
)
def test_spans_of_a_trapezoid(end: float, stop: float | None, spans: list[tuple[float, float]]) -> None:
    """The time is divided into as many intervals as there are spans."""
    found = velocity_spans(moved(stop), end, len(spans))
    assert [each for span in found for each in span] == pytest.approx(
        [each for span in spans for each in span]
    )


def test_a_chart_has_ten_columns_at_least() -> None:
    """The times, "0" and "1.00005 s", have ten letters and one blank between them."""
    run = ballscrew()
    *rows, times = velocity_chart(run.controller.axes[0], run.time, width=0, height=3)
    assert max(len(row) for row in rows) == 12 + 10
    assert times == f"{'0':>13} 1.00005 s"


@pytest.mark.parametrize(
    ("spans", "low", "height", "drawn"),
    [
        ([(0, 0), (3, 3)], 0, 1, ["⣸"]),  # from the lowest left dot up to the highest right one
        ([(3, 3), (0, 0)], 0, 1, ["⢹"]),
        ([(0, 1), (3, 3)], 0, 1, ["⡼"]),  # from the third dot, the upper end of the span on the left
        ([(2, 3), (0, 0)], 0, 1, ["⢳"]),
        ([(0, 3), (0, 3), (0, 3)], 0, 1, ["⣿⡇"]),
        ([(-4, -4), (3, 3)], -4, 2, ["⢸", "⣸"]),
        ([(-1, 0), (-1, -1)], -4, 2, ["⡀", "⠉"]),
    ],
)
def test_dots_join_their_neighbours(
    spans: list[tuple[float, float]], low: float, height: int, drawn: list[str]
) -> None:
    """A row has four dots in height; 3 is the highest value."""
    assert dots(spans, low, 3, height) == drawn


def test_the_panel_of_a_velocity_passes_through_all_extremes() -> None:
    """The line rises in the second interval of 1 s and falls in the last one."""
    axis = moved(None)
    axis.scales = [(0.0, 2.0, 0.0)]
    panel = velocity_panel(axis, 5.0, 5)
    (curve,) = panel.curves
    assert [float(x) for x in curve.x] == [0.5, 0.5, 1.5, 1.5, 2.5, 2.5, 3.5, 3.5, 4.5, 4.5]
    assert [float(y) for y in curve.y] == pytest.approx(
        [0.0, 0.0, 0.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 0.0]
    )
    assert (panel.title, panel.unit, panel.x_limits) == ("axis 0", "uu/s", (0.0, 5.0))


def test_a_chart_draws_the_line_between_distant_points() -> None:
    """From 0 to 10 over ten characters, of two columns and of four dots each."""
    panel = Panel([Curve([2.0, 4.0], [0.0, 10.0], "#000000")], x_limits=(2.0, 4.0))
    assert chart(panel, width=22, height=2) == [
        "        10 ┤⠀⠀⠀⠀⠀⣀⣠⠴⠒⠋",
        "         0 ┼⣀⡤⠴⠚⠉⠁",
        "            2 s    4 s",
    ]
