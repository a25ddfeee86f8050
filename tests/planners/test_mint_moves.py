"""Worked examples of AN00115 (trapezoid), AN00118 (S-ramp), and chapter 12.

The last is the two-ramp S-curve.
"""

from __future__ import annotations

import pytest

from motionlang.planners import Profile, plan_jerk, plan_ratio, plan_trapezoid


def figures(profile: Profile) -> list[float]:
    return [value for phase in profile.phases for value in (phase.duration, phase.distance)]


@pytest.mark.parametrize(
    ("distance", "speed", "accel", "expected"),
    [
        (12, 8, 16, (0.5, 2, 1, 8, 0.5, 2)),
        (20, 50, 250, (0.2, 5, 0.2, 10, 0.2, 5)),
        (20, 400 / 9, 8000 / 27, (0.15, 10 / 3, 0.3, 40 / 3, 0.15, 10 / 3)),
        (200, 250, 1250, (0.2, 25, 0.6, 150, 0.2, 25)),
    ],
)
def test_an00115(distance: float, speed: float, accel: float, expected: tuple[float, ...]) -> None:
    move = plan_trapezoid(0.0, distance, speed, accel, accel)
    assert figures(move) == pytest.approx(expected, rel=1e-12)
    assert move.peak_speed == pytest.approx(speed, rel=1e-12)


@pytest.mark.parametrize(
    ("speed", "distance", "ramp_time", "ramp_distance", "acceleration", "peak", "total"),
    [
        (100, 100, 0.3, 15, 500, 100, 1.3),
        (40, 100, 0.1788854382, 3.577708764, 447.2135955, 40, 2.6788854382),
        (100, 10, 0.2, 5, 500, 50, 0.4),
        (100, 1.25, 0.1, 0.625, 250, 12.5, 0.2),
    ],
)
def test_s_ramp(
    speed: float,
    distance: float,
    ramp_time: float,
    ramp_distance: float,
    acceleration: float,
    peak: float,
    total: float,
) -> None:
    move = plan_jerk(0.0, distance, speed, 500.0, 500.0, 5000.0, 5000.0)
    ramp = move.phases[0]
    found = (ramp.duration, ramp.distance, move.peak_acceleration, move.peak_speed, move.duration)
    assert found == pytest.approx((ramp_time, ramp_distance, acceleration, peak, total), rel=1e-9)


@pytest.mark.parametrize(
    ("time", "position", "velocity"),
    [
        (0.1, 0.8333333333333, 25),
        (0.2, 5.8333333333333, 75),
        (0.3, 15, 100),
        (0.65, 50, 100),
        (1.0, 85, 100),
        (1.1, 94.166666666667, 75),
        (1.2, 99.166666666667, 25),
        (1.3, 100, 0),
    ],
)
def test_s_ramp_on_its_way(time: float, position: float, velocity: float) -> None:
    state = plan_jerk(0.0, 100.0, 100.0, 500.0, 500.0, 5000.0, 5000.0).at(time)
    assert state.position == pytest.approx(position, rel=1e-12)
    assert state.velocity == pytest.approx(velocity, rel=1e-12, abs=1e-9)


def test_a_very_high_jerk_is_a_trapezoid() -> None:
    smooth = plan_jerk(0.0, 100.0, 100.0, 500.0, 500.0, 1e12, 1e12)
    assert smooth.duration == pytest.approx(
        plan_trapezoid(0.0, 100.0, 100.0, 500.0, 500.0).duration, rel=1e-8
    )


def test_chapter_12_two_ramps() -> None:
    """T_a = 2V/A, D_a = V^2/A, T_move = D/V + 2V/A.

    This is the time of a trapezoid of half the acceleration.
    """
    move = plan_ratio(0.0, 100.0, 20.0, 40.0, 40.0, 0.5)
    assert move.phases[0].duration == pytest.approx(1.0, rel=1e-12)
    assert move.phases[0].distance == pytest.approx(10.0, rel=1e-12)
    assert move.duration == pytest.approx(100 / 20 + 2 * 20 / 40, rel=1e-12)
    assert move.duration == pytest.approx(plan_trapezoid(0.0, 100.0, 20.0, 20.0, 20.0).duration, rel=1e-12)


def test_chapter_12_trapezoid() -> None:
    move = plan_trapezoid(0.0, 100.0, 20.0, 40.0, 40.0)
    assert move.duration == pytest.approx(100 / 20 + 20 / 40, rel=1e-12)
