"""Other buffer entries: dwells, outputs, pulses."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


@pytest.mark.parametrize("duration", [-1.0, float("nan"), float("inf")])
def test_a_time_that_is_none_is_refused(duration: float) -> None:
    c = machine()
    with pytest.raises(Rejected):
        c.load_dwell(0, duration)
    with pytest.raises(Rejected):
        c.load_pulse(0, 1, duration)
    assert c.room(0) == 2


def test_how_many_entries_fit() -> None:
    c = machine(1, buffer_size=3)
    assert c.room(0) == 3
    for left in (2, 1, 0):
        c.load_by(0, 1.0)
        assert c.room(0) == left
    with pytest.raises(Rejected, match="the move buffer of axis 0 is full"):
        c.load_by(0, 1.0)
    c.go([0])
    assert c.room(0) == 1
    assert until(c, 9.0).room(0) == 3
    assert c.position(0) == pytest.approx(3.0)


def test_a_relative_move_behind_a_jog_has_no_start() -> None:
    c = machine(1)
    c.jog(0, 10.0)
    with pytest.raises(Rejected, match="axis 0 moves without an end: a relative move has no start"):
        c.load_by(0, 1.0)
