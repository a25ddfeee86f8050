"""Suspend and resume, and a new target for the move in progress."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


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
