"""Figures of PVT moves, servos, plans and sweeps: where each curve, arrow and text is."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.commands.plan.an00115_plot import plan_figure
from motionlang.commands.plan.solve import solve_move
from motionlang.kernel.planners import plan_pvt
from motionlang.lab.pvt import plot as pvt_plot
from motionlang.lab.pvt.plot import pvt_figure
from motionlang.lab.servo.plot import comparison_figure, trace_figure
from motionlang.views.figure import AXIS, BLUE, FAINT, GREEN, INK, RED, VIOLET, Curve, Figure, Panel
from motionlang.views.report import motors_table

LINES = plan_pvt((0.0, 100.0, 250.0), (), (1.0, 1.0))
"""100 counts in a second, and 150 in the next one, at constant velocities."""


def only(figure: Figure) -> Panel:
    ((panel,),) = figure.rows
    return panel


def points(curve: Curve) -> list[tuple[float, float]]:
    return [(round(x, 9), round(y, 9)) for x, y in zip(curve.x, curve.y, strict=True)]


@pytest.mark.parametrize(("count", "per_piece"), [(2, 60), (40, 50), (999, 2), (1001, 2)])
def test_a_curve_has_up_to_60_points_a_piece_and_2000_in_all(count: int, per_piece: int) -> None:
    profile: Any = SimpleNamespace(drawn=(range(count + 1), [(0.0, 1.0, 0.0, 0.0)] * count, ()))
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
    profile: Any = SimpleNamespace(drawn=((0.0, 1.0, 3.0), pieces, ()))
    times, values = pvt_plot._curve(profile, order)
    assert [times[k] for k in (0, 59, 60, 119)] == [0.0, 1000.0, 1000.0, 3000.0]
    assert [values[k] for k in (0, 59, 60, 119)] == pytest.approx(ends)


@pytest.mark.parametrize(("most", "is_marked"), [(3, True), (2, False)])
def test_given_points_are_marked_unless_there_are_very_many(
    most: int, is_marked: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The velocity is that after a point, and before the last one."""
    monkeypatch.setattr(pvt_plot, "MAX_MARKS", most)
    made = [panel for (panel,) in pvt_figure([LINES], ["a move"]).rows]
    marks = [points(curve) for panel in made for curve in panel.curves if curve.marker == "star"]
    positions = [(0.0, 0.0), (1000.0, 100.0), (2000.0, 250.0)]
    velocities = [(0.0, 100.0), (1000.0, 150.0), (2000.0, 150.0)]
    assert marks == ([positions, velocities] if is_marked else [])
    assert [(panel.title, panel.label, panel.unit) for panel in made] == [
        ("a move", "position", "counts"),
        ("", "velocity", "counts/s"),
        ("", "acceleration", "counts/s²"),
    ]


def test_moves_are_drawn_side_by_side() -> None:
    figure = pvt_figure([LINES, LINES], ["one", "two"])
    assert [panel.title for panel in figure.rows[0]] == ["one", "two"]
    assert (figure.x_label, figure.has_shared_y) == ("time (ms)", True)


def test_profiles_are_compared_in_columns() -> None:
    trace = {"velocity": np.array([0.0, 2.0]), "acceleration": np.array([3.0, 4.0])}
    columns: Any = Columns({**trace, "error": np.array([5.0, 6.0])})
    shapes = ("trapezoid", "parabolic", "sinusoidal", "scurve")
    rows: Any = [SimpleNamespace(shape=shape, trace=columns) for shape in shapes]
    figure = comparison_figure({"acceleration": rows, "time": rows})
    assert [panel.title for panel in figure.rows[0]] == ["equal peak acceleration", "equal time"]
    assert [[panel.unit for panel in row] for row in figure.rows] == [
        ["counts/s"] * 2, ["counts/s²"] * 2, ["counts"] * 2]  # fmt: skip
    for row, (begin, end) in zip(figure.rows, ((0, 2), (3, 4), (5, 6)), strict=True):
        for panel in row:
            assert [points(curve) for curve in panel.curves] == [[(0, begin), (1, end)]] * 4
            assert [curve.colour for curve in panel.curves] == [BLUE, GREEN, RED, VIOLET]
    assert len(figure.legend) == 4


class Columns(dict[str, Any]):
    """The columns of a trace of two samples."""

    time = np.array([0.0, 1.0])


def test_a_trace_has_five_panels() -> None:
    names = ("demand", "position", "velocity", "error", "output", "integral", "torque")
    trace: Any = Columns({name: np.array([0.0, float(k)]) for k, name in enumerate(names, 1)})
    figure = trace_figure(trace, "axis 3")
    made = [
        (panel.label, panel.unit, [(c.colour, c.y[-1], c.name) for c in panel.curves])
        for (panel,) in figure.rows
    ]
    assert made == [
        ("position", "counts", [(AXIS, 1.0, "demand"), (BLUE, 2.0, "motor")]),
        ("velocity", "counts/s", [(GREEN, 3.0, "")]),
        ("following error", "counts", [(RED, 4.0, "")]),
        ("output", "V", [(VIOLET, 5.0, "output"), (AXIS, 6.0, "integral")]),
        ("torque", "N m", [(INK, 7.0, "")]),
    ]
    assert (figure.title, figure.x_label) == ("axis 3", "time (s)")


def test_the_trapezoid_of_a_plan_is_drawn_with_its_times() -> None:
    """20 uu in 0.6 s by thirds: 50 uu/s, and 0.2 s for each phase."""
    figure = plan_figure(solve_move("third", distance=20.0, time=0.6))
    upper = figure.rows[0][0]
    corners = [(0.0, 0.0), (0.2, 50.0), (0.4, 50.0), (0.6, 0.0)]
    trapezoid, *sides = [curve for curve in upper.curves if not curve.marker]
    assert points(trapezoid) == corners
    assert [points(side) for side in sides] == [[(0.2, 0), (0.2, 50)], [(0.4, 0), (0.4, 50)]]
    assert [(curve.x[0], curve.x[-1]) for curve in upper.curves if curve.marker == "arrows"] == [
        pytest.approx(each) for each in ((0, 0.2), (0.2, 0.4), (0.4, 0.6), (0, 0.6))
    ]
    assert [(note.text, round(note.x, 9)) for note in upper.notes] == [
        ("Ta = 0.2 s", 0.1),
        ("Ts = 0.2 s", 0.3),
        ("Td = 0.2 s", 0.5),
        ("T = 0.6 s", 0.3),
        ("Sp = 50", 0.3),
        ("Accel = Sp / Ta", 0.124),
        ("Decel = Sp / Td", 0.476),
    ]


def test_the_rectangle_of_a_plan_has_the_triangle_moved() -> None:
    """An arrow leads from the cut triangle, 0.6 - 0.65 · 0.2 = 0.47 s, to 0.35 · 0.2 = 0.07 s."""
    panel = plan_figure(solve_move("third", distance=20.0, time=0.6)).rows[1][0]
    _, rectangle, arrow, _ = panel.curves
    assert points(rectangle) == [(0, 0), (0, 50), (0.4, 50), (0.4, 0), (0, 0)]
    assert (points(arrow)[0], points(arrow)[-1], arrow.colour) == ((0.47, 17.5), (0.07, 35.0), FAINT)
    cut, moved = [[(round(x, 9), y) for x, y in zip(a.x, a.y, strict=True)] for a in panel.areas]
    assert (cut, moved) == ([(0.4, 0), (0.4, 50), (0.6, 0)], [(0, 0), (0, 50), (0.2, 50)])
    assert [note.text for note in panel.notes] == ["Ta + Ts", "Distance = Sp (Ta + Ts) = 50 · 0.4 = 20"]


@pytest.mark.parametrize(
    ("given", "panels", "names"),
    [
        # Td is 0.3 s, so there is no rectangle.
        (
            {"distance": 20, "slew_time": 0.2, "time": 0.6, "accel_time": 0.1},
            1,
            ["Ta = 0.1 s", "Ts = 0.2 s", "Td = 0.3 s"],
        ),
        # A triangle: ramps of 0.5 s to 8 uu/s.
        ({"distance": 4, "slew_time": 0, "accel": 16, "decel": 16}, 2, ["Ta = 0.5 s", "Td = 0.5 s"]),
    ],
)
def test_a_plan_has_a_rectangle_if_its_ramps_are_equal_and_names_what_takes_time(
    given: dict[str, float], panels: int, names: list[str]
) -> None:
    figure = plan_figure(solve_move(None, **given))
    assert len(figure.rows) == panels
    texts = [note.text for note in figure.rows[0][0].notes]
    assert [text for text in texts if text.startswith(("Ta", "Ts", "Td"))] == names


def test_a_motor_that_never_settles_is_reported() -> None:
    figures = {"peak_following_error": 2.0, "rms_torque": 0.1, "peak_output": 3.0}
    rows = [
        {"axis": axis, "line": 1, "motor": {**figures, "settle_time": time}}
        for axis, time in ((0, None), (1, 0.25))
    ]
    lines = motors_table(rows, False).lines(100)
    assert ["never" in line for line in lines if line.split()[0] in ("0", "1")] == [True, False]
    assert "0.25" in lines[-1]
