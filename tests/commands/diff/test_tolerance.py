"""Tolerances: their units, and which figures they make equal."""

from __future__ import annotations

import pytest

from motionlang.commands.diff.tolerance import EXACT, Tolerance


@pytest.mark.parametrize(
    ("text", "kind", "size"),
    [
        ("time=2ms", "time", 0.002),
        ("time=3 us", "time", 3e-6),
        ("time=0.5s", "time", 0.5),
        (" position=0.01uu ", "position", 0.01),
        ("speed=1e1uu/s", "speed", 10.0),
        ("speed=0uu/s", "speed", 0.0),
    ],
)
def test_the_size_of_a_tolerance(text: str, kind: str, size: float) -> None:
    made = Tolerance(text)
    assert made.size(kind) == pytest.approx(size)
    assert {other: made.size(other) for other in {"time", "position", "speed"} - {kind}} == dict.fromkeys(
        {"time", "position", "speed"} - {kind}, 0.0
    )


@pytest.mark.parametrize(
    ("texts", "field", "expected", "found", "same"),
    [
        (["time=2ms"], "duration", 1.0, 1.0019, True),
        (["time=2ms"], "duration", 1.0, 0.9979, False),
        (["time=2ms"], "end", 1.0, 1.001, False),  # a position
        (["time=2ms", "position=0.1uu"], "end", -1.0, -1.09, True),
        (["speed=2%"], "peak_speed", 100.0, 98.1, True),  # 2 % of the larger one
        (["speed=2%"], "peak_speed", 98.1, 100.0, True),
        (["speed=2%"], "peak_speed", 100.0, 97.9, False),
        (["speed=2%", "speed=3uu/s"], "peak_speed", 100.0, 97.1, True),  # the wider one counts
        (["speed=2%"], "note", 100.0, 99.0, False),
        ([], "", 1e6, 1e6 + 0.5e-3, True),  # a billionth is rounding
        ([], "", 1e6, 1e6 + 2e-3, False),
        ([], "", 0.0, 0.9e-12, True),
        ([], "", 0.0, 2e-12, False),
        ([], "", 3, 3, True),
        ([], "", 3, 3.0, False),
        ([], "", "a", "b", False),
        ([], "", float("inf"), float("inf"), True),
    ],
)
def test_two_figures_are_the_same_within_a_tolerance(
    texts: list[str], field: str, expected: object, found: object, same: bool
) -> None:
    assert Tolerance(*texts).same(expected, found, field) is same
    if not texts:
        assert EXACT.same(expected, found) is same


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("time=1", "is not a tolerance"),
        ("time=1uu", "is not a tolerance"),
        ("jerk=1%", "is not a tolerance"),
        ("time", "is not a tolerance"),
        ("time=1e-e5s", "is not a number"),
        ("time=-1s", "must be 0 or more"),
        ("time=1e999s", "must be 0 or more"),
    ],
)
def test_what_is_no_tolerance(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Tolerance(text)
