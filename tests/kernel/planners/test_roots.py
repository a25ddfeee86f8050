"""Roots of a monotone function in a bracket, and of a quadratic."""

from __future__ import annotations

import pytest

from motionlang.kernel.planners.pieces import _quadratic
from motionlang.kernel.planners.root import bracketed_root


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
