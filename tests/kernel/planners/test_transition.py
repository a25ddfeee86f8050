"""Transitions from any velocity and acceleration.

Nothing jumps, all limits are observed, and the required state is reached.
"""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random

import pytest

from motionlang.kernel.planners import Profile, plan, plan_stop, plan_velocity


def check(
    made: Profile, v0: float, a0: float, accel: float, decel: float, jerks: tuple[float, float]
) -> None:
    """Check piece by piece: continuous acceleration, rates and jerks within limits.

    The limits depend on the direction.
    """
    state = made.at(0.0)
    assert (state.velocity, state.acceleration) == pytest.approx((v0, a0), rel=1e-9, abs=1e-9)
    velocity, acceleration = v0, a0
    top = 1.0 + max(abs(v0), made.peak_speed)
    for begin, finish in pairwise(made.knots):
        if finish - begin < 1e-9 or math.isinf(finish):
            continue
        first, last = made.at(begin), made.at(math.nextafter(finish, begin))
        assert first.velocity == pytest.approx(velocity, rel=1e-7, abs=1e-7 * top), begin
        assert first.acceleration == pytest.approx(acceleration, rel=1e-6, abs=1e-6 * (accel + decel)), begin
        velocity, acceleration = last.velocity, last.acceleration
        middle = made.at(0.5 * (begin + finish))
        speeding = middle.acceleration * middle.velocity > 0.0
        assert abs(middle.jerk) <= (jerks[0] if speeding else jerks[1]) * (1.0 + 1e-9)
        if abs(a0) <= min(accel, decel):
            assert abs(middle.acceleration) <= (accel if speeding else decel) * (1.0 + 1e-9)


def limits(random: Random) -> tuple[float, float, float, tuple[float, float]]:
    """Return random speed, acceleration, deceleration and jerks."""
    return (
        random.uniform(5, 100),
        random.uniform(50, 500),
        random.uniform(50, 500),
        (random.uniform(500, 5000), random.uniform(500, 5000)),
    )


def state(random: Random, made: Profile) -> tuple[float, float, float]:
    here = made.at(random.random() * min(made.duration, 20.0))
    return here.position, here.velocity, here.acceleration


def moved(seed: int) -> None:
    """Change the target in the middle of a move."""
    random = Random(seed)
    speed, accel, decel, jerks = limits(random)
    first = plan("scurve", 0.0, random.uniform(-100, 100), speed, accel, decel, 0.0, 0.0, *jerks)
    p, v, a = state(random, first)
    target = random.choice([random.uniform(-150, 150), p + math.copysign(random.uniform(0, 5), v or 1.0)])
    made = plan("scurve", p, target, speed, accel, decel, v, 0.0, *jerks, a)
    check(made, v, a, accel, decel, jerks)
    assert (made.end, made.end_velocity) == (target, 0.0)
    before = made.at(made.duration * (1.0 - 1e-12))
    assert before.position == pytest.approx(target, abs=1e-6 * (1.0 + abs(target)))
    assert made.peak_speed <= max(speed, abs(v)) * (1.0 + 1e-9) or abs(v) + abs(a) ** 2 / jerks[0] > speed


def test_rounding_leaves_no_stretch_of_less_than_no_time() -> None:
    moved(12_566)  # its first section would take -2e-17 s


def test_a_stop_out_of_a_ramp_takes_each_side_back_at_its_own_jerk() -> None:
    """At a jerk of 4000 the rate of 320 is zero after 0.08 s, at 25.6 and 2.048.

    Two ramps at a jerk of 1500 then stop it in 0.2613 s.
    """
    made = plan_stop("scurve", 4000.0 * 0.08**3 / 6.0, 12.8, 250.0, 0.0, 1500.0, 320.0, 4000.0)
    assert made.end == pytest.approx(2.048 + 25.6 * math.sqrt(25.6 / 1500.0), rel=1e-12)


def test_a_move_planned_again_in_its_middle_takes_the_time_it_had_left() -> None:
    """The best plan from the beginning is the best from every state in between.

    This applies to ramps and slew.
    """
    random = Random(3)
    for _ in range(300):
        speed, accel, decel, jerks = limits(random)
        target = random.uniform(1, 200) * random.choice([-1.0, 1.0])
        whole = plan("scurve", 0.0, target, speed, accel, decel, 0.0, 0.0, *jerks)
        time = random.uniform(0.01, 0.99) * whole.duration
        here = whole.at(time)
        rest = plan(
            "scurve",
            here.position,
            target,
            speed,
            accel,
            decel,
            here.velocity,
            0.0,
            *jerks,
            here.acceleration,
        )
        assert rest.duration == pytest.approx(whole.duration - time, rel=1e-6, abs=1e-6)
        assert rest.extrema()[1] <= max(0.0, target) + 1e-6


def test_a_stop_that_has_hardly_begun_takes_its_own_time_whatever_its_velocity() -> None:
    """A stop from v takes 2 sqrt(v/j), here without the nanosecond that has passed.

    A velocity of 1e-9 is a trillionth of that in a ramp to 100 000, and was once dropped as rounding.
    """
    for velocity in (1e-3, 1e-9, 1e-11):
        whole = 2.0 * math.sqrt(velocity / 1e6)
        begun = velocity - 0.5 * 1e6 * 1e-18
        made = plan_stop("scurve", 0.0, begun, 1e5, 0.0, 1e6, -1e-3)
        assert made.duration == pytest.approx(whole - 1e-9, rel=1e-6)
        back = plan("scurve", 0.0, -1.0, 10.0, 1e5, 1e5, begun, 0.0, 1e6, 1e6, -1e-3)
        assert back.phases[0].duration == pytest.approx(whole - 1e-9, rel=1e-6)


def test_a_ramp_that_has_hardly_begun_is_taken_back_whole() -> None:
    """A deceleration of J·t has cost J·t²/2 after t s.

    It costs as much again until it is zero. A ramp regains J·t² in 2·t, so that all takes 3·t, even if the
    velocity has changed by 1 in 10¹⁴.
    """
    jerk, lasted = 1e6, 1e-9
    slowed = 46.6 - 0.5 * jerk * lasted**2
    made = plan_velocity("scurve", 0.0, slowed, 46.6, 1e3, 1e3, 0.0, jerk, jerk, -jerk * lasted)
    assert made.knots[-2] == pytest.approx(3.0 * lasted, rel=0.02)


def test_a_stop_that_is_nearly_over_is_finished_however_short_it_is() -> None:
    """A stop over 2·t has its peak deceleration of J·t at t.

    At d before that, the deceleration is J·(t - d) and the velocity J·(t²/2 + t·d - d²/2). It takes t + d more.
    """
    jerk, t, d = 1e4, 1e-8, 1e-8 / 8.0
    velocity = jerk * (0.5 * t * t + t * d - 0.5 * d * d)
    made = plan_velocity("scurve", 0.0, velocity, 0.0, 1e5, 1e5, 0.0, jerk, jerk, -jerk * (t - d))
    assert made.knots[-2] == pytest.approx(t + d)
