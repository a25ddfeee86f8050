"""The number of iterations that a loop with counters may skip."""

from __future__ import annotations

import pytest

from motionlang.fast.loop_counters import counted


# A counter, its step, the constant that it is compared with, and the iterations in which it does not pass it.
@pytest.mark.parametrize(
    ("counter", "step", "level", "iterations"),
    [
        (0, 1, 10, 9),
        (0, -1, -10, 9),
        (0, 4, 10, 2),
        (0, -4, -10, 2),
        (10, 1, 10, 0),  # it may have passed the constant in the last iteration
        (11, 1, 10, 0),
        (12, 1, 10, 2147483647 - 12),
    ],
)
def test_a_counter_advances_until_it_reaches_a_level(
    counter: int, step: int, level: int, iterations: int
) -> None:
    assert counted([counter], [step], [[level]]) == iterations
