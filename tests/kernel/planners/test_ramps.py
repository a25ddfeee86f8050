"""Velocity ramps and their pieces, each figure by hand."""

from __future__ import annotations

from math import inf, pi
from typing import TYPE_CHECKING

import pytest

from motionlang.kernel.planners import named_ramps
from motionlang.kernel.planners.ramps import FALLING, RISING, SINE, expand, ramp_distance

if TYPE_CHECKING:
    from motionlang.kernel.planners import Recipe

REST = (0.0, 0.0, 0.0)
# A recipe that begins at 3, and its knots, its pieces and the marks of its phases.
Made = tuple[tuple[float, ...], list[tuple[float, ...]], tuple[tuple[str, int], ...]]
RECIPES: dict[str, tuple[Recipe, Made]] = {
    "nothing": ((0.0,), ((0.0,), [], ())),
    "constant velocity": (
        (8.0, 1.5, 0.0, 8.0), ((0.0, 1.5), [(3.0, 8.0, 0.0, 0.0, *REST)], (("slew", 0),)),
    ),
    "without an end": (
        (8.0, inf, 0.0, 8.0), ((0.0, inf), [(3.0, 8.0, 0.0, 0.0, *REST)], (("slew", 0),)),
    ),
    "constant acceleration of 5": (
        (0.0, 2.0, 0.0, 10.0), ((0.0, 2.0), [(3.0, 0.0, 2.5, 0.0, *REST)], (("accel", 0),)),
    ),
    "half a wave: 6 * 3 / (2 pi)": (
        (2.0, 3.0, SINE, 8.0),
        ((0.0, 3.0), [(3.0, 5.0, 0.0, 0.0, -9.0 / pi, pi / 3.0, 0.0)], (("accel", 0),)),
    ),
    "an acceleration that falls from 4": (
        (2.0, 3.0, FALLING, 8.0), ((0.0, 3.0), [(3.0, 2.0, 2.0, -2.0 / 9.0, *REST)], (("accel", 0),)),
    ),
    "a deceleration that rises to 4": (
        (8.0, 3.0, RISING, 2.0), ((0.0, 3.0), [(3.0, 8.0, 0.0, -2.0 / 9.0, *REST)], (("decel", 0),)),
    ),
    "an acceleration of 4 for half of 4 s": (
        (0.0, 4.0, 0.25, 12.0),
        (
            (0.0, 1.0, 3.0, 4.0),
            [
                (3.0, 0.0, 0.0, 2.0 / 3.0, *REST), (3.0 + 2.0 / 3.0, 2.0, 2.0, 0.0, *REST),
                (15.0 + 2.0 / 3.0, 10.0, 2.0, -2.0 / 3.0, *REST),
            ],
            (("accel", 0),),
        ),
    ),
    "an acceleration that rises to 6 and falls": (
        (0.0, 2.0, 0.5, 6.0),
        ((0.0, 1.0, 2.0), [(3.0, 0.0, 0.0, 1.0, *REST), (4.0, 3.0, 3.0, -1.0, *REST)], (("accel", 0),)),
    ),
    "a ratio above one half is one half": (
        (0.0, 2.0, 0.6, 6.0),
        ((0.0, 1.0, 2.0), [(3.0, 0.0, 0.0, 1.0, *REST), (4.0, 3.0, 3.0, -1.0, *REST)], (("accel", 0),)),
    ),
    "a move, without the ramp that takes no time": (
        (0.0, 2.0, 0.0, 10.0, 0.0, 0.0, 10.0, 1.5, 0.0, 10.0, 1.0, 0.0, 0.0),
        (
            (0.0, 2.0, 3.5, 4.5),
            [(3.0, 0.0, 2.5, 0.0, *REST), (13.0, 10.0, 0.0, 0.0, *REST), (28.0, 10.0, -5.0, 0.0, *REST)],
            (("accel", 0), ("slew", 1), ("decel", 2)),
        ),
    ),
    "a stop, and back": (
        (4.0, 1.0, 0.0, 0.0, 1.0, 0.0, -4.0, 1.0, 0.0, 0.0),
        (
            (0.0, 1.0, 2.0, 3.0),
            [(3.0, 4.0, -2.0, 0.0, *REST), (5.0, 0.0, -2.0, 0.0, *REST), (3.0, -4.0, 2.0, 0.0, *REST)],
            (("stop", 0), ("accel", 1), ("decel", 2)),
        ),
    ),
    "marks count pieces": (
        (0.0, 2.0, 0.5, 6.0, 1.0, 0.0, 6.0),
        (
            (0.0, 1.0, 2.0, 3.0),
            [(3.0, 0.0, 0.0, 1.0, *REST), (4.0, 3.0, 3.0, -1.0, *REST), (9.0, 6.0, 0.0, 0.0, *REST)],
            (("accel", 0), ("slew", 2)),
        ),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", RECIPES)
def test_the_pieces_of_a_recipe(name: str) -> None:
    recipe, (knots, pieces, marks) = RECIPES[name]
    found = expand(3.0, recipe)
    assert (found[0], found[2]) == (knots, marks)
    assert len(found[1]) == len(pieces)
    for piece, expected in zip(found[1], pieces, strict=True):
        assert piece == pytest.approx(expected, rel=1e-12, abs=0.0)


def test_a_ramp_below_the_resolution_of_its_time_has_a_constant_acceleration() -> None:
    """A thousandth of 4e-12 s is no time after 10⁴ s."""
    knots, pieces, _ = expand(0.0, (0.0, 1e4, 0.0, 10.0, 4e-12, 0.001, 12.0))
    assert knots == (0.0, 1e4, 1e4 + 4e-12)
    assert pieces[1][1:] == pytest.approx((10.0, 2.5e11, 0.0, *REST))


@pytest.mark.parametrize(
    ("ramp", "distance"),
    [
        ((2.0, 3.0, 0.0, 8.0), 15.0),
        ((2.0, 3.0, 0.25, 8.0), 15.0),
        ((2.0, 3.0, SINE, 8.0), 15.0),
        ((2.0, 3.0, FALLING, 8.0), 18.0),
        ((8.0, 3.0, RISING, 2.0), 18.0),
        ((0.0, 3.0, FALLING, 6.0), 12.0),
        ((6.0, 3.0, RISING, 0.0), 12.0),
    ],
)
def test_the_distance_of_a_ramp(ramp: tuple[float, float, float, float], distance: float) -> None:
    """A parabolic ramp has two thirds of its higher speed and a third of the lower."""
    assert ramp_distance(*ramp) == distance


def test_ramps_have_names_by_their_velocities() -> None:
    recipe = (
        0.0,
        2.0,
        0.0,
        -4.0,
        0.0,
        0.0,
        -4.0,
        3.0,
        0.0,
        -2.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        6.0,
        1.0,
        0.0,
        6.0,
    )
    assert named_ramps(recipe) == [
        ("accel", 2.0, -4.0, 0.0, -4.0),
        ("decel", 3.0, -9.0, -4.0, -2.0),
        ("stop", 1.0, -1.0, -2.0, 0.0),
        ("accel", 1.0, 3.0, 0.0, 6.0),
        ("slew", 1.0, 6.0, 6.0, 6.0),
    ]
    assert named_ramps((4.0, 1.0, 0.0, 0.0))[0][0] == "decel"
