"""Checks of profiles that are planned from settings, each figure by hand.

The order is a move at 10 counts/s that speeds up at 10 and slows down at 20 counts/s². Over 100 counts it takes
1 s up, over 5, 0.5 s down, over 2.5, and 9.25 s at its speed.
"""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.axes import check_profile
from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.followers import (
    _on,
    _wanted,
    check_points,
)
from motionlang.commands.prove.order import Order, Tie
from motionlang.kernel.planners import (
    Profile,
    from_curve,
    hold,
    plan_jerk,
    plan_pvt,
    plan_stop,
    plan_trapezoid,
    plan_velocity,
)
from motionlang.kernel.planners.table_motion import table_curve

MOVE = Order("move", 3, 10.0, (10.0, 20.0), shape="trapezoid")
JOG, STOP = MOVE._replace(kind="jog", goal=10.0), MOVE._replace(kind="stop", speed=inf)
SMOOTH = MOVE._replace(rates=(10.0, 10.0), shape="scurve", jerks=(20.0, 20.0))
WHOLE = plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0)
FOUR = (0.0, 0.0, 0.0, 0.0)


def ending(profile: Profile, end: float) -> Profile:
    """Return a profile that states another end than its pieces have."""
    profile.end = end
    return profile


def broken(velocity: float) -> Profile:
    """Return 1 s at 5 and 1 s at another velocity, as a jog that never ends."""
    pieces = ((0.0, 5.0, *FOUR, 0.0), (5.0, velocity, *FOUR, 0.0))
    return from_curve(
        "trapezoid", 0.0, 5.0 + velocity, ((0.0, 1.0, 2.0), pieces, (("slew", 0),)), 5.0, velocity
    )


# The order, the profile, how long it is in force, and the violations. With a jerk of 20, 1.5 s each way cover 7.5,
# and 85 take 8.5 s; a ramp that begins at its rate takes 1.25 s over 7.3958.
CASES: dict[str, tuple[Order, Profile, float, list[str]]] = {
    "as commanded": (MOVE, WHOLE, 10.75, []),
    "in reverse": (MOVE, plan_trapezoid(0.0, -100.0, 10.0, 10.0, 20.0), 10.75, []),
    "faster": (
        MOVE, plan_trapezoid(0.0, 100.0, 11.0, 10.0, 20.0), 9.0,
        ["the speed reaches 11 counts, above 10"],
    ),
    "slower": (
        MOVE, plan_trapezoid(0.0, 100.0, 8.0, 10.0, 20.0), inf, [],
    ),
    "speeding up harder": (
        MOVE, plan_trapezoid(0.0, 100.0, 10.0, 20.0, 20.0), inf,
        ["the acceleration reaches 20 counts, above 10"],
    ),
    "slowing down harder": (
        MOVE, plan_trapezoid(0.0, 100.0, 10.0, 10.0, 40.0), inf,
        ["the deceleration reaches 40 counts, above 20"],
    ),
    "a jog": (JOG, plan_velocity("trapezoid", 0.0, 0.0, 10.0, 10.0, 20.0), 5.0, []),
    "a jog that is too slow": (
        JOG, plan_velocity("trapezoid", 0.0, 0.0, 9.0, 10.0, 20.0), 5.0,
        ["it reaches 9 counts/s, commanded 10"],
    ),
    "a stop": (STOP, plan_stop("trapezoid", 0.0, 10.0, 20.0), 0.5, []),
    "a stop that is too hard": (
        STOP, plan_stop("trapezoid", 0.0, 10.0, 40.0), 0.25,
        ["the deceleration reaches 40 counts, above 20"],
    ),
    "too fast as it begins, slowing down": (
        MOVE, plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0, 20.0), inf, [],
    ),
    "too fast as it begins, and for ever": (
        MOVE, plan_trapezoid(0.0, 100.0, 20.0, 10.0, 20.0, 20.0), 2.0,
        ["the speed reaches 20 counts, above 10"],
    ),
    "with a jerk": (SMOOTH, plan_jerk(0.0, 100.0, 10.0, 10.0, 10.0, 20.0, 20.0), inf, []),
    "with a jerk that is too high": (
        SMOOTH, plan_jerk(0.0, 100.0, 10.0, 10.0, 10.0, 40.0, 40.0), inf,
        ["the jerk reaches 40 counts, above 20"],
    ),
    "without the jerk": (
        SMOOTH, plan_trapezoid(0.0, 100.0, 10.0, 10.0, 10.0), inf,
        ["the acceleration jumps by 10 counts within a profile"] * 2,
    ),
    "it states another end": (
        MOVE, ending(plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0), 100.001), inf,
        ["it ends at 100.001, its pieces at 100"],
    ),
    "it states another end by rounding": (
        MOVE, ending(plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0), 100.00009), inf, [],
    ),
    "another motion than a planned one": (
        MOVE._replace(kind="Cam"), plan_trapezoid(0.0, 100.0, 99.0, 99.0, 99.0), inf, [],
    ),
    "at rest": (Order("rest", 0), hold(5.0), inf, []),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_a_planned_profile_keeps_its_bounds_and_its_end(name: str) -> None:
    order, profile, length, expected = CASES[name]
    track: Any = SimpleNamespace(index=0, starts=[2.0], profiles=[profile])
    proof = Proof()
    check_profile(proof, track, 0, order, order, length)
    messages = [each.message.partition(" s: ")[2] for each in proof.violations]
    assert messages == expected
    assert proof.counts["profiles"] == (order.kind != "rest")


@pytest.mark.parametrize(
    ("kind", "velocity", "found"),
    [
        ("jog", 5.0, False),
        ("jog", 5.000004, False),
        ("jog", 5.00001, True),
        ("path", 6.0, True),
        ("Gear", 6.0, False),
    ],
)
def test_the_velocity_of_a_planned_profile_is_continuous(kind: str, velocity: float, found: bool) -> None:
    """A millionth of its top speed is rounding."""
    track: Any = SimpleNamespace(index=0, starts=[2.0], profiles=[broken(velocity)])
    proof = Proof()
    check_profile(proof, track, 0, MOVE._replace(kind=kind, goal=velocity), MOVE, inf)
    jumps = [each.message for each in proof.violations if "jumps" in each.message]
    message = f"axis 0 at 3.000000 s: the velocity jumps by {velocity - 5.0:g} counts within a profile"
    assert jumps == [message] * found


# -- profiles that others prescribe


@pytest.mark.parametrize(
    ("along", "value"),
    [(-1.0, 0.5), (0.0, 3.0), (1.0, 5.5), (2.0, 8.0), (3.0, 9.0), (4.0, 10.0), (5.0, 11.0)],
)
def test_a_curve_goes_on_straight_at_its_ends(along: float, value: float) -> None:
    """From 3 to 8 over 2, and to 10 over 2 more."""
    positions, values = (0.0, 2.0, 4.0), (3.0, 8.0, 10.0)
    curve = table_curve(list(positions), list(values))
    master: Any = None
    assert _on(curve, along) == pytest.approx(value)
    assert _wanted(Tie(master, table=(positions, values, "linear")), hold(0.0), along) == pytest.approx(value)
    assert _wanted(Tie(master, table=(positions, values, "cubic")), curve, along) == pytest.approx(value)
    assert _wanted(Tie(master), curve, along) == pytest.approx(value)


POINTS, VELOCITIES, TIMES = [0.0, 10.0, 4.0], [0.0, 5.0, 0.0], [1.0, 0.5]
# The points, velocities and times that are commanded, and the violations.
Given = tuple[list[float], list[float], list[float]]
COMMANDED: dict[str, tuple[Given, list[str]]] = {
    "the same": ((POINTS, VELOCITIES, TIMES), []),
    "the same but for rounding": (([0.0, 10.000009, 4.0], [0.0, 5.000004, 0.0], TIMES), []),
    "another end": (
        ([0.0, 10.0, 5.0], VELOCITIES, TIMES),
        ["it ends at 4, commanded 5", "point 2 is 5 at 0 counts/s, it is at 4 at 0 counts/s"],
    ),
    "another end by less than a millionth of its farthest point": (
        ([0.0, 10.0, 4.000005], VELOCITIES, TIMES), ["it ends at 4, commanded 4"],
    ),
    "another point": (
        ([0.0, 10.00002, 4.0], VELOCITIES, TIMES), ["point 1 is 10 at 5 counts/s, it is at 10 at 5 counts/s"],
    ),
    "another velocity": (
        (POINTS, [0.0, 5.00001, 0.0], TIMES), ["point 1 is 10 at 5.00001 counts/s, it is at 10 at 5 counts/s"],
    ),
    "another start": (
        ([1.0, 10.0, 4.0], VELOCITIES, TIMES), ["point 0 is 1 at 0 counts/s, it is at 0 at 0 counts/s"],
    ),
    "another time, as it was suspended": (([0.0, 99.0, 4.0], VELOCITIES, [1.0, 0.6]), []),
    "more points": (
        ([0.0, 9.0, 10.0, 4.0], [0.0, 1.0, 5.0, 0.0], [0.5, 0.5, 0.5]), ["it has 2 segments, commanded 3"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", COMMANDED)
def test_a_profile_through_points_passes_each_at_its_velocity(name: str) -> None:
    given, expected = COMMANDED[name]
    track: Any = SimpleNamespace(index=0, starts=[2.0], profiles=[plan_pvt(POINTS, VELOCITIES, TIMES)])
    proof = Proof()
    check_points(proof, track, 0, MOVE._replace(points=given))
    where = "axis 0 from 2.000000 s: "
    assert [each.message for each in proof.violations] == [where + message for message in expected]
