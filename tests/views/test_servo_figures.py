"""The drawings of a plan and of a servo: where each line, arrow and text is."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.text import Annotation

from motionlang.planners.solve import solve_move
from motionlang.views import servo_plot
from motionlang.views.an00115_plot import draw_plan
from motionlang.views.plot_panel import INK
from motionlang.views.servo_plot import BLUE, GREEN, GREY, RED, VIOLET


def approx(points: Any) -> Any:
    return pytest.approx(points, rel=1e-6, abs=1e-6)


def curves(panel: Axes) -> list[tuple[str, list[tuple[float, float]]]]:
    """Return the colour and the points of each line of a panel."""
    return [
        (str(line.get_color()), [(float(x), float(y)) for x, y in np.asarray(line.get_xydata())])
        for line in panel.lines
    ]


def texts(panel: Axes) -> dict[str, tuple[float, float]]:
    """Return the texts of a panel, each with the point that it is at."""
    return {
        text.get_text(): tuple(map(float, text.xy if isinstance(text, Annotation) else text.get_position()))  # type: ignore[misc]
        for text in panel.texts
        if text.get_text()
    }


def arrows(panel: Axes) -> list[tuple[float, ...]]:
    """Return the arrows of a panel: from x, y to x, y."""
    return [
        (*map(float, text.xyann), *map(float, text.xy))
        for text in panel.texts
        if isinstance(text, Annotation) and text.arrow_patch is not None
    ]


def shapes(panel: Axes) -> list[tuple[str, list[list[float]]]]:
    """Return the filled shapes of a panel, each with its colour and corners."""
    return [(to_hex(each.get_facecolor()), np.asarray(each.get_xy())[:-1].tolist()) for each in panel.patches]  # type: ignore[attr-defined]


def have_one_time_scale(panels: Sequence[Axes]) -> bool:
    return all(panels[0].get_shared_x_axes().joined(panels[0], each) for each in panels[1:])


# ------------------------------------------------------------------------------------------------------ AN00115


def test_the_trapezoid_of_a_plan_is_drawn_with_its_times(figures: list[Figure]) -> None:
    """20 uu in 0.6 s by thirds: 50 uu/s, and 0.2 s for each phase.

    The times of the phases are at -0.1 of the speed, the whole time at -0.24, and the texts of the ramps at 0.25; those
    are 0.62 of a ramp from its end at rest.
    """
    draw_plan(solve_move("third", distance=20.0, time=0.6), "x.svg")
    upper, lower = figures[0].axes
    assert figures[0].get_size_inches().tolist() == [10.0, 6.4]
    assert have_one_time_scale(figures[0].axes)
    assert [(panel.get_xlabel(), panel.get_ylabel()) for panel in (upper, lower)] == [
        ("", "speed\n(uu/s)"),
        ("time (s)", "speed\n(uu/s)"),
    ]
    corners = [(0.0, 0.0), (0.2, 50.0), (0.4, 50.0), (0.6, 0.0)]
    found = curves(upper)
    assert [colour for colour, _ in found] == [BLUE, GREY, GREY]
    for (_, points), expected in zip(
        found, (corners, [(0.2, 0), (0.2, 50)], [(0.4, 0), (0.4, 50)]), strict=True
    ):
        assert np.array(points) == approx(np.array(expected))
    ((colour, filled),) = shapes(upper)
    assert colour == BLUE
    assert np.array(filled) == approx(np.array(corners))
    assert upper.patches[0].get_alpha() == 0.08
    expected_texts = {
        "Ta = 0.2 s": (0.1, -5.0),
        "Ts = 0.2 s": (0.3, -5.0),
        "Td = 0.2 s": (0.5, -5.0),
        "T = 0.6 s": (0.3, -12.0),
        "Sp = 50": (0.3, 50.0),
        "Accel = Sp / Ta": (0.124, 12.5),
        "Decel = Sp / Td": (0.476, 12.5),
    }
    made = texts(upper)
    assert list(made) == list(expected_texts)
    assert np.array(list(made.values())) == approx(np.array(list(expected_texts.values())))
    assert np.array(arrows(upper)) == approx(
        np.array([(0, -5, 0.2, -5), (0.2, -5, 0.4, -5), (0.4, -5, 0.6, -5), (0, -12, 0.6, -12)])
    )
    assert upper.get_ylim() == approx((-18.0, 59.0))


def test_the_rectangle_of_a_plan_has_the_triangle_moved(figures: list[Figure]) -> None:
    """The rectangle ends at Ta + Ts = 0.4 s.

    An arrow leads from the cut triangle to its new position. It begins at 0.6 - 0.65 · 0.2 = 0.47 s and 0.35 of the
    speed, and ends at 0.35 · 0.2 = 0.07 s and 0.7.
    """
    draw_plan(solve_move("third", distance=20.0, time=0.6), "x.svg")
    panel = figures[0].axes[1]
    (blue, trapezoid), (red, rectangle) = curves(panel)
    assert (blue, red) == (BLUE, RED)
    assert np.array(trapezoid) == approx(np.array([(0, 0), (0.2, 50), (0.4, 50), (0.6, 0)]))
    assert np.array(rectangle) == approx(np.array([(0, 0), (0, 50), (0.4, 50), (0.4, 0), (0, 0)]))
    (grey, cut), (shade, moved) = shapes(panel)
    assert (grey, shade) == (GREY, RED)
    assert [each.get_alpha() for each in panel.patches] == [0.3, 0.2]
    assert np.array(cut) == approx(np.array([(0.4, 0), (0.4, 50), (0.6, 0)]))
    assert np.array(moved) == approx(np.array([(0, 0), (0, 50), (0.2, 50)]))
    assert np.array(arrows(panel)) == approx(np.array([(0.47, 17.5, 0.07, 35.0), (0, -5, 0.4, -5)]))
    assert {name: list(at) for name, at in texts(panel).items()} == {
        "Ta + Ts": approx([0.2, -5.0]),
        "Distance = Sp (Ta + Ts) = 50 · 0.4 = 20": approx([0.2, 52.5]),
    }
    assert panel.get_ylim() == approx((-11.0, 59.0))


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
    given: dict[str, float], panels: int, names: list[str], figures: list[Figure]
) -> None:
    draw_plan(solve_move(None, **given), "x.svg")
    axes = figures[0].axes
    assert len(axes) == panels
    assert figures[0].get_figheight() == (6.4 if panels == 2 else 3.4)
    assert [name for name in texts(axes[0]) if name.startswith(("Ta", "Ts", "Td"))] == names
    assert axes[-1].get_xlabel() == "time (s)"


# -------------------------------------------------------------------------------------------------------- servo


def test_profiles_are_compared_in_columns(figures: list[Figure]) -> None:
    trace = {"velocity": [0.0, 2.0], "acceleration": [3.0, 4.0], "error": [5.0, 6.0]}
    rows: Any = [
        SimpleNamespace(shape=shape, trace=Columns(trace))
        for shape in ("trapezoid", "parabolic", "sinusoidal", "scurve")
    ]
    servo_plot.plot_comparison({"acceleration": rows, "time": rows}, "x.svg")
    grid = np.array(figures[0].axes).reshape(3, 2)
    assert [panel.get_title(loc="left") for panel in grid[0]] == ["equal peak acceleration", "equal time"]
    for column in range(2):
        for panel, name in zip(grid[:, column], trace, strict=True):
            points = [(0.0, trace[name][0]), (1.0, trace[name][1])]
            assert curves(panel) == [(colour, points) for colour in (BLUE, GREEN, RED, VIOLET)]
    assert [panel.get_ylabel() for panel in grid[:, 1]] == [
        "velocity\n(counts/s)",
        "acceleration\n(counts/s²)",
        "following error\n(counts)",
    ]
    assert [panel.get_xlabel() for panel in grid.flat] == ["", "", "", "", "time (s)", "time (s)"]
    (legend,) = figures[0].legends
    assert (len(legend.get_texts()), legend._ncols, legend.get_frame_on()) == (4, 4, False)  # type: ignore[attr-defined]
    assert figures[0].get_size_inches().tolist() == approx([11.8, 7.2])
    assert [
        have_one_time_scale(panels) for panels in (list(grid[:, 0]), list(grid[:, 1]), list(grid[0]))
    ] == [
        True,
        True,
        False,
    ]


class Columns(dict[str, Any]):
    """The columns of a trace of two samples."""

    time = np.array([0.0, 1.0])


def test_a_trace_has_five_panels(figures: list[Figure]) -> None:
    names = ("demand", "position", "velocity", "error", "output", "integral", "torque")
    trace: Any = Columns({name: np.array([0.0, float(k)]) for k, name in enumerate(names, 1)})
    servo_plot.plot_trace(trace, "axis 3", "x.svg")
    assert [[(colour, points[-1]) for colour, points in curves(panel)] for panel in figures[0].axes] == [
        [(GREY, (1.0, 1.0)), (BLUE, (1.0, 2.0))],
        [(GREEN, (1.0, 3.0))],
        [(RED, (1.0, 4.0))],
        [(VIOLET, (1.0, 5.0)), (GREY, (1.0, 6.0))],
        [(INK, (1.0, 7.0))],
    ]
    assert [panel.get_ylabel() for panel in figures[0].axes] == [
        "position\n(counts)",
        "velocity\n(counts/s)",
        "following error\n(counts)",
        "output\n(V)",
        "torque\n(N m)",
    ]
    legends = [panel.get_legend() for panel in figures[0].axes]
    assert [None if each is None else [text.get_text() for text in each.get_texts()] for each in legends] == [
        ["demand", "motor"],
        None,
        None,
        ["output", "integral"],
        None,
    ]
    assert [panel.get_xlabel() for panel in figures[0].axes] == ["", "", "", "", "time (s)"]
    (title,) = figures[0].texts
    assert (title.get_text(), title.get_position()[0]) == ("axis 3", 0.01)
    assert figures[0].get_size_inches().tolist() == [10.0, 8.4]
    assert have_one_time_scale(figures[0].axes)
