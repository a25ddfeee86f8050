"""Suspend and resume, and a new target for the move in progress."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


def test_resumed_before_it_has_come_to_rest_the_axis_goes_on_from_its_speed() -> None:
    c = machine()
    c.move_to(0, 20.0)
    until(c, 1.0).suspend(0)
    until(c, 1.05).resume(0)
    assert c.velocity(0) == pytest.approx(5.0)
    assert until(c, 1.1).velocity(0) == pytest.approx(10.0)
    assert until(c, 9.0).position(0) == 20.0


def test_moves_started_while_suspended_wait_for_resume() -> None:
    c = machine()
    c.suspend(0)
    c.load_by(0, 10.0)
    c.load_by(0, 10.0)
    c.go([0])
    assert until(c, 3.0).position(0) == 0.0
    assert not c.is_idle(0)
    c.resume(0)
    assert until(c, 5.2).position(0) == 20.0
    assert c.is_idle(0)


def test_stop_ends_what_is_suspended() -> None:
    c = machine()
    c.move_to(0, 20.0)
    until(c, 1.0).suspend(0)
    until(c, 2.0).stop(0)
    assert until(c, 3.0).is_idle(0)
    assert not c.is_suspended(0)
    assert c.position(0) == pytest.approx(10.0)
    assert c.log.moves[0].ended == "stop"


@pytest.mark.parametrize("jogs", [True, False])
def test_a_stop_needs_no_acceleration(jogs: bool) -> None:
    """At 1 s the axis is at 9.5 with a velocity of 10; at 100 it stops within 0.5."""
    c = machine()
    if jogs:
        c.jog(0, 10.0)
    else:
        c.move_to(0, 20.0)
    until(c, 1.0).configure(0, "accel", 0.0)
    c.stop(0)
    assert until(c, 2.0).position(0) == pytest.approx(10.0)


@pytest.mark.parametrize("ended", ["stop", "fault"])
def test_a_hard_stop_has_the_deceleration_of_errors(ended: str) -> None:
    """From 10 at 200 it takes 0.25."""
    c = machine(error_decel=200.0)
    c.jog(0, 10.0)
    until(c, 1.0).stop(0, ended, hard=True)
    assert until(c, 2.0).position(0) == pytest.approx(9.75)


def test_a_stop_without_a_deceleration_is_rejected_and_changes_nothing() -> None:
    c = machine()
    c.jog(0, 10.0)
    until(c, 1.0).configure(0, "decel", 0.0)
    c.load_to(0, 5.0)
    with pytest.raises(Rejected, match="axis 0 cannot stop: its deceleration is 0"):
        c.stop(0)
    assert len(c.axes[0].buffer) == 1
    assert list(c.log.events) == []
    assert until(c, 2.0).velocity(0) == 10.0
    c.configure(0, "decel", 100.0)
    c.stop(0)
    assert until(c, 3.0).is_idle(0)


def test_a_new_end_point_keeps_the_move() -> None:
    c = machine()
    c.move_to(0, 20.0)
    until(c, 1.0).retarget_by(0, 10.0)
    assert c.target(0) == 30.0
    assert c.idle_time(0) == pytest.approx(3.1)
    until(c, 1.5).retarget_to(0, 5.0)
    assert until(c, 9.0).position(0) == 5.0
    assert len(c.log.moves) == 1
    assert c.log.moves[0].target == 5.0


def test_an_axis_at_rest_starts_at_once() -> None:
    c = machine()
    c.retarget_by(0, 10.0, "INCR", 4)
    assert until(c, 2.0).position(0) == 10.0
    assert c.log.moves[0].command == "INCR"


def test_a_jog_and_a_stop_have_no_end_point_to_change() -> None:
    c = machine()
    c.jog(0, 5.0)
    with pytest.raises(Rejected, match="position"):
        c.retarget_to(0, 3.0)
    c.stop(0)
    with pytest.raises(Rejected, match="position"):
        c.retarget_to(0, 3.0)


def test_what_does_not_suspend_an_axis_does_not_resume_it() -> None:
    """A move that goes on is not planned again, as a resumed one is. Reason 2 is an input."""
    c = machine()
    c.move_to(0, 20.0)
    until(c, 1.0).resume(0, 2)
    assert len(c.axes[0].starts) == 2
    c.suspend(0)
    until(c, 3.0).resume(0, 2)
    assert until(c, 4.0).is_suspended(0)
