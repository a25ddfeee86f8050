"""Settling of a simulated motor, and levels that it reaches, by hand."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest

from motionlang.kernel.planners import hold, plan, plan_trapezoid
from motionlang.kernel.servo import Track
from motionlang.kernel.servo.samples import (
    SampleBlock,
    SettlingWindow,
    crossing,
    next_other_side,
    next_side,
    rests_as_seen,
)
from motionlang.kernel.servo.step import COLUMNS


def block(first: int, error: list[float], velocity: list[float] | None = None) -> SampleBlock:
    """Return samples from number `first` on; the encoder is at 100 - error."""
    rows = np.zeros((len(COLUMNS), len(error)))
    rows[COLUMNS.index("demand")] = 100.0
    rows[COLUMNS.index("measured")] = 100.0 - np.array(error)
    rows[COLUMNS.index("velocity")] = velocity or [0.0] * len(error)
    return SampleBlock(first, rows)


@pytest.mark.parametrize("at_target", [False, True])
@pytest.mark.parametrize(
    ("error", "onsets", "settled"),
    [
        ([0.0] * 4, [(52, 54)], (52.0, 53.0)),
        ([2.0, 0.0, 0.0, 0.0], [(53, 54)], (53.0, 53.0)),
        ([-1.0, 1.0, 1.5, 1.0], [(52, 52), (55, 54)], (55.0, 55.0)),  # inside to the end: settled after it
        ([-2.0, 2.0, 2.0, 2.0], [], (inf, inf)),
        ([0.0, 0.0, 0.0, 2.0], [(52, 53)], (52.0, inf)),
        ([2.0, 0.0, 2.0, 2.0], [(53, 52)], (inf, inf)),
    ],
)
def test_a_motor_settles_after_its_hold_in_the_window(
    at_target: bool, error: list[float], onsets: list[tuple[int, int]], settled: tuple[float, float]
) -> None:
    """Of samples 50 to 53 at 1000 a second, the hold of 2 ms is two samples.

    An error of 1 is inside.
    """
    window = SettlingWindow(error=1.0, hold=0.002, at_target=at_target)
    samples = block(50, error)
    if at_target:  # the command is elsewhere
        samples.rows[COLUMNS.index("demand")] += 9.0
    assert window.onsets(samples, 100.0, 1000.0) == onsets
    found = tuple(window.settled(samples, 100.0, now, 1000.0) for now in (50, 53))
    assert found == settled


def test_a_motor_that_was_inside_before_the_samples_settles_sooner() -> None:
    window = SettlingWindow(error=1.0, hold=0.01)
    window.since = 45.0
    assert window.onsets(block(50, [0.0] * 4), 100.0, 1000.0) == [(55, 54)]
    assert window.onsets(block(50, [2.0, 0.0]), 100.0, 1000.0) == [(61, 52)]


def test_a_window_of_speed() -> None:
    samples = block(0, [0.0] * 4, [5.0, -5.0, 5.1, -5.1])
    assert SettlingWindow(error=1.0, speed=5.0).inside(samples, 0.0).tolist() == [True, True, False, False]
    assert SettlingWindow(error=1.0).inside(samples, 0.0).tolist() == [True] * 4


@pytest.mark.parametrize(
    ("error", "until", "before", "since"),
    [
        ([0.0] * 4, 54, inf, 50.0),
        ([0.0] * 4, 54, 40.0, 40.0),
        ([2.0, 0.0, 0.0, 0.0], 54, 40.0, 51.0),
        ([0.0, 0.0, 2.0, 0.0], 54, 40.0, 53.0),
        ([0.0, 0.0, 2.0, 0.0], 53, 40.0, inf),
        ([0.0, 0.0, 2.0, 0.0], 52, 40.0, 40.0),
        ([0.0, 0.0, 2.0, 2.0], 54, 40.0, inf),
        ([2.0] * 4, 54, 40.0, inf),
        ([0.0] * 4, 50, 40.0, inf),
    ],
)
def test_a_window_passed_by_samples(error: list[float], until: int, before: float, since: float) -> None:
    window = SettlingWindow(error=1.0)
    window.since = before
    window.pass_by(block(50, error), 100.0, until)
    assert window.since == since


def test_windows_are_the_same_by_their_bounds() -> None:
    window = SettlingWindow(1.0, 2.0, 3.0)
    assert window.same(SettlingWindow(1.0, 2.0, 3.0, announced=False))
    for other in (
        SettlingWindow(1.5, 2.0, 3.0),
        SettlingWindow(1.0, 2.5, 3.0),
        SettlingWindow(1.0, 2.0, 4.0),
        None,
    ):
        assert not window.same(other)
    assert not window.same(SettlingWindow(1.0, 2.0, 3.0, at_target=True))


def test_samples_are_kept_and_extended() -> None:
    samples = block(50, [0.0, 1.0, 2.0, 3.0])
    assert (len(samples), samples.end) == (4, 54)
    samples.extend(block(54, [4.0, 5.0]).rows)
    assert (samples.first, samples.end) == (50, 56)
    samples.keep(52, 55)
    assert (samples.first, samples.error.tolist()) == (52, [2.0, 3.0, 4.0])
    samples.keep(40, 54)
    assert (samples.first, samples.error.tolist()) == (52, [2.0, 3.0])
    assert samples.encoder.tolist() == [98.0, 97.0]


@pytest.mark.parametrize(
    ("position", "level", "found"),
    [
        ([0.0, 2.0, 4.0, 6.0], 4.0, 2),
        ([0.0, 2.0, 4.0 - 5e-7, 6.0], 4.0, 2),  # within a millionth
        ([0.0, 2.0, 4.0 - 2e-6, 6.0], 4.0, 3),
        ([6.0, 5.0, 4.0 + 5e-7, 0.0], 4.0, 2),
        ([6.0, 5.0, 4.0 + 2e-6, 0.0], 4.0, 3),
        ([0.0, 2.0, 3.0], 4.0, None),
        ([4.0, 4.0, 4.0 + 5e-7, 4.1], 4.0, 3),  # it is there: when it leaves
        ([4.0, 4.0, 3.9], 4.0, 2),
        ([4.0, 4.0], 4.0, None),
        ([1e9, 1e9 + 5e-4, 1e9 + 1.0], 1e9, 2),  # rounding of large positions
        ([0.0, 1e9 - 5e-4, 1e9 + 1.0], 1e9, 1),
        ([0.0, -1e9 + 5e-4, -1e9 - 1.0], -1e9, 1),
    ],
)
def test_a_level_is_reached_or_left(position: list[float], level: float, found: int | None) -> None:
    assert crossing(np.array(position), level) == found


@pytest.mark.parametrize(
    ("position", "level", "side", "found"),
    [
        ([0.0, 5.0, 6.0], 4.0, -1, (1, 1)),
        ([0.0, 4.0, 3.0], 4.0, -1, (1, 1)),  # reaching it counts
        ([0.0, 3.0, 2.0], 4.0, -1, (None, -1)),
        ([6.0, 5.0, 3.0], 4.0, 1, (2, -1)),
        ([4.0, 5.0, 3.0], 4.0, 1, (2, -1)),  # from the level back to its side, then to the other one
        ([4.0, 3.0, 5.0], 4.0, 1, (1, -1)),  # from the level to the other side
        ([4.0, 5.0, 3.0], 4.0, -1, (1, 1)),
        ([4.0, 4.0, 4.0], 4.0, 1, (None, 1)),
        ([4.0, 4.0, 4.0], 4.0, 0, (None, 0)),
        ([4.0, 4.0, 4.5], 4.0, 0, (2, 1)),
        ([4.0, 3.5, 4.5], 4.0, 0, (1, -1)),
        ([9.0, 3.5, 4.5], 4.0, 0, (1, -1)),  # only later samples count
        ([9.0, 4.0, 4.5], 4.0, 0, (2, 1)),
        ([4.0, 5.0, 6.0], 4.0, 1, (None, 1)),
    ],
)
def test_a_motor_changes_sides(
    position: list[float], level: float, side: int, found: tuple[int | None, int]
) -> None:
    assert next_side(np.array(position), level, side) == found


@pytest.mark.parametrize(
    ("values", "level", "found"),
    [
        ([1.0, 2.0, 5.0], 4.0, 2),
        ([5.0, 6.0, 3.0], 4.0, 2),
        ([1.0, 4.0, 1.0], 4.0, 1),  # at the level it is not clearly on a side
        ([1.0, 4.0 + 5e-7, 1.0], 4.0, 1),
        ([4.0, 5.0], 4.0, 1),
        ([1.0, 2.0, 3.0], 4.0, None),
        ([1.0, 1e9 - 0.5, 1.0], 1e9, 1),
        ([1.0, -1e9 + 0.5, 1.0], -1e9, 1),
    ],
)
def test_a_value_leaves_its_side(values: list[float], level: float, found: int | None) -> None:
    assert next_other_side(np.array(values), level) == found


def test_a_rest_is_seen_ahead_of_its_time() -> None:
    """A move of 10 in 1.1 s, and a rest that begins then, too soon, or elsewhere."""
    move = plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0)
    assert rests_as_seen(Track([0.0, 1.1], [move, hold(10.0)]))
    assert rests_as_seen(Track([5.0, 5.0, 7.0], [hold(0.0), move, hold(10.0)]))
    for late, before, after in (
        (1.0, move, hold(10.0)),
        (1.1, move, hold(9.0)),
        (1.1, move, hold(10.0, 5.0)),
        (1.1, move, move.shifted(10.0)),
        (0.6, move.cut(0.5), hold(move.position(0.5))),
        (9.0, plan("sinusoidal", 0.0, 10.0, 10.0, 50.0, 50.0).then(move.shifted(10.0)), hold(19.0)),
    ):
        assert not rests_as_seen(Track([0.0, late], [before, after])), late
    assert not rests_as_seen(Track([0.0], [move]))
