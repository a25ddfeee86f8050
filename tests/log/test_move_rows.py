"""Moves as rows: a profile on the track of its axis is stored as its index."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.controller.move import Move
from motionlang.log.move_rows import move_of, row
from motionlang.planners import hold, plan_trapezoid

# The last three begin at one time: each is replaced by the next.
PROFILES = [plan_trapezoid(0.0, 10.0 + k, 5.0, 100.0, 100.0) for k in range(4)]
STARTS = [0.0, 2.0, 2.0, 2.0]


def moved(number: int, start: float) -> Move:
    move = Move(0, "MOVER", 3, 10.0)
    move.profile, move.start_time = PROFILES[number], start
    return move


@pytest.mark.parametrize("packed", [0, 5])
@pytest.mark.parametrize("number", range(4))
def test_the_index_counts_the_packed_profiles_too(number: int, packed: int) -> None:
    earlier = plan_trapezoid(0.0, 3.0, 5.0, 100.0, 100.0)
    older = (
        SimpleNamespace(count=packed, profile=[None, None, None, None, earlier].__getitem__)
        if packed
        else None
    )
    axis: Any = SimpleNamespace(starts=STARTS, profiles=PROFILES, older=older)
    made = row(moved(number, STARTS[number]), axis)
    assert made[-1] == packed + number
    assert move_of(made, {0: axis}).profile is PROFILES[number]
    if packed:
        assert move_of((*made[:-1], 4), {0: axis}).profile is earlier


def test_a_profile_that_is_not_at_its_time_on_the_track_is_stored_whole() -> None:
    axis: Any = SimpleNamespace(starts=STARTS, profiles=PROFILES, older=None)
    made = row(moved(2, 1.0), axis)
    assert not isinstance(made[-1], int)
    again = move_of(made, {0: axis})
    assert again.profile is not None
    assert again.profile is not PROFILES[2]
    assert (again.profile.end, again.profile.duration) == (PROFILES[2].end, PROFILES[2].duration)
    assert (again.axis, again.command, again.line, again.target, again.start_time) == (
        0,
        "MOVER",
        3,
        10.0,
        1.0,
    )


def test_standstills_of_one_time_are_compared_by_identity() -> None:
    """All standstills share a recipe."""
    here, there = hold(3.0), hold(5.0)
    axis: Any = SimpleNamespace(starts=[0.0, 2.0], profiles=[PROFILES[0], here], older=None)
    moves = [moved(0, 2.0) for _ in range(4)]
    moves[0].profile, moves[1].profile, moves[2].profile = here, there, None
    assert row(moves[0], axis)[-1] == 1
    assert row(moves[1], axis)[-1] == (5.0,)
    assert row(moves[2], axis)[-1] is None
    assert move_of(row(moves[1], axis), {0: axis}).profile is not there
