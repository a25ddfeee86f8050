"""Moves in S-ramps from a velocity and an acceleration."""

from __future__ import annotations

from itertools import combinations
from math import sqrt

import pytest

from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.limits import LARGEST
from motionlang.kernel.planners.shapes import JerkRamps
from motionlang.kernel.planners.target import approach
from motionlang.kernel.planners.transition import ease
from tests.kernel.planners.cases import plan_jerk

# Acceleration, deceleration and their jerks. A ramp reaches 400 in 0.2 s from 40 per second on, 300 from 60 on.
RATES = (400.0, 300.0, 2000.0, 1500.0)

# Velocity, acceleration, and the length and time of the shortest stop from there.
STOPS: dict[str, tuple[float, float, float, float]] = {
    # 60 / 300 + 300 / 1500 s at a mean velocity of 30.
    "no acceleration": (60.0, 0.0, 12.0, 0.4),
    # 2 sqrt(15 / 1500) s at 7.5: 300 is not reached.
    "a short stop": (15.0, 0.0, 1.5, 0.2),
    # In 0.2 s the acceleration falls to 0 at 60: 20 * 0.2 + 400 / 2 * 0.2^2 - 2000 / 6 * 0.2^3 = 9.333; then as above.
    "speeding up": (20.0, 400.0, 28.0 / 3.0 + 12.0, 0.6),
    # 0.1 s at -300 down to 30, 4.5 long; then 0.2 s in which it falls to 0: 1500 / 6 * 0.2^3 = 2.
    "slowing down": (60.0, -300.0, 6.5, 0.3),
    # -150 rises to -300 in 0.1 s: from 102.5 by 22.5 to 80, at 0.1 s * 102.5 - 0.75 - 0.25 = 9.25; then 50 / 300 s
    # to 30, at a mean velocity of 55; then as above.
    "beginning to slow down": (102.5, -150.0, 9.25 + 55.0 / 6.0 + 2.0, 0.1 + 1.0 / 6.0 + 0.2),
}


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("start", [0.0, -7.0])
@pytest.mark.parametrize("name", STOPS)
def test_a_target_exactly_at_the_end_of_the_shortest_stop(sign: float, start: float, name: str) -> None:
    """The move only stops, and a target 1 % farther takes more time.

    From 1 % beyond the target it moves back: d = v (sqrt(v / J1) + sqrt(v / J2)), and the time is 2 d / v.
    """
    v0, a0, length, time = STOPS[name]

    def planned(distance: float) -> Profile:
        return plan_jerk(start, start + sign * distance, 100.0, *RATES, sign * v0, sign * a0)

    made, nearer, farther = planned(length), planned(0.99 * length), planned(1.01 * length)
    assert made.duration == pytest.approx(time, rel=1e-6)
    assert made.end == start + sign * length
    assert made.peak_speed <= v0 + 0.5 * max(a0, 0.0) ** 2 / RATES[2] + 1e-9
    roots = 2000.0**-0.5 + 1500.0**-0.5
    assert nearer.duration == pytest.approx(time + 2.0 * roots * (0.01 * length / roots) ** (1.0 / 3.0))
    assert time < farther.duration < nearer.duration


def test_a_deceleration_that_ends_hardly_above_rest_ends_at_rest() -> None:
    """A fraction of 1e-12 of 300^2 / 1500 = 60 and of the velocity is rounding.

    From 20 that is 8e-11. Above it, the deceleration first grows on, for a section of its own.
    """
    for after, knots in ((7e-11, 6), (9e-11, 7)):
        made = plan_jerk(0.0, 0.0, 100.0, *RATES, 20.0, -sqrt(2.0 * 1500.0 * (20.0 - after)))
        assert len(made.knots) == knots


# Initial velocity and acceleration, then the velocity and the distance after a ramp-down at a jerk of 500.
EASED = [
    (20.0, -100.0, 10.0, 4.0 - 2.0 + 2.0 / 3.0),
    (20.0, 100.0, 30.0, 4.0 + 2.0 - 2.0 / 3.0),
    (-5.0, -100.0, -15.0, -1.0 - 2.0 + 2.0 / 3.0),
]


@pytest.mark.parametrize(("v0", "a0", "v1", "distance"), EASED)
def test_a_ramp_down_of_an_acceleration(v0: float, a0: float, v1: float, distance: float) -> None:
    """It takes T = 100 / 500 s and covers v0 T + a0 T^2 / 2 less a0 T^2 / 6."""
    made = ease(3.0, v0, a0, 500.0)
    assert (made.duration, made.end_velocity) == pytest.approx((0.2, v1))
    assert (made.end, made.position(0.2)) == pytest.approx((3.0 + distance, 3.0 + distance))


# Target, speed, rates and jerks, velocity, acceleration, and the jerk that takes the acceleration to zero.
FAR_APART = [
    (-1e5, 1e8, (5e-8, 5e6, 0.2, 20.0), -2000.0, 0.05, -20.0),
    (1e5, 1e8, (5e-8, 5e6, 0.2, 20.0), 2000.0, -0.05, 20.0),
]


@pytest.mark.parametrize(("target", "speed", "rates", "v0", "a0", "jerk"), FAR_APART)
def test_limits_that_are_too_far_apart_for_a_sum(
    target: float, speed: float, rates: tuple[float, float, float, float], v0: float, a0: float, jerk: float
) -> None:
    """The acceleration is ramped down first: speeding up or slowing down has its jerk."""
    made = plan_jerk(0.0, target, speed, *rates, v0, a0)
    time = abs(a0 / jerk)
    eased = ease(0.0, v0, a0, abs(jerk))
    rest = approach(JerkRamps(*rates), eased.end, target, speed, eased.end_velocity)
    assert made.at(0.0).jerk == pytest.approx(jerk, rel=1e-4)
    assert made.duration == time + rest.duration
    assert made.end == target
    assert made.position(0.5 * made.duration) == pytest.approx(
        rest.position(0.5 * made.duration - time), rel=1e-6
    )


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("first", "second"), list(combinations(range(4), 2)))
def test_two_figures_that_are_too_large_are_reported_by_the_first(
    first: int, second: int, sign: float
) -> None:
    """Their difference is 0, but each is twice the bound."""
    figures = [0.0, 1.0, 1.0, 1.0]
    figures[first], figures[second] = 2.0 * LARGEST, 2.0 * LARGEST * sign
    start, target, v0, a0 = figures
    name = ("position", "target", "start velocity", "start acceleration")[first]
    with pytest.raises(ValueError, match=f"^{name} must lie between -1e\\+60 and 1e\\+60$"):
        plan_jerk(start, target, 1.0, *RATES, v0, a0)


def test_the_largest_speed_is_still_a_speed() -> None:
    """A move of 8 at rates and jerks of 1 does not come near it."""
    limits = (1.0, 1.0, 1.0, 1.0)
    assert plan_jerk(0.0, 8.0, LARGEST, *limits).duration == plan_jerk(0.0, 8.0, 100.0, *limits).duration
    with pytest.raises(ValueError, match="speed must lie between 1e-60 and 1e"):
        plan_jerk(0.0, 8.0, 2.0 * LARGEST, *limits)
