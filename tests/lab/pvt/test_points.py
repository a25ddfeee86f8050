"""From points to motion: the points themselves and the motion in between."""

from __future__ import annotations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from motionlang.kernel.planners import plan_pvt
from motionlang.lab.pvt.points import (
    Point,
    absolute,
    knots,
    plan_points,
    points_from,
    relative,
    segments,
    split_long,
)

numbers = st.integers(-100_000, 100_000).map(float)
times = st.integers(1, 255).map(lambda t: t / 1000)
point = st.builds(Point, numbers, st.one_of(st.none(), numbers), times, st.booleans())


@st.composite
def moves(draw: st.DrawFn) -> list[Point]:
    """Return cubic and linear, relative and absolute points; the last time is zero."""
    made = draw(st.lists(point, min_size=1, max_size=8))
    last = draw(point)
    return [*made, Point(last.position, last.velocity, 0.0, last.relative)]


def test_the_cubic_of_the_note() -> None:
    p0, v0, pt, vt, t = 100.0, 2000.0, 400.0, -1000.0, 0.1
    profile = plan_pvt((p0, pt), (v0, vt), (t,))
    piece = profile.drawn[1][0]
    b2 = 3 * (pt - p0) / t**2 - (2 * v0 + vt) / t
    b3 = (vt + v0) / t**2 + 2 * (p0 - pt) / t**3
    assert piece[:4] == pytest.approx((p0, v0, b2, b3))
    segment = segments(profile)[0]
    assert segment.jerk == pytest.approx(6 * b3)
    assert segment.acceleration == pytest.approx(2 * b2)
    assert segment.end_acceleration == pytest.approx(2 * b2 + 6 * b3 * t)


@given(moves())
def test_every_point_is_hit(move: list[Point]) -> None:
    profile = plan_points(move, start=7.0)
    marks = knots(profile)
    assert len(marks) == len(move)
    for mark, given_point in zip(marks, absolute(move, 7.0), strict=True):
        assert mark.position == pytest.approx(given_point.position, abs=1e-6)
        if given_point.velocity is not None:
            expected = pytest.approx(given_point.velocity, rel=1e-9, abs=1e-4)
            approached = mark is not marks[0]
            assert (mark.velocity if approached else mark.next_velocity) == expected or move[
                1
            ].velocity is None


@given(moves())
def test_relative_and_absolute_points_are_the_same_motion(move: list[Point]) -> None:
    one, other = plan_points(absolute(move, -3.0)), plan_points(relative(move, -3.0), start=-3.0)
    for time in (0.0, 0.3 * one.duration, 0.7 * one.duration, one.duration):
        assert one.position(time) == pytest.approx(other.position(time), abs=1e-6)


@given(moves())
def test_a_cubic_after_a_line_begins_at_the_velocity_of_the_line(move: list[Point]) -> None:
    marks = knots(plan_points(move))
    for i, mark in enumerate(marks[1:-1], 1):
        if move[i].velocity is None and move[i + 1].velocity is not None:
            assert mark.next_velocity == pytest.approx(mark.velocity, rel=1e-9, abs=1e-6)


def test_points_without_velocities_are_joined_by_lines() -> None:
    profile = plan_points(points_from([0, 10, 30], [None] * 3, 0.1))
    assert [segment.acceleration for segment in segments(profile)] == [0.0, 0.0]
    assert profile.velocity(0.05) == pytest.approx(100.0)
    assert profile.velocity(0.15) == pytest.approx(200.0)


def test_a_zero_time_ends_the_move() -> None:
    move = [Point(0, 0, 0.1), Point(10, 0, 0.0), Point(99, 0, 0.1)]
    assert plan_points(move).end == 10.0
    assert plan_points(move).duration == 0.1


def test_the_first_relative_point_counts_from_the_motor_position() -> None:
    move = [Point(5, 0, 0.1, relative=True), Point(10, 0, 0.0, relative=True)]
    assert plan_points(move, start=100.0).start == 105.0
    assert plan_points(move, start=100.0).end == 115.0


def test_jumps_are_those_of_the_accelerations_on_both_sides() -> None:
    profile = plan_points(points_from([0, 5000, 15000, 20000], [0, 750_000, 750_000, 0], 0.01))
    assert [mark.jump for mark in knots(profile)] == pytest.approx([1.5e8, 1.5e8, 1.5e8, 1.5e8])


@given(numbers, numbers, numbers, numbers, st.integers(256, 3000).map(lambda t: t / 1000), st.booleans())
def test_long_segments_are_cut_on_the_curve(
    p0: float, v0: float, p1: float, v1: float, time: float, straight: bool
) -> None:
    assume(p0 != p1)
    move = points_from([p0, p1], [v0, None if straight else v1], time)
    cut = split_long(move)
    assert all(0.001 <= p.time <= 0.2551 for p in cut[:-1])
    assert all(abs(p.time * 1000 - round(p.time * 1000)) < 1e-6 for p in cut)
    one, other = plan_points(move), plan_points(cut)
    for step in range(21):
        moment = time * step / 20
        assert other.position(moment) == pytest.approx(one.position(moment), abs=1e-5)


@pytest.mark.parametrize(
    ("points", "velocities", "spans", "message"),
    [
        ([0, 1], [0, 0], [0.0], "segment time must be greater than zero"),
        ([0, 1], [0, 0], [-1.0], "segment time must be greater than zero"),
        ([0, float("nan")], [0, 0], [1.0], "target is not a number"),
        ([0, 1], [float("inf"), 0], [1.0], "start velocity must be finite"),
        ([0, 1, 2], [0, 0], [1.0], "one velocity per point and one time per segment"),
        ([0, 1e300], [0, 0], [1e-300], "segment time must lie between"),
        ([0, 1e300], [None, None], [1e-300], "segment time must lie between"),
    ],
)
def test_impossible_motions_are_refused(
    points: list[float], velocities: list[float | None], spans: list[float], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        plan_pvt(points, velocities, spans)
