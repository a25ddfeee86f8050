"""The time bounds of a proof agree with the planners for random states.

The two share no code.
"""

from __future__ import annotations

import os
from random import Random

import pytest

from motionlang.analysis.proof.time_bounds import Law, law, lead, move_time, ramp
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
