"""The kinds of waits: when they are over, and when they are checked."""

from __future__ import annotations

from math import inf
from typing import Any

import pytest

from motionlang import run
from motionlang.kernel import Controller, Source
from motionlang.kernel.controller import Clock
from motionlang.kernel.lang import wait_idle, wait_until
from motionlang.kernel.lang.change_times import MAX_NOTES, Dependencies
from motionlang.kernel.lang.waits import TICK, Condition, Delay, next_tick, until_idle


def test_a_delay_ends_at_its_time() -> None:
    """Times less than a nanosecond apart are equal."""
    controller = Controller(1)
    delay = wait_until(controller, 1.0, 3.5)
    assert isinstance(delay, Delay)
    assert (delay.since, delay.ends, delay.due(), delay.why) == (1.0, 3.5, 3.5, "for 2.5 s")
    for now, ready in ((3.4, False), (3.5 - 2e-9, False), (3.5 - 0.5e-9, True), (3.5, True), (4.0, True)):
        controller.clock.now = now
        assert delay.ready() is ready


def test_a_wait_for_standstill_of_several_axes() -> None:
    """A ramp to 8 at 16 takes 0.5 s and covers 2.

    The other 8 and 16 of the moves take 1 s and 2 s, so the moves take 2 s and 3 s.
    """
    controller = Controller(3)
    for axis, distance in ((0, 12.0), (1, 20.0)):
        for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
            controller.configure(axis, name, value)
        controller.load_by(axis, distance)
    controller.go([0, 1])
    wait = wait_idle(controller, 0.0, iter([0, 1, 2]))
    assert (wait.ready(), wait.due(), wait.why) == (False, 3.0, "for axis 0, 1, 2 to be idle")
    assert (wait.cause, wait.what) == ("axis", (0, 1, 2))
    controller.clock.advance(2.5)
    assert (wait.ready(), wait.due()) == (False, 3.0)
    controller.clock.advance(3.0)
    assert wait.ready()
    assert wait_idle(controller, 1.25, []).due() == 1.25
    assert until_idle((4,)) == "for axis 4 to be idle"


@pytest.mark.parametrize(
    ("now", "tick"), [(0.0, 0.001), (0.0004, 0.001), (0.001, 0.002), (0.0039999999999, 0.005), (2.0, 2.001)]
)
def test_the_next_tick_of_the_profiler(now: float, tick: float) -> None:
    """A tick that rounding puts just after now is over."""
    assert next_tick(now) == pytest.approx(tick, abs=1e-12)


class Reading:
    """A value that changes at some times; a condition that reads it records when."""

    def __init__(self, *times: float) -> None:
        self.clock, self.times = Clock(), times
        self.dependencies = Dependencies(self.clock)

    def count(self) -> int:
        """Return how many of the times are over; a time itself is not."""
        self.dependencies.note(self.next)
        return sum(time < self.clock.now for time in self.times)

    def next(self) -> float:
        return min((time for time in self.times if time > self.clock.now), default=inf)


def test_a_condition_is_checked_when_its_reading_changes() -> None:
    """The reading changes at 1 s, which is not enough, and at 2 s."""
    reading = Reading(1.0, 2.0)
    wait = Condition(reading.dependencies, lambda: reading.count() > 1, 0.0, "until two")
    checks = []
    while not wait.ready():
        reading.clock.now = wait.due()
        checks.append(reading.clock.now)
    assert checks == [1.0, 2.0]
    assert (reading.clock.now, reading.dependencies.notes) == (2.0, None)
    assert not Condition(reading.dependencies, lambda: False, 0.0, "never").ready()


def test_a_condition_that_is_due_now_stays_due_until_it_is_checked() -> None:
    """It holds just after its time, so a second solution must not replace that time."""
    reading = Reading(1.0)
    wait = Condition(reading.dependencies, lambda: reading.count() > 0, 0.0, "until one")
    reading.clock.now = wait.due()
    assert (wait.due(), wait.due(), wait.ready()) == (1.0, 1.0, True)


def test_a_condition_without_readings_is_never_due() -> None:
    reading = Reading()
    assert Condition(reading.dependencies, lambda: False, 0.0, "never").due() == inf


def test_a_condition_that_cannot_be_solved_is_checked_at_each_tick() -> None:
    reading = Reading()
    dependencies = reading.dependencies

    def test() -> bool:
        dependencies.note(dependencies.at_once)
        return False

    wait = Condition(dependencies, test, 0.0, "until then")
    times = []
    for _ in range(3):
        reading.clock.now = wait.due()
        times.append(reading.clock.now)
    assert times == pytest.approx([TICK, 2 * TICK, 3 * TICK])


def test_the_first_change_of_several_readings() -> None:
    reading = Reading(1.0, 2.0)
    dependencies, notes = reading.dependencies, [(reading.next, ())]
    assert [dependencies.until(since, notes) for since in (0.5, 1.0, 2.0)] == [1.0, 2.0, inf]
    assert dependencies.until(0.5, [*notes, (dependencies.at_once, ())]) == 0.5
    assert dependencies.until(0.5, []) == inf
    assert reading.clock.now == 0.0


def test_a_list_of_too_many_readings_is_given_up() -> None:
    reading = Reading(1.0)
    dependencies = reading.dependencies
    notes: list[Any] = []
    dependencies.notes = notes
    for _ in range(MAX_NOTES):
        reading.count()
    assert dependencies.notes is notes
    reading.count()
    assert dependencies.notes is None


def test_the_record_of_a_wait() -> None:
    """A wait for a time needs no description: its line and its length say all."""
    driven: dict[str, object] = {"input": [{"channel": 2, "at": 1.0}]}
    found = run(Source("a.mcl", "WA0.005,1MN,1MR10,1WS,WN2"), machine=driven)
    assert [(each.cause, each.what, each.why) for each in found.machine.log.waits] == [
        ("time", (), ""),
        ("axis", (1,), "for axis 1 to be idle"),
        ("input", (2,), "for channel 2 to be on"),
    ]
