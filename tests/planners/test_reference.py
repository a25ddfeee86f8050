"""The ramp of a speed reference: its closed form, and the result of the checker."""

from __future__ import annotations

from math import sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.planners.curve import relabelled
from motionlang.planners.reference import Slope, plan_reference
from tests.planners.verify import verify

speeds = st.floats(-1000.0, 1000.0)
rates = st.floats(10.0, 1e5)
edges = st.floats(1e-3, 2.0)


def test_the_rate_is_reached_between_its_edges() -> None:
    """500 at 2000 take 0.25 s, plus half of the edges of 0.1 s and 0.2 s.

    The distances are 10/3, 20 and 260/3 units.
    """
    made = plan_reference(0.0, 0.0, 500.0, Slope(2000.0, 0.1, 0.2), Slope(1.0))
    assert made.knots[:-1] == pytest.approx((0.0, 0.1, 0.2, 0.4))
    assert [made.velocity(t) for t in (0.1, 0.2, 0.4, 9.0)] == pytest.approx([100.0, 300.0, 500.0, 500.0])
    assert made.position(0.4) == pytest.approx(110.0)
    assert made.acceleration(0.15) == pytest.approx(2000.0)


def test_a_small_change_peaks_where_both_slopes_meet() -> None:
    """A change of 50, with edges of 0.1 s and 0.3 s to 2000, does not reach 2000.

    The peak is sqrt(2 50 2000 / 0.4) = 707.1, 35.36 ms up and 106.1 ms down.
    """
    made = plan_reference(0.0, 100.0, 150.0, Slope(2000.0, 0.1, 0.3), Slope(1.0))
    peak = sqrt(2 * 50 * 2000 / 0.4)
    assert made.knots[1:3] == pytest.approx((0.1 * peak / 2000, 0.4 * peak / 2000))
    assert made.peak_acceleration == pytest.approx(peak)


def test_through_rest_it_slows_down_at_one_rate_and_speeds_up_at_the_other() -> None:
    made = plan_reference(5.0, 100.0, -300.0, Slope(600.0), Slope(200.0))
    assert made.knots[:-1] == pytest.approx((0.0, 0.5, 1.0))
    assert made.position(1.0) == pytest.approx(5.0 + 25.0 - 75.0)


@given(speeds, speeds, rates, rates, edges, edges, edges, edges)
def test_the_judge_finds_nothing(
    v0: float, v1: float, up: float, down: float, a: float, b: float, c: float, d: float
) -> None:
    made = plan_reference(0.0, v0, v1, Slope(up, a, b), Slope(down, c, d))
    ramp = relabelled(made.cut(made.knots[-2]), "scurve")
    jerk = max(up / a, up / b, down / c, down / d)
    assert verify(ramp, speed=max(abs(v0), abs(v1)), accel=up, decel=down, jerk=jerk, tolerance=1e-6) == []
    assert made.end_velocity == pytest.approx(v1, abs=1e-11)


@given(speeds, speeds, rates, edges, st.floats(0.01, 1.0) | st.floats(-1.0, -0.01))
def test_an_acceleration_fades_first(v0: float, v1: float, rate: float, edge: float, share: float) -> None:
    slope = Slope(rate, edge, edge)
    made = plan_reference(0.0, v0, v1, slope, slope, a0=share * rate)
    assert made.acceleration(0.0) == pytest.approx(share * rate, abs=1e-6 * rate)
    ramp = relabelled(made.cut(made.knots[-2]), "scurve")
    assert verify(ramp, accel=rate, decel=rate, jerk=rate / edge, tolerance=1e-6) == []
