"""The kinds of waits: when they are over, and when they are checked."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Controller, Source
from motionlang.kernel.lang import wait_idle, wait_until


def test_a_delay_ends_at_its_time() -> None:
    """Times less than a nanosecond apart are equal."""
    controller = Controller(1)
    delay = wait_until(controller, 1.0, 3.5)
    assert (delay.since, delay.due(), delay.why) == (1.0, 3.5, "for 2.5 s")
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


def test_the_record_of_a_wait() -> None:
    """A wait for a time needs no description: its line and its length say all."""
    driven: dict[str, object] = {"input": [{"channel": 2, "at": 1.0}]}
    found = run(Source("a.mcl", "WA0.005,1MN,1MR10,1WS,WN2"), machine=driven)
    assert [(each.cause, each.what, each.why) for each in found.machine.log.waits] == [
        ("time", (), ""),
        ("axis", (1,), "for axis 1 to be idle"),
        ("input", (2,), "for channel 2 to be on"),
    ]
