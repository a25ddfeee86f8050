"""Speeds, rates and limits that change in motion: what `tests/spec` does not show."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


def test_both_kinds_of_move_share_one_buffer() -> None:
    c = machine(buffer_size=5)
    for mode in (1, 0):
        c.configure(0, "feedrate_mode", mode)
        c.load_by(0, 10.0)
    c.configure(0, "speed", 20.0)
    c.go([0])
    until(c, 9.0)
    assert [move.profile and move.profile.peak_speed for move in c.log.moves] == [10.0, 20.0]


def test_a_speed_does_not_wake_an_axis_that_is_stopping() -> None:
    c = machine(feedrate_mode=0)
    c.move_to(0, 20.0)
    until(c, 1.0).stop(0)
    until(c, 1.05).configure(0, "speed", 20.0)
    assert until(c, 9.0).position(0) == pytest.approx(10.0)


def test_a_stop_of_a_move_has_the_jerk_of_its_own_speed_and_rate() -> None:
    """From 2 at 50 a ramp of 100 % takes 0.08 s, over 2 * 0.08 / 2 = 0.08."""
    c = machine(shape="scurve", s_ramp=1.0, speed=2.0, feedrate_mode=1)
    c.load_by(0, 5.0)
    c.axes[0].buffer[-1].rates = None, 50.0
    c.configure(0, "speed", 40.0)
    c.go([0])
    until(c, 1.0).stop(0)
    assert c.idle_time(0) == pytest.approx(1.08)
    assert until(c, 2.0).position(0) == pytest.approx(2.0 * 1.0 - 0.04 + 0.08)


def test_a_velocity_that_is_decided_at_each_tick() -> None:
    """It speeds up by 0.1 and slows down by 0.05 counts/s each ms.

    At rest there are no more ticks.
    """
    c = machine(decel=50.0, max_speed=8.0)
    wanted = [10.0, False]
    decided: list[float] = []

    def decide() -> tuple[float, bool]:
        decided.append(c.clock.now)
        return wanted[0], bool(wanted[1])

    track = c.track(0, decide, "HTA", 3)
    with pytest.raises(Rejected, match="axis 0 is in HTA, which takes no other motion"):
        c.track(0, decide, "HTA", 3)
    c.jog(1, 1.0)
    with pytest.raises(Rejected, match="axis 1 is moving"):
        c.track(1, decide, "HTA", 3)
    until(c, 0.0505)
    assert (len(decided), c.is_idle(0)) == (50, False)
    assert c.velocity(0) == pytest.approx(4.95)
    assert until(c, 0.0905).velocity(0) == pytest.approx(8.0)
    wanted[0] = 6.98
    until(c, 0.1105)
    assert c.velocity(0) == pytest.approx(7.025)
    assert until(c, 0.2).velocity(0) == pytest.approx(6.98)
    wanted[0] = -1.0
    until(c, 0.5)
    assert c.velocity(0) == pytest.approx(-1.0)
    wanted[0] = 0.0
    until(c, 1.0)
    count = len(decided)
    assert (c.velocity(0), track.resting, c.axes[0].is_at_standstill) == (0.0, True, True)
    until(c, 2.0)
    assert len(decided) == count
    wanted[:] = [0.0, True]
    track.wake()
    until(c, 2.0105)
    assert len(decided) == count + 10
    assert not track.resting
    c.suspend(0)
    until(c, 3.0)
    assert (track.resting, len(decided)) == (True, count + 10)
    wanted[0] = 1.0
    c.resume(0)
    assert until(c, 4.0).velocity(0) == pytest.approx(1.0)
