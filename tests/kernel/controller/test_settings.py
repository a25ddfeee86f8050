"""Speeds, rates and limits that change in motion: what `tests/spec` does not show."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


def test_the_override_acts_on_both_kinds_of_move_at_once() -> None:
    for mode in (2, 3):
        c = machine(feedrate_mode=mode)
        c.load_by(0, 100.0)
        c.go([0])
        until(c, 1.0).configure(0, "override", 1.5)
        assert until(c, 2.0).velocity(0) == pytest.approx(15.0)


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


@pytest.mark.parametrize(("percent", "ramp"), [(0.5, 0.03), (1.0, 0.04)])
@pytest.mark.parametrize("axes", [(0,), (0, 1)])
def test_a_percentage_of_a_ramp_is_one_of_the_speed_that_a_move_has(
    axes: tuple[int, ...], percent: float, ramp: float
) -> None:
    """A ramp to 2 at 100 takes 0.02 s, and half or all of that longer.

    The speed of the axis has no effect. A move of 5 takes 5 / 2 s and one ramp; a path along the first axis, too.
    """
    c = machine(shape="scurve", s_ramp=percent, speed=2.0, feedrate_mode=1)
    if axes == (0,):
        c.load_by(0, 5.0)
    else:
        c.load_line_by(axes, [5.0, 0.0])
    for axis in axes:
        c.configure(axis, "speed", 0.0)
    c.go([0])
    assert c.idle_time(0) == pytest.approx(2.5 + ramp)
    assert until(c, 0.5 * ramp).velocity(0) == pytest.approx(1.0)


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


def test_a_jog_with_rates_of_its_own_has_their_jerk() -> None:
    """A rise to 50 in 0.1 s, 50 for 0.1 s, and a fall in 0.1 s: 10 in 0.3 s."""
    c = machine(shape="scurve", accel_jerk_time=0.1, decel_jerk_time=0.1)
    c.jog(0, 10.0, rates=(50.0, 50.0))
    assert until(c, 0.1).velocity(0) == pytest.approx(2.5)
    assert until(c, 0.2).velocity(0) == pytest.approx(7.5)
    assert until(c, 0.3).velocity(0) == pytest.approx(10.0)


def test_bit_1_of_the_feed_rate_mode_alone_lets_the_override_act() -> None:
    c = machine(feedrate_mode=3)
    c.load_by(0, 100.0)
    c.go([0])
    until(c, 1.0).configure(0, "feedrate_mode", 1)
    c.configure(0, "override", 0.5)
    assert until(c, 2.0).velocity(0) == 10.0
    c.configure(0, "feedrate_mode", 2)
    assert until(c, 3.0).velocity(0) == pytest.approx(5.0)


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
