"""The time bounds of a proof agree with the planners for random states.

The two share no code.
"""

from __future__ import annotations

import os
from random import Random

import pytest

from motionlang.analysis.proof.time_bounds import Law, law, lead, move_time, ramp, top_speed
from motionlang.planners import plan, plan_jerk, plan_velocity
from tests.planners.test_states import State

COUNT = int(os.environ.get("MOTIONLANG_LONG", "2000"))
PMC = ("sinusoidal", "parabolic", "scurve")


@pytest.mark.parametrize("shape", ["trapezoid", "scurve"])
def test_a_move_from_any_state_takes_as_long_as_is_due(shape: str) -> None:
    choose = Random(4)
    for number in range(COUNT):
        state = State(choose, shape)
        jerks = tuple(state.jerks) if shape == "scurve" else (float("inf"),) * 2
        by = law(shape, (state.rates[0], state.rates[1]), (jerks[0], jerks[1]), 0.0)
        expected = move_time(state.v0, state.a0, state.target - state.start, state.speed, by)
        assert state.planned().duration == pytest.approx(expected, rel=1e-7, abs=1e-9), (
            f"{number}: {vars(state)}"
        )


@pytest.mark.parametrize("shape", PMC)
def test_a_move_of_the_pmc_shapes_takes_as_long_as_is_due(shape: str) -> None:
    choose = Random(6)
    for number in range(COUNT):
        state = State(choose, "trapezoid")
        by = law(shape, (state.rates[0], state.rates[1]), (float("inf"),) * 2, 0.2)
        made = plan(
            shape, state.start, state.target, state.speed, state.rates[0], state.rates[1], state.v0, 0.2
        )
        expected = move_time(state.v0, 0.0, state.target - state.start, state.speed, by)
        assert made.duration == pytest.approx(expected, rel=1e-7, abs=1e-9), f"{number}: {vars(state)}"


def test_a_jog_takes_as_long_as_is_due() -> None:
    choose = Random(8)
    for number in range(COUNT):
        state = State(choose, "trapezoid")
        by, goal = Law((state.rates[0], state.rates[1])), choose.uniform(-1.0, 1.0) * state.speed
        made = plan_velocity("trapezoid", state.start, state.v0, goal, *state.rates)
        assert made.knots[-2] == pytest.approx(lead(state.v0, 0.0, goal, by)[0], rel=1e-9), str(number)


def test_ramps_by_hand() -> None:
    """A ramp from 0 to 100 at 50 with a jerk of 100 takes 2.5 s and 125 units.

    TN1069's shapes to 40 at 0.1 take 628.3, 444.4 and 800 cycles.
    """
    assert ramp(0.0, 100.0, Law((50.0, 50.0), (100.0, 100.0))) == pytest.approx((2.5, 125.0))
    endless = (float("inf"),) * 2
    for shape, time, distance in (
        ("sinusoidal", 628.3185307, 12566.37061), ("scurve", 444.4444444, 8888.888889),
        ("parabolic", 800.0, 21333.33333),
    ):  # fmt: skip
        assert ramp(0.0, 40.0, law(shape, (0.1, 0.1), endless, 0.1)) == pytest.approx(
            (time, distance), rel=1e-9
        )


@pytest.mark.parametrize("distance", [-100.0, 100.0, -1e-3])
@pytest.mark.parametrize("a0", [30.0, -30.0, 0.0])
def test_a_move_from_a_standstill_that_speeds_up_takes_as_long_as_is_due(a0: float, distance: float) -> None:
    by = Law((100.0, 80.0), (400.0, 100.0))
    made = plan_jerk(0.0, distance, 50.0, *by.rates, *by.jerks, 0.0, a0)
    assert made.duration == pytest.approx(move_time(0.0, a0, distance, 50.0, by), rel=1e-7)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(
    ("v0", "a0", "distance", "expected"),
    [
        (0.0, 0.0, 100.0, 200.0),
        (100.0, 0.0, 87.5, 200.0),
        (0.0, 0.0, 5000.0, 1000.0),
        (200.0, 0.0, 50.0, 200.0),
        (200.0, 0.0, 49.0, 1000.0),
        (-200.0, 0.0, 100.0, 1000.0),
    ],
)
def test_the_top_speed_of_a_move_by_hand(
    way: float, v0: float, a0: float, distance: float, expected: float
) -> None:
    """With rates of 400 a ramp from u to v needs |v² - u²|/800.

    From rest 50 + 50 reach 200; from 100 it is 37.5 + 50. A velocity of 200 stops in exactly 50. A move that overshoots
    or reverses is bounded by the commanded speed alone.
    """
    by = Law((400.0, 400.0))
    found = top_speed(way * v0, way * a0, way * distance, 1000.0, by)
    assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_the_top_speed_from_an_acceleration_by_hand(way: float) -> None:
    """From rest with an acceleration of 200 to 140, at a jerk of 1000.

    The acceleration rises to 400 in 0.2 s: 60 is reached after 16/3. It falls to 0 in 0.4 s, over 24 + 32 - 32/3.
    The stop from 140 < 400²/1000 takes 2 sqrt(0.14) s at a mean velocity of 70.
    """
    by = Law((400.0, 400.0), (1000.0, 1000.0))
    distance = 152.0 / 3.0 + 140.0 * 0.14**0.5
    assert top_speed(0.0, way * 200.0, way * distance, 1000.0, by) == pytest.approx(140.0, rel=1e-9)
