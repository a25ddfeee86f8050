"""Every planner with random moves: checker, integral and closed form agree."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given

from motionlang.planners import plan_jerk, plan_trapezoid
from tests.planners.cases import SHAPES, Move, integrated, moves, quick
from tests.planners.verify import verify

STRETCH = {"trapezoid": 1.0, "sinusoidal": math.pi / 2, "parabolic": 2.0}


@pytest.mark.parametrize("shape", SHAPES)
def test_a_move_keeps_its_limits_and_arrives(shape: str) -> None:
    @quick
    @given(moves(shape))
    def check(move: Move) -> None:
        jerk = max(move.accel_jerk, move.decel_jerk) if shape == "jerk" else None
        made = move.planned()
        limits = {"speed": move.speed, "accel": move.accel, "decel": move.decel, "end": move.target}
        assert verify(made, **limits, jerk=jerk) == []
        assert made.end_velocity == 0.0

    check()


@quick
@given(moves())
def test_the_velocity_integrates_to_the_distance(move: Move) -> None:
    made = move.planned()
    travelled = sum(abs(phase.distance) for phase in made.phases)
    slack = 1e-12 * (abs(travelled) + abs(move.start) + abs(move.target))
    assert integrated(made) == pytest.approx(made.distance, rel=1e-12, abs=slack)


@quick
@given(moves("trapezoid", moving=False))
def test_the_trapezoid_in_closed_form(move: Move) -> None:
    made, size = move.planned(), abs(move.target - move.start)
    full = move.speed**2 * (0.5 / move.accel + 0.5 / move.decel)
    peak = move.speed if size >= full else math.sqrt(size / (0.5 / move.accel + 0.5 / move.decel))
    slew = max(size - full, 0.0) / move.speed
    assert made.duration == pytest.approx(peak / move.accel + peak / move.decel + slew, rel=1e-12)


@pytest.mark.parametrize("shape", ["sinusoidal", "ratio", "parabolic"])
def test_the_ramp_times_of_tn1069(shape: str) -> None:
    @quick
    @given(moves(shape, moving=False))
    def check(move: Move) -> None:
        stretch = 1.0 / (1.0 - move.ramp) if shape == "ratio" else STRETCH[shape]
        for phase in move.planned().phases:
            rate = {"accel": move.accel, "decel": move.decel}.get(phase.name)
            change = abs(phase.end_velocity - phase.start_velocity)
            if rate:
                assert phase.duration == pytest.approx(stretch * change / rate, rel=1e-9)

    check()


@quick
@given(moves("jerk", moving=False))
def test_a_short_s_ramp_fills_its_distance_with_its_ramps(move: Move) -> None:
    made = move.planned()
    if made.phases and all(phase.name != "slew" for phase in made.phases):
        assert sum(phase.distance for phase in made.phases) == pytest.approx(
            made.distance, rel=1e-9, abs=1e-9
        )
        assert made.peak_speed <= move.speed * (1 + 1e-12)


@quick
@given(moves(moving=False))
def test_the_mirror_image_takes_the_same_time(move: Move) -> None:
    other = move._replace(target=move.start - (move.target - move.start))
    assert other.planned().duration == pytest.approx(move.planned().duration, rel=1e-9, abs=1e-12)


def names(v0: float, target: float = 12.0) -> list[str]:
    return [phase.name for phase in plan_trapezoid(0.0, target, 8.0, 16.0, 16.0, v0).phases]


def test_a_start_that_is_already_moving() -> None:
    assert names(5.0) == ["accel", "slew", "decel"]
    assert names(8.0) == ["slew", "decel"]
    assert names(9.0) == ["decel", "slew", "decel"]
    assert names(-5.0) == ["stop", "accel", "slew", "decel"]
    assert names(30.0) == ["stop", "accel", "slew", "decel"]
    assert names(8.0, 2.0) == ["decel"]
    assert names(0.0, 0.0) == []
    assert names(4.0, 0.0) == ["stop", "accel", "decel"]


def test_a_move_cut_while_braking_and_planned_again_brakes_on() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    for tenth in range(16, 20):
        state = move.at(tenth / 10)
        again = plan_trapezoid(state.position, 12.0, 8.0, 16.0, 16.0, state.velocity)
        assert [phase.name for phase in again.phases] == ["decel"]
        assert again.duration == pytest.approx(2.0 - tenth / 10)


@quick
@given(moves("jerk"))
def test_a_start_that_is_already_accelerating(move: Move) -> None:
    a0 = math.copysign(0.5 * min(move.accel, math.sqrt(2.0 * move.speed * move.accel_jerk)), move.v0)
    rates = (move.speed, move.accel, move.decel, move.accel_jerk, move.decel_jerk)
    made = plan_jerk(move.start, move.target, *rates, v0=move.v0, a0=a0)
    assert made.at(0.0).acceleration == pytest.approx(a0)
    # the change of velocity while easing has few digits left compared with the velocity
    assert verify(made, end=move.target, jerk=max(rates[3:]), tolerance=1e-6) == []


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"speed": 0.0}, "speed must be greater than zero"),
        ({"speed": -1.0}, "speed must be greater than zero"),
        ({"accel": 0.0}, "acceleration must be greater than zero"),
        ({"decel": -3.0}, "deceleration must be greater than zero"),
        ({"speed": math.nan}, "speed is not a number"),
        ({"accel": math.inf}, "acceleration must be finite"),
        ({"target": math.nan}, "target is not a number"),
        ({"target": math.inf}, "target must be finite"),
        ({"start": -math.inf}, "position must be finite"),
        ({"target": 1.7e308, "start": -1.7e308}, "position must lie between"),
        ({"target": 1e308, "speed": 1e-100}, "speed must lie between 1e-60 and 1e\\+60"),
        ({"v0": math.nan}, "start velocity is not a number"),
        ({"v0": 1e308}, "start velocity must lie between -1e\\+60 and 1e\\+60"),
    ],
)
def test_numbers_no_machine_can_follow(shape: str, wrong: dict[str, Any], message: str) -> None:
    move = Move(shape, 0.0, 10.0, 5.0, 20.0, 20.0, 0.0, 0.25, 100.0, 100.0)
    with pytest.raises(ValueError, match=message):
        move._replace(**wrong).planned()


def test_only_known_shapes_and_ramps() -> None:
    move = Move("ratio", 0.0, 10.0, 5.0, 20.0, 20.0, 0.0, 0.0, 100.0, 100.0)
    with pytest.raises(ValueError, match="ramp must be greater than zero and at most"):
        move.planned()
    with pytest.raises(ValueError, match="there is no profile shape 'square'"):
        move._replace(shape="square").planned()
    with pytest.raises(ValueError, match="acceleration jerk must be greater than zero"):
        move._replace(shape="jerk", accel_jerk=-1.0).planned()
