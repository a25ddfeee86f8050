"""Jogs: ramps, limits, rates of their own, and when they are over, by hand.

The rates of the axis are 100 counts/s2, and its speed, which jogs do not use, is 10 counts/s.
"""

from __future__ import annotations

from math import inf, pi

import pytest

from tests.kernel.controller.machines import machine, until


def test_another_jog_at_its_beginning_replaces_one_without_an_acceleration_yet() -> None:
    """A sinusoidal ramp to 20 at 100 takes 0.1 pi s, at 50 twice that."""
    c = machine(1, shape="sinusoidal")
    c.jog(0, 20.0, "JOG")
    assert c.axes[0].profiles[-1].knots == pytest.approx((0.0, 0.1 * pi, inf))
    c.jog(0, 20.0, "JOG", rates=(50.0, None))
    assert c.axes[0].profiles[-1].knots == pytest.approx((0.0, 0.2 * pi, inf))
    assert len(c.log.moves) == 2


def test_the_same_jog_again_at_its_velocity_changes_nothing_after_another_one() -> None:
    c = machine(1)
    c.jog(0, 15.0, "JOG", 1)
    until(c, 1.0).jog(0, 20.0, "JOG", 2)
    until(c, 2.0).jog(0, 20.0, "JOG", 3, rates=(50.0, None))
    assert [move.line for move in c.log.moves] == [1, 2]
