"""Positions captured at edges, and outputs switched at positions, both exact."""

from __future__ import annotations

import pytest

from motionlang.controller.controller import Controller
from tests.cases import cases
from tests.controller.machines import machine, until


def pulses(c: Controller, channel: int, *times: float) -> None:
    """Turn the input on for 10 ms at each of the times, s."""
    for time in times:
        c.clock.at(time, lambda: c.inputs.__setitem__(channel, 1))
        c.clock.at(time + 0.01, lambda: c.inputs.__setitem__(channel, 0))


def captured(c: Controller) -> list[float]:
    """Return a list that gets the captures of latch 0 from now on."""
    seen: list[float] = []
    c.listeners.append(lambda what, _: seen.append(c.latch(0).value) if what == "latch" else None)
    return seen


def test_the_position_is_that_of_the_moment_of_the_edge() -> None:
    c = machine()
    events: list[tuple[str, int]] = []
    c.listeners.append(lambda what, number: events.append((what, number)))
    c.latch_on_input(5, 0, 2)
    c.latch(5).enabled = True
    pulses(c, 2, 1.23456)
    c.move_to(0, 20.0)
    until(c, 2.0)
    latch = c.latch(5)
    assert latch.value == pytest.approx(10.0 * 1.23456 - 0.5, abs=1e-12)
    assert latch.time == 1.23456
    assert events == [("latch", 5)]
    assert [latch.take(), latch.take()] == [True, False]


def test_once_or_again_and_again() -> None:
    for automatic, expected in ((False, 5.0), (True, 9.0)):
        c = machine()
        c.latch_on_input(0, 0, 2)
        c.latch(0).enabled, c.latch(0).automatic = True, automatic
        pulses(c, 2, 0.55, 0.95)
        c.move_to(0, 20.0)
        until(c, 5.0)
        assert c.latch(0).value == pytest.approx(expected)
        assert c.latch(0).enabled is automatic


@pytest.mark.parametrize(("edge", "expected"), [(1, 5.0), (-1, 5.1), (0, 5.1)])
def test_rising_falling_and_both(edge: int, expected: float) -> None:
    c = machine()
    c.latch_on_input(0, 0, 2, edge)
    c.latch(0).enabled = c.latch(0).automatic = True
    pulses(c, 2, 0.55)
    c.move_to(0, 20.0)
    assert until(c, 5.0).latch(0).value == pytest.approx(expected)


def test_edges_too_near_to_the_last_one_do_not_count() -> None:
    for name, value in (("inhibit_time", 0.3), ("inhibit_distance", 3.0)):
        c = machine()
        c.latch_on_input(0, 0, 2)
        c.latch(0).enabled = c.latch(0).automatic = True
        setattr(c.latch(0), name, value)
        pulses(c, 2, 0.55, 0.75, 0.95)
        c.move_to(0, 20.0)
        seen = captured(c)
        until(c, 5.0)
        assert seen == pytest.approx([5.0, 9.0])


def test_an_encoder_that_the_world_turns_is_captured_too() -> None:
    c = machine()
    c.drive_encoder(3, 1000.0)
    c.latch_on_input(0, 3, 2, encoder=True)
    c.latch(0).enabled = True
    pulses(c, 2, 0.5)
    assert until(c, 1.0).latch(0).value == pytest.approx(500.0)


def test_index_marks_there_and_back() -> None:
    c = machine()
    c.axes[0].index_every, c.axes[0].index_origin = 4.0, 1.0
    c.latch_on_index(0, 0)
    c.latch(0).enabled = c.latch(0).automatic = True
    seen = captured(c)
    c.move_to(0, 11.0)
    until(c, 2.0)
    c.move_to(0, -6.0)
    until(c, 9.0)
    assert seen == pytest.approx([1.0, 5.0, 9.0, 9.0, 5.0, 1.0, -3.0])
    assert c.latch(0).time == pytest.approx(2.0 + 14.5 / 10.0)


def test_an_output_is_on_between_two_positions() -> None:
    c = machine()
    compare = c.compare(0, 7, 8.0, 5.0)
    c.move_to(0, 20.0)
    until(c, 5.0)
    assert [value for _, _, value in c.log.outputs] == [1, 0]
    assert [time for time, _, _ in c.log.outputs] == pytest.approx([0.55, 0.85])
    compare.enable(False)
    compare.place(19.0, 21.0)
    assert c.output(7) == 0
    compare.enable(True)
    assert c.output(7) == 1
    compare.remove()
    c.move_to(0, 0.0)
    assert until(c, 9.0).output(7) == 1


def test_a_compare_is_notified_of_a_new_zero() -> None:
    c = Controller(1)
    c.compare(0, 7, 5.0, 10.0)
    c.define_position(0, 7.0)
    between = c.output(7)
    c.define_position(0, 12.0)
    assert (between, c.output(7)) == (1, 0)


@cases(
    "time, distance, taken",
    [
        # Edges at 1, 1.5 and 2.25 s, at 8, 12 and 18 counts. Just as long or as far as inhibited is enough.
        (0.0, 0.0, [8.0, 12.0, 18.0]),
        (0.5, 0.0, [8.0, 12.0, 18.0]),
        (0.75, 0.0, [8.0, 18.0]),
        (1.5, 0.0, [8.0]),
        (0.0, 4.0, [8.0, 12.0, 18.0]),
        (0.0, 4.5, [8.0, 18.0]),
        (0.0, 10.5, [8.0]),
        (0.75, 4.5, [8.0, 18.0]),
        (0.75, 10.5, [8.0]),
        (1.5, 4.5, [8.0]),
    ],
)
def test_when_the_next_edge_counts(time: float, distance: float, taken: list[float]) -> None:
    for back in (False, True):
        c = machine()
        c.drive_encoder(7, -8.0 if back else 8.0)
        c.latch_on_input(0, 7, 2, encoder=True)
        latch = c.latch(0)
        latch.enabled = latch.automatic = True
        latch.inhibit_time, latch.inhibit_distance = time, distance
        pulses(c, 2, 1.0, 1.5, 2.25)
        seen = captured(c)
        until(c, 5.0)
        assert seen == [-each if back else each for each in taken]
        assert latch.fired


def test_a_latch_is_off_at_first_and_another_input_does_not_matter() -> None:
    c = machine()
    c.latch_on_input(0, 0, 2)
    latch = c.latch(0)
    assert (latch.enabled, latch.automatic, latch.fired, latch.value) == (False, False, False, 0.0)
    pulses(c, 2, 0.5)
    assert not until(c, 1.0).latch(0).fired
    latch.enabled = True
    pulses(c, 3, 1.5)
    assert not until(c, 2.0).latch(0).fired
    latch.release()
    pulses(c, 2, 2.5)
    assert not until(c, 3.0).latch(0).fired
