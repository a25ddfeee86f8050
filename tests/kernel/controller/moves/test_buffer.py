"""Other buffer entries: dwells, outputs, pulses."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.kernel.controller.machines import machine, until


def test_on_a_suspended_axis_outputs_change_and_moves_rest() -> None:
    c = machine(buffer_size=5)
    c.suspend(0)
    c.load_output(0, {3: 1})
    c.load_pulse(0, 2, 0.25)
    c.load_by(0, 10.0)
    c.go([0])
    assert until(c, 1.0).position(0) == 0.0
    assert [each[:3] for each in c.log.outputs] == [(0.0, 3, 1), (0.0, 2, 1), (0.25, 2, 0)]
    c.resume(0)
    assert until(c, 3.0).position(0) == 10.0


def test_relative_moves_count_through_what_does_not_move() -> None:
    c = machine(buffer_size=5)
    c.load_by(0, 10.0)
    c.load_dwell(0, 0.1)
    c.load_by(0, 5.0)
    c.go([0])
    assert until(c, 9.0).position(0) == 15.0


def test_listeners_are_notified_when_more_entries_are_free_than_requested() -> None:
    c = machine(buffer_size=4, buffer_low=2)
    events: list[tuple[float, str]] = []
    c.listeners.append(lambda what, axis: events.append((round(c.clock.now, 9), what)))
    for _ in range(4):
        c.load_by(0, 10.0)
    c.go([0])  # 1 free; 2 at 1.1 s; 3 at 2.2 s
    until(c, 9.0)
    assert events == [(2.2, "buffer-low"), (4.4, "idle")]


@pytest.mark.parametrize("duration", [-1.0, float("nan"), float("inf")])
def test_a_time_that_is_none_is_refused(duration: float) -> None:
    c = machine()
    with pytest.raises(Rejected):
        c.load_dwell(0, duration)
    with pytest.raises(Rejected):
        c.load_pulse(0, 1, duration)
    assert c.room(0) == 2


def test_relative_moves_keep_their_ends_when_the_present_one_gets_another() -> None:
    """10, then 5 more, a dwell and 3 more.

    15 and 18, although the first one ends at 12.
    """
    c = machine(1, buffer_size=5)
    c.load_to(0, 10.0)
    for distance in (5.0, 0.0, 3.0):
        if distance:
            c.load_by(0, distance)
        else:
            c.load_dwell(0, 0.5)
    c.go([0])
    until(c, 0.5).retarget_to(0, 12.0)
    until(c, 9.0)
    ends = [move.profile.end for move in c.log.moves if move.profile is not None and move.profile.distance]
    assert ends == pytest.approx([12.0, 15.0, 18.0])


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
