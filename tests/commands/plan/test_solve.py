"""AN00115: calculation of the missing figures of a move."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import pytest

import motionlang

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


def figures(rule: str | None = None, **given: Any) -> dict[str, float]:
    return motionlang.plan(rule=rule, **given).figures()


def test_the_exercise() -> None:
    assert figures(distance=200.0, time=1.0, accel_time=0.2, decel_time=0.2) == pytest.approx(SHEET)


def solvable(names: tuple[str, ...]) -> bool:
    try:
        figures(**{name: SHEET[name] for name in names})
    except ValueError as problem:
        if "not enough" in str(problem):
            return False
        raise
    return True


@pytest.mark.parametrize("count", range(1, 8))
def test_whatever_is_given_it_is_the_same_move_or_not_enough(count: int) -> None:
    for names in combinations(SHEET, count):
        if solvable(names):
            assert figures(**{name: SHEET[name] for name in names}) == pytest.approx(SHEET), names


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"distance": 20.0, "time": 0.6}, "not enough is known: accel time, slew time"),
        ({"distance": 20.0, "time": 0.6, "speed": 10.0}, "contradiction: the distance does not fit"),
        (
            {"speed": 8.0, "accel": 16.0, "decel": 16.0, "distance": 12.0, "time": 3.0},
            "distance 12 .given. against 20 from",
        ),
        ({"distance": 20.0, "time": 0.1, "accel": 10.0, "decel": 10.0}, "cannot be covered in the time"),
        ({"speed": 10.0, "accel": 1.0, "accel_time": 2.0}, "not enough|contradiction"),
        ({"speed": 0.0}, "speed must be greater than zero"),
        # Of 4 s the slew takes 2 * 300 / 100 - 4 = 2 s, and the deceleration 2 s or 2.5 s.
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "decel": 50.0},
            "contradiction: distance 300 .given. against 200 from the rest",
        ),
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "decel": 40.0},
            "contradiction: the distance does not fit the speed and the time",
        ),
    ],
)
def test_what_cannot_be_solved(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        figures(**given)


def test_a_rule_leaves_no_time_after_a_ramp_of_more_than_two_thirds() -> None:
    """0.9 s up and 1/3 s down take longer than 1 s."""
    with pytest.raises(ValueError, match="the ramps alone take longer than the move"):
        figures("third", distance=5.0, time=1.0, accel_time=0.9)
