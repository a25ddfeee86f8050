"""AN00115: calculation of the missing figures of a move."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import pytest

from motionlang.commands.plan.solve import NAMES, solve_move

SHEET: dict[str, Any] = {
    "distance": 200.0,
    "time": 1.0,
    "accel_time": 0.2,
    "slew_time": 0.6,
    "decel_time": 0.2,
    "speed": 250.0,
    "accel": 1250.0,
    "decel": 1250.0,
}


def test_the_exercise() -> None:
    assert solve_move(distance=200.0, time=1.0, accel_time=0.2, decel_time=0.2) == pytest.approx(SHEET)


def solvable(names: tuple[str, ...]) -> bool:
    try:
        solve_move(**{name: SHEET[name] for name in names})
    except ValueError as problem:
        if "not enough" in str(problem):
            return False
        raise
    return True


@pytest.mark.parametrize("count", range(1, 8))
def test_whatever_is_given_it_is_the_same_move_or_not_enough(count: int) -> None:
    for names in combinations(NAMES, count):
        if solvable(names):
            assert solve_move(**{name: SHEET[name] for name in names}) == pytest.approx(SHEET), names


def test_four_figures_are_enough_unless_three_of_them_say_the_same() -> None:
    for names in combinations(NAMES, 4):
        says_the_same = any(set(relation) <= set(names) for relation in RELATIONS)
        assert solvable(names) is not says_the_same, names


RELATIONS = (
    ("speed", "accel", "accel_time"),
    ("speed", "decel", "decel_time"),
    ("accel", "accel_time", "decel", "decel_time"),
    ("distance", "time", "slew_time", "speed"),
    ("time", "accel_time", "slew_time", "decel_time"),
)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"distance": 20.0, "time": 0.6}, "not enough is known: accel time, slew time"),
        ({"distance": 20.0, "time": 0.6, "speed": 10.0}, "contradiction: the distance does not fit"),
        (
            {"speed": 8.0, "accel": 16.0, "decel": 16.0, "distance": 12.0, "time": 3.0},
            "distance 12 .given. against 20 from",
        ),
        (
            {"speed": 8.0, "accel": 16.0, "decel": 16.0, "distance": 2.0},
            "the distance does not fit the speed",
        ),
        ({"distance": 20.0, "time": 0.1, "accel": 10.0, "decel": 10.0}, "cannot be covered in the time"),
        ({"speed": 10.0, "accel": 1.0, "accel_time": 2.0}, "not enough|contradiction"),
        ({"speed": 0.0}, "speed must be greater than zero"),
        ({"velocity": 1.0}, "no figure called velocity"),
        # Of 4 s the slew takes 2 * 300 / 100 - 4 = 2 s, and the deceleration 2 s or 2.5 s.
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "decel": 50.0},
            "contradiction: the accel time would have to be 0",
        ),
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "decel": 40.0},
            "contradiction: the accel time would have to be -0.5",
        ),
    ],
)
def test_what_cannot_be_solved(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        solve_move(**given)


def test_a_rule_leaves_no_time_after_a_ramp_of_more_than_two_thirds() -> None:
    """0.9 s up and 1/3 s down take longer than 1 s."""
    with pytest.raises(ValueError, match="the ramps alone take longer than the move"):
        solve_move("third", distance=5.0, time=1.0, accel_time=0.9)
