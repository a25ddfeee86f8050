"""Jogs and stops: what the laws (`test_laws.py`) do not say."""

from __future__ import annotations

import pytest

from motionlang.kernel.planners import plan_stop, plan_velocity
from tests.kernel.planners.verify import verify


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
