"""The picture of a path: its points, colours, limits and labels."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from motionlang.execution import run
from motionlang.result import Run
from motionlang.source import Source
from motionlang.views import path_plot
from motionlang.views.path_plot import path_figure
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


def labels(axes: Axes) -> list[tuple[str, tuple[float, float]]]:
    return [(text.get_text(), (float(text.xy[0]), float(text.xy[1]))) for text in axes.texts]  # type: ignore[attr-defined]


def test_a_path_has_its_positions_and_the_colour_of_its_speed(twice: Run) -> None:
    """The margin is 6 % of the longer side, 0.06 · 100 uu."""
    figure = path_figure(twice, (0, 1), Window(path=(0, 1)))
    axes, bar = figure.axes
    (lines,) = axes.collections
    assert isinstance(lines, LineCollection)
    segments = np.array(lines.get_segments())
    assert segments.shape == (5999, 2, 2)
    assert segments[0, 0].tolist() == pytest.approx([0.0, 0.0], abs=1e-9)
    assert segments[-1, 1].tolist() == pytest.approx([100.0, 0.0], abs=1e-6)
    assert np.array_equal(segments[1:, 0], segments[:-1, 1])
    colours = np.asarray(lines.get_colors())
    slewing = int(np.argmin(np.abs(segments[:, 0, 0] - 15.0)))  # at 100 uu/s
    np.testing.assert_allclose(colours[[0, slewing]], colormaps["turbo"]([0.0, 1.0]), atol=0.02)
    assert axes.get_xlim() == pytest.approx((-6.0, 106.0))
    assert axes.get_ylim() == pytest.approx((-6.0, 46.0))
    assert axes.get_aspect() == 1.0
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("axis 0 (uu)", "axis 1 (uu)")
    assert bar.get_ylabel() == "speed (uu/s), at most 100"
    assert bar.get_ylim() == pytest.approx((0.0, 100.0), rel=1e-4)
    assert figure.texts[0].get_text() == "a.mnt"
    assert figure.texts[1].get_text().endswith(f"  ·  0 to {twice.time:g} s")
    assert figure.get_size_inches().tolist() == pytest.approx([9.0, 7.74])


def test_each_line_is_named_at_the_middle_of_its_time(twice: Run) -> None:
    """A move is symmetrical in time, so that is the middle of its way, too."""
    axes = path_figure(twice, (0, 1), Window(path=(0, 1))).axes[0]
    assert [(name, tuple(round(each, 4) for each in at)) for name, at in labels(axes)] == [
        ("line 2", (15.0, 20.0)),
        ("line 3", (45.0, 20.0)),
        ("line 4", (80.0, 0.0)),
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
    figure = path_figure(twice, (0, 1), Window(begin, min(end + 0.001, twice.time), path=(0, 1)))
    assert [name for name, _ in labels(figure.axes[0])] == names


def test_a_line_is_named_once_and_forty_of_them_at_most(monkeypatch: pytest.MonkeyPatch, twice: Run) -> None:
    loop = "SPEED(0) = 100\nDim i\nFor i = 1 To 3\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nMOVER(1) = 5 : GO(1)\nNext\n"
    made = run(Source("a.mnt", loop))
    axes = path_figure(made, (0, 1), Window(path=(0, 1))).axes[0]
    assert [name for name, _ in labels(axes)] == ["line 4"]
    monkeypatch.setattr(path_plot, "MAX_NAMED", 2)
    axes = path_figure(twice, (0, 1), Window(path=(0, 1))).axes[0]
    assert [name for name, _ in labels(axes)] == ["line 2", "line 3"]


def test_a_path_in_space_has_three_axes_and_no_names(twice: Run) -> None:
    axes = path_figure(run(Source("a.mnt", TWICE + "MOVER(2) = 7 : GO(2)\n")), (0, 1, 2), Window()).axes[0]
    assert axes.name == "3d"
    assert axes.get_zlabel() == "axis 2 (uu)"  # type: ignore[attr-defined]
    assert labels(axes) == []


def test_axes_at_rest_are_a_point() -> None:
    """The colours go from 0 to 1 uu/s then."""
    made, controller = new_run()
    for axis in (0, 1):
        controller.move_by(axis, 1.0)
    controller.clock.advance(100.0)
    figure = path_figure(ended(made), (0, 1), Window(50.0, 60.0, path=(0, 1)))
    axes, bar = figure.axes
    assert axes.get_xlim() == pytest.approx((1.0, 1.0), abs=1e-8)
    assert bar.get_ylabel() == "speed (uu/s), at most 0"
    assert bar.get_ylim() == (0.0, 1.0)
