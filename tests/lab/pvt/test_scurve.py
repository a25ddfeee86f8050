"""S-curves as PVT points: the four segments of the note, and moves within limits."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import Profile, plan
from motionlang.lab.pvt.points import knots, plan_points, segments
from motionlang.lab.pvt.scurve import limited_scurve, limited_times, scurve, scurve_time

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
    oracle = plan("scurve", 0.0, distance, speed, accel, accel, accel_jerk=jerk)
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


# The distance and the limits of acceleration and speed, and the times of jerk, acceleration and speed. At a jerk of
# 8 the acceleration is 4 after 0.5 s, the velocity 1, and 3 after another 0.5 s.
TIMES: dict[str, tuple[float, float, float, tuple[float, float, float]]] = {
    "all limits: 4 (2 * 0.5 + 0.5 + 1)": (10.0, 4.0, 4.0, (0.5, 0.5, 1.0)),
    "no time at the speed": (6.0, 4.0, 4.0, (0.5, 0.5, 0.0)),
    "the speed is not reached": (6.0, 4.0, 99.0, (0.5, 0.5, 0.0)),
    "the acceleration is not reached": (3.0, 99.0, 2.0, (0.5, 0.0, 0.5)),
    "neither is": (2.0, 99.0, 99.0, (0.5, 0.0, 0.0)),
    "both just are": (2.0, 4.0, 2.0, (0.5, 0.0, 0.0)),
}  # fmt: skip


@pytest.mark.parametrize("name", TIMES)
def test_the_times_of_a_move_within_limits(name: str) -> None:
    distance, accel, speed, times = TIMES[name]
    assert limited_times(distance, 8.0, accel, speed) == pytest.approx(times, abs=1e-12)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_points_of_a_move_within_limits(sign: float) -> None:
    found = limited_scurve(sign * 10.0, 8.0, 4.0, 4.0)
    assert [each.time for each in found] == pytest.approx([0.5, 0.5, 0.5, 1.0, 0.5, 0.5, 0.5, 0.0])
    positions = [0.0, 1.0 / 6.0, 7.0 / 6.0, 3.0, 7.0, 53.0 / 6.0, 59.0 / 6.0, 10.0]
    assert [each.position for each in found] == pytest.approx([sign * each for each in positions])
    assert [each.velocity for each in found] == pytest.approx(
        [sign * each for each in (0, 1, 3, 4, 4, 3, 1, 0)]
    )


def test_times_are_rounded_up_to_a_grid() -> None:
    """0.5, 0.5 and 1 s become 0.75, 0.75 and 1.5 s: the speed is 10 / 3.75."""
    found = limited_scurve(10.0, 8.0, 4.0, 4.0, grid=0.75)
    assert [each.time for each in found] == [0.75, 0.75, 0.75, 1.5, 0.75, 0.75, 0.75, 0.0]
    assert [each.velocity for each in found][3:5] == pytest.approx([10.0 / 3.75] * 2)
    exact = limited_scurve(10.0, 8.0, 4.0, 4.0, grid=0.25)
    assert [each.time for each in exact] == [0.5, 0.5, 0.5, 1.0, 0.5, 0.5, 0.5, 0.0]


@pytest.mark.parametrize("distance", [1000.0, -1000.0])
def test_the_segment_time_of_a_distance(distance: float) -> None:
    assert scurve_time(distance, 4000.0) == pytest.approx(0.5)
