"""Profiles that were packed and unpacked are the same motion."""

from __future__ import annotations

import pytest

from motionlang.kernel.planners import Profile, hold, plan, plan_pvt, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.packed import packed, unpacked
from motionlang.kernel.planners.sequence import chained
from tests.kernel.planners.cases import plan_jerk

MOVE = plan_trapezoid(5.0, 105.0, 20.0, 40.0, 40.0)
S_JOG = plan_velocity("scurve", 0.0, 5.0, 20.0, 40.0, 40.0, 0.0, 80.0, 80.0, 10.0)
# The profile, and the number of its items: 1 for a position, 5 for ramps, 6 for pieces, 4 for a formula.
PROFILES: dict[str, tuple[Profile, int]] = {
    "rest without an end": (hold(5.0), 1),
    "rest for 2 s": (hold(5.0).cut(2.0), 6),
    "ramps": (MOVE, 5),
    "a wave": (plan("sinusoidal", 0.0, 100.0, 20.0, 40.0, 40.0), 5),
    "a jerk": (plan_jerk(0.0, 100.0, 20.0, 40.0, 40.0, 80.0, 80.0, 5.0, 10.0), 6),
    "a jog": (plan_velocity("trapezoid", 0.0, 0.0, 20.0, 40.0, 40.0), 5),
    "a jog from an acceleration, without an end": (S_JOG, 6),
    "segments": (plan_pvt([0.0, 10.0, 4.0], [0.0, 5.0, 0.0], [1.0, 0.5]), 6),
    "the rest of a move": (MOVE.after(0.7), 6),
    "a sequence": (chained(MOVE, MOVE.shifted(100.0)), 4),
}


@pytest.mark.parametrize("name", PROFILES)
def test_a_profile_is_the_same_after_it_was_packed(name: str) -> None:
    profile, length = PROFILES[name]
    row = packed(profile)
    made = unpacked(row)
    assert (made.shape, made.start, made.end, made.duration) == (
        profile.shape, profile.start, profile.end, profile.duration,
    )  # fmt: skip
    assert (made.start_velocity, made.end_velocity) == (profile.start_velocity, profile.end_velocity)
    for time in (0.0, 0.25, 0.5, 1.0, 3.0, 99.0):
        assert made.at(min(time, made.duration)).position == profile.at(min(time, made.duration)).position
        assert made.velocity(time) == profile.velocity(time)
    assert packed(made) == row
    assert len(row) == length
