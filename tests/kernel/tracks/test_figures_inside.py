"""Seen from inside: extremes with their times, columns of a trace on request, and tracks, by hand."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.commands.certify.extremes import Extreme, extremes
from tests.kernel.tracks.test_figures import machine


def test_the_extremes_of_a_trapezoid_and_their_times() -> None:
    """0.1 s up, 0.2 s down, and 100 - 2.5 - 5 counts at speed in 1.85 s.

    Then back to -20 at rest at 3 s.
    """
    controller = machine()
    controller.clock.advance(1.0)
    controller.move_to(0, 100.0)
    controller.clock.advance(4.0)
    found = extremes(controller.axes[0], 4.0)
    assert (found.lowest.value, found.lowest.time) == (0.0, 0.0)
    assert (found.highest.value, found.highest.time) == pytest.approx((100.0, 3.15))
    assert (found.speed.value, found.speed.time) == pytest.approx((50.0, 1.1))
    assert (found.acceleration.value, found.acceleration.time) == pytest.approx((500.0, 1.0))
    assert (found.jerk.value, found.jerk.time) == (inf, 1.0)
    assert repr(Extreme(2.5, 1.0)) == "Extreme(2.5, 1)"
    # In the middle of the first ramp.
    early = extremes(controller.axes[0], 1.05)
    assert (early.speed.value, early.highest.value) == pytest.approx((25.0, 0.625))
    assert extremes(controller.axes[0], 0.5).speed.value == 0.0
