"""A simulated motor is at standstill once a block of rest exceeds none before it."""

from __future__ import annotations

import numpy as np
import pytest

from motionlang.kernel.servo.standstill import HUNTING, StandstillDetector, extent, is_still
from motionlang.kernel.servo.step import State, at_rest

# Extents: lowest position (negated), highest, lowest output (negated), highest.
CALM = (-5.0, 5.0, 0.0, 0.0)
WIDER = (-5.0, 5.1, 0.0, 0.0)
LOWER = (-4.9, 5.0, 0.0, 0.0)
PUSHED = (-5.0, 5.0, 0.0, 2e-9)
# Within a millionth of a count, and a billionth of a volt.
NEARLY = (-5.0, 5.0 + 9e-7, 0.0, 9e-10)


def test_the_extent_of_samples() -> None:
    assert extent(np.array([3.0, -1.0, 2.0]), np.array([0.5, -0.25])) == (1.0, 3.0, 0.25, 0.5)


@pytest.mark.parametrize(
    ("blocks", "expected"),
    [
        ((CALM,), (False,)),
        ((CALM, CALM), (False, True)),
        ((CALM, NEARLY), (False, True)),
        ((CALM, WIDER, CALM), (False, False, True)),
        ((CALM, LOWER, LOWER), (False, False, True)),
        ((CALM, PUSHED), (False, False)),
        ((CALM, None, CALM, CALM), (False, False, False, True)),
    ],
)
def test_a_motor_rests_when_a_block_is_no_wider_than_the_one_before(
    blocks: tuple[tuple[float, ...] | None, ...], expected: tuple[bool, ...]
) -> None:
    """None is a block in which the command moved.

    Before any command the motor is at rest, too.
    """
    detector, found = StandstillDetector(), list[bool]()
    assert detector.at_standstill
    detector.disturb()
    assert not detector.at_standstill
    for block in blocks:
        detector.check(block, 1.0)
        found.append(detector.at_standstill)
    assert tuple(found) == expected


def test_a_motor_that_hunts_rests_after_20_seconds_in_its_range() -> None:
    """It alternates between two ranges, so each block exceeds the one before.

    A wider block counts as motion.
    Blocks take 5 s, so the fifth is the first after more than 20 s.
    """
    assert HUNTING == 20.0  # seconds
    detector, found = StandstillDetector(), list[bool]()
    detector.disturb()
    for number in range(10):
        detector.check((-5.0, 6.0, 0.0, 0.0) if number % 2 else (-4.0, 5.0, 0.0, 0.0), 5.0)
        found.append(detector.at_standstill)
    assert found == [False] * 4 + [True] * 6
    detector.check((-5.0, 7.0, 0.0, 0.0), 5.0)
    assert not detector.at_standstill
    detector.disturb()
    detector.check((-4.0, 5.0, 0.0, 0.0), 5.0)
    assert not detector.at_standstill


@pytest.mark.parametrize(
    ("position", "output", "moved", "still"),
    [
        ([5.0, 5.0], [1.0, 1.0], 0.0, True),
        ([5.0, 5.0 + 9e-10], [1.0, 1.0 - 9e-10], 9e-10, True),
        ([5.0, 5.0 + 2e-9], [1.0, 1.0], 0.0, False),
        ([5.0, 5.0], [1.0, 1.0 - 2e-9], 0.0, False),
        ([5.0, 5.0], [1.0, 1.0], -2e-9, False),
        ([1e9, 1e9 + 5e-6], [1.0, 1.0], 0.0, True),  # at 1e9 counts a float has steps of 1e-7
        ([-1e9, -1e9 - 5e-6], [1.0, 1.0], 5e-6, False),
    ],
)
def test_a_motor_is_still_if_only_rounding_moves_it(
    position: list[float], output: list[float], moved: float, still: bool
) -> None:
    """`moved` is the change of its velocity."""
    before = at_rest(position[0])
    after: State = (position[0], moved, 0.0, 0.0, 0.0), before[1]
    assert is_still(extent(np.array(position), np.array(output)), before, after) is still
