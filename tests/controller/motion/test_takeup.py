"""Take-up of backlash: its rate, by hand arithmetic."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.controller.motion.takeup import Takeup
from motionlang.source import Source
from tests.controller.machines import machine, until
from tests.fuzz.guard import bounded


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


def test_no_play_is_taken_up_while_a_spline_stands_on_its_way() -> None:
    """Backlash of 2 takes 0.2 s of motion: half of it in the first 100 ms.

    None is taken up in the next 100 ms, in which the spline is at rest.
    """
    text = (
        "Dim way(4) As Float = 3, 10, 0, 10\nDim slow(4) As Float = 3, 0, 0, 0\n"
        "BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 200 : BACKLASHMODE(0) = 1\n"
        "SPLINETABLE(0, way, slow, NULL) : SPLINETIME(0) = 100\nSPLINE(0) = 0 : GO(0)\n"
        "WAIT = 150\nPRINT ENCODER(0) - POS(0) USING 1, 4\n"
        "PAUSE IDLE(0)\nPRINT ENCODER(0) - POS(0) USING 1, 4\n"
    )
    with bounded(5.0):  # the standstill is one stretch, not one every nanosecond
        result = run(Source("spline.mnt", text), machine={}, cache=False)
    assert [each.message for each in result.diagnostics] == []
    assert result.output == ["1.0000", "2.0000"]
