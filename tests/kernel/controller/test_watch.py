"""Watches: a call at the exact time at which an axis passes a position."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller


def machine() -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


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


def test_a_watch_can_stop_the_axis_it_watches() -> None:
    c = machine()
    c.watch(0, 6.0, lambda _: c.stop(0))
    c.move_to(0, 12.0)
    c.clock.advance(9.0)
    assert c.position(0) == pytest.approx(8.0)
