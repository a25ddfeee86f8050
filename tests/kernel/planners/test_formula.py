"""Pieces that are no cubics: their derivatives, and the roots of these."""

from __future__ import annotations

from math import pi

import pytest

from motionlang.kernel.planners.formula import Chain, Sum, chain, plus
from motionlang.kernel.planners.pieces import all_in, even_points, still_points
from motionlang.kernel.planners.ramps import Plain

# 2 + 3x + x², and sin(x), a half wave of 10.
SQUARE: Plain = (2.0, 3.0, 1.0, 0.0, 0.0, 0.0, 0.0)
WAVE: Plain = (0.0, 0.0, 0.0, 0.0, 10.0, 1.0, 0.0)


def test_a_square_of_a_square() -> None:
    """At 1 the motion is at 6 and its velocity is 5: 2 + 18 + 36, 15 * 5, 2 * 25 + 15 * 2, and 3 * 2 * 5 * 2."""
    assert Chain(SQUARE, SQUARE).state(1.0) == (56.0, 75.0, 80.0, 60.0)


@pytest.mark.parametrize("velocity", [2.0, -2.0, 0.0])
def test_a_curve_at_uniform_speed_is_plain(velocity: float) -> None:
    line = (1.0, velocity, 0.0, 0.0, 0.0, 0.0, 0.0)
    for outer in (SQUARE, WAVE):
        made = chain(outer, line)
        assert type(made) is tuple
        assert all_in(made, 0.25) == pytest.approx(Chain(outer, line).state(0.25))


def test_a_wave_on_a_wave_has_the_extrema_of_both() -> None:
    """sin(x) + sin(2x) is still at cos(x) = (sqrt(33) - 1)/8, and has no acceleration at cos(x) = -1/8."""
    both = plus(WAVE, (0.0, 0.0, 0.0, 0.0, 10.0, 2.0, 0.0))
    assert isinstance(both, Sum)
    assert still_points(both, 0.5 * pi) == pytest.approx([0.9359295])
    assert even_points(both, 2.0) == pytest.approx([1.6961242])
    assert all_in(both.recentred(0.5), 0.25) == pytest.approx(both.state(0.75))
    assert all_in(both.transformed(-2.0, 1.0, 5.0), 0.25)[0] == pytest.approx(
        5.0 - 2.0 * (both.state(0.25)[0] - 1.0)
    )
