"""Roots of a monotone function in a bracket, and of a quadratic."""

from __future__ import annotations

import random

import pytest

from motionlang.planners.pieces import _quadratic, position_in, velocity_in
from motionlang.planners.root import bracketed_root, cubic_root


@pytest.mark.parametrize("power", [1, 3, 9, 25])
@pytest.mark.parametrize("rising", [True, False])
def test_a_root_that_is_flat_takes_no_more_than_bisection(power: int, rising: bool) -> None:
    """Newton's steps to a root of order n shrink by 1 - 1/n: 300 steps for n = 9."""
    calls: list[float] = []
    sign = 1.0 if rising else -1.0

    def f(x: float) -> tuple[float, float]:
        calls.append(x)
        return sign * (x - 0.3) ** power, sign * power * (x - 0.3) ** (power - 1)

    assert bracketed_root(f, 0.0, 1.0, rising) == pytest.approx(0.3, rel=1e-13)
    assert len(calls) <= 2 * 53


@pytest.mark.parametrize(
    ("small", "large"), [(1e-8, 1e8), (-1e-8, 1e8), (1e-8, -1e8), (-1e-9, -1e7), (2.0, 3.0)]
)
def test_a_small_root_next_to_a_large_one_keeps_its_digits(small: float, large: float) -> None:
    """The roots of a (x - small) (x - large), with each coefficient rounded once."""
    for a in (1.0, -0.5):
        found = sorted(_quadratic(a, -a * (small + large), a * small * large))
        assert found == pytest.approx(sorted((small, large)), rel=1e-14)


def test_the_root_of_a_cubic_has_the_same_bits_as_the_search_for_it() -> None:
    """The cubics are ramps with and without jerk, some of them from rest."""
    numbers = random.Random(7)
    for case in range(2000):
        c0, c1 = numbers.uniform(-1e3, 1e3), numbers.choice((0.0, numbers.uniform(0.0, 50.0)))
        c2, c3 = numbers.uniform(0.0, 40.0), numbers.choice((0.0, numbers.uniform(0.0, 9.0)))
        sign = numbers.choice((-1.0, 1.0))
        piece = (c0, sign * c1, sign * c2, sign * c3, 0.0, 0.0, 0.0)
        low, high = sorted((numbers.choice((0.0, numbers.uniform(0.0, 2.0))), numbers.uniform(0.0, 3.0)))
        wanted = position_in(piece, numbers.uniform(low, high) if case % 9 else low)

        def search(x: float, piece: tuple[float, ...] = piece, wanted: float = wanted) -> tuple[float, float]:
            return position_in(piece, x) - wanted, velocity_in(piece, x)  # type: ignore[arg-type]

        rising = sign > 0.0
        assert cubic_root(piece[:4], wanted, low, high, rising) == bracketed_root(search, low, high, rising)
