"""The state of an axis at past and future times, and its rates and jerks, by hand."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Axis
from motionlang.kernel.log import log as log_module
from tests.cases import cases
from tests.kernel.controller.machines import machine, until


def test_past_times_have_the_profile_of_their_time() -> None:
    """10 counts/s and 100 counts/s2: 0.1 s and 0.5 counts up.

    From 1 s on down, 9.5 to 10 counts.
    """
    c = machine(1)
    c.jog(0, 10.0)
    until(c, 1.0).stop(0)
    until(c, 3.0).jog(0, -10.0)
    a = until(c, 4.0).axes[0]
    for time, position, velocity in (
        (0.0, 0.0, 0.0), (0.05, 0.125, 5.0), (0.1, 0.5, 10.0), (0.9, 8.5, 10.0), (1.0, 9.5, 10.0),
        (1.05, 9.875, 5.0),
        (1.1, 10.0, 0.0), (2.0, 10.0, 0.0), (3.0, 10.0, 0.0), (3.05, 9.875, -5.0),
        (4.0, 0.5, -10.0), (5.0, -9.5, -10.0),
    ):  # fmt: skip
        assert (a.position(time), a.velocity(time)) == pytest.approx((position, velocity), abs=1e-9)
        state = a.at(time)
        assert (state.position, state.velocity) == pytest.approx((position, velocity), abs=1e-9)
    assert a.at(0.05).acceleration == a.at(1.1 - 1e-6).acceleration * -1.0 == pytest.approx(100.0)
    starts = [a.in_force(time)[0] for time in (0.5, 1.0, 1.05, 2.0, 3.0, 9.0)]
    assert starts[0] == 0.0
    assert starts[1:3] == [1.0, 1.0]
    assert starts[4:] == [3.0, 3.0]
    assert [a.next_start(time) for time in (0.0, 0.99, 3.0, 9.0)] == [1.0, 1.0, inf, inf]
    assert a.next_start(2.5) == 3.0
    assert a.end_of_motion() == a.end_of_move() == inf


def test_the_times_of_packed_profiles(monkeypatch: pytest.MonkeyPatch) -> None:
    """A track of many short moves is packed; each began where the one before ended."""
    for name, value in (("FIRST_CHECK", 1), ("HURRY", 0.0), ("MAX_PROFILES", 16), ("LEFT_PROFILES", 4)):
        monkeypatch.setattr(log_module, name, value)
    c = machine(1)
    a = c.axes[0]
    begins = []
    for k in range(60):
        begins.append(c.clock.now)
        c.move_to(0, float(k % 2))
        c.clock.advance(c.clock.now + 1.0)
    assert a.older is not None
    for k in (1, 2, 5, 20, 40, 55, 58):
        # One count takes 0.2 s; half of it takes 0.1 s, then the axis rests.
        assert a.position(begins[k] + 0.1) == pytest.approx(0.5)
        assert a.velocity(begins[k] + 0.05) == pytest.approx(5.0 if k % 2 else -5.0)
        assert a.in_force(begins[k] + 0.1)[0] == begins[k]
        assert begins[k] < a.next_start(begins[k]) <= begins[k + 1]
        assert a.next_start(begins[k] + 0.9) == begins[k + 1]
    last = a.older.start(a.older.count - 1)
    assert last < a.next_start(last) == a.starts[0]


def test_a_stop_or_an_idle_axis_has_an_end() -> None:
    c = machine(1)
    assert (c.axes[0].end_of_motion(), c.axes[0].end_of_move()) == (0.0, -1.0)
    c.move_to(0, 1.0)
    assert c.axes[0].end_of_motion() == c.axes[0].end_of_move() == pytest.approx(0.2)
    until(c, 1.0)
    assert c.axes[0].end_of_move() == -1.0
    assert c.axes[0].end_of_motion() == pytest.approx(0.2)


@cases(
    "settings, accel, decel",
    [
        ({}, 100.0, 50.0), ({"accel_time": 0.5}, 40.0, 50.0), ({"decel_time": 0.25}, 100.0, 80.0),
        ({"accel_time": 2.0, "decel_time": 4.0}, 10.0, 5.0),
    ],
)  # fmt: skip
def test_a_ramp_time_replaces_a_rate(settings: dict[str, float], accel: float, decel: float) -> None:
    a = Axis(0)
    a.accel, a.decel = 100.0, 50.0
    for name, value in settings.items():
        setattr(a, name, value)
    assert a.rates(20.0) == (accel, decel)


@cases(
    "settings, up, down",
    [
        # 20 counts/s at 100 and 50 counts/s2: ramps of 0.2 s and 0.4 s.
        ({"accel_jerk": 700.0}, 700.0, 900.0),
        ({"decel_jerk": 700.0}, 800.0, 700.0),
        ({"accel_jerk_time": 0.1}, 1000.0, 900.0),
        ({"decel_jerk_time": 0.1}, 800.0, 500.0),
        ({"s_ramp": 0.5}, 100.0 / 0.1, 50.0 / 0.2),
        ({"s_ramp": 0.5, "accel_jerk_time": 0.05}, 2000.0, 250.0),
        ({"s_ramp": 0.5, "decel_jerk": 700.0}, 800.0, 700.0),
        ({"accel_jerk_time": 0.0}, 1e60, 900.0),
        ({"s_ramp": 0.5, "accel": 0.0}, 1e60, 250.0),
        ({"accel_time": 0.4, "s_ramp": 0.5}, 50.0 / 0.2, 250.0),
    ],
)
def test_a_jerk_follows_from_the_last_one_written(settings: dict[str, float], up: float, down: float) -> None:
    a = Axis(0)
    a.speed, a.accel, a.decel, a.accel_jerk, a.decel_jerk = 20.0, 100.0, 50.0, 800.0, 900.0
    for name, value in settings.items():
        setattr(a, name, value)
    assert (a.accel_jerk, a.decel_jerk) == pytest.approx((up, down))


@cases("mode, live, changed", [(0, True, 1), (1, False, 0), (2, True, 3), (3, False, 2)])
def test_bit_0_of_the_feed_rate_mode_keeps_the_speed_of_loaded_moves(
    mode: int, live: bool, changed: int
) -> None:
    a = Axis(0)
    a.feedrate_mode = mode
    assert a.live_speed is live
    a.live_speed = live
    assert a.feedrate_mode == mode
    a.live_speed = not live
    assert a.feedrate_mode == changed


def test_a_new_axis() -> None:
    a = Axis(3)
    assert (a.index, a.enabled, a.faults, a.locks, a.feedrate_mode, a.override) == (3, True, 0, 0, 1, 1.0)
    assert (a.live_speed, a.suspended, a.limited, a.moves, a.is_at_standstill) == (
        False,
        False,
        False,
        False,
        True,
    )
    assert (a.target, a.datum, a.position(5.0), a.velocity(5.0), a.entries) == (0.0, 0.0, 0.0, 0.0, ())
    assert (a.buffer_low, a.suspend_time, a.index_pitch, a.move_id, a.last_id) == (-1, 0.1, 0.0, 0, 0)
    for name in ("max_speed", "max_accel", "max_decel"):
        limited = Axis(0)
        setattr(limited, name, 5.0)
        assert limited.limited
    for reason in (1, 2, 3):
        a.suspend_reasons = reason
        assert a.suspended


def test_index_marks_are_apart_by_whole_counts_whatever_the_sign_of_the_scale() -> None:
    a = Axis(0)
    a.index_every = 2.5
    a.scale.set(-4.0)
    assert a.index_pitch == 10.0


def test_at_the_time_of_a_crossing_the_position_is_exactly_the_one_crossed() -> None:
    """At 1 s the axis is at 9.5 counts.

    The time of a crossing is rounded, its position is not.
    """
    c = machine(1)
    c.jog(0, 10.0)
    a = until(c, 1.0).axes[0]
    a.cross(1.0, 9.5000001)
    assert (a.here(1.0), c.demand(0), c.position(0)) == (9.5000001, 9.5000001, 9.5000001)
    assert a.here(1.1) == a.position(1.1) == pytest.approx(10.5)
    assert a.position(1.0) == pytest.approx(9.5, abs=1e-12)
    a.put_on(a.starts[-1], a.profiles[-1].shifted(1.0))
    assert a.here(1.0) == pytest.approx(10.5, abs=1e-12)
