"""Elements of a panel: positions, margins, labels and shades.

The figure is 10 inches wide and its axes fill it, so it shows 720 points; the time axis is in milliseconds.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from motionlang.views import plot_panel
from motionlang.views.lanes import Lane
from motionlang.views.panels import Curve, Panel

MS = 0.001


@pytest.fixture
def axes() -> Axes:
    return Figure(figsize=(10.0, 2.0)).add_axes((0.0, 0.0, 1.0, 1.0))


def texts(axes: Axes) -> dict[str, float]:
    """Return the annotations with their positions across."""
    return {each.get_text(): each.xy[0] for each in axes.texts}  # type: ignore[attr-defined]


def move(line: int, start: float, *durations: float, command: str = "MOVER") -> dict[str, Any]:
    names = ("accel", "slew", "decel")
    phases = [{"name": name, "duration": each} for name, each in zip(names, durations, strict=False)]
    return {
        "command": command, "line": line, "start_time": start, "duration": sum(durations), "phases": phases
    }  # fmt: skip


def test_a_point_of_the_figure_in_seconds(axes: Axes) -> None:
    """10 inches of 72 points; half of them if the axes are half as wide."""
    assert plot_panel.pixel_of(axes, (1.0, 8.2)) == pytest.approx(7.2 / 720.0)
    axes.set_position((0.0, 0.0, 0.5, 1.0))
    assert plot_panel.pixel_of(axes, (1.0, 8.2)) == pytest.approx(7.2 / 360.0)


def test_channels_are_bars_in_their_rows(axes: Axes) -> None:
    """On from 0.2 to 0.5 s, and from 0.8 s to the end at 1 s; shown from 0.3 s on."""
    lanes = [
        Lane("inputs", "start", True, [0.0, 0.2, 0.5, 0.8], [0.0, 1.0, 0.0, 1.0]),
        Lane("inputs", "stop", True, [0.0], [0.0]),
    ]
    plot_panel.draw_lanes(axes, lanes, (0.3, 1.0), MS)
    bars = next(each for each in axes.collections if isinstance(each, PolyCollection) and each.get_paths())
    boxes = [(box.x0, box.x1, box.y0, box.y1) for box in (path.get_extents() for path in bars.get_paths())]
    assert boxes == [pytest.approx((300.0, 500.0, -0.34, 0.34)), pytest.approx((800.0, 1000.0, -0.34, 0.34))]
    rules = [each for each in axes.collections if isinstance(each, LineCollection)]
    found = [np.asarray(each.get_segments()[0]).tolist() for each in rules]
    assert found == [[[300.0, 0.34], [1000.0, 0.34]], [[300.0, 1.34], [1000.0, 1.34]]]
    assert axes.get_ylim() == pytest.approx((1.6, -0.6))
    assert [label.get_text() for label in axes.get_yticklabels()] == ["start", "stop"]
    assert not axes.spines["top"].get_visible()
    assert axes.spines["left"].get_visible()


@pytest.mark.parametrize(
    ("values", "limits"),
    [
        ([0.0, 50.0, 100.0], (-8.0, 108.0)),  # 8 % of the range on either side
        ([-20.0, 30.0], (-24.0, 34.0)),
        ([50.0], (46.0, 54.0)),  # of a constant, 8 % of its size
        ([-50.0], (-54.0, -46.0)),
        ([0.0], (-0.08, 0.08)),
    ],
)
def test_an_analogue_channel_is_drawn_in_steps_with_margins(
    axes: Axes, values: list[float], limits: tuple[float, float]
) -> None:
    times = [0.25 * n for n in range(len(values))]
    plot_panel.draw_analogue(axes, Lane("outputs", "torque", False, times, values), 2.0, MS)
    (line,) = axes.get_lines()
    assert np.asarray(line.get_xdata()).tolist() == [*(1000.0 * time for time in times), 2000.0]
    assert np.asarray(line.get_ydata()).tolist() == [*values, values[-1]]
    assert line.get_drawstyle() == "steps-post"
    assert axes.get_ylim() == pytest.approx(limits)
    assert axes.get_ylabel() == "torque\n(%)"


@pytest.mark.parametrize(("size", "style"), [(999_000.0, ""), (1e6, "1e6"), (-2e6, "1e6")])
def test_a_million_counts_have_a_power_of_ten(axes: Axes, size: float, style: str) -> None:
    plot_panel.draw_analogue(axes, Lane("outputs", "torque", False, [0.0, 1.0], [0.0, size]), 2.0, MS)
    figure = axes.get_figure()
    assert figure is not None
    figure.draw_without_rendering()  # type: ignore[union-attr]
    assert axes.yaxis.get_offset_text().get_text() == style


@pytest.mark.parametrize(
    ("quantity", "first", "last", "place"),
    [
        ("position", 0.0, 10.0, 4),
        ("velocity", 10.0, -4.0, 1),
        ("velocity", 10.0, 3.3, 4),
        ("velocity", 10.0, 3.2, 1),
    ],
)
def test_curves_of_a_panel(axes: Axes, quantity: str, first: float, last: float, place: int) -> None:
    """The legend is at the lower right (4) if the curve ends above the middle, 3.25.

    If not, it is at the upper right (1).
    Of a velocity the peak of the last curve is given, and zero has a line.
    """
    times = np.array([0.0, 0.5, 1.0])
    curves = (
        Curve(times, np.array([first, 0.0, last]), "#000000", "motor"),
        Curve(times, np.array([0.0, -3.5, 2.0]), "#ff0000", "command"),
    )
    plot_panel.draw_panel(axes, Panel(quantity, "uu", curves), [], (0.0, 1.0), MS)
    motor, command, *zero = axes.get_lines()
    assert np.asarray(motor.get_xdata()).tolist() == [0.0, 500.0, 1000.0]
    assert to_hex(command.get_color()) == "#ff0000"
    assert (motor.get_linewidth(), motor.get_alpha()) == (1.6, 1.0)
    assert [np.asarray(each.get_ydata()).tolist() for each in zero] == (
        [] if quantity == "position" else [[0.0, 0.0]]
    )
    assert list(texts(axes)) == ([] if quantity == "position" else ["peak 3.5 uu"])
    legend = axes.get_legend()
    assert legend is not None
    assert legend._loc == place  # type: ignore[attr-defined]
    low, high = min(first, last, -3.5), max(first, last)
    room = 0.08 * (high - low)
    assert axes.get_ylim() == pytest.approx((low - room, high + room))


def test_phases_are_shaded_and_short_ones_are_a_point_wide(axes: Axes) -> None:
    """The phases from 1 s on take 0.1, 0.3 and 0.001 s.

    A point, 2 s over 720, is longer than the last one.
    """
    curve = Curve(np.array([0.0, 2.0]), np.array([0.0, 1.0]), "#000000")
    rows = [move(3, 1.0, 0.1, 0.3, 0.001)]
    plot_panel.draw_panel(axes, Panel("position", "uu", (curve,)), rows, (0.0, 2.0), MS)
    outlines = [(each.get_patch_transform().transform_path(each.get_path()), each) for each in axes.patches]
    shades = [(path.get_extents().x0, path.get_extents().width, each.get_zorder()) for path, each in outlines]
    assert shades == [
        pytest.approx((1000.0, 100.0, 0.5)),
        pytest.approx((1100.0, 300.0, 0.5)),
        pytest.approx((1400.0, 2000.0 / 720.0, 0.6)),
    ]
    assert len({to_hex(each.get_facecolor()) for each in axes.patches}) == 3


def test_shades_have_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three phases a move: two moves have six."""
    rows = [move(1, 0.0, 0.1, 0.1, 0.1), move(2, 1.0, 0.1, 0.1, 0.1)]
    for most, shaded in ((5, False), (6, True), (7, True)):
        monkeypatch.setattr(plot_panel, "MAX_SHADED", most)
        assert plot_panel.is_shaded(rows) is shaded
    assert not plot_panel.is_shaded([])


def test_moves_are_named_where_there_is_room(axes: Axes, monkeypatch: pytest.MonkeyPatch) -> None:
    """A letter takes a hundredth of the width of 10 s; labels are a hundredth apart.

    "MOVER · line 7" has 14 letters, 1.4 s; "MOVER 8" 0.7 s; "9" 0.1 s. The move of line 11 begins before the span.
    """
    monkeypatch.setattr(plot_panel, "LETTER", 0.01)
    monkeypatch.setattr(plot_panel, "GAP", 0.01)
    rows = [
        move(11, 8.0, 4.0, command=""),  # 2 s are visible: the middle is at 11
        move(7, 12.5, 1.5),
        move(8, 14.0, 1.3),
        move(9, 15.3, 0.6),
        move(10, 15.9, 0.1),
        move(12, 19.0, 9.0),  # up to 20: the middle is at 19.5
    ]
    plot_panel.name_moves(axes, rows, (10.0, 20.0), MS)
    expected = {
        "move · line 11": 11_000.0,
        "MOVER · line 7": 13_250.0,
        "MOVER 8": 14_650.0,
        "9": 15_600.0,
        "MOVER 12": 19_500.0,
    }
    assert texts(axes) == pytest.approx(expected)
    monkeypatch.setattr(plot_panel, "MAX_NAMED", 5)
    plot_panel.name_moves(axes, rows, (10.0, 20.0), MS)
    assert len(axes.texts) == len(expected)


def test_events_are_marked_in_all_panels_and_named_in_the_first(axes: Axes) -> None:
    other = Figure().add_axes((0.0, 0.0, 1.0, 1.0))
    rows = [{"time": 1.0, "kind": "limit"}, {"time": 1.0, "kind": "fault"}, {"time": 3.0, "kind": "fault"}]
    plot_panel.mark_events([axes, other], [*rows, rows[0]], (0.0, 4.0), MS)
    for each in (axes, other):
        assert [np.asarray(line.get_xdata()).tolist() for line in each.get_lines()] == [
            [1000.0] * 2,
            [3000.0] * 2,
        ]
    dashes = {line._unscaled_dash_pattern for line in axes.get_lines()}  # type: ignore[attr-defined]
    assert dashes == {(0, (3, 2))}
    assert [(each.get_text(), each.get_ha(), each.xy) for each in axes.texts] == [  # type: ignore[attr-defined]
        (" limit, fault ", "left", (1000.0, 0.04)),
        (" fault ", "right", (3000.0, 0.04)),
    ]
    assert not other.texts
