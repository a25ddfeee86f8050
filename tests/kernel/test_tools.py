"""Sums are rounded only once, in every version of Python."""

from __future__ import annotations

from fractions import Fraction
from math import inf, isnan
from random import Random

import pytest

from motionlang.kernel.planners import plan
from motionlang.kernel.tools import total


@pytest.mark.parametrize("terms", [[], [0.1] * 10, [1e16, 1.0, -1e16], [0.1, 0.2, 0.3], [1e308, 1e-308, 3.0]])
def test_the_sum_is_the_float_next_to_the_exact_one(terms: list[float]) -> None:
    assert total(iter(terms)) == float(sum(map(Fraction, terms)))


def test_what_no_float_represents_is_reported() -> None:
    assert total([1e308, 1e308]) == inf
    assert total([1.0, inf]) == inf
    assert isnan(total([inf, -inf]))


def test_the_duration_of_a_move_is_the_exact_sum_of_its_ramps() -> None:
    random, before = Random(1), 0
    for _ in range(2000):
        speed, accel, decel, v0 = (random.uniform(1.0, 100.0) for _ in range(4))
        move = plan("trapezoid", 0.0, random.uniform(-100.0, 100.0), speed, accel, decel, v0)
        times = move._recipe[1::3]
        assert move.duration == float(sum(map(Fraction, times)))
        one_by_one = 0.0
        for time in times:
            one_by_one += time
        before += one_by_one != move.duration
    assert before > 100  # that rounding showed earlier
