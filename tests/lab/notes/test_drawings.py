"""The drawings of the examples: where each line, arrow and text is.

The figures of chapter 12 show 2 ft at 100 ft/min (5/3 ft/s) and 3.22 ft/s². A ramp takes 5/3 / 3.22 = 0.517598 s, and
the trapezoid 2 / (5/3) = 1.2 s more.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

from tests.lab.notes.examples import printed
from tests.lab.notes.vendor.chapter12 import run_listing
from tests.lab.notes.vendor.dac_override import demonstrate

RAMP, TOTAL, SPEED, LIMIT = 0.5175983, 1.7175983, 5.0 / 3.0, 3.22
STEP, STEP_TIME = 0.048828125, 252.7336
"""A step of a DAC of 12 bits, 100 ft/min / 2048, and its time at 3.22 ft/s², µs."""


def approx(points: Any) -> Any:
    return pytest.approx(np.array(points), rel=1e-5, abs=1e-6)


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the figures that a script would have written."""
    found: list[Figure] = []
    monkeypatch.setattr(Figure, "savefig", lambda figure, path: found.append(figure))
    return found


def panels_of(number: str, drawn: list[Figure]) -> list[Axes]:
    """Draw a figure of chapter 12 and return its panels."""
    assert printed("chapter12_drawn", number, "x.svg") == ""
    assert drawn[-1].get_suptitle().startswith(f"{number}  ")
    return drawn[-1].axes


def curves(panel: Axes) -> dict[str, np.ndarray[Any, Any]]:
    """Return the points of each line of a panel by its name in the legend, or its number."""
    return {str(line.get_label()): np.asarray(line.get_xydata()) for line in panel.lines}


def texts(panel: Axes) -> dict[str, tuple[float, float]]:
    return {each.get_text(): each.get_position() for each in panel.texts if each.get_text()}


def arrows(panel: Axes) -> list[tuple[float, ...]]:
    """Return the arrows of a panel: from x, y to x, y."""
    return [(*text.xyann, *text.xy) for text in panel.texts if isinstance(text, Annotation)]


def test_figure_12_1_names_the_jumps_of_acceleration(drawn: list[Figure]) -> None:
    upper, lower = panels_of("12.1", drawn)
    assert texts(lower) == {
        "A1": approx((0.0, 1.61)),
        "A2": approx((0.5 * RAMP, 3.22)),
        "A3": approx((RAMP, 1.61)),
        "A4": approx((1.2, -1.61)),
        "A5": approx((1.2 + 0.5 * RAMP, -3.22)),
        "A6": approx((TOTAL, -1.61)),
    }
    velocity = curves(upper)["trapezoid"]
    assert velocity[[0, 500, -1]] == approx([(0.0, 0.0), (0.5 * TOTAL, SPEED), (TOTAL, 0.0)])
    acceleration = np.asarray(lower.lines[0].get_ydata())
    assert acceleration[[0, 1, -3, -1]] == approx([0.0, LIMIT, -LIMIT, 0.0])


@pytest.mark.parametrize(
    ("number", "forces"),
    [
        ("12.2", {"A": (8.2, 0.25, 9.6, 0.25)}),
        (
            "12.4",
            {
                "A": (8.2, 0.25, 9.6, 0.25),
                "F_f = 0.5 lb": (5.0, 0.75, 7.4, 0.75),
                "F_i = m A": (3.0, 2.0, 0.6, 2.0),
            },
        ),
    ],
)
def test_figures_12_2_and_12_4_have_forces_at_a_cube(
    number: str, forces: dict[str, tuple[float, ...]], drawn: list[Figure]
) -> None:
    (panel,) = panels_of(number, drawn)
    assert list(texts(panel)) == ["5 lb", "friction 0.1", *forces]
    assert arrows(panel) == list(forces.values())
    cube = [each.get_bbox().bounds for each in panel.patches if isinstance(each, Rectangle)]
    assert cube == [(0.0, 0.0, 8.0, 0.5), (3.0, 0.5, 2.0, 2.0)]


def test_figure_12_3_reaches_the_speed_at_the_limit(drawn: list[Figure]) -> None:
    (panel,) = panels_of("12.3", drawn)
    (points,) = curves(panel).values()
    assert points == approx([(0.0, 0.0), (RAMP, SPEED), (1.5 * RAMP, SPEED)])
    assert list(texts(panel)) == ["0.5176 s", "slope 3.22 ft/s²"]


def test_figure_12_5_builds_up_to_a_step_in_five_time_constants(drawn: list[Figure]) -> None:
    """A time constant is 2/3 of the time of a step.

    After 2.5 and 5 of them, 1 - e^-2.5 = 0.917915 and 1 - e^-5 = 0.993262 of the step are there.
    """
    (panel,) = panels_of("12.5", drawn)
    rise, limit, level = curves(panel).values()
    constant = STEP_TIME / 1.5
    expected = [(0.0, 0.0), (2.5 * constant, 0.917915 * STEP), (5.0 * constant, 0.993262 * STEP)]
    assert rise[[0, 200, 400]] == approx(expected)
    assert limit == approx([(0.0, 0.0), (STEP_TIME, STEP)])
    assert level[:, 1] == approx([STEP, STEP])


def test_figure_12_6_has_the_answers_to_steps_of_1_2_and_1(drawn: list[Figure]) -> None:
    """After t updates the answer to a step s from v is s - (s - v) e^(-t/T).

    With T = 1 it is 1 - e^-1 = 0.632121 after one update, and 3 - (3 - 0.632121) e^-1 = 2.128906 after two.
    """
    (panel,) = panels_of("12.6", drawn)
    found = curves(panel)
    assert found["DAC"] == approx([(0.0, 1.0), (1.0, 3.0), (2.0, 4.0), (3.0, 4.0)])
    assert found["limit"] == approx([(0.0, 0.0), (3.0, 3.0)])
    assert [name.partition(":")[0] for name in found] == ["DAC", "C", "D to G", "whole", "limit"]
    expected = [(0.0, 0.0), (0.5, 0.3934693), (1.0, 0.6321206), (1.0, 0.6321206), (2.0, 2.1289064)]
    assert found["whole: time constant 1.00 updates"][[0, 50, 100, 101, 201]] == approx(expected)


def test_figure_12_7_is_a_progression(drawn: list[Figure]) -> None:
    """2, 4, …, 20 are 110 counts, and 18, 16, …, 2 are 90: 200 in all."""
    upper, lower = panels_of("12.7", drawn)
    velocities, changes = (next(iter(curves(panel).values())) for panel in (upper, lower))
    assert velocities.tolist() == list(map(list, enumerate([*range(0, 20, 2), *range(20, -1, -2)])))
    assert changes[:, 1].tolist() == [2.0] * 10 + [-2.0] * 10
    assert {panel.lines[0].get_drawstyle() for panel in (upper, lower)} == {"steps-post"}


@pytest.mark.parametrize(
    ("number", "expected"),
    [
        # The ramps of an S-curve take twice as long; with twice the acceleration, as long as those of the trapezoid.
        ("12.8", {"S-curve": (TOTAL + RAMP, LIMIT)}),
        (
            "12.9",
            {
                "trapezoidal, A": (TOTAL, LIMIT),
                "S-curve, A": (TOTAL + RAMP, LIMIT),
                "S-curve, 2A": (TOTAL, 2.0 * LIMIT),
            },
        ),
    ],
)
def test_figures_12_8_and_12_9_compare_profiles(
    number: str, expected: dict[str, tuple[float, float]], drawn: list[Figure]
) -> None:
    upper, lower = panels_of(number, drawn)
    assert {name: points[-1, 0] for name, points in curves(upper).items()} == pytest.approx(
        {name: time for name, (time, _) in expected.items()}
    )
    peaks = [points[:, 1].max() for points in curves(lower).values()]
    assert peaks == pytest.approx([peak for _, peak in expected.values()], rel=0.01)


def test_figure_12_10_has_the_steps_of_two_dacs(drawn: list[Figure]) -> None:
    """In 1500 µs a DAC of 12 bits makes 5.9 steps and one of 16 bits 95.

    The next step is outside the picture. The limit is 3.22 · 60 · 0.0015 = 0.2898 ft/min then.
    """
    (panel,) = panels_of("12.10", drawn)
    assert {name: (len(points), points[-1]) for name, points in curves(panel).items()} == {
        "12 bits": (7, approx((6 * STEP_TIME, 6 * STEP))),
        "16 bits": (96, approx((95 * STEP_TIME / 16, 95 * STEP / 16))),
        "3.22 ft/s²": (2, approx((1500.0, 0.2898))),
    }


def test_figure_12_11_is_a_chain_of_blocks_with_feedback(drawn: list[Figure]) -> None:
    """Blocks are 1.3 apart and 1 wide; an arrow leads to each but the first.

    Both feedbacks begin below the middle of the last block and lead to the error and to the override.
    """
    (panel,) = panels_of("12.11", drawn)
    count = len(panel.patches)
    assert count == 8
    chain = [(1.3 * k - 0.3, 2.5, 1.3 * k, 2.5) for k in range(1, count)]
    assert arrows(panel) == [approx(each) for each in (*chain, (3.1, 1.0, 3.1, 2.0), (5.7, 0.2, 5.7, 2.0))]
    encoder, tachometer = curves(panel).values()
    assert encoder == approx([(9.6, 2.0), (9.6, 1.0), (3.1, 1.0)])
    assert tachometer == approx([(9.6, 2.0), (9.6, 0.2), (5.7, 0.2)])
    assert {"error", "override", "desired - actual"} <= set(texts(panel))


def test_tn1069_is_drawn_in_three_panels(drawn: list[Figure]) -> None:
    assert printed("tn1069", "x.svg")
    panels = drawn[0].axes
    assert [list(curves(panel)) for panel in panels] == [
        ["trapezoidal", "sinusoidal", "trapezoidal 0.1", "parabolic"]
    ] * 3
    ends = [[points[-1, 1] for points in curves(panel).values()] for panel in panels]
    assert ends == [approx([40_000.0] * 4), approx([0.0] * 4), approx([0.0] * 4)]
    times = [points[-1, 0] for points in curves(panels[0]).values()]
    assert times == approx([1.4, 1.6283185, 1.4444444, 1.5491933])
    peaks = [points[:, 1].max() for points in curves(panels[2]).values()]
    assert peaks == pytest.approx([100_000.0] * 4, rel=1e-4)


def test_the_listing_is_drawn_by_update(drawn: list[Figure]) -> None:
    assert printed("listing", "x.svg")
    made = run_listing()
    first, second, third = drawn[0].axes
    assert {name: points[:, 1].tolist() for name, points in curves(first).items()} == {
        "demand": list(made.demand),
        "motor": list(made.position),
    }
    assert second.lines[0].get_ydata().tolist() == list(made.velocity)  # type: ignore[union-attr]
    assert third.lines[0].get_ydata().tolist() == list(made.dac)  # type: ignore[union-attr]
    assert third.lines[0].get_drawstyle() == "steps-post"


def test_the_start_of_a_move_is_drawn_against_its_limit(drawn: list[Figure]) -> None:
    """A row for each run: 60 ms of the acceleration after each change of the DAC, and the DAC in steps of 12 bits."""
    assert printed("dac", "x.svg")
    runs = demonstrate()
    for left, right, run in zip(drawn[0].axes[::2], drawn[0].axes[1::2], runs, strict=True):
        assert left.get_ylabel().startswith(run.name)
        assert [line.get_ydata() for line in left.lines] == [[run.limit] * 2, [-run.limit] * 2]
        (bars,) = left.collections
        segments: Any = bars.get_segments()  # type: ignore[attr-defined]
        assert len(segments) == 240
        # A foot is 60 000 counts: 100 000 counts/s are 100 ft/min.
        assert np.array([segment[1][1] for segment in segments]) == approx(run.trace.onset[:240] / 60_000.0)
        steps = np.asarray(right.lines[0].get_ydata())
        assert steps == approx(run.trace.dac_steps[:240] * 2.0 ** (12 - run.bits))
