"""Copley's PVT page: the coefficients of a segment, velocities, the S-curve."""

from __future__ import annotations

import numpy as np
import pytest

from motionlang.planners import Profile
from motionlang.planners.pvt.motion import plan_pvt, pvt_segment
from motionlang.planners.pvt.velocities import average_velocities, refined_velocities, smooth_velocities
from tests.planners.verify import verify

POINTS = [0.0, 100, 150, 200, 300, 240, 0, -100, -50, 40]
T = 0.01
TIMES = [T] * 9


def largest_jump(profile: Profile) -> float:
    pairs = zip(profile.pieces, profile.pieces[1:], strict=False)
    return max(abs(2 * b[2] - 2 * a[2] - 6 * a[3] * T) for a, b in pairs)


def test_average_velocities() -> None:
    v = average_velocities(POINTS, T)
    assert v[1:-1] == pytest.approx([7500, 5000, 7500, 2000, -15000, -17000, -2500, 7000])
    assert largest_jump(plan_pvt(POINTS, v, TIMES)) == pytest.approx(3.3e6, rel=0.02)


def test_one_sweep_of_refinement() -> None:
    v = refined_velocities(POINTS, average_velocities(POINTS, T), T)
    expected = [10500, 2333.33, 9577.78, 5512.59, -18836.69, -20710.22, -1277.28, 10819.32]
    assert v[1:-1] == pytest.approx(expected, abs=0.006)
    assert largest_jump(plan_pvt(POINTS, v, TIMES)) == pytest.approx(2.31e5, rel=0.01)


def test_two_sweeps_of_refinement() -> None:
    v = average_velocities(POINTS, T)
    for _ in range(2):
        v = refined_velocities(POINTS, v, T)
    expected = [10638.52, 2530.57, 9269.40, 5347.48, -18711.15, -20489.07, -1336.25, 10834.06]
    assert v[1:-1] == pytest.approx(expected, abs=0.006)
    assert largest_jump(plan_pvt(POINTS, v, TIMES)) == pytest.approx(1.69e4, rel=0.01)


def test_exact_velocities_leave_no_jump() -> None:
    v = smooth_velocities(POINTS, TIMES)
    expected = [10618.5720, 2525.7122, 9278.5794, 5359.9704, -18718.4610, -20486.1265, -1337.0329, 10834.2582]
    assert v[1:-1] == pytest.approx(expected, abs=6e-5)
    assert largest_jump(plan_pvt(POINTS, v, TIMES)) < 1e-6


def test_unequal_times_too() -> None:
    times = [0.01, 0.02, 0.005, 0.01, 0.03, 0.01, 0.01, 0.02, 0.01]
    profile = plan_pvt(POINTS, smooth_velocities(POINTS, times, 100.0, -50.0), times)
    for i, knot in enumerate(profile.knots[1:-1]):
        before = profile.pieces[i]
        assert 2 * before[2] + 6 * before[3] * times[i] == pytest.approx(profile.acceleration(knot), rel=1e-9)
    assert (profile.start_velocity, profile.end_velocity) == (100.0, -50.0)


def test_continuous_acceleration_at_900_000() -> None:
    points = [0.0, 5000, 15000, 20000]
    assert average_velocities(points, T)[1:-1] == [750_000, 750_000]
    assert smooth_velocities(points, [T] * 3)[1:-1] == pytest.approx([900_000, 900_000])


def test_s_curve_in_four_segments() -> None:
    jerk = 1000 / (2 * 0.1**3)
    points = [x * jerk * 0.1**3 for x in (0, 1 / 6, 1, 11 / 6, 2)]
    speeds = [x * jerk * 0.1**2 for x in (0, 0.5, 1, 0.5, 0)]
    assert points == pytest.approx([0, 83.3333333, 500, 916.6666667, 1000])
    profile = plan_pvt(points, speeds, [0.1] * 4)
    assert [abs(6 * piece[3]) for piece in profile.pieces] == pytest.approx([500_000] * 4)
    assert verify(profile, speed=5000.0, jerk=500_000.0, end=1000.0) == []


def test_coefficients_of_one_segment() -> None:
    p0, v0, p1, v1, time = 3.0, -2.0, 10.0, 5.0, 0.7
    b2 = 3 * (p1 - p0) / time**2 - (2 * v0 + v1) / time
    b3 = (v1 + v0) / time**2 + 2 * (p0 - p1) / time**3
    assert pvt_segment(p0, v0, p1, v1, time).pieces[0][:4] == pytest.approx((p0, v0, b2, b3))


def test_without_velocities_the_segments_are_straight() -> None:
    profile = plan_pvt([0.0, 10.0, 0.0], [], [1.0, 2.0])
    assert [profile.position(t) for t in np.arange(0, 3.5, 0.5)] == [0, 5, 10, 7.5, 5, 2.5, 0]
    assert [phase.name for phase in profile.phases] == ["segment", "segment"]


def test_a_time_of_zero_is_refused() -> None:
    with pytest.raises(ValueError, match="segment time must be greater than zero"):
        pvt_segment(0.0, 0.0, 1.0, 0.0, 0.0)
    with pytest.raises(ValueError, match="one velocity per point"):
        plan_pvt([0.0, 1.0], [0.0], [1.0])
