"""A profile as a function of time: values, crossings, cutting and joining."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import from_curve, hold, plan_pvt, plan_trapezoid
from tests.kernel.planners.cases import Move, moves, quick
from tests.kernel.planners.verify import verify

fractions = st.floats(0.0, 1.0)


@quick
@given(moves(), fractions)
def test_the_crossing_of_a_position_is_where_it_is_first_reached(move: Move, fraction: float) -> None:
    made = move.planned()
    low, high = made.extrema()
    wanted = min(low + fraction * (high - low), high)  # not beyond it by rounding
    time = made.crossing(wanted)
    assert time is not None
    size = max(abs(low), abs(high), 1e-9)
    assert made.position(time) == pytest.approx(wanted, rel=1e-12, abs=1e-12 * size)
    before = [made.position(time * i / 50) - wanted for i in range(50)]
    assert all(x >= -1e-9 * size for x in before) or all(x <= 1e-9 * size for x in before)


@quick
@given(moves(), fractions)
def test_the_crossing_is_not_before_the_requested_time(move: Move, fraction: float) -> None:
    made = move.planned()
    after = fraction * made.duration
    time = made.crossing(made.end, after)
    assert time is not None
    assert time >= after


def test_the_end_is_reached_at_the_end() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert move.crossing(12.0) == 2.0
    assert move.crossing(12.0, after=5.0) == 5.0
    assert move.crossing(6.0) == 1.0
    assert move.crossing(6.0, after=1.5) is None
    assert move.crossing(12.1) is None
    assert move.crossing(0.0) == 0.0


def test_an_overshoot_crosses_its_target_twice() -> None:
    move = plan_trapezoid(0.0, 1.0, 8.0, 16.0, 16.0, v0=8.0)
    first = move.crossing(1.0)
    assert first is not None
    assert first < 0.5
    assert move.crossing(1.0, after=0.5) == move.duration
    assert move.extrema() == pytest.approx((0.0, 2.0))


def test_a_place_is_crossed_in_the_rounding_of_a_piece_that_lasts_no_time() -> None:
    before, slew = 0.001 - 8e-15, (0.0, 7.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    knots = 0.0, before / 7.0, before / 7.0, 1.0
    pieces = slew, (before, *slew[1:]), (0.001 + 6e-15, *slew[1:])
    made = from_curve("parabolic", 0.0, 7.0, (knots, pieces, (("slew", 0),)), 7.0, 7.0)
    assert made.crossing(0.001) == before / 7.0
    assert made.crossing(0.001, after=0.5) is None
    assert made.velocity_crossing(8.0) is None


def test_the_crossing_of_a_velocity() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert move.velocity_crossing(4.0) == 0.25
    assert move.velocity_crossing(4.0, after=0.5) == 1.75
    assert move.velocity_crossing(8.0) == 0.5
    assert move.velocity_crossing(0.0, after=0.1) == 2.0
    assert move.velocity_crossing(9.0) is None


def test_a_jump_of_velocity_crosses_nothing() -> None:
    steps = plan_pvt([0.0, 5.0, 15.0], [], [1.0, 1.0])
    assert steps.velocity_crossing(7.0) is None


@quick
@given(moves(), fractions, fractions)
def test_cut_and_rest_are_the_whole(move: Move, where: float, when: float) -> None:
    made = move.planned()
    time = where * made.duration
    first, rest = made.cut(time), made.after(time)
    both = first.then(rest)
    assert first.duration + rest.duration == pytest.approx(made.duration)
    t = when * made.duration
    size = max(abs(x) for x in made.extrema())
    assert both.position(t) == pytest.approx(made.position(t), rel=1e-9, abs=1e-9 * size)
    assert both.velocity(t) == pytest.approx(made.velocity(t), rel=1e-6, abs=1e-6 * made.peak_speed)
    assert verify(both, speed=move.speed, accel=move.accel, decel=move.decel, end=move.target) == []


def test_a_phase_cut_in_the_middle_is_shorter() -> None:
    first = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0).cut(0.75)
    assert [(phase.name, phase.duration) for phase in first.phases] == [("accel", 0.5), ("slew", 0.25)]
    assert (first.end, first.end_velocity) == (4.0, 8.0)


def test_cut_outside_the_move() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert move.cut(3.0) is move
    assert move.after(0.0) is move
    assert (move.cut(0.0).duration, move.cut(0.0).end) == (0.0, 0.0)
    assert (move.after(2.5).duration, move.after(2.5).start) == (0.0, 12.0)
    assert move.cut(0.0).then(move) is move


def test_joining_across_a_gap_is_our_own_mistake() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    with pytest.raises(AssertionError, match="jump"):
        move.then(move)


@quick
@given(moves(), st.sampled_from([-2.5, -1.0, 0.5, 3.0]), fractions)
def test_scaling(move: Move, factor: float, when: float) -> None:
    made = move.planned()
    other, t = made.scaled(7.0, factor), when * made.duration
    size = max(abs(x) for x in made.extrema()) + 10.0
    assert other.position(t) - 7.0 == pytest.approx((made.position(t) - made.start) * factor, abs=1e-9 * size)
    assert verify(other, end=7.0 + made.distance * factor) == []


def test_shifting_keeps_the_motion() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert [move.shifted(5.0).position(t) for t in (0.0, 0.5, 2.0)] == [5.0, 7.0, 17.0]


def test_hold() -> None:
    still = hold(3.0)
    assert (still.position(1e6), still.velocity(5.0), still.crossing(3.0), still.crossing(4.0)) == (
        3,
        0,
        0,
        None,
    )
    assert hold(3.0, 2.0).duration == 2.0


@pytest.mark.parametrize("jump", [5.0, -5.0])
def test_a_jump_to_a_position_reaches_it(jump: float) -> None:
    """From 0 it moves by 0.2 in 1 s, jumps to the position, and rests there."""
    for slope in (0.2, -0.2, 0.0):
        made = from_curve(
            "pvt",
            0.0,
            jump,
            (
                (0.0, 1.0, 2.0),
                ((0.0, slope, 0.0, 0.0, 0.0, 0.0, 0.0), (jump, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
                (("segment", 0), ("segment", 1)),
            ),
            slope,
            0.0,
        )
        assert made.crossing(jump) == 1.0
        assert made.crossing(jump, 1.5) == 1.5
        assert made.crossing(2.0 * jump) is None
