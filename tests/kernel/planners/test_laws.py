"""The laws of motion, each for every planner: a table "law x planner".

A planner is a strategy of plans with random figures. The time of a plan comes from a second implementation, which
knows the time and the distance of each ramp and finds the peak speed by bisection.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from motionlang.kernel.planners import Profile, plan, plan_stop, plan_trapezoid, plan_velocity
from tests.cases import cases
from tests.kernel.planners.cases import SHAPES, Move, plan_jerk

RATIO, JERK = 0.2, 2000.0


def ramp(shape: str, change: float, rate: float, jerk: float, ratio: float = RATIO) -> float:
    """Return the time of a change of velocity, by the formulas of TN1069 and AN00118."""
    if shape == "jerk":
        return change / rate + rate / jerk if change * jerk >= rate * rate else 2.0 * math.sqrt(change / jerk)
    stretch = {"trapezoid": 1.0, "sinusoidal": math.pi / 2, "parabolic": 2.0, "ratio": 1.0 / (1.0 - ratio)}
    return stretch[shape] * change / rate


def move_from(v0: float, target: float = 12.0) -> Profile:
    return plan_trapezoid(0.0, target, 8.0, 16.0, 16.0, v0)


# What only one planner has: the phases by hand, with name and duration.
PHASES: dict[str, tuple[Profile, list[tuple[str, float]]]] = {
    "AN00115, the first example": (move_from(0.0), [("accel", 0.5), ("slew", 1.0), ("decel", 0.5)]),
    "slower": (move_from(4.0), [("accel", 0.25), ("slew", 1.0625), ("decel", 0.5)]),
    "at speed": (move_from(8.0), [("slew", 1.25), ("decel", 0.5)]),
    "too fast": (move_from(10.0), [("decel", 0.125), ("slew", 1.109375), ("decel", 0.5)]),
    "backwards": (move_from(-4.0), [("stop", 0.25), ("accel", 0.5), ("slew", 1.0625), ("decel", 0.5)]),
    "beyond the target": (
        move_from(24.0), [("stop", 1.5), ("accel", 0.5), ("slew", 0.25), ("decel", 0.5)],
    ),
    "just far enough to stop": (move_from(8.0, 2.0), [("decel", 0.5)]),
    "no distance": (move_from(0.0, 0.0), []),
    "back to the start": (move_from(4.0, 0.0), [("stop", 0.25), ("accel", 0.1767767), ("decel", 0.1767767)]),
    "a jog through rest": (
        plan_velocity("trapezoid", 0.0, -4.0, 8.0, 16.0, 8.0), [("stop", 0.5), ("accel", 0.5), ("slew", math.inf)],
    ),
    "a stop at rest": (plan_stop("trapezoid", 1.0, 0.0, 16.0), []),
    "chapter 12: 2 V / A of ramp": (
        plan("scurve", 0.0, 100.0, 20.0, 40.0, 40.0, ramp=0.5), [("accel", 1.0), ("slew", 4.0), ("decel", 1.0)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PHASES)
def test_the_phases_of_a_plan(name: str) -> None:
    made, phases = PHASES[name]
    assert [phase.name for phase in made.phases] == [name for name, _ in phases]
    assert [phase.duration for phase in made.phases] == pytest.approx([time for _, time in phases])


@cases(
    "time, position, velocity",
    [(0.1, 5 / 6, 25), (0.2, 35 / 6, 75), (0.3, 15, 100), (1.0, 85, 100), (1.1, 565 / 6, 75), (1.3, 100, 0)],
)  # fmt: skip
def test_the_s_ramp_of_an00118(time: float, position: float, velocity: float) -> None:
    state = plan_jerk(0.0, 100.0, 100.0, 500.0, 500.0, 5000.0, 5000.0).at(time)
    assert (state.position, state.velocity) == pytest.approx((position, velocity), rel=1e-12, abs=1e-9)


def test_a_move_cut_while_braking_and_planned_again_brakes_on() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    for tenth in range(16, 20):
        state = move.at(tenth / 10)
        again = plan_trapezoid(state.position, 12.0, 8.0, 16.0, 16.0, state.velocity)
        assert [phase.name for phase in again.phases] == ["decel"]
        assert again.duration == pytest.approx(2.0 - tenth / 10)


@pytest.mark.parametrize("shape", SHAPES)
@cases(
    "wrong, message",
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
        ({"shape": "square"}, "there is no profile shape 'square'"),
        ({"shape": "ratio", "ramp": 0.0}, "ramp must be greater than zero and at most"),
        ({"shape": "jerk", "accel_jerk": -1.0}, "acceleration jerk must be greater than zero"),
    ],
)
def test_numbers_no_machine_can_follow(shape: str, wrong: dict[str, object], message: str) -> None:
    move = Move(shape, 0.0, 10.0, 5.0, 20.0, 20.0, 0.0, 0.25, 100.0, 100.0)
    with pytest.raises(ValueError, match=message):
        move._replace(**wrong).planned()  # type: ignore[arg-type]


@cases(
    "planner, figures, message",
    [
        (plan_velocity, ("trapezoid", 0.0, 0.0, 1.0, 1.0, 0.0), "deceleration must be greater than zero"),
        (plan_velocity, ("trapezoid", 0.0, 0.0, math.nan, 1.0, 1.0), "velocity is not a number"),
        (plan_velocity, ("trapezoid", 0.0, 1e200, 1e-200, 1e-200, 1e-200), "acceleration must lie between 1e-60"),
        (plan_stop, ("square", 0.0, 1.0, 1.0), "no profile shape"),
    ],
)  # fmt: skip
def test_a_jog_or_a_stop_that_no_machine_can_follow(
    planner: Callable[..., Profile], figures: tuple[object, ...], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        planner(*figures)
