"""Readers and writers bound to an axis equal the verbs, to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.controller.readers import POSITION
from tests.recorder import Recorder


def scaled() -> Controller:
    """Return two axes of 10 counts per unit, the first at 8 counts/s and 16 counts/s²."""
    controller = Controller(2)
    controller.set_scale(0, 10.0)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        controller.configure(0, name, value)
    return controller


@pytest.mark.parametrize("shape", ["trapezoid", "scurve", "sinusoidal", "parabolic"])
def test_a_bound_reading_is_the_reading(shape: str) -> None:
    controller = scaled()
    controller.configure(0, "shape", shape)
    scale = controller.axes[0].scale
    position, speed = controller.reader("position", 0, POSITION), controller.reader("velocity", 0, "uu/s")
    counts, left = controller.reader("demand", 0), controller.reader("remaining", 0, "uu")
    controller.load_to(0, 40.0)
    controller.load_by(0, -7.0)
    controller.go([0])
    for step in range(200):
        controller.clock.advance(step * 0.05)
        if step == 60:
            controller.define_position(0, 3.0)
        assert position() == scale.position_to_user(controller.position(0))
        assert speed() == scale.to_user(controller.velocity(0), "uu/s")
        assert counts() == controller.demand(0)
        assert left() == scale.to_user(controller.remaining(0))
    assert controller.is_idle(0)
    assert controller.reader("is_idle", 0)() is True


def test_a_bound_reading_is_right_at_a_past_moment_and_between_the_moves() -> None:
    controller = scaled()
    position = controller.reader("position", 0, POSITION)
    controller.move_to(0, 8.0)
    controller.clock.advance(1.0)
    assert position() == pytest.approx(0.6)  # half a second of ramp, 2 counts; half a second at 8 counts/s
    controller.clock.now = 0.25  # a condition evaluates a past value
    assert position() == pytest.approx(0.05)  # 16 counts/s², over 2, of a sixteenth of a second²
    controller.clock.now = 1.0
    controller.stop(0)
    assert position() == pytest.approx(0.6)


def test_units_that_change_change_what_is_read_and_written() -> None:
    controller = scaled()
    read, write = controller.reader("speed", 0, "uu/s"), controller.writer("speed", 0, "uu/s")
    assert read() == 0.8
    write(2.0)
    assert controller.setting(0, "speed") == 20.0
    controller.set_units(0, 5.0, None)  # a unit of speed of its own
    assert read() == 4.0
    controller.set_time_unit(0, 60.0)  # a minute
    assert read() == 240.0
    controller.set_scale(0, 1.0)
    assert read() == 20.0


def test_a_rate_that_is_written_ends_the_time_for_it_and_acts_on_a_move() -> None:
    controller = scaled()
    controller.configure(0, "accel_time", 0.5)
    controller.configure(0, "live_speed", True)
    controller.writer("accel", 0)(16.0)
    assert controller.setting(0, "accel_time") is None
    controller.move_to(0, 40.0)
    controller.clock.advance(1.0)
    controller.writer("speed", 0)(4.0)
    controller.clock.advance(2.0)
    assert controller.velocity(0) == 4.0


class Subscriber:
    """A subscriber that receives readings through `note` while `notes` is not None."""

    def __init__(self) -> None:
        self.dependencies = self
        self.notes: list[object] | None = None
        self.subscriptions: list[tuple[Callable[..., float], object]] = []

    def note(self, until: Callable[..., float], level: object) -> None:
        self.subscriptions.append((until, level))


def test_a_subscriber_gets_readings_and_the_levels_they_are_compared_with() -> None:
    controller, subscriber = scaled(), Subscriber()
    position = controller.reader("position", 0, POSITION, subscriber)
    speed = controller.reader("velocity", 0, "uu/s", subscriber)
    controller.define_position(0, 70.0)
    assert position() == 7.0
    assert subscriber.subscriptions == []
    subscriber.notes = []
    controller.axes[0].scale.wrap = 5.0
    assert position(6.5) == 2.0
    assert speed() == 0.0
    assert [level for _, level in subscriber.subscriptions] == [6.5, None]


def test_a_subscriber_is_notified_when_a_reading_passes_a_level() -> None:
    """The axis has 8 counts/s, 16 counts/s2 and 10 counts per unit.

    It covers 2 counts in the first half second, 16 in two seconds, and 2 in the last half second.
    """
    controller, subscriber = scaled(), Subscriber()
    subscriber.notes = []
    controller.reader("position", 0, POSITION, subscriber)()
    controller.reader("velocity", 0, "uu/s", subscriber)()
    until_position, speed = (until for until, _ in subscriber.subscriptions)
    assert until_position(0.5) == until_position() == inf
    controller.move_by(0, 20.0)
    assert until_position() == 0.0  # it may change at any time
    assert until_position(0.6) == until_position((0.6, 0.0)) == pytest.approx(0.5 + 4.0 / 8.0)
    assert until_position(2.5) == inf
    assert speed(0.4) == pytest.approx(0.25)
    controller.clock.advance(0.6)
    assert until_position(inf) == inf
    controller.axes[0].scale.wrap = 0.4
    assert until_position(0.3) == pytest.approx(0.5 + 1.0 / 8.0)
    assert until_position(0.1) == pytest.approx(0.5 + 2.0 / 8.0)  # as it wraps
    assert until_position(inf) == until_position(-inf) == inf


def test_a_recorder_writes_every_reading_and_every_setting_down() -> None:
    recorder = Recorder(2, answers={"position": 30.0, "setting": 20.0})
    recorder.set_scale(1, 10.0)
    assert recorder.reader("position", 1, POSITION)() == 3.0
    assert recorder.reader("speed", 1, "uu/s")() == 2.0
    recorder.writer("speed", 1, "uu/s")(4.0)
    assert recorder.calls[1:] == [("position", 1), ("setting", 1, "speed"), ("configure", 1, "speed", 40.0)]


@pytest.mark.parametrize("heard", [False, True])
def test_a_reading_of_motion_has_the_unit_of_time(heard: bool) -> None:
    """8 counts/s are 0.8 units/s, 48 units a minute; after 4.5 s 6 counts are left."""
    controller = scaled()
    controller.set_time_unit(0, 60.0)
    subscriber = Subscriber()
    subscriber.notes = [] if heard else None
    speed = controller.reader("velocity", 0, "uu/s", subscriber)
    left = controller.reader("remaining", 0, "uu", subscriber)
    controller.move_to(0, 40.0)
    controller.clock.advance(4.5)
    assert (speed(), left()) == pytest.approx((48.0, 0.6))


def test_a_velocity_is_read_along_a_ramp_that_began_later() -> None:
    """From 1 s on the axis speeds up at 16 counts/s², which is 1.6 units/s²."""
    controller = scaled()
    speed = controller.reader("velocity", 0, "uu/s")
    controller.configure(0, "speed", 160.0)
    controller.clock.advance(1.0)
    controller.move_to(0, 1e6)
    for time in (2.0, 3.0, 4.5, 7.0):
        controller.clock.advance(time)
        assert speed() == pytest.approx(1.6 * (time - 1.0))
