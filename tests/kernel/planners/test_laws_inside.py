"""Seen from inside: the laws of motion, each for every planner: a table "law x planner"."""

from __future__ import annotations

import math
from typing import NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.planners import Profile, plan_stop, plan_velocity
from motionlang.kernel.planners.curve import relabelled
from tests.cases import examples
from tests.kernel.planners.cases import SHAPES, Move, integrated, moves, plan_jerk, sizes
from tests.kernel.planners.test_laws import JERK, RATIO, ramp
from tests.kernel.planners.verify import verify

velocities = st.floats(-1000.0, 1000.0).map(lambda v: v if abs(v) > 1e-60 else 0.0)


rates, edges = st.floats(10.0, 1e5), st.floats(1e-3, 2.0)


few = settings(max_examples=examples(80))


class Plan(NamedTuple):
    """A plan, and its time if there is a closed form. `shape` is what its ramps promise."""

    made: Profile
    shape: str
    limits: dict[str, float]
    mirrored: Profile
    end: float | None = None
    end_velocity: float = 0.0
    time: float | None = None


def time_of(move: Move) -> float:
    """Return the time of a move from rest."""
    mean = 2.0 / 3.0 if move.shape == "parabolic" else 0.5

    def ramps(peak: float) -> tuple[float, float]:
        sides = ((move.accel, move.accel_jerk), (move.decel, move.decel_jerk))
        time = sum(ramp(move.shape, peak, rate, jerk, move.ramp) for rate, jerk in sides)
        return time, mean * peak * time

    size = abs(move.target - move.start)
    time, distance = ramps(move.speed)
    if distance <= size:
        return time + (size - distance) / move.speed if size else 0.0
    low, high = 0.0, move.speed
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if ramps(middle)[1] < size else (low, middle)
    return ramps(high)[0]


def moved(shape: str) -> st.SearchStrategy[Plan]:
    """Return moves of a shape."""

    def made(move: Move) -> Plan:
        mirrored = move._replace(start=-move.start, target=-move.target, v0=-move.v0)
        limits = {"speed": move.speed, "accel": move.accel, "decel": move.decel}
        if shape == "jerk":
            limits["jerk"] = max(move.accel_jerk, move.decel_jerk)
        time = None if move.v0 else time_of(move)
        return Plan(move.planned(), shape, limits, mirrored.planned(), move.target, time=time)

    return moves(shape).map(made)


def accelerating() -> st.SearchStrategy[Plan]:
    """Return jerk-limited moves that begin with an acceleration, which rounding may let exceed a limit."""

    def made(move: Move) -> Plan:
        a0 = math.copysign(0.5 * min(move.accel, math.sqrt(2.0 * move.speed * move.accel_jerk)), move.v0)
        figures = (move.speed, move.accel, move.decel, move.accel_jerk, move.decel_jerk)
        one = plan_jerk(move.start, move.target, *figures, v0=move.v0, a0=a0)
        other = plan_jerk(-move.start, -move.target, *figures, v0=-move.v0, a0=-a0)
        assert one.at(0.0).acceleration == pytest.approx(a0)
        return Plan(one, "scurve", {"jerk": max(figures[3:]), "tolerance": 1e-6}, other, move.target)

    return moves("jerk").map(made)


def stopped(shape: str) -> st.SearchStrategy[Plan]:
    """Return stops of a shape from any velocity."""
    name, jerk = "scurve" if shape in ("ratio", "jerk") else shape, JERK if shape == "jerk" else math.inf

    def made(v0: float, decel: float) -> Plan:
        one, other = (plan_stop(name, 5.0 * sign, sign * v0, decel, RATIO, jerk) for sign in (1.0, -1.0))
        limits = {"decel": decel, "accel": 0.0, "speed": abs(v0)}
        if shape == "jerk":
            limits["jerk"] = jerk
        return Plan(one, name, limits, other, time=ramp(shape, abs(v0), decel, jerk))

    return st.builds(made, velocities, sizes(1.0, 1e4))


def sides(v0: float, v1: float) -> tuple[float, float]:
    """Return how much a change of velocity slows down and how much it speeds up."""
    if v0 * v1 < 0.0:
        return abs(v0), abs(v1)
    return max(abs(v0) - abs(v1), 0.0), max(abs(v1) - abs(v0), 0.0)


def jogged(shape: str) -> st.SearchStrategy[Plan]:
    """Return motion at a velocity, from any velocity."""
    name, jerk = "scurve" if shape in ("ratio", "jerk") else shape, JERK if shape == "jerk" else math.inf

    def made(v0: float, v1: float, accel: float, decel: float) -> Plan:
        one, other = (
            plan_velocity(name, 5.0 * sign, sign * v0, sign * v1, accel, decel, RATIO, jerk, jerk)
            for sign in (1.0, -1.0)
        )
        down, up = sides(v0, v1)
        time = ramp(shape, down, decel, jerk) + ramp(shape, up, accel, jerk)
        limits = {"accel": accel, "decel": decel, "speed": max(abs(v0), abs(v1))}
        if shape == "jerk":
            limits["jerk"] = jerk
        return Plan(one, name, limits, other, None, v1, time)

    return st.builds(made, velocities, velocities, sizes(1.0, 1e4), sizes(1.0, 1e4))


PLANNERS: dict[str, st.SearchStrategy[Plan]] = {
    **{f"a move, {shape}": moved(shape) for shape in SHAPES},
    "a move from an acceleration": accelerating(),
    **{f"a stop, {shape}": stopped(shape) for shape in SHAPES},
    **{f"a jog, {shape}": jogged(shape) for shape in SHAPES},
}


def changing(made: Profile) -> Profile:
    """Return the profile without its last section if that has no end."""
    return made if made.duration < math.inf else made.cut(made.knots[-2])


def keeps_its_limits_and_arrives(each: Plan) -> None:
    """Position and velocity are continuous, the acceleration if the shape promises it."""
    made = each.made
    if made.duration == math.inf:
        assert made.velocity(1e6) == each.end_velocity
        made = relabelled(changing(made), each.shape)
    assert verify(made, end=each.end, **each.limits) == []
    assert made.end_velocity == pytest.approx(each.end_velocity, abs=1e-11)


def velocity_integrates_to_the_distance(each: Plan) -> None:
    made = changing(each.made)
    travelled = sum(abs(phase.distance) for phase in made.phases)
    slack = 1e-12 * (abs(travelled) + abs(made.start) + abs(made.end))
    assert integrated(made) == pytest.approx(made.distance, rel=1e-12, abs=slack)


def has_a_mirror_image(each: Plan) -> None:
    made, other = changing(each.made), changing(each.mirrored)
    assert other.duration == pytest.approx(made.duration, rel=1e-9, abs=1e-12)
    size = max(abs(x) for x in (*made.extrema(), 1e-300))
    for share in (0.0, 0.3, 0.7, 1.0):
        assert other.position(share * made.duration) == pytest.approx(
            -made.position(share * made.duration), rel=1e-9, abs=1e-9 * size
        )


def takes_the_time_of_the_closed_form(each: Plan) -> None:
    if each.time is not None:
        assert changing(each.made).duration == pytest.approx(each.time, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("planner", PLANNERS)
def test_a_planner_obeys_the_laws(planner: str) -> None:
    @few
    @given(PLANNERS[planner])
    def check(each: Plan) -> None:
        keeps_its_limits_and_arrives(each)
        velocity_integrates_to_the_distance(each)
        has_a_mirror_image(each)
        takes_the_time_of_the_closed_form(each)

    check()
