"""The checker detects every kind of violation."""

from __future__ import annotations

import math

from motionlang.kernel.planners import Profile, from_curve, plan, plan_trapezoid
from tests.kernel.planners.cases import plan_jerk
from tests.kernel.planners.verify import verify

LINE = (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def two_lines(second: tuple[float, ...]) -> Profile:
    piece = (second[0], second[1], 0.0, 0.0, 0.0, 0.0, 0.0)
    curve = ((0.0, 1.0, 2.0), (LINE, piece), (("slew", 0),))
    return from_curve("pvt", 0.0, second[0] + second[1], curve, 1.0, second[1])


def test_a_sound_profile_has_no_complaint() -> None:
    assert verify(plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0), speed=8, accel=16, decel=16, end=12.0) == []


def test_jumps() -> None:
    assert verify(two_lines((1.0, 1.0))) == []
    assert verify(two_lines((1.5, 1.0))) == ["position jumps by 0.5 at 1 s"]
    assert verify(two_lines((1.0, 2.0))) == ["velocity jumps by 1 at 1 s"]


def test_a_trapezoid_is_not_an_s_curve() -> None:
    plain = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    posing = from_curve("scurve", 0.0, 12.0, plain.curve, 0.0, 0.0)
    assert verify(posing) == ["acceleration jumps by -16 at 0.5 s", "acceleration jumps by -16 at 1.5 s"]


def test_limits() -> None:
    move = plan_jerk(0.0, 100.0, 100.0, 500.0, 400.0, 5000.0, 4000.0)
    found = verify(move, speed=99.0, accel=499.0, decel=399.0, jerk=4999.0)
    words = [complaint.split(" reaches ")[0] for complaint in found]
    assert words == ["speed", "acceleration", "deceleration", "jerk"]
    assert len(verify(plan("sinusoidal", 0.0, 9.0, 9.0, 5.0, 5.0), jerk=1.0)) == 1


def test_the_end() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert verify(move, end=11.0) == ["the profile ends at 12.0, not at 11.0"]
    lying = from_curve("trapezoid", 0.0, 13.0, move.curve, 0.0, 1.0)
    assert [complaint[:14] for complaint in verify(lying)] == ["the curve ends", "the curve ends"]


def test_not_a_number_is_a_complaint() -> None:
    piece = (0.0, math.nan, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert verify(from_curve("pvt", 0.0, 1.0, ((0.0, 1.0), (piece,), (("slew", 0),)), 1.0, 1.0))
