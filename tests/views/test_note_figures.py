"""The drawings of the notes and of a servo: where each line, arrow and text is.

The figures of chapter 12 show 2 ft at 100 ft/min (5/3 ft/s) and 3.22 ft/s². A ramp takes 5/3 / 3.22 = 0.517598 s, and
the trapezoid 2 / (5/3) = 1.2 s more.
"""

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
from motionlang.views.chapter12_plot import draw_figure
from motionlang.views.plot_panel import INK
from motionlang.views.servo_plot import BLUE, GREEN, GREY, RED, VIOLET

RAMP, TOTAL, SPEED, LIMIT = 0.5175983, 1.7175983, 5.0 / 3.0, 3.22
STEP, STEP_TIME = 0.048828125, 252.7336
"""A step of a DAC of 12 bits, 100 ft/min / 2048, and its time at 3.22 ft/s², µs."""


def approx(points: Any) -> Any:
    return pytest.approx(points, rel=1e-6, abs=1e-6)


def curves(panel: Axes) -> list[tuple[str, list[tuple[float, float]]]]:
    """Return the colour and the points of each line of a panel."""
    return [
        (str(line.get_color()), [(float(x), float(y)) for x, y in np.asarray(line.get_xydata())])
        for line in panel.lines
    ]


def ends(panel: Axes) -> list[tuple[str, int, tuple[float, float], tuple[float, float]]]:
    """Return colour, number of points, first and last point of each line."""
    return [(colour, len(points), points[0], points[-1]) for colour, points in curves(panel)]


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


# --------------------------------------------------------------------------------------------------- chapter 12


def panels_of(number: str, figures: list[Figure]) -> list[Axes]:
    """Draw a figure of chapter 12 and return its panels."""
    draw_figure(number, "x.svg")
    (figure,) = figures
    assert figure.get_size_inches().tolist() == [10.0, 5.6]
    assert have_one_time_scale(figure.axes)
    (title,) = figure.texts
    assert (title.get_text().split("  ")[0], title.get_position()[0], title.get_fontsize()) == (
        number,
        0.01,
        12,
    )
    return figure.axes


def test_figure_12_1_names_the_steps_of_acceleration(figures: list[Figure]) -> None:
    """Each is at the middle of its jump, or of its ramp."""
    upper, lower = panels_of("12.1", figures)
    assert (upper.get_ylabel(), lower.get_ylabel()) == ("velocity\n(ft/s)", "acceleration\n(ft/s²)")
    assert lower.get_xlabel() == "time (s)"
    found = texts(lower)
    expected = {
        "A1": (0.0, 1.61),
        "A2": (0.5 * RAMP, 3.22),
        "A3": (RAMP, 1.61),
        "A4": (1.2, -1.61),
        "A5": (1.2 + 0.5 * RAMP, -3.22),
        "A6": (TOTAL, -1.61),
    }
    assert list(found) == list(expected)
    assert np.array(list(found.values())) == approx(np.array(list(expected.values())))
    ((colour, count, first, last),) = ends(upper)
    assert (colour, count) == (BLUE, 1001)
    assert first == approx((0.0, 0.0))
    assert last == approx((TOTAL, 0.0))
    assert lower.margins() == (0.05, 0.2)


def test_figures_12_2_and_12_4_have_forces_at_a_cube(figures: list[Figure]) -> None:
    """The text of an arrow is above its middle."""
    expected = {
        "12.2": ({"A = ?": (8.75, 0.4)}, [(8.2, 0.25, 9.3, 0.25)]),
        "12.4": (
            {"F_f = 0.5 lb": (6.2, 0.9), "F_i = m A": (1.8, 2.15), "A": (8.75, 0.4)},
            [(5.0, 0.75, 7.4, 0.75), (3.0, 2.0, 0.6, 2.0), (8.2, 0.25, 9.3, 0.25)],
        ),
    }
    for number, (names, forces) in expected.items():
        (panel,) = panels_of(number, figures)
        figures.clear()
        assert {name: list(at) for name, at in texts(panel).items()} == {
            "5 lb": [4.0, 1.5],
            "friction 0.1": [4.0, 0.22],
            **{name: approx(list(at)) for name, at in names.items()},
        }
        assert arrows(panel) == forces
        cube: list[Any] = list(panel.patches)
        assert [(each.get_x(), each.get_y(), each.get_width(), each.get_height()) for each in cube] == [
            (0.0, 0.0, 8.0, 0.5),
            (3.0, 0.5, 2.0, 2.0),
        ]
        assert (panel.get_xlim(), panel.get_ylim(), panel.get_aspect()) == ((-1.5, 9.5), (-1.0, 4.0), 1.0)


def test_figure_12_3_reaches_the_speed_at_the_limit(figures: list[Figure]) -> None:
    (panel,) = panels_of("12.3", figures)
    ((colour, points),) = curves(panel)
    assert colour == BLUE
    assert np.array(points) == approx(np.array([(0.0, 0.0), (RAMP, SPEED), (1.5 * RAMP, SPEED)]))
    assert {name: list(at) for name, at in texts(panel).items()} == {
        "0.5176 s": approx([RAMP, SPEED]),
        "slope 3.22 ft/s²": approx([0.5 * RAMP, 0.5 * SPEED]),
    }
    assert panel.margins() == (0.05, 0.15)


def test_figure_12_5_builds_up_to_a_step_in_five_time_constants(figures: list[Figure]) -> None:
    """A time constant is 2/3 of the time of a step.

    After 2.5 and 5 of them, 1 - e^-2.5 = 0.917915 and 1 - e^-5 = 0.993262 of the step are there.
    """
    (panel,) = panels_of("12.5", figures)
    (_, answer), (ink, limit), (grey, level) = curves(panel)
    constant = STEP_TIME / 1.5
    assert len(answer) == 401
    assert np.array([answer[0], answer[200], answer[400]]) == pytest.approx(
        np.array([(0.0, 0.0), (2.5 * constant, 0.917915 * STEP), (5.0 * constant, 0.993262 * STEP)]), rel=1e-5
    )
    assert (ink, grey) == (INK, GREY)
    assert np.array(limit) == pytest.approx(np.array([(0.0, 0.0), (STEP_TIME, STEP)]), rel=1e-6)
    assert [y for _, y in level] == [STEP, STEP]
    assert {name: list(at) for name, at in texts(panel).items()} == {
        "3.22 ft/s²": pytest.approx([0.5 * STEP_TIME, 0.5 * STEP], rel=1e-6)
    }


def test_figure_12_6_has_the_answers_to_steps_of_1_2_and_1(figures: list[Figure]) -> None:
    """After t updates the answer to a step s from v is s - (s - v) e^(-t/T).

    With T = 1 it is 1 - e^-1 = 0.632121 after one update, and 3 - (3 - 0.632121) e^-1 = 2.128906 after two.
    """
    (panel,) = panels_of("12.6", figures)
    (grey, dac), *answers, (ink, limit) = curves(panel)
    assert dac == [(0.0, 1.0), (1.0, 3.0), (2.0, 4.0), (3.0, 4.0)]
    assert limit == [(0.0, 0.0), (3.0, 3.0)]
    assert (grey, *(colour for colour, _ in answers), ink) == (GREY, RED, BLUE, GREEN, INK)
    slow = dict(answers)[GREEN]
    assert len(slow) == 3 * 101
    assert np.array([slow[0], slow[50], slow[100], slow[101], slow[201]]) == approx(
        np.array([(0.0, 0.0), (0.5, 0.3934693), (1.0, 0.6321206), (1.0, 0.6321206), (2.0, 2.1289064)])
    )
    legend = panel.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == [
        "DAC",
        "C: time constant 0.20 updates",
        "D to G: time constant 0.67 updates",
        "whole: time constant 1.00 updates",
        "limit",
    ]


def test_figure_12_7_is_a_progression(figures: list[Figure]) -> None:
    """2, 4, …, 20 are 110 counts, and 18, 16, …, 2 are 90: 200 in all."""
    upper, lower = panels_of("12.7", figures)
    ((blue, velocities),), ((red, changes),) = curves(upper), curves(lower)
    assert (blue, red) == (BLUE, RED)
    assert [y for _, y in velocities] == [*range(0, 20, 2), *range(20, -1, -2)]
    assert [y for _, y in changes] == [2.0] * 10 + [-2.0] * 10
    assert [x for x, _ in velocities] == list(range(21))
    assert (upper.lines[0].get_drawstyle(), lower.lines[0].get_drawstyle()) == ("steps-post", "steps-post")


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        # The ramps of an S-curve take twice as long; with twice the acceleration, as long as those of the trapezoid.
        ("12.8", [(GREEN, TOTAL + RAMP)]),
        ("12.9", [(BLUE, TOTAL), (GREEN, TOTAL + RAMP), (RED, TOTAL)]),
    ],
)
def test_figures_12_8_and_12_9_compare_profiles(
    number: str, expected: list[tuple[str, float]], figures: list[Figure]
) -> None:
    upper, lower = panels_of(number, figures)
    assert [(colour, count, last[0]) for colour, count, _, last in ends(upper)] == [
        (colour, 1001, approx(time)) for colour, time in expected
    ]
    assert [(colour, count) for colour, count, _, _ in ends(lower)] == [
        (colour, 1003) for colour, _ in expected
    ]
    peaks = [max(y for _, y in points) for _, points in curves(lower)]
    assert peaks == pytest.approx(
        [LIMIT * (2.0 if colour == RED else 1.0) for colour, _ in expected], rel=0.01
    )
    legend = upper.get_legend()
    assert ([] if legend is None else [text.get_text() for text in legend.get_texts()]) == (
        ["trapezoidal, A", "S-curve, A", "S-curve, 2A"] if len(expected) > 1 else []
    )


def test_figure_12_10_has_the_steps_of_two_dacs(figures: list[Figure]) -> None:
    """In 1500 µs a DAC of 12 bits makes 5.9 steps and one of 16 bits 95.

    The next step is outside the picture. The limit is 3.22 · 60 · 0.0015 = 0.2898 ft/min then.
    """
    (panel,) = panels_of("12.10", figures)
    found = ends(panel)
    assert [(colour, count) for colour, count, _, _ in found] == [(RED, 7), (BLUE, 96), (INK, 2)]
    assert [first for _, _, first, _ in found] == [(0.0, 0.0)] * 3
    assert np.array([last for _, _, _, last in found]) == pytest.approx(
        np.array([(6 * STEP_TIME, 6 * STEP), (95 * STEP_TIME / 16, 95 * STEP / 16), (1500.0, 0.2898)]),
        rel=1e-6,
    )
    assert panel.get_xlim() == (0.0, 1500.0)


def test_figure_12_11_is_a_chain_of_blocks_with_feedback(figures: list[Figure]) -> None:
    """Blocks are 1.3 apart and 1 wide; an arrow leads to each but the first.

    Both feedbacks begin below the middle of the last block and lead to that of block 2 or 4.
    """
    (panel,) = panels_of("12.11", figures)
    count = len(panel.patches)
    assert count == 8
    assert [(each.get_x(), each.get_y(), each.get_width()) for each in panel.patches] == [  # type: ignore[attr-defined]
        approx((1.3 * k, 2.0, 1.0)) for k in range(count)
    ]
    last = 1.3 * 7 + 0.5
    assert np.array(arrows(panel)) == approx(
        np.array(
            [
                *((1.3 * k - 0.28, 2.5, 1.3 * k - 0.02, 2.5) for k in range(1, count)),
                (3.1, 1.0, 3.1, 1.96),
                (5.7, 0.2, 5.7, 1.96),
            ]
        )
    )
    (green, position), (violet, velocity) = curves(panel)
    assert (green, violet) == (GREEN, VIOLET)
    assert np.array(position) == approx(np.array([(last, 1.96), (last, 1.0), (3.1, 1.0)]))
    assert np.array(velocity) == approx(np.array([(last, 1.96), (last, 0.2), (5.7, 0.2)]))
    found = texts(panel)
    assert list(found["encoder: actual position"]) == approx([last - 0.2, 1.0])
    assert list(found["tachometer and A/D: actual velocity"]) == approx([last - 0.2, 0.2])
    heights = [at[1] for text, at in found.items() if not text.startswith(("encoder: a", "tachometer and"))]
    assert heights == [2.62, 2.28] * count
    across = [at[0] for at in found.values()]
    assert across[: 2 * count] == approx([1.3 * k + 0.5 for k in range(count) for _ in range(2)])
    assert (panel.get_xlim(), panel.get_ylim()) == ((-0.2, 10.4), (-0.2, 3.6))


# -------------------------------------------------------------------------------------------------------- servo


def test_a_listing_is_drawn_by_update(figures: list[Figure]) -> None:
    made: Any = SimpleNamespace(
        demand=[0, 2, 6], position=[0.0, 1.5, 5.0], velocity=[0.0, 1.5, 3.5], dac=[0, 9, 4]
    )
    servo_plot.plot_listing(made, "x.svg")
    first, second, third = figures[0].axes
    assert curves(first) == [
        (GREY, [(0.0, 0.0), (1.0, 2.0), (2.0, 6.0)]),
        (BLUE, [(0.0, 0.0), (1.0, 1.5), (2.0, 5.0)]),
    ]
    assert curves(second) == [(GREEN, [(0.0, 0.0), (1.0, 1.5), (2.0, 3.5)])]
    assert curves(third) == [(VIOLET, [(0.0, 0.0), (1.0, 9.0), (2.0, 4.0)])]
    assert third.lines[0].get_drawstyle() == "steps-post"
    assert [panel.get_ylabel() for panel in figures[0].axes] == [
        "position\n(counts)",
        "velocity\n(counts/update)",
        "DAC\n(steps)",
    ]
    assert third.get_xlabel() == "update"
    legend = first.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["demand", "motor"]
    assert figures[0].get_size_inches().tolist() == [10.0, 5.4]
    assert have_one_time_scale(figures[0].axes)


def test_the_start_of_a_move_is_drawn_against_its_limit(figures: list[Figure]) -> None:
    """60 ms are shown. The greatest change, -24 later on, is 3 ft/s²: 8 to one.

    A volt is 20 steps of 0.05 V: with 16 bits, 16 of them are a step of 12 bits.
    """
    trace = SimpleNamespace(
        time=np.array([0.0, 0.02, 0.04, 0.06, 0.08]),
        onset=np.array([0.0, 6.0, -12.0, 4.0, -24.0]),
        output=np.array([0.0, 0.1, 0.8, 1.0, 1.0]),
        loop=SimpleNamespace(dac_step=0.05),
    )
    runs: Any = [SimpleNamespace(name=f"{bits} bits", bits=bits, onset=3.0, trace=trace) for bits in (12, 16)]
    servo_plot.plot_override(runs, 3.22, "ft", "x.svg")
    (left, right), (_, fine) = figures[0].axes[:2], figures[0].axes[2:]
    (bars,) = left.collections
    assert [each.tolist() for each in bars.get_segments()] == [  # type: ignore[attr-defined]
        [[0.0, 0.0], [0.0, 0.0]],
        [[20.0, 0.0], [20.0, 0.75]],
        [[40.0, 0.0], [40.0, -1.5]],
    ]
    assert [line.get_ydata() for line in left.lines] == [[3.22, 3.22], [-3.22, -3.22]]
    assert curves(right) == [(VIOLET, [(0.0, 0.0), (20.0, approx(2.0)), (40.0, approx(16.0))])]
    assert curves(fine) == [(VIOLET, [(0.0, 0.0), (20.0, approx(0.125)), (40.0, approx(1.0))])]
    assert left.get_ylabel() == "12 bits\nacceleration\n(ft/s²)"
    assert right.get_ylabel() == "DAC\n(12-bit steps)"
    assert [panel.get_xlabel() for panel in figures[0].axes] == [
        "",
        "",
        "time (ms); dashed: beyond this the load slips",
        "time (ms)",
    ]
    assert figures[0].get_size_inches().tolist() == approx([10.0, 4.6])
    assert have_one_time_scale(figures[0].axes)
    servo_plot.plot_override(runs[:1], 3.22, "ft", "x.svg")
    assert figures[1].get_size_inches().tolist() == approx([10.0, 2.7])
    assert left.get_subplotspec().get_gridspec().get_width_ratios() == (1.6, 1.0)  # type: ignore[union-attr]


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
