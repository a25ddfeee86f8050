"""S-curves as PVT points: the four segments of the note, and moves within limits."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.planners import Profile, plan_jerk
from motionlang.planners.pvt.points import knots, plan_points, segments
from motionlang.planners.pvt.scurve import limited_scurve, scurve, scurve_time

distances = st.floats(1.0, 1e6) | st.floats(-1e6, -1.0)
jerks, accels, speeds = st.floats(1e3, 1e7), st.floats(1e2, 1e6), st.floats(1e1, 1e5)


def largest_jerk(profile: Profile) -> float:
    """Return the largest jerk, without the rounding error of third differences."""
    noise = 1e-15 * abs(profile.distance) / min(s.duration for s in segments(profile)) ** 3
    return max(abs(s.jerk) for s in segments(profile)) - 12 * noise


def test_the_example_of_the_note() -> None:
    points = scurve(1000.0, 0.1)
    assert [p.position for p in points] == pytest.approx([0, 83.3333333, 500, 916.6666667, 1000])
    assert [p.velocity for p in points] == pytest.approx([0, 2500, 5000, 2500, 0])
    assert [s.jerk for s in segments(plan_points(points))] == pytest.approx(
        [500_000, -500_000, -500_000, 500_000]
    )


def test_time_and_jerk_say_the_same() -> None:
    assert scurve_time(1000.0, 500_000.0) == pytest.approx(0.1)
    assert limited_scurve(1000.0, 500_000.0)[1].time == pytest.approx(0.1)


@given(distances, st.floats(0.001, 1.0))
def test_acceleration_never_jumps(distance: float, time: float) -> None:
    profile = plan_points(scurve(distance, time))
    largest = max(abs(s.end_acceleration) for s in segments(profile))
    assert all(abs(mark.jump) <= 1e-9 * largest for mark in knots(profile))
    assert profile.end == distance


@given(distances, jerks, accels, speeds)
def test_limits_are_kept_and_met(distance: float, jerk: float, accel: float, speed: float) -> None:
    """The duration is that of Mint's S-ramp with the same limits.

    The two planners share no arithmetic.
    """
    profile = plan_points(limited_scurve(distance, jerk, accel, speed))
    oracle = plan_jerk(0.0, distance, speed, accel, accel, jerk, jerk)
    assert profile.duration == pytest.approx(oracle.duration, rel=1e-6)
    assert profile.peak_speed == pytest.approx(oracle.peak_speed, rel=1e-6)
    assert profile.end == distance
    assert largest_jerk(profile) <= jerk * (1 + 1e-6)


@given(distances, jerks, accels, speeds)
def test_whole_milliseconds_keep_every_limit(
    distance: float, jerk: float, accel: float, speed: float
) -> None:
    points = limited_scurve(distance, jerk, accel, speed, grid=0.001)
    assert all(abs(p.time * 1000 - round(p.time * 1000)) < 1e-6 for p in points)
    profile = plan_points(points)
    assert profile.peak_speed <= speed * (1 + 1e-9)
    shortest = min(s.duration for s in segments(profile))
    assert profile.peak_acceleration <= accel * (1 + 1e-6) + 1e-14 * abs(distance) / shortest**2
    assert largest_jerk(profile) <= jerk * (1 + 1e-5)
    assert profile.end == distance


@pytest.mark.parametrize(
    ("limits", "count"),
    [
        ({}, 4),
        ({"accel": 20_000.0}, 6),
        ({"speed": 3000.0}, 5),
        ({"accel": 20_000.0, "speed": 3000.0}, 7),
    ],
)
def test_each_limit_adds_its_segments(limits: dict[str, float], count: int) -> None:
    assert len(limited_scurve(1000.0, 500_000.0, **limits)) == count + 1


def test_no_distance_is_one_point() -> None:
    assert [p.time for p in limited_scurve(0.0, 1000.0)] == [0.0]


@pytest.mark.parametrize("jerk", [0.0, -1.0, float("nan"), float("inf")])
def test_impossible_jerks_are_refused(jerk: float) -> None:
    with pytest.raises(ValueError, match="jerk"):
        limited_scurve(100.0, jerk)


@pytest.mark.parametrize("time", [0.0, -1.0, float("nan"), 1e-200])
def test_impossible_times_are_refused(time: float) -> None:
    with pytest.raises(ValueError, match="segment time"):
        scurve(100.0, time)
