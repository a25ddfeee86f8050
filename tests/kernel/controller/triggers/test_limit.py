"""Travel limits, exact to the count."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.controller.faults import LIMIT_FORWARD, SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE
from motionlang.kernel.controller.triggers.limit import Limit


def machine() -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0), ("error_decel", 32.0)):
        c.configure(0, name, value)
    return c


def limited(action: str, position: float = 6.0, physical: bool = False) -> tuple[Controller, Limit]:
    c = machine()
    limit = Limit(c, 0, +1, LIMIT_FORWARD if physical else SOFT_LIMIT_FORWARD, action, physical)
    c.axes[0].limits.append(limit)
    limit.set_position(position)
    return c, limit


def test_an_active_limit_stops_a_move_into_it_and_lets_one_out() -> None:
    c, limit = limited("abort")
    c.move_to(0, 12.0)
    c.clock.advance(9.0)
    assert limit.active
    c.clear_faults(0)
    c.move_to(0, 12.0)
    assert (c.is_idle(0), c.faults(0)) == (True, SOFT_LIMIT_FORWARD)
    c.clear_faults(0)
    c.move_to(0, 0.0)
    c.clock.advance(20.0)
    assert (c.position(0), c.faults(0), limit.active) == (0.0, 0, False)


def test_a_soft_limit_counts_from_the_programs_zero_and_a_switch_does_not() -> None:
    for physical, rest in ((False, 6.0), (True, 106.0)):
        c, _ = limited("abort", physical=physical)
        c.define_position(0, 100.0 if physical else 0.0)
        c.move_by(0, 12.0)
        c.clock.advance(9.0)
        assert c.position(0) == pytest.approx(rest)


def test_a_reverse_limit() -> None:
    c = machine()
    limit = Limit(c, 0, -1, SOFT_LIMIT_REVERSE, "abort")
    c.axes[0].limits.append(limit)
    limit.set_position(-6.0)
    c.jog(0, -8.0)
    c.clock.advance(9.0)
    assert c.position(0) == pytest.approx(-6.0)
    assert c.faults(0) == SOFT_LIMIT_REVERSE


def test_listeners_are_notified_of_faults_and_of_rest() -> None:
    c, _ = limited("abort")
    events: list[tuple[str, int]] = []
    c.listeners.append(lambda what, axis: events.append((what, axis)))
    c.move_to(0, 12.0)
    c.clock.advance(9.0)
    assert events == [("idle", 0), ("fault", 0), ("error", 0), ("limit", 0)]


def test_a_new_zero_takes_the_axis_out_of_a_software_limit() -> None:
    c, limit = limited("abort", -5.0)
    assert limit.active
    c.define_position(0, -20.0)
    assert not limit.active
    c.move_to(0, -10.0)
    c.clock.advance(9.0)
    assert (c.position(0), c.faults(0)) == (-10.0, 0)


def test_the_action_of_one_kind_of_limit() -> None:
    c, soft = limited("ignore")
    hard = Limit(c, 0, +1, LIMIT_FORWARD, "abort", physical=True)
    c.axes[0].limits.append(hard)
    c.set_limit_action(0, SOFT_LIMIT_FORWARD, "stop")
    assert (soft.action, hard.action) == ("stop", "abort")
    c.set_limit_action(0, LIMIT_FORWARD, "off")
    assert (soft.action, hard.action) == ("stop", "off")


def test_stops_and_aborts_of_a_program_are_events_and_faults_are_none() -> None:
    """At 0.5 s and 16 counts/s² the axis has 8 counts/s."""
    c = machine()
    for verb, *arguments in ((c.stop, 0), (c.abort, 0), (c.abort, 0, "fault")):
        c.abort(0, "fault")
        c.jog(0, 8.0, "JOG", 7)
        c.clock.advance(c.clock.now + 1.0)
        verb(*arguments)
        c.clock.advance(c.clock.now + 2.0)
    found = [(event.kind, event.value, event.limit, event.ordered, event.text) for event in c.log.events]
    assert found == [
        ("stop", 8.0, None, 7, ""),
        ("cancel", 8.0, None, 7, ""),
        ("velocity jump", 8.0, 0.0, 7, "cancel, an infinite acceleration"),
        ("velocity jump", 8.0, 0.0, 7, "fault, an infinite acceleration"),
    ]
