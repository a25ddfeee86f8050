"""The layout of pictures, read from matplotlib's figures."""

from __future__ import annotations

import numpy as np
import pytest

from motionlang.execution import run
from motionlang.source import Source
from motionlang.views import plot, sweep_plot
from motionlang.views.report import motors_table
from motionlang.views.window import Window

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure
from matplotlib.text import Annotation

from motionlang.views.plot_panel import GAP, LETTER, MAX_NAMED, _names, mark_events, name_moves


def test_panels_fill_a_figure_from_its_head_to_its_foot() -> None:
    """A group of two panels and a group of one; heights and gaps are in inches."""
    figure, groups = plot._layout([[1.0, 2.0], [1.5]], 0.7)
    height = figure.get_figheight()
    assert height == pytest.approx(0.7 + 1.0 + plot.WITHIN + 2.0 + plot.BETWEEN + 1.5 + plot.BOTTOM)
    assert (1.0 - groups[0][0].get_position().y1) * height == pytest.approx(0.7)
    assert groups[-1][-1].get_position().y0 * height == pytest.approx(plot.BOTTOM)


@pytest.mark.parametrize(("axes", "titles"), [((0,), [""]), ((0, 1), ["axis 0", "axis 1"])])
def test_of_several_axes_each_is_named(axes: tuple[int, ...], titles: list[str]) -> None:
    made = run(Source("a.mnt", "".join(f"MOVER({axis}) = 1 : GO({axis})\n" for axis in axes)))
    figure = plot._figure(made, {}, Window())
    named = [each.get_title(loc="left") for each in figure.axes]
    assert [title for title in named if title] == [title for title in titles if title]


def test_the_legend_of_the_shades_lies_within_the_picture() -> None:
    made = run(Source("a.mnt", "MOVER(0) = 1 : GO(0)\n"))
    figure = plot._figure(made, {}, Window())
    (legend,) = figure.legends
    figure.draw_without_rendering()
    box = legend.get_window_extent()
    assert 0.5 * figure.bbox.width < box.x0 < box.x1 < figure.bbox.width
    assert 0.5 * figure.bbox.height < box.y0 < box.y1 < figure.bbox.height


def test_panels_of_a_sweep_have_one_scale(figures: list[Figure]) -> None:
    curves = {"time": {"": [(0.0, 1.0), (1.0, 2.0)]}, "peak": {"": [(0.0, 3.0), (9.0, 4.0)]}}
    sweep_plot.plot_lines("x.svg", "speed", curves, {})
    upper, lower = figures[0].axes
    assert upper.get_xlim() == lower.get_xlim()


@pytest.mark.parametrize(("count", "marker"), [(60, "o"), (61, "None")])
def test_points_of_a_sweep_are_marked_up_to_60(count: int, marker: str, figures: list[Figure]) -> None:
    points = [(float(k), 1.0) for k in range(count)]
    sweep_plot.plot_lines("x.svg", "speed", {"time": {"": points}}, {})
    (line,) = figures[0].axes[0].lines
    assert line.get_marker() == marker


@pytest.mark.parametrize(("count", "is_grid"), [(4, True), (5, False)])
def test_a_map_is_a_grid_if_a_quarter_of_it_is_known(
    count: int, is_grid: bool, figures: list[Figure]
) -> None:
    """Points on a diagonal: 4 of 16 are a quarter, 5 of 25 are less."""
    points = [(float(k), float(k), 1.0) for k in range(count)]
    sweep_plot.plot_map("x.svg", ("speed", "accel", "time"), points, {})
    drawn = figures[0].axes[0].collections[0]
    assert type(drawn).__name__ == ("QuadMesh" if is_grid else "PathCollection")


@pytest.mark.parametrize(
    ("across", "up", "is_grid"), [(2, 2, True), (1, 4, False), (4, 1, False), (2, 3, True)]
)
def test_a_map_is_a_grid_if_both_names_have_two_values(
    across: int, up: int, is_grid: bool, figures: list[Figure]
) -> None:
    points = [(float(x), float(y), 10.0 * x + y) for x in range(across) for y in range(up)]
    sweep_plot.plot_map("x.svg", ("speed", "accel", "time"), points, {"time": "s"}, best=(0.0, 0.0))
    panel, bar = figures[0].axes
    drawn = panel.collections[0]
    assert type(drawn).__name__ == ("QuadMesh" if is_grid else "PathCollection")
    rows = (
        [[10.0 * x + y for x in range(across)] for y in range(up)]
        if is_grid
        else [each[2] for each in points]
    )
    assert np.asarray(drawn.get_array()).tolist() == rows
    assert (panel.get_xlabel(), panel.get_ylabel(), bar.get_ylabel()) == ("speed", "accel", "time (s)")
    assert [np.asarray(line.get_xydata()).tolist() for line in panel.lines] == [[[0.0, 0.0]]]


def test_a_front_is_drawn_over_all_variants(figures: list[Figure]) -> None:
    points = [(1.0, 5.0), (2.0, 3.0), (2.5, 4.0)]
    sweep_plot.plot_front("x.svg", ("time", "peak"), points, points[:2], {"peak": "V"})
    (panel,) = figures[0].axes
    variants, front = panel.lines
    assert np.asarray(variants.get_xydata()).tolist() == [list(each) for each in points]
    assert np.asarray(front.get_xydata()).tolist() == [list(each) for each in points[:2]]
    assert (variants.get_linestyle(), front.get_drawstyle()) == ("None", "steps-post")
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("time", "peak (V)")


@pytest.mark.parametrize(("time", "side"), [(3.0, "left"), (7.0, "right")])
def test_an_event_is_named_towards_the_middle_of_its_run(time: float, side: str) -> None:
    panels = Figure().subplots(2, 1)
    mark_events(panels, [{"time": time, "kind": "limit"}], (0.0, 10.0), 1.0)
    (text,) = panels[0].texts
    assert (text.get_text(), text.get_ha()) == (" limit ", side)
    assert list(panels[1].texts) == []
    assert [line.get_xdata()[0] for panel in panels for line in panel.lines] == [time, time]


def test_a_motor_that_never_settles_is_reported() -> None:
    figures = {"peak_following_error": 2.0, "rms_torque": 0.1, "peak_output": 3.0}
    rows = [
        {"axis": axis, "line": 1, "motor": {**figures, "settle_time": time}}
        for axis, time in ((0, None), (1, 0.25))
    ]
    lines = motors_table(rows, False).lines(100)
    assert ["never" in line for line in lines if line.split()[0] in ("0", "1")] == [True, False]
    assert "0.25" in lines[-1]


@pytest.mark.parametrize(("count", "height"), [(1, 5.0), (2, 5.0), (3, 7.2), (4, 9.4)])
def test_the_picture_of_a_sweep_grows_with_its_panels(
    count: int, height: float, figures: list[Figure]
) -> None:
    curves = {f"time.{k}": {"": [(0.0, 1.0)]} for k in range(count)}
    sweep_plot.plot_lines("x.svg", "speed", curves, {})
    assert figures[0].get_figheight() == pytest.approx(height)


def named(rows: list[dict[str, object]], span: tuple[float, float]) -> list[tuple[str, float]]:
    """Return the labels above a panel, each with the time at its centre, ms."""
    axes = Figure().subplots()
    name_moves(axes, rows, span, 1e-3)
    return [(text.get_text(), text.xy[0]) for text in axes.texts if isinstance(text, Annotation)]


def move(line: int, start: float, duration: float) -> dict[str, object]:
    return {"line": line, "start_time": start, "duration": duration, "command": "MOVEA"}


def test_a_move_is_named_in_the_middle_of_what_is_shown_of_it() -> None:
    """Of a move from 8 to 14 s, a window from 10 to 20 s shows 10 to 14 s."""
    rows = [move(3, 8.0, 6.0), move(4, 14.0, 6.0)]
    assert [at for _, at in named(rows, (10.0, 20.0))] == pytest.approx([12_000.0, 17_000.0])
    assert named(rows, (10.0, 10.0)) == []


@pytest.mark.parametrize(("count", "shown"), [(MAX_NAMED, 1), (MAX_NAMED + 1, 0)])
def test_of_very_many_moves_none_is_named(count: int, shown: int) -> None:
    """One move takes nearly all the time; the others are too short for their names."""
    rows = [move(3, 0.0, 9.0), *(move(4, 9.0, 0.001) for _ in range(count - 1))]
    assert len(named(rows, (0.0, 10.0))) == shown


def test_a_name_has_a_gap_to_the_one_before() -> None:
    """There is room for ten names, but not for the gaps: every second move is named."""
    (*_, shortest) = _names(move(3, 0.0, 1.0))
    time = len(shortest) * LETTER + 0.5 * GAP
    rows = [move(3, k * time, time) for k in range(10)]
    assert [round(at / 1000.0 / time, 3) for _, at in named(rows, (0.0, 1.0))] == [0.5, 2.5, 4.5, 6.5, 8.5]
