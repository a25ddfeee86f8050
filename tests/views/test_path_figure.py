"""The figure of a path: its points, colours, limits and labels."""

from __future__ import annotations

from dataclasses import replace

import pytest

from motionlang.commands.plot.view import run_figure
from motionlang.kernel import Run, Source, run
from motionlang.views.figure import Figure
from motionlang.views.figure_layout import TextLine, layout
from motionlang.views.window import Window
from tests.views.runs import ended, new_run

# 30 and 40 uu are a path of 50 uu: 0.1 s up to 100 uu/s, 0.4 s, and 0.1 s down, twice.
TWICE = """\
SPEED(0, 1) = 100; : ACCEL(0, 1) = 1000; : DECEL(0, 1) = 1000;
VECTORR(0, 1) = 30, 40 : GO(0) : PAUSE IDLE(0)
VECTORR(0, 1) = 30, -40 : GO(0) : PAUSE IDLE(0)
MOVER(0) = 40 : GO(0) : PAUSE IDLE(0)
"""


@pytest.fixture(scope="module")
def twice() -> Run:
    return run(Source("a.mnt", TWICE))


def path_figure(made: Run, axes: tuple[int, ...], begin: float = 0.0, end: float | None = None) -> Figure:
    return run_figure(made, {}, Window(begin, end, path=axes))


def named(made: Run, begin: float = 0.0, end: float | None = None) -> list[str]:
    return [note.text for note in path_figure(made, (0, 1), begin, end).rows[0][0].notes]


def test_a_path_has_its_positions_and_the_colour_of_its_speed(twice: Run) -> None:
    """The margin is 6 % of the longer side, 0.06 · 100 uu."""
    figure = path_figure(twice, (0, 1))
    ((panel,),) = figure.rows
    first, last = panel.curves[0], panel.curves[-1]
    assert (first.x[0], first.y[0]) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert (last.x[-1], last.y[-1]) == pytest.approx((100.0, 0.0), abs=1e-6)
    for a, b in zip(panel.curves, panel.curves[1:], strict=False):
        assert (a.x[-1], a.y[-1]) == (b.x[0], b.y[0])
    assert figure.scale is not None
    slewing = next(curve for curve in panel.curves if curve.x[0] <= 15.0 <= curve.x[-1])  # at 100 uu/s
    assert (first.colour, slewing.colour) == (figure.scale.colour(0.0), figure.scale.colour(100.0))
    assert panel.x_limits == pytest.approx((-6.0, 106.0))
    assert panel.y_limits == pytest.approx((-6.0, 46.0))
    assert panel.is_equal
    assert (figure.x_label, panel.label) == ("axis 0 (uu)", "axis 1 (uu)")
    assert figure.scale.label == "speed (uu/s), at most 100"
    assert figure.subtitle.endswith(f" · 0 to {twice.time:g} s")


def test_each_line_is_named_at_the_middle_of_its_time(twice: Run) -> None:
    """A move is symmetrical in time, so that is the middle of its way, too."""
    found = path_figure(twice, (0, 1)).rows[0][0].notes
    assert [(note.text, round(note.x, 4), round(note.y, 4)) for note in found] == [
        ("line 2", 15.0, 20.0),
        ("line 3", 45.0, 20.0),
        ("line 4", 80.0, 0.0),
    ]


@pytest.mark.parametrize(
    ("begin", "end", "names"),
    [
        (0.0, 0.9, ["line 2", "line 3"]),  # the middles of the moves are at 0.3, 0.9 and 1.45 s
        (0.31, 0.89, []),
        (0.31, 1.7, ["line 3", "line 4"]),
    ],
)
def test_a_window_names_the_lines_in_it(begin: float, end: float, names: list[str], twice: Run) -> None:
    """A statement takes some time before each move, so the window has 1 ms more."""
    assert named(twice, begin, min(end + 0.001, twice.time)) == names


def test_a_line_is_named_once_and_forty_of_them_at_most() -> None:
    loop = "SPEED(0) = 100\nDim i\nFor i = 1 To 3\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nMOVER(1) = 5 : GO(1)\nNext\n"
    assert named(run(Source("a.mnt", loop))) == ["line 4"]
    lines = "MOVER(1) = 1 : GO(1) : PAUSE IDLE(1)\n" + 41 * "MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\n"
    assert named(run(Source("a.mnt", lines))) == [f"line {k}" for k in range(2, 42)]


def test_axes_at_rest_are_a_point() -> None:
    """The colours go from 0 to 1 uu/s then."""
    made, controller = new_run()
    for axis in (0, 1):
        controller.move_by(axis, 1.0)
    controller.clock.advance(100.0)
    figure = path_figure(ended(made), (0, 1), 50.0, 60.0)
    assert figure.rows[0][0].x_limits == pytest.approx((1.0, 1.0), abs=1e-8)
    assert figure.scale is not None
    assert (figure.scale.label, figure.scale.low, figure.scale.high) == ("speed (uu/s), at most 0", 0.0, 1.0)
    scaled = replace(figure, scale=replace(figure.scale, high=70.0))
    names = [each.text for each in layout(scaled)[2] if isinstance(each, TextLine)]
    assert names[-5:-1] == ["0", "20", "40", "60"]
