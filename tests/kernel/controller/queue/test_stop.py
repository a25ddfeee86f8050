"""Suspend and resume, and a new target for the move in progress."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


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
