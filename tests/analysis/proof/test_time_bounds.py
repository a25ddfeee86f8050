"""The time bounds of a proof agree with the planners for random states.

The two share no code.
"""

from __future__ import annotations

import os
from random import Random

import pytest

from motionlang.analysis.proof.time_bounds import (
    Law,
    law,
    lead,
    move_time,
    move_times,
    ramp,
    reverses,
    rounding,
    top_speed,
)
from motionlang.planners import Profile, plan, plan_jerk, plan_velocity

COUNT = int(os.environ.get("MOTIONLANG_LONG", "2000"))
PMC = ("sinusoidal", "parabolic", "scurve")


class State:
    """A random state and target, over orders of magnitude.

    The acceleration is one that occurs in a ramp.
    """

    def __init__(self, choose: Random, shape: str) -> None:
        self.shape = shape
        self.speed = 10.0 ** choose.uniform(-1.0, 4.0)
        self.rates = [self.speed * 10.0 ** choose.uniform(-1.0, 2.0) for _ in range(2)]
        self.jerks = [rate * 10.0 ** choose.uniform(-0.5, 2.5) for rate in self.rates]
        self.v0 = choose.uniform(-1.5, 1.5) * self.speed * (choose.random() < 0.8)
        self.a0 = 0.0
        if shape == "scurve" and choose.random() < 0.7:
            self.a0 = choose.choice((-1.0, 1.0)) * choose.random() * min(self.rates)
            # Less than would carry the velocity through rest.
            jerk = self.jerks[self.a0 * self.v0 < 0.0]
            if self.a0 * self.v0 < 0.0 and self.a0 * self.a0 > 2.0 * jerk * abs(self.v0):
                self.a0 = 0.0
        self.start = choose.uniform(-1.0, 1.0) * self.speed
        self.target = self.start + choose.choice((1.0, 10.0, 0.01)) * choose.uniform(-3.0, 3.0) * self.speed

    def planned(self) -> Profile:
        jerks = self.jerks if self.shape == "scurve" else [float("inf")] * 2
        rates, numbers = self.rates, (self.start, self.target, self.speed)
        return plan(self.shape, *numbers, rates[0], rates[1], self.v0, 0.0, jerks[0], jerks[1], self.a0)


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


LIMITED = Law((100.0, 80.0), (400.0, 200.0))
LINEAR = Law((100.0, 100.0))


@pytest.mark.parametrize(
    ("v0", "a0", "margin", "expected"),
    [
        (0.5, -20.0, 1e-9, True),
        (1.0, -20.0, 1e-9, False),
        (1.0, -20.0, -1e-6, True),
        (1.0 + 2e-6, -20.0, -1e-6, False),
        (1.0 - 2e-6, -20.0, 1e-6, True),
        (0.5, 20.0, 1e-9, False),
        (0.0, 0.0, -1e-6, False),
    ],
)
def test_a_velocity_reverses_before_its_acceleration_is_ramped_down(
    v0: float, a0: float, margin: float, expected: bool
) -> None:
    """At a jerk of 200 a deceleration of 20 takes another 20² / (2 * 200) = 1 away."""
    assert reverses(v0, a0, LIMITED, margin) is expected
    assert not reverses(v0, a0, LINEAR, margin)


def test_a_distance_is_as_exact_as_its_ends() -> None:
    """A sum is rounded nine times, by 2⁻⁵³: 2000 is exact to 9 * 2000 / 2⁵³."""
    assert rounding(-100.0, 5.0, -2000.0) == pytest.approx(1e-11 + 9 * 2000 / 2**53, abs=1e-20)
    assert rounding(0.0, 3000.0, 5.0) == pytest.approx(9 * 3000 / 2**53, abs=1e-20)


def test_a_velocity_may_end_with_its_acceleration_but_for_rounding() -> None:
    """At a jerk of 200, 20 ends in 0.1 s, with a velocity of 20² / (2 * 200) = 1.

    Of a velocity 4e-12 lower, the rest needs another ramp, of 2 sqrt(4e-12 / 200) = 2.8e-7 s.
    """
    back = lead(1.0 - 4e-12, -20.0, 0.0, LIMITED)
    assert back[0] == pytest.approx(0.1 + 2.0 * (4e-12 / 200.0) ** 0.5, abs=1e-9)
    distance = 1.0 / 30.0  # 1 * 0.1 - 20 * 0.1² / 2 + 200 * 0.1³ / 6
    assert move_times(1.0 - 4e-12, -20.0, distance, 10.0, LIMITED, 1e-11)[0] == pytest.approx(0.1, abs=1e-15)
    assert move_times(1.0 - 4e-5, -20.0, back[1], 10.0, LIMITED, 1e-4)[0] > 0.1


# The velocity, the distance, its rounding, and the shortest and the longest time at a speed of 10.
TIMES: dict[str, tuple[float, float, float, float, float]] = {
    "exact, from rest": (0.0, 10.0, 0.0, 1.1, 1.1),
    "from rest, 0.5 at the speed": (0.0, 10.0, 0.5, 1.05, 1.1),
    "from rest, in reverse": (0.0, -10.0, 0.5, 1.05, 1.1),
    "just a stop, or 0.02 from a standstill": (10.0, 0.5, 0.02, 0.1, 0.1 + 2.0 * 0.0002**0.5),
    "0.01 more than a stop": (10.0, 0.51, 0.02, 0.1, 0.12),
    "0.01 less than a stop": (10.0, 0.49, 0.02, 0.1, 0.1 + 2.0 * 0.0003**0.5),
    "far more than a stop": (10.0, 10.5, 0.5, 1.05, 1.15),
}  # fmt: skip


@pytest.mark.parametrize("name", TIMES)
def test_a_rounded_distance_takes_from_a_shortest_to_a_longest_time(name: str) -> None:
    """At 100 a stop from 10 takes 0.1 s over 0.5; d from rest takes 2 sqrt(d / 100) s."""
    v0, distance, rounded, least, most = TIMES[name]
    assert move_times(v0, 0.0, distance, 10.0, LINEAR, rounded) == pytest.approx((least, most))


# The velocity, the acceleration and the velocity to reach, and the time and the distance of the ramp. At a
# jerk of 400 a change of v takes 2 sqrt(v / 400) up to 25, at 200 2 sqrt(v / 200) up to 32. A flank of T s from v
# with an acceleration a and a jerk J covers v T + a T² / 2 - J T³ / 6.
RAMPS: dict[str, tuple[float, float, float, float, float]] = {
    "nothing to do": (10.0, 0.0, 10.0, 0.0, 0.0),
    "from rest, in reverse": (0.0, 0.0, -16.0, 0.4, -3.2),
    "at the rate for 0.4 s": (0.0, 0.0, 65.0, 0.65 + 0.25, 0.9 * 32.5),
    "just the last flank": (8.0, 80.0, 16.0, 0.2, 1.6 + 1.6 - 3.2 / 6.0),
    "less than the last flank": (10.0, 80.0, 16.0, 0.2 + 0.2, 2.0 + 1.6 - 3.2 / 6.0 + 0.2 * 17.0),
    "above the rate, at the rate, and a flank": (
        0.0, 120.0, 38.0, 0.05 + 0.2 + 0.25,
        (0.15 - 0.05 / 6.0) + (1.1 + 2.0) + (6.375 + 3.125 - 6.25 / 6.0),
    ),
    "braking ends first: 16 in 0.4 s": (
        17.0, -80.0, 17.0, 0.4 + 0.4, (6.8 - 6.4 + 12.8 / 6.0) + 0.4 * 9.0,
    ),
    "braking ends first, at rest": (16.0, -80.0, 1.0, 0.4 + 0.1, (6.4 - 6.4 + 12.8 / 6.0) + 0.1 * 0.5),
    "through rest": (8.0, 0.0, -16.0, 0.4 + 0.4, 0.4 * 4.0 - 0.4 * 8.0),
    "through rest as its braking ends": (
        2.0, -80.0, -30.0, 0.4 + 0.4, (0.8 - 6.4 + 12.8 / 6.0) - 0.4 * 22.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("name", RAMPS)
def test_a_ramp_from_an_acceleration_by_hand(name: str, way: float) -> None:
    v0, a0, v1, time, distance = RAMPS[name]
    found = lead(way * v0, way * a0, way * v1, LIMITED)
    assert found == pytest.approx((time, way * distance), abs=1e-12)
