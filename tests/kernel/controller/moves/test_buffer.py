"""Other buffer entries: dwells, outputs, pulses.

The tests include identifiers and low-buffer events.
"""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from tests.cases import cases
from tests.kernel.controller.machines import machine, until


def test_a_dwell_between_two_moves() -> None:
    c = machine(buffer_size=5)
    c.load_by(0, 10.0)
    c.load_dwell(0, 0.5, "MOVEDWELL", 3)
    c.load_by(0, 10.0)
    c.go([0])
    assert until(c, 1.3).position(0) == 10.0  # 1.1 s for each move
    assert not c.is_idle(0)
    assert until(c, 1.6).position(0) == 10.0
    assert until(c, 2.7).position(0) == 20.0
    assert c.is_idle(0)
    rows = [(move.command, move.start_time, move.profile and move.profile.duration) for move in c.log.moves]
    assert rows == [
        ("", 0.0, pytest.approx(1.1)),
        ("MOVEDWELL", pytest.approx(1.1), 0.5),
        ("", 1.6, pytest.approx(1.1)),
    ]


def test_outputs_change_between_moves_and_take_no_time() -> None:
    c = machine(buffer_size=9)
    c.load_output(0, {3: 1})
    c.load_by(0, 10.0)
    c.load_output(0, {3: 0, 4: 1})
    c.load_by(0, 10.0)
    assert c.output(3) == 0
    c.go([0])
    until(c, 5.0)
    assert [(round(time, 9), channel, value) for time, channel, value, *_ in c.log.outputs] == [
        (0.0, 3, 1),
        (1.1, 3, 0),
        (1.1, 4, 1),
    ]
    assert c.log.moves[-1].start_time == pytest.approx(1.1)


def test_a_pulse_does_not_hold_up_the_next_move() -> None:
    c = machine(buffer_size=5)
    c.load_pulse(0, 2, 0.25)
    c.load_by(0, 10.0)
    c.go([0])
    until(c, 5.0)
    assert [each[:3] for each in c.log.outputs] == [(0.0, 2, 1), (0.25, 2, 0)]
    assert c.log.moves[0].start_time == 0.0


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


def test_a_second_pulse_prolongs_the_first() -> None:
    c = machine()
    c.pulse(2, 0.25)
    until(c, 0.2)
    c.pulse(2, 0.25)
    until(c, 1.0)
    assert [each[:3] for each in c.log.outputs] == [(0.0, 2, 1), (0.45, 2, 0)]


def test_relative_moves_count_through_what_does_not_move() -> None:
    c = machine(buffer_size=5)
    c.load_by(0, 10.0)
    c.load_dwell(0, 0.1)
    c.load_by(0, 5.0)
    c.go([0])
    assert until(c, 9.0).position(0) == 15.0


def test_only_what_was_released_by_go_is_carried_out() -> None:
    c = machine(buffer_size=5)
    c.load_by(0, 10.0)
    c.go([0])
    c.load_output(0, {1: 1})
    until(c, 5.0)
    assert c.output(1) == 0
    c.go([0])
    assert c.output(1) == 1


def test_moves_carry_the_mark_of_their_loading() -> None:
    c = machine(buffer_size=5)
    for mark in (7, 8):
        c.configure(0, "move_id", mark)
        c.load_by(0, 10.0)
    c.go([0])
    assert c.move_id(0) == 7
    assert until(c, 2.0).move_id(0) == 8
    assert until(c, 9.0).move_id(0) == 8


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


@cases("override, mode, duration", [(2.0, 1, 1.1), (2.0, 3, 0.7), (0.5, 3, 2.05), (2.0, 2, 0.7)])
def test_the_override_multiplies_the_speed_of_moves_loaded_with_bit_1(
    override: float, mode: int, duration: float
) -> None:
    c = machine(1, feedrate_mode=mode, override=override)
    c.move_to(0, 10.0)
    assert c.idle_time(0) == pytest.approx(duration)


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
