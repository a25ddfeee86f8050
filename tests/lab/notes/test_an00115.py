"""AN00115: the formulas for a move's figures, and the areas in its drawings."""

from __future__ import annotations

from itertools import pairwise

import pytest

from motionlang.commands.plan import an00115
from motionlang.commands.plan.an00115_plot import plan_figure
from motionlang.commands.plan.solve import NAMES, solve_move
from motionlang.views.figure_files import svg
from tests.cases import cases

# What is given, the rule, and the formula of each other figure as the note writes it.
DERIVED: dict[str, tuple[dict[str, float], str | None, dict[str, str]]] = {
    "the first example": (
        {"distance": 12, "speed": 8, "accel": 16, "decel": 16},
        None,
        {
            "accel_time": "Sp / Accel",
            "decel_time": "Sp / Decel",
            "slew_time": "(D - Da - Dd) / Sp",
            "time": "Ta + Ts + Td",
        },
    ),
    "the third rule": (
        {"distance": 20, "time": 0.6},
        "third",
        {
            "accel_time": "T / 3",
            "slew_time": "T / 3",
            "decel_time": "T / 3",
            "speed": "D / (Ta + Ts)",
            "accel": "Sp / Ta",
            "decel": "Sp / Td",
        },
    ),
    "the third rule at a speed": (
        {"distance": 12, "speed": 8},
        "third",
        {
            "time": "3 D / (2 Sp)",
            "accel_time": "T / 3",
            "slew_time": "T / 3",
            "decel_time": "T / 3",
            "accel": "Sp / Ta",
            "decel": "Sp / Td",
        },
    ),
    "the quarter rule at a speed": (
        {"distance": 12, "speed": 8},
        "quarter",
        {
            "time": "4 D / (3 Sp)",
            "accel_time": "T / 4",
            "slew_time": "T / 2",
            "decel_time": "T / 4",
            "accel": "Sp / Ta",
            "decel": "Sp / Td",
        },
    ),
    "unequal ramps": (
        {"distance": 20, "slew_time": 0.2, "time": 0.6, "accel_time": 0.1},
        None,
        {
            "decel_time": "T - Ta - Ts",
            "speed": "2 D / (Ts + T)",
            "accel": "Sp / Ta",
            "decel": "Sp / Td",
        },
    ),
    "an equation to solve": ({"distance": 20, "time": 1, "accel": 200, "decel": 300}, None, {}),
    "a slow equation to solve": ({"distance": 20, "time": 10, "accel": 1, "decel": 1}, None, {}),
}


@cases("name", DERIVED)
def test_each_figure_has_its_formula(name: str) -> None:
    given, rule, expected = DERIVED[name]
    assert an00115.formulas(solve_move(rule, **given), given, rule) == expected


def test_a_rule_that_the_move_does_not_follow_gives_no_formula() -> None:
    """Of 2 s the first example accelerates for 0.5 s, not for a third."""
    given, _, expected = DERIVED["the first example"]
    assert an00115.formulas(solve_move(None, **given), given, "third") == expected


def test_every_formula_holds_for_a_move() -> None:
    """All eight figures of the note's first example are known.

    The formulas of the triangle are those of a move without slew.
    """
    move = solve_move(None, distance=12.0, speed=8.0, accel=16.0, decel=16.0)
    short = solve_move(None, distance=4.0, slew_time=0.0, accel=16.0, decel=16.0)
    assert an00115.formulas(move, NAMES, None) == an00115.formulas(short, NAMES, "third") == {}
    for name, _, text, value in an00115.FORMULAS:
        assert name in NAMES
        figures = short if "sqrt" in text else move
        assert value(figures) == pytest.approx(figures[name], rel=1e-12), text


def area(corners: list[tuple[float, float]]) -> float:
    """Return the area of a polygon, by a sum over its sides."""
    sides = pairwise([*corners, corners[0]])
    return abs(sum(x * v - u * y for (x, y), (u, v) in sides)) / 2


def test_the_cut_triangle_makes_a_rectangle_of_the_trapezoid() -> None:
    move = solve_move("third", distance=20.0, time=0.6)
    assert area(an00115.trapezoid(move)) == pytest.approx(20.0)
    assert area(an00115.rectangle(move)) == pytest.approx(20.0)
    assert area(an00115.cut_triangle(move)) == pytest.approx(area(an00115.moved_triangle(move)))
    shapes = [an00115.trapezoid, an00115.cut_triangle, an00115.moved_triangle, an00115.rectangle]
    assert [[(round(x, 9), round(y, 9)) for x, y in corners(move)] for corners in shapes] == [
        [(0.0, 0.0), (0.2, 50.0), (0.4, 50.0), (0.6, 0.0)],
        [(0.4, 0.0), (0.4, 50.0), (0.6, 0.0)],
        [(0.0, 0.0), (0.0, 50.0), (0.2, 50.0)],
        [(0.0, 0.0), (0.0, 50.0), (0.4, 50.0), (0.4, 0.0)],
    ]


def test_the_drawing_names_the_figures() -> None:
    text = svg(plan_figure(solve_move("third", distance=20.0, time=0.6)))
    for label in (
        "T = 0.6 s",
        "Ta = 0.2 s",
        "Ts = 0.2 s",
        "Td = 0.2 s",
        "Sp = 50",
        "Distance = Sp (Ta + Ts)",
    ):
        assert f">{label}" in text, label
