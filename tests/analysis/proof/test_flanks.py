"""The state in which a plan begins, from the motion before it, by hand.

TRAPEZOID speeds up to 10 in 0.1 s, and slows down from 10.0 s to 10.1 s. TURNING brakes from 10 to rest in
0.1 s, and then moves back. S_RAMP has a jerk of 100: its acceleration reaches 50 after 0.5 s and leaves it
after 2.0 s; its velocity is 100 after 2.5 s. SINE reaches 12 in 3 s.
"""

from __future__ import annotations

from math import inf, pi, sin, sqrt
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.analysis.proof.flanks import Begin, begin, is_without_flank, last_change
from motionlang.log.order import Order
from motionlang.planners import (
    Profile,
    plan_jerk,
    plan_parabolic,
    plan_sinusoidal,
    plan_trapezoid,
    plan_velocity,
)
from motionlang.planners.curve import State

TRAPEZOID = plan_trapezoid(0.0, 100.0, 10.0, 100.0, 100.0)
TURNING = plan_trapezoid(0.0, -100.0, 10.0, 100.0, 100.0, 10.0)
S_RAMP = plan_jerk(0.0, 1000.0, 100.0, 50.0, 50.0, 100.0, 100.0)
SINE = plan_sinusoidal(0.0, 1000.0, 12.0, 2.0 * pi, 2.0 * pi)
PARABOLA = plan_parabolic(0.0, 1000.0, 12.0, 8.0, 8.0)
JOG = plan_velocity("trapezoid", 0.0, 0.0, 10.0, 100.0, 100.0)

MOVE = Order("move", 1, 10.0, (100.0, 100.0), shape="trapezoid")
STOP = MOVE._replace(kind="stop", speed=inf)
SMOOTH = MOVE._replace(shape="scurve", jerks=(100.0, 100.0), speed=100.0)
CURVE = SMOOTH._replace(jerks=(inf, inf))


def begun(
    before: Profile, elapsed: float, order: Order, earlier: Order = MOVE, shifted: bool = False
) -> Begin:
    """Return the initial state of a plan that replaces `before`, in its state."""
    state = before.at(elapsed)
    plan: Any = SimpleNamespace(at=lambda time: state)
    track: Any = SimpleNamespace(starts=[2.0, 2.0 + elapsed], profiles=[before, plan])
    return begin(track, 1, order, earlier, shifted)


# The motion before, the time in it, the order, the order before, and whether the zero is new. Expected are the
# velocity and the acceleration of the plan, the speed and the acceleration before, and how long the motion
# before would have changed its velocity: if the plan may continue it, and by the same ramps.
Case = tuple[Profile, float, Order, Order, bool, tuple[float, float, float, float, float | None, float]]
STATES: dict[str, Case] = {
    "another move at speed": (TRAPEZOID, 1.0, MOVE, MOVE, False, (10.0, 0.0, 10.0, 0.0, None, inf)),
    "the same at a new zero": (TRAPEZOID, 1.0, MOVE, MOVE, True, (10.0, 0.0, 10.0, 0.0, 9.1, inf)),
    "braking by the same ramps": (TRAPEZOID, 10.05, MOVE, MOVE, False, (5.0, 0.0, 5.0, 0.0, None, 0.05)),
    "braking by ramps of its own": (
        TRAPEZOID, 10.05, MOVE._replace(ramp=0.5), MOVE, False, (5.0, 0.0, 5.0, 0.0, None, inf),
    ),
    "braking above its speed": (
        TRAPEZOID, 10.05, MOVE._replace(speed=4.9), MOVE._replace(speed=4.9), False,
        (5.0, 0.0, 5.0, 0.0, None, inf),
    ),
    "braking at its speed": (
        TRAPEZOID, 10.05, MOVE._replace(speed=5.0), MOVE, False, (5.0, 0.0, 5.0, 0.0, None, 0.05),
    ),
    "speeding up by the same ramps": (TRAPEZOID, 0.05, MOVE, MOVE, False, (5.0, 0.0, 5.0, 0.0, None, inf)),
    "braking, and turning by the same ramps": (
        TURNING, 0.05, MOVE, MOVE, False, (5.0, 0.0, 5.0, 0.0, None, TURNING.duration - 0.05),
    ),
    "back at speed, at a new zero": (
        TURNING, 1.0, MOVE, MOVE, True, (-10.0, 0.0, 10.0, 0.0, TURNING.duration - 1.0, inf),
    ),
    "at rest": (TRAPEZOID, 11.0, MOVE, MOVE, True, (0.0, 0.0, 0.0, 0.0, None, inf)),
    "a jerk-limited move while the acceleration rises": (
        S_RAMP, 0.2, SMOOTH, SMOOTH, False, (2.0, 20.0, 2.0, 20.0, None, inf),
    ),
    "a jog at a new zero changes no more": (JOG, 0.25, MOVE, MOVE, True, (10.0, 0.0, 10.0, 0.0, 0.0, inf)),
    "a jog speeds up": (JOG, 0.025, MOVE, MOVE, True, (2.5, 0.0, 2.5, 0.0, 0.075, inf)),
    "a constant acceleration without a flank": (
        TRAPEZOID, 0.05, CURVE, MOVE, False, (5.0, 0.0, 5.0, 100.0, None, inf),
    ),
    "a parabolic order has no flank": (
        S_RAMP, 0.2, CURVE._replace(shape="parabolic"), MOVE, False, (2.0, 0.0, 2.0, 20.0, None, inf),
    ),
    "a stop without a flank": (
        TRAPEZOID, 10.05, STOP._replace(shape="scurve"), MOVE, False, (5.0, 0.0, 5.0, -100.0, 0.05, inf),
    ),
    "a stop of what turns ends at its rest": (
        TURNING, 0.05, STOP._replace(shape="scurve"), MOVE, False, (5.0, 0.0, 5.0, -100.0, 0.05, inf),
    ),
    "a stop that speeds up is none": (
        TRAPEZOID, 0.05, STOP._replace(shape="scurve"), MOVE, False, (5.0, 0.0, 5.0, 100.0, None, inf),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", STATES)
def test_a_plan_begins_in_the_state_of_the_motion_before(name: str) -> None:
    before, elapsed, order, earlier, shifted, expected = STATES[name]
    found = begun(before, elapsed, order, earlier, shifted)
    velocity, acceleration, came, acceleration_before, left, planned = expected
    assert (found.time, found.distance) == (0.0, 0.0)
    assert (found.velocity, found.acceleration) == pytest.approx((velocity, acceleration), abs=1e-9)
    assert (found.came, found.acceleration_before) == pytest.approx((came, acceleration_before), abs=1e-9)
    assert found.left == (left if left is None else pytest.approx(left))
    assert found.planned == pytest.approx(planned)


def test_the_first_plan_of_an_axis_begins_at_rest() -> None:
    track: Any = SimpleNamespace(starts=[0.0], profiles=[S_RAMP])
    assert begin(track, 0, SMOOTH, SMOOTH, False) == Begin(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, None)


# The motion before, the time in it, and the flank of its ramp: the velocity after it, its time, and its distance
# v t + a t²/2 - J t³/6. Of 12 sin² of a sixth of pi per second, the flank of the first second is the last one,
# with a quarter of 12 below it.
FLANKS: dict[str, tuple[Profile, float, tuple[float, float, float]]] = {
    "while the acceleration rises": (S_RAMP, 0.2, (4.0, 0.2, 0.4 + 0.4 - 0.4 / 3.0)),
    "as the ramp has hardly begun": (S_RAMP, 0.005, (0.0025, 0.005, 6.25e-6 + 6.25e-6 - 6.25e-6 / 3.0)),
    "while it is constant": (S_RAMP, 1.0, (50.0, 0.5, 18.75 + 6.25 - 12.5 / 6.0)),
    "while it falls": (S_RAMP, 2.2, (100.0, 0.3, 28.65 + 1.35 - 0.45)),
    "while the deceleration rises": (S_RAMP, S_RAMP.duration - 2.3, (96.0, 0.2, 19.6 - 0.4 + 0.4 / 3.0)),
    "while it is constant, braking": (
        S_RAMP, S_RAMP.duration - 1.5, (50.0, 0.5, 31.25 - 6.25 + 12.5 / 6.0),
    ),
    "a third of a sinusoidal ramp": (SINE, 1.0, (6.0, 1.0, 18.0 / pi * sin(pi / 3.0))),
    "two thirds of it": (SINE, 2.0, (12.0, 1.0, 6.0 + 18.0 / pi * sin(pi / 3.0))),
    "the middle of it": (SINE, 1.5, (12.0, 1.5, 9.0 + 18.0 / pi)),
    "a third of the braking": (SINE, SINE.duration - 2.0, (6.0, 1.0, 12.0 - 18.0 / pi * sin(pi / 3.0))),
}  # fmt: skip


@pytest.mark.parametrize("name", FLANKS)
def test_an_interrupted_ramp_ends_along_its_flank(name: str) -> None:
    before, elapsed, expected = FLANKS[name]
    state = before.at(elapsed)
    found = begun(before, elapsed, CURVE)
    assert (found.velocity, found.time, found.distance) == pytest.approx(expected)
    assert (found.acceleration, found.left, found.planned) == (0.0, None, inf)
    assert (found.came, found.acceleration_before) == (state.velocity, state.acceleration)


def test_a_ramp_that_comes_from_elsewhere_has_the_flank_from_its_own_velocity() -> None:
    """The plan begins at 7, not at 2; in 0.2 s its velocity rises by 2."""
    plan: Any = SimpleNamespace(at=lambda time: State(0.0, 7.0, 20.0, 0.0))
    track: Any = SimpleNamespace(starts=[0.0, 0.2], profiles=[S_RAMP, plan])
    found = begin(track, 1, CURVE, MOVE, False)
    assert (found.velocity, found.distance) == pytest.approx((9.0, 1.4 + 0.4 - 0.4 / 3.0))


@pytest.mark.parametrize(
    ("profile", "time"), [(TRAPEZOID, 10.1), (JOG, 0.1), (S_RAMP, 12.5), (TURNING, 0.1 + 100.5 / 10.0 + 0.1)]
)
def test_the_velocity_of_a_profile_is_constant_at_last(profile: Profile, time: float) -> None:
    """TURNING brakes over 0.5, so it travels 100.5 back; each ramp takes 0.1 s."""
    assert last_change(profile) == pytest.approx(time)


@pytest.mark.parametrize(
    ("profile", "elapsed", "without"),
    [
        (TRAPEZOID, 0.05, True),
        (TRAPEZOID, 1.0, False),  # at speed
        (TRAPEZOID, 10.05, True),
        (S_RAMP, 0.2, False),
        (S_RAMP, 1.0, False),
        (S_RAMP, 2.2, False),
        (SINE, 1.0, False),
        (PARABOLA, 1.0, False),
        (JOG, 0.05, True),
        (JOG, 9.0, False),
    ],
)
def test_only_the_ramp_of_a_trapezoid_has_no_flank(profile: Profile, elapsed: float, without: bool) -> None:
    assert is_without_flank(profile, elapsed) is without


def test_the_ramps_of_these_cases_take_3_s() -> None:
    """The parabolic one takes 2 * 12 / 8 = 3 s, and reaches 12 (1 - (2/3)²) after 1 s."""
    assert PARABOLA.velocity(1.0) == pytest.approx(12.0 * (1.0 - 4.0 / 9.0))
    assert SINE.velocity(1.0) == pytest.approx(3.0)
    assert SINE.acceleration(1.0) == pytest.approx(2.0 * pi * sqrt(0.75))
