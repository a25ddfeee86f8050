"""Seen from inside: transitions from any velocity and acceleration."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest

from motionlang.kernel.planners import plan, plan_stop, plan_velocity
from motionlang.kernel.planners.evaluate import evaluate
from motionlang.kernel.planners.lookahead import PathPace, plan_course
from motionlang.kernel.planners.ramp_down import stop_in_motion
from motionlang.kernel.planners.shapes import JerkRamps
from motionlang.kernel.planners.transition import (
    distance_of_steps,
    eased_speed,
    initial_steps,
    profile_of_steps,
)
from tests.cases import examples
from tests.kernel.planners.test_transition import check, limits, moved, state


def stopped(seed: int) -> None:
    """Stop in the middle of a move, or change the speed of a jog."""
    random = Random(seed)
    speed, accel, decel, jerks = limits(random)
    first = plan("scurve", 0.0, random.uniform(1, 100), speed, accel, decel, 0.0, 0.0, *jerks)
    p, v, a = state(random, first)
    made = plan_stop("scurve", p, v, decel, 0.0, jerks[1], a, jerks[0])
    check(made, v, a, accel, decel, jerks)
    assert made.end <= first.end + 1e-9
    v1 = random.uniform(-1.0, 1.0) * speed
    jogged = plan_velocity("scurve", p, v, v1, accel, decel, 0.0, *jerks, a)
    check(jogged, v, a, accel, decel, jerks)
    assert jogged.end_velocity == v1


def coursed(seed: int) -> None:
    """Plan a course with several speeds again from its middle."""
    random = Random(seed)
    _, accel, decel, jerks = limits(random)
    stretches = [
        (random.uniform(0.1, 40), PathPace("scurve", random.uniform(5, 60), accel, decel, 0.0, *jerks))
        for _ in range(random.randint(1, 8))
    ]
    end = sum(length for length, _ in stretches)
    first = plan_course(stretches, 0.0, 0.0)
    assert first is not None
    check(first, 0.0, 0.0, accel, decel, jerks)
    assert first.end == pytest.approx(end, rel=1e-12)
    p, v, a = state(random, first)
    again = plan_course(stretches, p, v, a)
    if again is None:
        assert first.duration - first.crossing(p) < 2.0 * (decel / jerks[1] + v / decel)  # type: ignore[operator]
        return
    check(again, v, a, accel, decel, jerks)
    position = 0.0
    for length, pace in stretches:
        position += length
        for made in (first, again):
            time = made.crossing(0.5 * (2.0 * position - length)) if position - 0.5 * length > p else None
            assert time is None or made.velocity(time) <= pace.speed * (1.0 + 1e-9)


@pytest.mark.parametrize("case", [moved, stopped, coursed])
def test_changes_in_the_middle(case: object) -> None:
    assert callable(case)
    for seed in range(examples(200)):
        case(seed)


@pytest.mark.long
@pytest.mark.parametrize("case", [moved, stopped, coursed])
def test_many_changes_in_the_middle(case: object) -> None:
    assert callable(case)
    for seed in range(1000, 101_000):
        case(seed)


@pytest.mark.parametrize(("shape", "ramp"), [("sinusoidal", 0.0), ("scurve", 0.1), ("scurve", 0.35)])
def test_a_stop_out_of_a_shaped_ramp_does_not_jump(shape: str, ramp: float) -> None:
    planned = plan(shape, 0.0, 500.0, 80.0, 400.0, 250.0, ramp=ramp)
    for k in range(1, 200):
        time = planned.duration * k / 200.0
        made = stop_in_motion(planned, time, shape, 250.0, ramp)
        here = planned.at(time)
        assert made.at(0.0).velocity == pytest.approx(here.velocity, rel=1e-9)
        assert made.at(0.0).acceleration == pytest.approx(here.acceleration, rel=1e-9, abs=1e-6)
        assert made.end <= 500.0
        assert made.end_velocity == 0.0
        bends = evaluate(made, np.linspace(0.0, made.duration, 2001)[:-1], 2)
        # an acceleration of 400 over the shortest flank there is here
        assert np.abs(np.diff(bends)).max() < 0.15 * 400.0


def test_a_stop_late_in_the_last_ramp_changes_nothing() -> None:
    for shape, ramp, jerk in (
        ("sinusoidal", 0.0, math.inf),
        ("scurve", 0.2, math.inf),
        ("scurve", 0.0, 3000.0),
    ):
        planned = plan(shape, 0.0, 500.0, 80.0, 400.0, 250.0, 0.0, ramp, jerk, jerk)
        made = stop_in_motion(planned, planned.duration - 0.1, shape, 250.0, ramp, jerk, jerk)
        assert made.end == pytest.approx(500.0, abs=1e-9)
        assert made.duration == pytest.approx(0.1, abs=1e-9)


def test_figures_of_any_size_are_planned_or_refused_by_name() -> None:
    random = Random(2)

    def size() -> float:
        return float(10.0 ** random.choice([0.0, random.uniform(-12, 12), random.uniform(-300, 300)]))

    for _ in range(1000):
        bend = random.choice([0.0, size(), -size()])
        shape = random.choice(["trapezoid", "scurve", "parabolic", "sinusoidal"])
        stretches = [
            (size(), PathPace(shape, size(), size(), size(), 0.1, size(), size()))
            for _ in range(random.randint(1, 4))
        ]
        try:
            made = plan("scurve", 0.0, size(), size(), size(), size(), size(), 0.0, size(), size(), bend)
            course = plan_course(stretches, 0.0, 0.0)
        except ValueError:
            continue
        assert made.duration >= 0.0
        assert course is not None
        assert course.duration >= 0.0


UP_DOWN = JerkRamps(100.0, 80.0, 400.0, 200.0)


# The velocity and acceleration, the velocity to reach, the steps by jerk and time, and the velocity after them.
STEPS: dict[str, tuple[float, float, float, tuple[tuple[float, float], ...], float]] = {
    "up, at the rate for 0.2 s": (
        8.0, 80.0, 45.0, ((400.0, 0.05), (0.0, 0.2), (-400.0, 0.25)), 45.0,
    ),
    "just the last flank": (8.0, 80.0, 16.0, ((-400.0, 0.2),), 16.0),
    "more than the last flank": (10.0, 80.0, 16.0, ((-400.0, 0.2),), 18.0),
    "above the rate": (0.0, 120.0, 38.0, ((-400.0, 0.05), (0.0, 0.2), (-400.0, 0.25)), 38.0),
    "down, at the rate": (50.0, -40.0, 10.0, ((-200.0, 0.2), (0.0, 0.15), (200.0, 0.4)), 10.0),
    "down, below the rate": (18.0, -20.0, 11.0, ((-200.0, 0.1), (0.0, 0.0), (200.0, 0.2)), 11.0),
    "down, above the rate": (50.0, -100.0, 10.0, ((200.0, 0.1), (0.0, 0.1875), (200.0, 0.4)), 10.0),
    "just the last flank down": (14.0, -40.0, 10.0, ((200.0, 0.2),), 10.0),
    "more than the last flank down": (13.0, -40.0, 10.0, ((200.0, 0.2),), 9.0),
    "beyond rest": (3.0, -40.0, 0.0, ((200.0, 0.2),), -1.0),
}  # fmt: skip


@pytest.mark.parametrize("name", STEPS)
def test_the_first_steps_towards_a_velocity(name: str) -> None:
    """80 falls to 0 in 0.2 s at 400, and gains 8; 40 does at 200, and costs 4."""
    v0, a0, v1, steps, reached = STEPS[name]
    found, last = initial_steps(UP_DOWN, v0, a0, v1)
    assert last == pytest.approx(reached)
    assert len(found) == len(steps)
    for step, expected in zip(found, steps, strict=True):
        assert step == pytest.approx(expected, abs=1e-12)
    velocity, acceleration, distance = v0, a0, 0.0
    for jerk, time in steps:
        distance += velocity * time + acceleration * time**2 / 2.0 + jerk * time**3 / 6.0
        velocity += acceleration * time + jerk * time**2 / 2.0
        acceleration += jerk * time
    assert (velocity, acceleration) == pytest.approx((reached, 0.0), abs=1e-9)
    assert distance_of_steps(v0, a0, found) == pytest.approx(distance)
    for sign in (1.0, -1.0):
        made = profile_of_steps(7.0, v0, a0, found, last, sign)
        assert (made.start_velocity, made.end_velocity) == pytest.approx((sign * v0, sign * last))
        assert made.distance == pytest.approx(sign * distance)
        assert made.duration == pytest.approx(sum(time for _, time in steps))
        assert made.acceleration(0.0) == pytest.approx(sign * a0)
        assert made.phases[0].name == ("accel" if abs(reached) > v0 else "decel")


@pytest.mark.parametrize("v1", [math.nextafter(9.0, 0.0), math.nextafter(9.0, math.inf)])
def test_a_last_flank_ends_at_the_speed_itself_whatever_is_rounded(v1: float) -> None:
    """From 13, the deceleration of 40 falls at 200 to the velocity 13 - 40²/400 = 9."""
    assert initial_steps(UP_DOWN, 13.0, -40.0, v1) == (((200.0, 0.2),), v1)


@pytest.mark.parametrize(("a0", "expected"), [(80.0, 18.0), (-80.0, -6.0), (0.0, 10.0)])
def test_the_velocity_after_an_acceleration_was_ramped_down(a0: float, expected: float) -> None:
    assert eased_speed(UP_DOWN, 10.0, a0) == expected
