"""Ramp-down of residual acceleration along the flank of a ramp, by hand.

S_RAMP has a jerk of 100: its acceleration reaches 50 after 0.5 s and leaves it after 2.0 s; its velocity is 100
after 2.5 s. SINE and PARABOLA reach 12 in 3 s.
"""

from __future__ import annotations

from math import inf, pi, sin

import pytest

from motionlang.kernel.planners import Profile, plan, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.ramp_down import admitted, onset, residual_ramp_down, shaped, stop_in_motion
from tests.kernel.planners.cases import plan_jerk

S_RAMP = plan_jerk(0.0, 1000.0, 100.0, 50.0, 50.0, 100.0, 100.0)
SINE = plan("sinusoidal", 0.0, 1000.0, 12.0, 2.0 * pi, 2.0 * pi)
PARABOLA = plan("parabolic", 0.0, 1000.0, 12.0, 8.0, 8.0)
TRAPEZOID = plan_trapezoid(0.0, 100.0, 10.0, 100.0, 100.0)
BACK = plan_jerk(0.0, -1000.0, 100.0, 50.0, 50.0, 100.0, 100.0)

# The motion, the time in it, and the ramp-down: its phase, velocity at its end, time, and distance
# v t + a t²/2 - J t³/6.
FLANKS: dict[str, tuple[Profile, float, tuple[str, float, float, float]]] = {
    "while the acceleration rises": (S_RAMP, 0.2, ("accel", 4.0, 0.2, 0.4 + 0.4 - 0.4 / 3.0)),
    "while it is constant": (S_RAMP, 1.0, ("accel", 50.0, 0.5, 18.75 + 6.25 - 12.5 / 6.0)),
    "while it falls": (S_RAMP, 2.2, ("accel", 100.0, 0.3, 28.65 + 1.35 - 0.45)),
    "while the deceleration rises": (
        S_RAMP, S_RAMP.duration - 2.3, ("decel", 96.0, 0.2, 19.6 - 0.4 + 0.4 / 3.0),
    ),
    "in reverse": (BACK, 0.2, ("accel", -4.0, 0.2, -0.4 - 0.4 + 0.4 / 3.0)),
    "braking in reverse": (BACK, BACK.duration - 2.3, ("decel", -96.0, 0.2, -19.6 + 0.4 - 0.4 / 3.0)),
    "a third of a sinusoidal ramp": (SINE, 1.0, ("accel", 6.0, 1.0, 18.0 / pi * sin(pi / 3.0))),
    "two thirds of it": (SINE, 2.0, ("accel", 12.0, 1.0, 6.0 + 18.0 / pi * sin(pi / 3.0))),
    "a third of the braking": (
        SINE, SINE.duration - 2.0, ("decel", 6.0, 1.0, 12.0 - 18.0 / pi * sin(pi / 3.0)),
    ),
    "a parabolic ramp from rest": (PARABOLA, 0.0, ("accel", 12.0, 3.0, 24.0)),
    "the last flank of a stop": (S_RAMP, S_RAMP.duration - 0.2, ("decel", 0.0, 0.2, 0.4 / 3.0)),
}  # fmt: skip


@pytest.mark.parametrize("name", FLANKS)
def test_an_acceleration_is_ramped_down_along_its_flank(name: str) -> None:
    profile, time, (phase, velocity, seconds, distance) = FLANKS[name]
    state, found = profile.at(time), residual_ramp_down(profile, time)
    assert found is not None
    assert (found.start, found.start_velocity) == pytest.approx((state.position, state.velocity))
    assert found.end_velocity == pytest.approx(velocity, abs=1e-9)
    assert (found.duration, found.distance) == pytest.approx((seconds, distance))
    assert found.acceleration(0.0) == pytest.approx(state.acceleration)
    assert [each.name for each in found.phases] == [phase]
    assert found.shape == profile.shape


@pytest.mark.parametrize(
    ("profile", "time"),
    [
        (TRAPEZOID, 0.05),
        (TRAPEZOID, 1.0),
        (TRAPEZOID, TRAPEZOID.duration - 0.05),
        (S_RAMP, 5.0),
        (S_RAMP, -1.0),
        (S_RAMP, S_RAMP.duration),
        (SINE, 10.0),
    ],
)
def test_without_an_acceleration_or_a_flank_there_is_no_ramp_down(profile: Profile, time: float) -> None:
    assert residual_ramp_down(profile, time) is None


def test_a_stop_that_is_nearly_over_leads_to_rest() -> None:
    found = residual_ramp_down(S_RAMP, S_RAMP.duration - 0.2)
    assert found is not None
    assert found.end_velocity == 0.0


@pytest.mark.parametrize(
    ("shape", "jerk", "expected"),
    [("sinusoidal", inf, True), ("scurve", inf, True), ("scurve", 5.0, False), ("trapezoid", inf, False)],
)
def test_the_acceleration_of_a_shape_without_a_jerk_is_shaped(
    shape: str, jerk: float, expected: bool
) -> None:
    assert shaped(shape, jerk) is expected


def test_a_new_plan_begins_after_the_ramp_down() -> None:
    """After 0.2 s the ramp is at 20 / 150 and has 2, and it goes on to 4 over 2 / 3."""
    eased, *state = onset(S_RAMP, 0.2, "scurve", inf)
    assert eased is not None
    assert state == pytest.approx([0.4 / 3.0 + 2.0 / 3.0, 4.0, 0.0])
    for shape, jerk, acceleration in (("scurve", 100.0, 20.0), ("trapezoid", inf, 0.0)):
        eased, *state = onset(S_RAMP, 0.2, shape, jerk)
        assert eased is None
        assert state == pytest.approx([0.4 / 3.0, 2.0, acceleration])


@pytest.mark.parametrize(
    ("acceleration", "velocity", "expected"),
    [
        (50.0, 5.0, 10.0),
        (-50.0, -5.0, -10.0),
        (-50.0, 5.0, -20.0),
        (50.0, -5.0, 20.0),
        (50.0, 0.0, 10.0),
        (-50.0, 0.0, -10.0),
        (7.0, 5.0, 7.0),
        (-17.0, 5.0, -17.0),
    ],
)
def test_the_acceleration_that_a_ramp_takes_over(
    acceleration: float, velocity: float, expected: float
) -> None:
    """It speeds up at 10 and slows down at 20."""
    assert admitted(acceleration, velocity, 10.0, 20.0) == expected


def test_a_jog_that_slows_down_to_a_lower_speed_is_stopped() -> None:
    """It slows down from 18 to 6 in 3 s. The stop follows the second half of that, and takes 1.5 s from 6 on."""
    slower = plan_velocity("sinusoidal", 0.0, 18.0, 6.0, 2.0 * pi, 2.0 * pi)
    made = stop_in_motion(slower, 1.5, "sinusoidal", 2.0 * pi, 0.0)
    assert made.at(0.0).velocity == pytest.approx(12.0)
    assert made.velocity(1.5) == pytest.approx(6.0)
    assert (made.duration, made.end_velocity) == pytest.approx((3.0, 0.0))
