"""The drawing of PVT moves: curves, given points, and labels."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure

from motionlang.planners.pvt.motion import plan_pvt
from motionlang.views import pvt_plot

LINES = plan_pvt((0.0, 100.0, 250.0), (), (1.0, 1.0))
"""100 counts in a second, and 150 in the next one, at constant velocities."""


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the pictures that a test draws; no image is written."""
    found: list[Figure] = []
    monkeypatch.setattr(pvt_plot, "_save", lambda picture, file, kind: found.append(picture))
    return found


@pytest.mark.parametrize(("count", "per_piece"), [(2, 60), (40, 50), (999, 2), (1001, 2)])
def test_a_curve_has_up_to_60_points_a_piece_and_2000_in_all(count: int, per_piece: int) -> None:
    profile: Any = SimpleNamespace(pieces=[(0.0, 1.0, 0.0, 0.0)] * count, knots=range(count + 1))
    assert [len(each) for each in pvt_plot._curve(profile, 0)] == [count * per_piece] * 2


@pytest.mark.parametrize(
    ("order", "ends"),
    [
        (0, [7.0, 13.0, 0.0, 6.0]),  # 7 + x + 2 x² + 3 x³ over 1 s, and 3 x over 2 s
        (1, [1.0, 14.0, 3.0, 3.0]),  # 1 + 4 x + 9 x², and 3
        (2, [4.0, 22.0, 0.0, 0.0]),  # 4 + 18 x, and 0
    ],
)
def test_a_curve_has_both_ends_of_each_piece(order: int, ends: list[float]) -> None:
    """Times are in ms, from the beginning of the move."""
    pieces = [(7.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0), (0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0)]
    profile: Any = SimpleNamespace(pieces=pieces, knots=(0.0, 1.0, 3.0))
    times, values = pvt_plot._curve(profile, order)
    assert [times[k] for k in (0, 59, 60, 119)] == [0.0, 1000.0, 1000.0, 3000.0]
    assert [values[k] for k in (0, 59, 60, 119)] == pytest.approx(ends)


@pytest.mark.parametrize(("most", "is_marked"), [(3, True), (2, False)])
def test_given_points_are_marked_unless_there_are_very_many(
    most: int, is_marked: bool, drawn: list[Figure], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The velocity is that after a point, and before the last one."""
    monkeypatch.setattr(pvt_plot, "MAX_MARKS", most)
    pvt_plot.write_pvt_plot([LINES], ["a move"], str(tmp_path / "x.svg"))
    panels = drawn[0].axes
    marks = [[line for line in panel.lines if line.get_marker() == "*"] for panel in panels]
    assert [len(each) for each in marks] == ([1, 1, 0] if is_marked else [0, 0, 0])
    assert not any(line.get_clip_on() for each in marks for line in each)
    points = [np.asarray(line.get_xydata()).tolist() for each in marks for line in each]
    if is_marked:
        assert points == [
            [[0.0, 0.0], [1000.0, 100.0], [2000.0, 250.0]],
            [[0.0, 100.0], [1000.0, 150.0], [2000.0, 150.0]],
        ]
    assert [panel.get_ylabel() for panel in panels] == [
        "Position (counts)",
        "Velocity (counts/s)",
        "Acceleration (counts/s²)",
    ]
    assert [panel.get_xlabel() for panel in panels] == ["", "", "Time (ms)"]
    assert [panel.get_title() for panel in panels] == ["a move", "", ""]
    assert panels[0].margins() == (0.02, 0.05)
    assert drawn[0].get_size_inches().tolist() == [8.0, 7.5]


def test_moves_are_drawn_side_by_side(drawn: list[Figure], tmp_path: Path) -> None:
    """Each has a column, and only the first has the labels of the quantities."""
    pvt_plot.write_pvt_plot([LINES, LINES], ["one", "two"], str(tmp_path / "x.svg"))
    grid = np.array(drawn[0].axes).reshape(3, 2)
    assert [panel.get_title() for panel in grid[0]] == ["one", "two"]
    assert [bool(panel.get_ylabel()) for panel in grid.flat] == [True, False] * 3
    assert [panel.get_xlabel() for panel in grid[2]] == ["Time (ms)"] * 2
    assert drawn[0].get_size_inches().tolist() == [8.4, 7.5]
