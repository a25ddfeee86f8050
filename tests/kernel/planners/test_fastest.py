"""Plans are as fast as their limits allow, from random states.

They are compared with a second implementation (`times.py`), with closed forms, and with ruckig, a time-optimal planner.
The proof of a run does not cover this: it checks limits, continuity and ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import inf
from random import Random
from typing import NamedTuple

import numpy as np
import pytest
from ruckig import InputParameter, Result, Ruckig, RuckigError, Trajectory

from motionlang.kernel.planners import plan, plan_stop, plan_velocity
from motionlang.kernel.planners.lookahead import PathPace, plan_course
from tests.kernel.planners.states import drawn
from tests.kernel.planners.times import Law, ends_together, law, lead, move_times, ramp, reverses, rounding

# The shapes, each with the name and the ramp of the planner.
SHAPES = {
    "trapezoid": ("trapezoid", 0.0),
    "jerk": ("scurve", 0.0),
    "ratio": ("scurve", 0.2),
    "sinusoidal": ("sinusoidal", 0.0),
    "parabolic": ("parabolic", 0.0),
}
# States in an ordinary run, and in each of ten slices of a long one.
FEW, MANY = 300, 10_000
# States from which a plan brakes twice and so is slower than ruckig's, of a hundred; and by how much.
TWICE, SLOWER = 0.01, 1.4
EXACT = 1e-9


class State(NamedTuple):
    """A state, a target and the limits of a move."""

    start: float
    target: float
    speed: float
    rates: tuple[float, float]
    jerks: tuple[float, float]
    v0: float
    a0: float

    @property
    def distance(self) -> float:
        return self.target - self.start


def states(seed: int, count: int, shape: str) -> Iterator[State]:
    """Yield random states; only jerk-limited ones have an acceleration."""
    smooth = shape == "jerk"
    found = drawn(np.random.default_rng(seed), count, "scurve" if smooth else shape)
    columns = (found.start, found.target, found.speed, *found.rates, *found.jerks, found.v0, found.a0)
    for row in zip(*(each.tolist() for each in columns), strict=True):
        start, target, speed, up, down, up_jerk, down_jerk, v0, a0 = row
        jerks = (up_jerk, down_jerk) if smooth else (inf, inf)
        yield State(start, target, speed, (up, down), jerks, v0, a0)


def law_of(state: State, shape: str) -> Law:
    name, ratio = SHAPES[shape]
    return law(name, state.rates, state.jerks, ratio)


def moves_take_the_least_time(seed: int, count: int, shape: str) -> None:
    name, ratio = SHAPES[shape]
    for each in states(seed, count, shape):
        made = plan(
            name, each.start, each.target, each.speed, *each.rates, each.v0, ratio, *each.jerks, each.a0
        )
        rounded = rounding(each.distance, each.start, each.target)
        least, most = move_times(each.v0, each.a0, each.distance, each.speed, law_of(each, shape), rounded)
        assert least * (1.0 - EXACT) - EXACT <= made.duration <= most * (1.0 + EXACT) + EXACT, each


def velocities_are_reached_in_the_least_time(seed: int, count: int, shape: str) -> None:
    name, ratio = SHAPES[shape]
    for each in states(seed, count, shape):
        by, (up, down) = law_of(each, shape), each.jerks
        for goal in (0.0, each.speed, -0.5 * each.speed):
            made = plan_velocity(name, each.start, each.v0, goal, *each.rates, ratio, up, down, each.a0)
            took = made.knots[-1] if made.knots[-1] < inf else made.knots[-2]
            most = lead(each.v0, each.a0, goal, by)[0]
            least = most if goal else min(most, ends_together(each.v0, each.a0, by))
            assert least * (1.0 - EXACT) - EXACT <= took <= most * (1.0 + EXACT) + EXACT, (each, goal)
        stop = plan_stop(name, each.start, each.v0, each.rates[1], ratio, down, each.a0, up)
        least, most = lead(each.v0, each.a0, 0.0, by)[0], ends_together(each.v0, each.a0, by)
        # A stop has only a deceleration, also for a velocity in the other direction after a reversal.
        if not reverses(each.v0, each.a0, by) and not reverses(-each.v0, -each.a0, by):
            assert stop.duration == pytest.approx(least, rel=EXACT, abs=EXACT) or most < inf, each


def optimal_time(each: State) -> float | None:
    """Return ruckig's time from a state in the direction of the target; None if it finds none.

    Lengths are counted in units of the speed, as its figures are absolute.
    """
    sign, unit = (1.0 if each.distance >= 0.0 else -1.0), each.speed
    given, found = InputParameter(1), Trajectory(1)
    given.current_position, given.target_position = [0.0], [abs(each.distance) / unit]
    given.current_velocity, given.current_acceleration = [sign * each.v0 / unit], [sign * each.a0 / unit]
    given.max_velocity, given.min_velocity = [1.0], [-1.0]
    given.max_acceleration, given.min_acceleration = [each.rates[0] / unit], [-each.rates[1] / unit]
    given.max_jerk = [each.jerks[0] / unit]
    try:
        result = Ruckig(1).calculate(given, found)
    except RuckigError:  # it gives up on some states
        return None
    return float(found.duration) if result in (Result.Working, Result.Finished) else None


def goes_forward(each: State) -> bool:
    """True if a move has its speed and its direction from the beginning, and can stop at its target.

    Others come to rest first, or slow down: ruckig has other rules for these.
    """
    sign, by = (1.0 if each.distance >= 0.0 else -1.0), Law(each.rates, each.jerks)
    v0, a0 = sign * each.v0, sign * each.a0
    if v0 < 0.0 or (v0 == 0.0 and a0 < 0.0) or reverses(v0, a0, by):
        return False
    peak = v0 + (0.5 * a0 * a0 / each.jerks[0] if a0 > 0.0 else 0.0)
    return peak <= each.speed and lead(v0, a0, 0.0, by)[1] <= abs(each.distance)


def moves_are_as_fast_as_those_of_ruckig(seed: int, count: int, shape: str) -> None:
    name, compared, slower = SHAPES[shape][0], 0, 0
    for each in states(seed, count, shape):
        each = each._replace(jerks=(each.jerks[0],) * 2)  # ruckig has one jerk
        least = optimal_time(each) if goes_forward(each) else None
        if least is None:
            continue
        made = plan(
            name, each.start, each.target, each.speed, *each.rates, each.v0, 0.0, *each.jerks, each.a0
        )
        assert least * (1.0 - EXACT) <= made.duration <= least * SLOWER + EXACT, each
        compared, slower = compared + 1, slower + (made.duration > least * (1.0 + EXACT))
    assert compared > count / 5
    assert slower <= TWICE * compared * (shape == "jerk")


def courses_of_one_pace_take_the_time_of_a_move(seed: int, count: int, shape: str) -> None:
    """A course of one segment is as long as a move; a trapezoid's may have several."""
    (name, ratio), choose = SHAPES[shape], Random(seed)
    for each in states(seed, count, shape):
        by, length, v0 = law_of(each, shape), abs(each.distance), min(abs(each.v0), each.speed)
        if lead(v0, 0.0, 0.0, by)[1] > length * (1.0 - EXACT):
            v0 = 0.0
        shares = sorted(choose.random() for _ in range(choose.randint(0, 3) * (shape == "trapezoid")))
        pace = PathPace(name, each.speed, *each.rates, ratio, *each.jerks)
        lengths = [(last - first) * length for first, last in pairwise((0.0, *shares, 1.0))]
        made = plan_course([(each, pace) for each in lengths], 0.0, v0)
        least, most = move_times(v0, 0.0, length, each.speed, by, rounding(length, length))
        assert made is not None
        assert least * (1.0 - EXACT) - EXACT <= made.duration <= most * (1.0 + EXACT) + EXACT, each


def courses_that_speed_up_take_the_time_of_their_ramps(seed: int, count: int, shape: str) -> None:
    """The second of two segments is faster and has room: it is entered at the speed of the first."""
    (name, ratio), choose = SHAPES[shape], Random(seed)
    for each in states(seed, count, shape):
        by, slow, fast = law_of(each, shape), choose.uniform(0.1, 0.9) * each.speed, each.speed
        first, between, last = ramp(0.0, slow, by), ramp(slow, fast, by), ramp(fast, 0.0, by)
        lengths = first[1] + choose.random() * slow, between[1] + last[1] + choose.random() * fast
        paces = [PathPace(name, speed, *each.rates, ratio, *each.jerks) for speed in (slow, fast)]
        made = plan_course(list(zip(lengths, paces, strict=True)), 0.0, 0.0)
        holds = (lengths[0] - first[1]) / slow + (lengths[1] - between[1] - last[1]) / fast
        time = first[0] + between[0] + last[0] + holds
        assert made is not None
        assert made.duration == pytest.approx(time, rel=EXACT), each


CHECKS = (
    [(moves_take_the_least_time, shape) for shape in SHAPES]
    + [(velocities_are_reached_in_the_least_time, shape) for shape in SHAPES]
    + [(courses_of_one_pace_take_the_time_of_a_move, shape) for shape in SHAPES]
    + [(courses_that_speed_up_take_the_time_of_their_ramps, shape) for shape in SHAPES]
    + [(moves_are_as_fast_as_those_of_ruckig, shape) for shape in ("trapezoid", "jerk")]
)


@pytest.mark.parametrize(("check", "shape"), CHECKS)
def test_plans_are_as_fast_as_allowed(check: object, shape: str) -> None:
    assert callable(check)
    check(1, FEW, shape)


@pytest.mark.long
@pytest.mark.parametrize(("check", "shape"), CHECKS)
@pytest.mark.parametrize("seed", range(10, 20))
def test_many_plans_are_as_fast_as_allowed(check: object, shape: str, seed: int) -> None:
    assert callable(check)
    check(seed, MANY, shape)
