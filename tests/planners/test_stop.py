"""Stops, and motion at a velocity, in every shape."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.planners import plan_stop, plan_velocity
from tests.planners.cases import quick, sizes
from tests.planners.verify import verify

SHAPES = ("trapezoid", "sinusoidal", "scurve", "parabolic")
velocities = st.floats(-1000.0, 1000.0).map(lambda v: v if abs(v) > 1e-60 else 0.0)


@quick
@given(st.sampled_from(SHAPES), velocities, sizes(1.0, 1e4))
def test_a_stop_keeps_its_deceleration(shape: str, v0: float, decel: float) -> None:
    made = plan_stop(shape, 5.0, v0, decel, ramp=0.2)
    assert verify(made, decel=decel, accel=0.0, speed=abs(v0)) == []
    assert made.end_velocity == 0.0
    assert (made.end - 5.0) * v0 >= 0.0


@quick
@given(st.sampled_from(SHAPES), velocities, velocities)
def test_a_jog_runs_at_its_velocity_for_ever(shape: str, v0: float, v1: float) -> None:
    made = plan_velocity(shape, 0.0, v0, v1, 100.0, 200.0, ramp=0.2)
    assert (made.shape, made.duration) == ("jog", math.inf)
    assert made.velocity(1e6) == v1
    assert verify(made, accel=100.0, decel=200.0, speed=max(abs(v0), abs(v1))) == []


def test_a_trapezoidal_stop() -> None:
    made = plan_stop("trapezoid", 1.0, 8.0, 16.0)
    assert (made.duration, made.end) == (0.5, 3.0)
    assert [phase.name for phase in made.phases] == ["stop"]


def test_a_stop_at_rest_is_nothing() -> None:
    made = plan_stop("trapezoid", 1.0, 0.0, 16.0)
    assert (made.duration, made.end, made.phases) == (0.0, 1.0, ())


def test_a_reversal_stops_first() -> None:
    made = plan_velocity("trapezoid", 0.0, -4.0, 8.0, 16.0, 8.0)
    assert [(p.name, p.duration) for p in made.phases] == [("stop", 0.5), ("accel", 0.5), ("slew", math.inf)]


def test_a_jog_reaches_any_position_on_its_way() -> None:
    made = plan_velocity("trapezoid", 0.0, 0.0, 8.0, 16.0, 16.0)
    assert made.crossing(802.0) == pytest.approx(0.5 + 100.0)
    assert made.crossing(-1.0) is None


def test_a_jog_that_is_stopped() -> None:
    jog = plan_velocity("scurve", 0.0, 0.0, 8.0, 16.0, 16.0, accel_jerk=100.0)
    state = jog.at(3.0)
    whole = jog.cut(3.0).then(plan_stop("scurve", state.position, state.velocity, 16.0, decel_jerk=100.0))
    assert [phase.name for phase in whole.phases] == ["accel", "slew", "stop"]
    assert verify(whole, speed=8.0, accel=16.0, decel=16.0, jerk=100.0) == []


def test_a_stop_while_accelerating_eases_first() -> None:
    made = plan_stop("scurve", 0.0, 8.0, 16.0, decel_jerk=100.0, a0=10.0)
    assert made.at(0.0).acceleration == pytest.approx(10.0)
    assert verify(made, jerk=100.0) == []
    assert made.end_velocity == 0.0


def test_bad_numbers() -> None:
    with pytest.raises(ValueError, match="deceleration must be greater than zero"):
        plan_velocity("trapezoid", 0.0, 0.0, 1.0, 1.0, 0.0)
    with pytest.raises(ValueError, match="velocity is not a number"):
        plan_velocity("trapezoid", 0.0, 0.0, math.nan, 1.0, 1.0)
    with pytest.raises(ValueError, match="acceleration must lie between 1e-60 and 1e\\+60"):
        plan_velocity("trapezoid", 0.0, 1e200, 1e-200, 1e-200, 1e-200)
    with pytest.raises(ValueError, match="no profile shape"):
        plan_stop("square", 0.0, 1.0, 1.0)
