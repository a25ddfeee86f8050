"""Which plans in motion have a closed form, and that a search agrees with it.

A move in motion that has no closed form is left to a search, which finds the same plan by more work. So each table
gives the number of plans of each kind, too.
"""

from __future__ import annotations

from collections import Counter
from itertools import product
from typing import Any

import pytest

from motionlang.planners import Profile
from motionlang.planners import jerk as planner
from motionlang.planners.feasibility import approach
from motionlang.planners.jerk import _directly, jerk_ramps, plan_jerk
from motionlang.planners.jerk_limited import JerkLimited, jerk_limited_approach

# Acceleration, deceleration and their jerks. A ramp reaches 400 in 0.2 s from 40 per second on, 300 from 60 on.
RATES = (400.0, 300.0, 2000.0, 1500.0)
RAMPS = jerk_ramps(*RATES)
VELOCITIES = (2.0, 5.0, 20.0, 60.0, 150.0, 250.0)
DISTANCES = (-20.0, 0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 1000.0)
SPEEDS = (15.0, 50.0, 100.0, 200.0)


def searched(target: float, speed: float, v0: float, a0: float) -> Profile:
    """Return the plan of the search, from position 0."""

    def straight(here: float, velocity: float) -> Profile:
        return plan_jerk(here, target, speed, *RATES, velocity)

    made = jerk_limited_approach(RAMPS, 0.0, target, speed, v0, a0, straight)
    assert made is not None
    return made


def assert_equal(made: Profile, expected: Profile) -> None:
    """Check that two plans are the same curve."""
    assert made.duration == pytest.approx(expected.duration, rel=1e-9)
    for k in range(6):
        a, b = (each.at(expected.duration * k / 5) for each in (made, expected))
        assert a.position == pytest.approx(b.position, abs=1e-7)
        assert a.velocity == pytest.approx(b.velocity, abs=1e-6)


def kind(made: Profile | None) -> str:
    """Return the number of sections of constant jerk of a plan, and that of ramps.

    A slew counts as a ramp.
    """
    if made is None:
        return "search"
    assert isinstance(made, JerkLimited)
    return f"{len(made._head[2])}+{len(made._tail) // 3}"


# By initial acceleration: plans that ramp it down and then move on (1+3) or stop and move back (1+4); that continue
# it as part of a ramp up (3+2) or as part of a ramp to rest, and then move back (3+3); and those left to the search.
KINDS: dict[float, dict[str, int]] = {
    -350.0: {"1+3": 26, "1+4": 84, "search": 82},
    -300.0: {"1+3": 23, "1+4": 84, "3+3": 68, "search": 17},
    -100.0: {"1+3": 51, "1+4": 28, "3+3": 88, "search": 25},
    -20.0: {"1+3": 71, "3+3": 100, "search": 21},
    20.0: {"1+4": 100, "3+2": 71, "search": 21},
    100.0: {"1+4": 104, "3+2": 68, "search": 20},
    400.0: {"1+4": 140, "3+2": 27, "search": 25},
    410.0: {"1+4": 140, "search": 52},
}


@pytest.mark.parametrize(("sign", "a0"), [((-1.0) ** k, a0) for k, a0 in enumerate(KINDS)])
def test_a_plan_from_an_acceleration_by_the_closed_form_is_that_of_the_search(sign: float, a0: float) -> None:
    """Beyond a limit, -350 or 410, there is a closed form only if it stops."""
    found: Counter[str] = Counter()
    for v0, distance, speed in product(VELOCITIES, DISTANCES, SPEEDS):
        made = _directly(0.0, sign * distance, speed, RATES, sign * v0, sign * a0)
        found[kind(made)] += 1
        if made is not None:
            assert made.end == sign * distance
            assert_equal(made, searched(sign * distance, speed, sign * v0, sign * a0))
    assert found == KINDS[a0]


# By initial velocity: the length of a stop, and how many of the moves have no closed form. These can stop before
# their target, and are above the set speed: a stop from 60 takes 60 / 300 + 0.2 s, so it is 12 long.
SEARCHED: dict[float, tuple[float, int]] = {
    -250.0: (0.0, 0),
    -15.0: (0.0, 0),
    0.0: (0.0, 0),
    15.0: (1.5, 0),  # 2 sqrt(15 / 1500) s
    20.0: (2.31, 1 * 5),
    50.0: (9.13, 1 * 4),
    60.0: (12.0, 2 * 3),
    150.0: (52.5, 3 * 2),
    200.0: (86.7, 3 * 2),
    250.0: (129.2, 4 * 1),
}


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("v0", SEARCHED)
def test_a_plan_from_a_velocity_by_the_closed_form_is_that_of_the_search(
    sign: float, v0: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    searches = []

    def counted(*given: Any) -> Profile:
        searches.append(given)
        return approach(*given)

    monkeypatch.setattr(planner, "approach", counted)
    length, most = SEARCHED[v0]
    for distance, speed in product(DISTANCES, SPEEDS):
        made = plan_jerk(0.0, sign * distance, speed, *RATES, sign * v0)
        assert_equal(made, approach(RAMPS, 0.0, sign * distance, speed, sign * v0))
    assert len(searches) == most
    assert all(speed < v0 and abs(target) > length for *_, target, speed, _ in searches)


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
    assert (made.duration, made.end) == (pytest.approx(time, rel=1e-6), start + sign * length)
    assert made.peak_speed <= v0 + 0.5 * max(a0, 0.0) ** 2 / RATES[2] + 1e-9
    roots = 2000.0**-0.5 + 1500.0**-0.5
    assert nearer.duration == pytest.approx(time + 2.0 * roots * (0.01 * length / roots) ** (1.0 / 3.0))
    assert time < farther.duration < nearer.duration
