"""The sum of two motions; the shorter one goes on as it ended."""

from __future__ import annotations

from itertools import product
from math import inf
from typing import Any

import numpy as np
import pytest

from motionlang.kernel.planners import Profile, from_curve, hold, plan, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.evaluate import evaluate
from motionlang.kernel.planners.superposition import added
from tests.kernel.planners.cases import plan_jerk

MOTIONS: dict[str, Profile] = {
    "a move of 0.7 s": plan_trapezoid(5.0, 45.0, 100.0, 400.0, 200.0),
    "its first 0.3 s, up to 75 per second": plan_trapezoid(5.0, 45.0, 100.0, 400.0, 200.0).cut(0.3),
    "a jog": plan_velocity("trapezoid", 1.0, 0.0, 50.0, 100.0, 100.0),
    "a jog back": plan_velocity("trapezoid", 2.0, 0.0, -50.0, 200.0, 100.0),
    "a faster jog back": plan_velocity("trapezoid", 2.0, 0.0, -80.0, 200.0, 100.0),
    "a wave": plan("sinusoidal", 0.0, 30.0, 50.0, 200.0, 200.0),
    "a jerk": plan_jerk(0.0, -30.0, 50.0, 200.0, 200.0, 1000.0, 1000.0),
    "rest": hold(3.0),
    "nothing": hold(3.0).cut(0.0),
}
TIMES = (0.0, 0.1, 0.25, 0.3, 0.35, 0.5, 0.75, 1.5, 4.0)


def continued(profile: Profile, time: float) -> tuple[float, float]:
    """Return position and velocity; after its end a profile keeps its last velocity."""
    if time < profile.duration:
        return profile.position(time), profile.velocity(time)
    return profile.end + profile.end_velocity * (time - profile.duration), profile.end_velocity


@pytest.mark.parametrize(("one", "other"), list(product(MOTIONS, MOTIONS)))
def test_a_sum_has_the_positions_and_velocities_of_both(one: str, other: str) -> None:
    first, second = MOTIONS[one], MOTIONS[other]

    def wanted(time: float) -> tuple[Any, Any]:
        (p, v), (q, w) = continued(first, time), continued(second, time)
        return pytest.approx(p + q, abs=1e-9), pytest.approx(v + w, abs=1e-9)

    for made in (added(first, second, "sum"),):
        assert (made.shape, made.duration) == ("sum", max(first.duration, second.duration))
        assert (made.start, made.start_velocity) == (
            first.start + second.start, first.start_velocity + second.start_velocity,
        )  # fmt: skip
        assert made.end_velocity == first.end_velocity + second.end_velocity
        if made.duration < inf:
            assert made.end == wanted(made.duration)[0]
        elif made.end_velocity:
            assert made.end == made.end_velocity * inf
        else:
            assert made.end == wanted(4.0)[0]
        for time in TIMES:
            assert (made.position(time), made.velocity(time)) == wanted(time)
            if time <= made.duration:
                rest = made.after(time)
                assert (rest.position(0.2), rest.velocity(0.2)) == wanted(time + 0.2)
            twice = made.scaled(7.0, -2.0)
            assert twice.position(time) == pytest.approx(7.0 - 2.0 * (made.position(time) - made.start))
            if 0.0 < time < made.duration:
                begun = made.cut(time)
                assert (begun.duration, begun.end, begun.end_velocity) == (time, *wanted(time))


@pytest.mark.parametrize("name", MOTIONS)
def test_many_times_at_once_have_the_values_of_each(name: str) -> None:
    """Before its beginning a profile has its first velocity, then its last one.

    Accelerations and jerks are 0 there.
    """
    profile = MOTIONS[name]
    times = np.array([-1.0, *TIMES, *(knot + 1e-6 for knot in profile.knots if knot < inf)])
    times.sort()
    inside = [0.0 <= time < profile.duration for time in times.tolist()]
    for each in (profile, added(profile, hold(0.0), "sum")):
        before = each.start, each.start_velocity
        states = [before if time < 0.0 else continued(profile, time) for time in times.tolist()]
        assert evaluate(each, times, 0).tolist() == pytest.approx([state[0] for state in states])
        assert evaluate(each, times, 1).tolist() == pytest.approx([state[1] for state in states])
    for order, value in ((2, "acceleration"), (3, "jerk")):
        wanted = [
            getattr(profile.at(time), value) if within else 0.0
            for time, within in zip(times.tolist(), inside, strict=True)
        ]
        assert evaluate(profile, times, order).tolist() == pytest.approx(wanted, abs=1e-6)
    one_by_one = [profile.position(time) for time in times.tolist()]
    assert one_by_one == pytest.approx(evaluate(profile, times, 0).tolist())


def test_a_profile_has_its_velocities_before_and_after_it() -> None:
    """It starts at rest, and ends after 0.5 s at 5."""
    curve = (0.0, 0.5), ((0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0),), ()
    profile = from_curve("jog", 0.0, 1.25, curve, 0.0, 5.0)
    times = np.array([-1.0, 0.6, 0.75])
    assert evaluate(profile, times, 1).tolist() == [0.0, 5.0, 5.0]
    assert evaluate(profile, times, 0).tolist() == pytest.approx([0.0, 1.75, 2.5])
