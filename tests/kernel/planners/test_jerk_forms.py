"""Which plans in motion have a closed form, and that a search agrees with it.

A move in motion that has no closed form is left to a search, which finds the same plan by more work. So each table
gives the number of plans of each kind, too.
"""

from __future__ import annotations

from collections import Counter
from itertools import combinations, product
from math import sqrt
from typing import Any

import pytest

from motionlang.kernel.planners import Profile, jerk_limited, plan_jerk
from motionlang.kernel.planners import jerk as planner
from motionlang.kernel.planners.feasibility import approach
from motionlang.kernel.planners.jerk import _directly, ease, jerk_ramps, peak_speed, ramp_to
from motionlang.kernel.planners.jerk_limited import JerkLimited, jerk_limited_approach
from motionlang.kernel.planners.limits import LARGEST
from motionlang.kernel.planners.segment_speed import between

# Acceleration, deceleration and their jerks. A ramp reaches 400 in 0.2 s from 40 per second on, 300 from 60 on.
RATES = (400.0, 300.0, 2000.0, 1500.0)
RAMPS = jerk_ramps(*RATES)
VELOCITIES = (0.0, 0.5, 5.0, 20.0, 60.0, 150.0, 250.0)
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
    -350.0: {"1+3": 26, "1+4": 112, "3+2": 3, "search": 83, "no ramp up": 15},
    -300.0: {"1+3": 23, "1+4": 112, "3+2": 3, "3+3": 68, "search": 18, "no ramp up": 18},
    -100.0: {"1+3": 51, "1+4": 56, "3+2": 4, "3+3": 88, "search": 25, "no ramp up": 25},
    -20.0: {"1+3": 71, "1+4": 28, "3+2": 4, "3+3": 100, "search": 21, "no ramp up": 21},
    20.0: {"1+4": 108, "3+2": 95, "search": 21, "no ramp up": 21},
    100.0: {"1+4": 112, "3+2": 92, "search": 20, "no ramp up": 20},
    400.0: {"1+4": 160, "3+2": 36, "search": 28, "no ramp up": 28},
    410.0: {"1+4": 160, "search": 64, "no ramp up": 64},
}


@pytest.mark.parametrize(("sign", "a0"), [((-1.0) ** k, a0) for k, a0 in enumerate(KINDS)])
def test_a_plan_from_an_acceleration_by_the_closed_form_is_that_of_the_search(
    sign: float, a0: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beyond a limit, -350 or 410, there is a closed form only if it stops."""
    found: Counter[str] = Counter()

    def counted(*given: Any) -> Any:
        found["no ramp up"] += 1
        return between(*given)

    monkeypatch.setattr(jerk_limited, "between", counted)
    for v0, distance, speed in product(VELOCITIES, DISTANCES, SPEEDS):
        made = _directly(0.0, sign * distance, speed, RATES, sign * v0, sign * a0)
        found[kind(made)] += 1
        other = searched(sign * distance, speed, sign * v0, sign * a0)
        if made is not None:
            assert made.end == sign * distance
            assert_equal(made, other)
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
    assert made.duration == pytest.approx(time, rel=1e-6)
    assert made.end == start + sign * length
    assert made.peak_speed <= v0 + 0.5 * max(a0, 0.0) ** 2 / RATES[2] + 1e-9
    roots = 2000.0**-0.5 + 1500.0**-0.5
    assert nearer.duration == pytest.approx(time + 2.0 * roots * (0.01 * length / roots) ** (1.0 / 3.0))
    assert time < farther.duration < nearer.duration


def test_a_deceleration_that_ends_hardly_above_rest_ends_at_rest() -> None:
    """A fraction of 1e-12 of 300^2 / 1500 = 60 and of the velocity is rounding.

    From 20 that is 8e-11. Above it, the move continues as a stop, of three sections, before it moves back.
    """
    for after, found in ((7e-11, "1+3"), (9e-11, "3+3")):
        made = _directly(0.0, 0.0, 100.0, RATES, 20.0, -sqrt(2.0 * 1500.0 * (20.0 - after)))
        assert kind(made) == found


# Initial speed, acceleration, deceleration and their jerks.
PEAKS = list(
    product(
        (0.0, 1.0, 20.0, 45.0, 80.0, 300.0), (100.0, 400.0), (50.0, 300.0), (500.0, 8000.0), (700.0, 6000.0)
    )
)


def test_the_peak_of_a_move_in_motion_is_found_in_few_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both ramps have the mean of their speeds, and fill the distance.

    Each step takes one square root for each ramp that does not reach its rate: at most two. Before the first step,
    up to three bound the speed.
    """
    roots: list[float] = []

    def counted(x: float) -> float:
        roots.append(x)
        return sqrt(x)

    monkeypatch.setattr(planner, "sqrt", counted)
    most, count = 0, 0
    for u, accel, decel, accel_jerk, decel_jerk in PEAKS:
        stop = 0.5 * u * ramp_to(u, decel, decel_jerk)[0]
        for size in (1.0, 1.001, 1.1, 1.5, 4.0, 50.0, 1e4):
            roots.clear()
            size *= stop or 1.0
            peak = peak_speed(u, size, (accel, accel_jerk), (decel, decel_jerk))
            most, count = max(most, len(roots)), count + len(roots)
            first = ramp_to(max(peak - u, 0.0), accel, accel_jerk)[0]
            last = ramp_to(peak, decel, decel_jerk)[0]
            assert 0.5 * (u + peak) * first + 0.5 * peak * last == pytest.approx(size, rel=1e-12)
    assert (most, count) == (23, 5421)  # 8 for each peak


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
    (100.0, 1e4, (50.0, 2e4, 1e-6, 1000.0), 50.0, 1e-8, -1e-6),
]


@pytest.mark.parametrize(("target", "speed", "rates", "v0", "a0", "jerk"), FAR_APART)
def test_limits_that_are_too_far_apart_for_a_sum(
    target: float, speed: float, rates: tuple[float, float, float, float], v0: float, a0: float, jerk: float
) -> None:
    """The acceleration is ramped down first: speeding up or slowing down has its jerk."""
    made = plan_jerk(0.0, target, speed, *rates, v0, a0)
    time = abs(a0 / jerk)
    eased = ease(0.0, v0, a0, abs(jerk))
    rest = approach(jerk_ramps(*rates), eased.end, target, speed, eased.end_velocity)
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
