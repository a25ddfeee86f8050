"""Waits of the moves of two runs, and their starts in the merged run, by hand."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.commands.diff.timeline import Timeline


def move(start: float, duration: float | None) -> dict[str, Any]:
    return {"start_time": start, "duration": duration}


# The first move takes 1.0 s in the old run, 1.5 s in the new one. Each row has the start and the duration of
# the next move in the old and in the new run, whether its change is accepted, whose duration the merged run
# has, and the wait and the start in that run.
PAIRS: dict[str, tuple[tuple[float, float | None], tuple[float, float | None], bool, bool, float, float]] = {
    "0.2 s after the first in both": ((1.25, 1.0), (1.75, 1.0), True, False, 0.0, 1.75),
    "0.25 s later": ((1.25, 1.0), (2.0, 1.0), True, False, 0.25, 2.0),
    "0.25 s later, which is rejected": ((1.25, 1.0), (2.0, 1.0), False, False, 0.25, 1.75),
    "earlier": ((1.5, 1.0), (1.75, 1.0), True, False, -0.25, 1.75),
    "before the first is over": ((0.5, 1.0), (0.75, 1.0), True, False, 0.25, 0.75),
    "as the first ends, by rounding": ((1.0 - 5e-10, 1.0), (1.5 - 5e-10, 1.0), True, False, 0.0, 1.5),
}


@pytest.mark.parametrize("name", PAIRS)
def test_the_wait_of_a_move_counts_from_the_end_of_the_last_one(name: str) -> None:
    old, new, accepted, _, wait, start = PAIRS[name]
    line = Timeline()
    assert line.pair(move(0.0, 1.0), move(0.0, 1.5)) == (0.0, 0.0)
    found = line.pair(move(*old), move(*new), accepted=accepted)
    assert found == pytest.approx((wait, start), abs=1e-8)


def test_the_merged_run_may_have_the_old_duration() -> None:
    """The first move is rejected: it takes 1.0 s, so the next one begins at 1.25 s."""
    line, a, b = Timeline(), move(0.0, 1.0), move(0.0, 1.5)
    line.pair(a, b, a, False)
    assert line.pair(move(1.25, 1.0), move(1.75, 1.0)) == (0.0, 1.25)
    assert line.pair(move(2.5, 1.0), move(3.0, 1.0)) == (0.0, 2.5)


def test_a_move_that_only_the_old_run_has_is_waited_for_there_alone() -> None:
    """It ends at 2.25 s. The next one waits 0.25 s after it, 0.5 s in the new run."""
    for in_merged, accepted, start in ((False, True, 2.0), (False, False, 1.75), (True, True, 3.25)):
        line = Timeline()
        line.pair(move(0.0, 1.0), move(0.0, 1.5))
        assert line.alone(move(1.25, 1.0), 0, in_merged) == 1.75
        assert line.pair(move(2.5, 1.0), move(2.0, 1.0), accepted=accepted) == (0.25, start)


def test_a_move_that_only_the_new_run_has_is_waited_for_there_alone() -> None:
    """It ends at 2.75 s. The next one waits 0.5 s after it, 0.25 s in the old run."""
    for in_merged, accepted, start in ((True, True, 3.25), (True, False, 3.0), (False, True, 2.0)):
        line = Timeline()
        line.pair(move(0.0, 1.0), move(0.0, 1.5))
        assert line.alone(move(1.75, 1.0), 1, in_merged) == 1.75
        assert line.pair(move(1.25, 1.0), move(3.25, 1.0), accepted=accepted) == (0.25, start)


def test_after_moves_that_the_merged_run_has_not_it_goes_on_at_the_last_one_it_has() -> None:
    """Its last one ends at 1.5 s; the next waits 0.25 s after a move of the new run."""
    line = Timeline()
    line.pair(move(0.0, 1.0), move(0.0, 1.5))
    line.alone(move(1.25, 1.0), 0, False)
    line.alone(move(1.75, 1.0), 1, False)
    assert line.pair(move(2.5, 1.0), move(3.0, 1.0)) == (0.0, 1.75)


def test_a_move_without_an_end_is_waited_for_by_none() -> None:
    line = Timeline()
    line.pair(move(0.0, 1.0), move(0.0, 1.5))
    assert line.pair(move(1.25, None), move(2.0, 1.0)) == (0.25, 2.0)
    assert line.pair(move(1.25, 1.0), move(2.0, None)) == (0.25, 2.0)
    assert line.alone(move(1.25, None), 0, True) == 1.75
    assert line.pair(move(3.0, 1.0), move(3.5, 1.0)) == (0.0, 3.5)


def test_the_last_end_counts_and_not_the_last_that_was_found() -> None:
    """A move to 2.0 s is compared after one to 4.0 s, which the next one waits for."""
    line = Timeline()
    line.pair(move(0.0, 4.0), move(0.0, 4.5))
    assert line.pair(move(4.5, 0.125), move(5.0, 0.125)) == (0.0, 5.0)
    line.pair(move(0.0, 2.0), move(0.0, 2.0))
    assert line.pair(move(4.75, 1.0), move(5.25, 1.0)) == (0.0, 5.25)
