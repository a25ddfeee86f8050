"""Play that is taken up: how fast, by hand."""

from __future__ import annotations

import pytest

from motionlang.controller.motion.takeup import Takeup
from tests.controller.machines import machine, until


def test_play_is_taken_up_while_the_axis_moves_and_at_its_rate() -> None:
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size, play.ramp = 10.0, 2.0
    assert (play.advance(0.0, True), play.rate()) == (0.0, 0.0)
    c.move_to(0, 12.0)
    assert until(c, 1.0).velocity(0) == 10.0
    assert (play.advance(1.0, True), play.rate()) == (5.0, 5.0)
    until(c, 2.0)
    assert (play.advance(2.0, True), play.rate()) == pytest.approx((6.5, 0.0))
