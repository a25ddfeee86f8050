"""A position on ramps without a reversal is found like on any other profile."""

from __future__ import annotations

import random
from math import inf

import pytest

from motionlang.kernel.planners import Profile, from_curve, hold, plan, plan_velocity
from tests.cases import cases, examples


def profiles(seed: int) -> list[Profile]:
    """Return moves, jogs and stops in one direction, from rest or at speed."""
    numbers = random.Random(seed)
    sign, start = numbers.choice((-1.0, 1.0)), numbers.choice((0.0, numbers.uniform(-1e4, 1e4)))
    distance, speed = numbers.uniform(1.0, 1e4), numbers.uniform(1.0, 1e3)
    rates = numbers.uniform(10.0, 1e4), numbers.uniform(10.0, 1e4)
    shape = numbers.choice(("trapezoid", "scurve", "sinusoidal", "parabolic"))
    move = plan(shape, start, start + sign * distance, speed, *rates, ramp=0.3)
    jog = plan_velocity("trapezoid", start, sign * speed * numbers.random(), sign * speed, *rates)
    stop = plan_velocity("trapezoid", start, sign * speed, 0.0, *rates)
    return [move, jog, stop, move.scaled(start, -0.5)]


def as_pieces(profile: Profile) -> Profile:
    """Return the same motion without its ramps. A search takes all of its pieces."""
    ends = profile.start, profile.end
    made = from_curve(profile.shape, *ends, profile.curve, profile.start_velocity, profile.end_velocity)
    made.duration = profile.duration
    return made


@pytest.mark.parametrize("seed", range(examples(40)))
def test_crossings_have_the_same_bits_as_a_search_of_all_pieces(seed: int) -> None:
    numbers = random.Random(seed + 1000)
    for profile in profiles(seed):
        searched = as_pieces(profile)
        assert profile.direction
        assert not searched.direction
        last = profile.duration if profile.duration < inf else 5.0
        times = [0.0, last, *profile.knots[:-1], *(numbers.uniform(0.0, 1.2 * last) for _ in range(12))]
        positions = [profile.position(time) for time in times]
        positions += [profile.position(numbers.uniform(0.0, last)) for _ in range(12)]
        positions += [position + 1e-12 * position for position in positions]
        positions += [profile.start - 1.0, profile.start + 1.0, profile.position(last) + 1.0]
        for position in positions:
            for after in (0.0, last, last + 1.0, numbers.uniform(0.0, last), *profile.knots[1:-1]):
                assert profile.crossing(position, after) == searched.crossing(position, after)


@cases(
    "profile, direction",
    (
        (plan("trapezoid", 0.0, 5.0, 1.0, 1.0, 1.0), 1.0),
        (plan("trapezoid", 0.0, -5.0, 1.0, 1.0, 1.0), -1.0),
        (plan("trapezoid", 0.0, 5.0, 1.0, 1.0, 1.0, -2.0), 0.0),
        (plan_velocity("trapezoid", 0.0, 0.0, -3.0, 1.0, 1.0), -1.0),
        (plan_velocity("trapezoid", 0.0, 2.0, -3.0, 1.0, 1.0), 0.0),
        (hold(3.0), 0.0),
    ),
)
def test_the_direction_is_that_of_all_ramps(profile: Profile, direction: float) -> None:
    assert profile.direction == direction
