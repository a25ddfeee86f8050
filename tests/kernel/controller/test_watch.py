"""Watches: a call at the exact time at which an axis passes a position."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller


def machine() -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


def test_a_watch_is_notified_of_the_direction_at_the_exact_time() -> None:
    c = machine()
    seen: list[tuple[float, int]] = []
    c.watch(0, 6.0, lambda direction: seen.append((c.clock.now, direction)))
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 0.0)
    c.clock.advance(20.0)
    assert [direction for _, direction in seen] == [1, -1]
    assert [time for time, _ in seen] == pytest.approx([1.0, 6.0])


def test_stopping_on_a_position_is_reaching_it_and_leaving_it_is_not() -> None:
    c = machine()
    seen: list[int] = []
    c.watch(0, 12.0, seen.append)
    c.move_to(0, 12.0)
    c.clock.advance(3.0)
    reached = len(seen)
    c.move_to(0, 24.0)
    c.clock.advance(9.0)
    assert (reached, len(seen)) == (1, 1)


def test_touching_a_position_and_turning_back_passes_it_both_ways() -> None:
    c = machine()
    seen: list[int] = []
    c.watch(0, 12.0, seen.append)
    c.move_to(0, 12.0)
    c.clock.advance(3.0)
    c.move_to(0, 0.0)
    c.clock.advance(9.0)
    assert seen == [1, -1]


@pytest.mark.parametrize("days", [0.01, 1.0, 30.0])
@pytest.mark.parametrize("speed", [1e5, 1e7, 84e6])
def test_a_fast_axis_passes_once_also_after_days(days: float, speed: float) -> None:
    """After days the clock is coarser than a position's margin."""
    c = machine()
    for name, value in (("speed", speed), ("accel", 1e9), ("decel", 1e9)):
        c.configure(0, name, value)
    c.clock.advance(days * 86400.0 + 0.123456789)
    seen: list[int] = []
    positions = [speed * (0.013 * k + 0.0001) for k in range(1, 40)]

    def pass_by(direction: int) -> None:
        seen.append(direction)
        assert len(seen) <= 2 * len(positions)

    for position in positions:
        c.watch(0, position, pass_by)
    c.move_to(0, speed)
    c.clock.advance(c.clock.now + 3.0)
    c.move_to(0, 0.0)
    c.clock.advance(c.clock.now + 3.0)
    assert seen == [1] * len(positions) + [-1] * len(positions)


def test_a_watch_set_in_motion_sees_only_what_is_still_to_come() -> None:
    c = machine()
    seen: list[int] = []
    c.move_to(0, 12.0)
    c.clock.advance(1.5)
    c.watch(0, 6.0, seen.append)
    c.watch(0, 11.0, seen.append)
    c.clock.advance(9.0)
    assert seen == [1]


def test_a_switch_stays_where_the_machine_has_it() -> None:
    c = machine()
    seen: list[float] = []
    c.watch(0, 6.0, lambda _: seen.append(c.clock.now), physical=True)
    c.define_position(0, 100.0)
    c.move_to(0, 112.0)
    c.clock.advance(9.0)
    assert seen == [pytest.approx(1.0)]


def test_a_watch_can_stop_the_axis_it_watches() -> None:
    c = machine()
    c.watch(0, 6.0, lambda _: c.stop(0))
    c.move_to(0, 12.0)
    c.clock.advance(9.0)
    assert c.position(0) == pytest.approx(8.0)


def test_unwatch_ends_it() -> None:
    c = machine()
    seen: list[int] = []
    watch = c.watch(0, 6.0, seen.append)
    c.move_to(0, 12.0)
    c.unwatch(0, watch)
    c.clock.advance(9.0)
    assert seen == []


def test_channels_log_and_notify_changes_only() -> None:
    c = machine()
    changes: list[tuple[int, float]] = []
    c.outputs.listeners.append(lambda channel, value: changes.append((channel, value)))
    c.set_output(3, 1)
    c.set_output(3, 1)
    c.clock.advance(2.0)
    c.outputs.set_bank(0, 4, 0b0101)
    assert changes == [(3, 1), (0, 1), (2, 1), (3, 0)]
    assert c.log.outputs[0][:3] == (0.0, 3, 1)
    assert [c.outputs[channel] for channel in range(4)] == [1, 0, 1, 0]
