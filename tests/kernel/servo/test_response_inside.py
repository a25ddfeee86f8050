"""Seen from inside: step response, bandwidth, margins and gains against the `control` library."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from motionlang.kernel.servo import (
    Loop,
    VelocityDrive,
    loop_figures,
    response,
)
from motionlang.kernel.servo.response import bandwidth, closed_loop, reaches

if TYPE_CHECKING:
    pass
from tests.kernel.servo.test_response import PAIRS, closed_by_control


@pytest.mark.parametrize("name", PAIRS)
def test_poles_are_controls(name: str) -> None:
    loop, plant = PAIRS[name]
    _, closed = closed_by_control(loop, plant)
    step, _, _ = closed_loop(loop, plant)
    ours = np.abs(np.linalg.eigvals(step)).max()
    assert ours == pytest.approx(np.abs(closed.poles()).max(), abs=1e-6)


@pytest.mark.parametrize("name", PAIRS)
def test_the_quick_search_of_a_bandwidth_finds_the_same_to_the_last_bit(name: str) -> None:
    loop, plant = PAIRS[name]
    found = bandwidth(loop, plant)
    assert found == loop_figures(loop, plant).bandwidth
    assert reaches(loop, plant, found)
    assert reaches(loop, plant, 0.5 * found)
    assert not reaches(loop, plant, np.nextafter(found, np.inf))
    assert not reaches(loop, plant, 2.0 * found)


def test_a_loop_that_is_there_in_one_sample_has_all_the_frequencies_that_there_are() -> None:
    """5000 counts/s per volt are 1.25 counts per volt in a sample of 0.25 ms.

    At 0.8 volts per count, an error is corrected in the next sample.
    """
    assert bandwidth(Loop(0.8), VelocityDrive(5000.0, 1e-6)) == 2000.0


@pytest.mark.parametrize("name", PAIRS)
def test_without_the_quick_search_the_bandwidth_is_the_same(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The polynomials are not trusted if they come too near to the level."""
    loop, plant = PAIRS[name]
    found = bandwidth(loop, plant)
    monkeypatch.setattr(response, "_first_below", lambda *arguments: None)
    assert bandwidth(loop, plant) == pytest.approx(found, rel=1e-9)
    monkeypatch.setattr(response, "_first_below", lambda f, g, c, period, grid: len(grid))
    assert bandwidth(loop, plant) == pytest.approx(0.5 * loop.servo_rate)
    monkeypatch.setattr(response, "_first_below", lambda *arguments: 0)
    assert bandwidth(loop, plant) == 0.0
