"""The controller's environment: switches and inputs by time and by position."""

from __future__ import annotations

import pytest

from motionlang.controller.controller import Controller
from motionlang.controller.faults import FOLLOWING_ERROR, LIMIT_FORWARD
from motionlang.controller.io.wiring import World


def machine(**settings: object) -> Controller:
    c = Controller(2)
    for axis in c.axes:
        for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
            c.configure(axis, name, value)
    World(c, {key.replace("__", "."): value for key, value in settings.items()})
    return c


def changes(c: Controller) -> list[tuple[float, int, float]]:
    return [(round(time, 9), channel, value) for time, channel, value in c.log.inputs]


def test_inputs_by_time() -> None:
    c = machine(input=[{"channel": 3, "at": 1.5}, {"channel": 4, "at": 2.0, "for": 0.25, "value": 1}])
    c.clock.advance(10.0)
    assert changes(c) == [(1.5, 3, 1), (2.0, 4, 1), (2.25, 4, 0)]


def test_an_input_by_position_follows_the_axis_in_both_directions() -> None:
    c = machine(input=[{"channel": 3, "axis": 0, "above": 6.0}])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 0.0)
    c.clock.advance(20.0)
    assert changes(c) == [(1.0, 3, 1), (6.0, 3, 0)]


def test_an_input_between_two_positions() -> None:
    c = machine(input=[{"channel": 3, "axis": 0, "between": [2.0, 10.0]}])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert changes(c) == [(0.5, 3, 1), (1.5, 3, 0)]


def test_positions_of_the_world_are_user_units_whatever_the_scale() -> None:
    c = machine(input=[{"channel": 3, "axis": 0, "above": 6.0}])
    c.set_scale(0, 1000.0)
    for name in ("speed", "accel", "decel"):
        c.configure(0, name, float(c.setting(0, name) or 0) * 1000)
    c.move_to(0, 12_000.0)
    c.clock.advance(5.0)
    assert changes(c) == [(1.0, 3, 1)]


def test_travel_limits_stop_the_axis_and_show_on_their_inputs() -> None:
    c = machine(axis__0__travel=[-5.0, 6.0], axis__0__forward_input=7)
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert c.position(0) == pytest.approx(6.0)
    assert c.faults(0) == LIMIT_FORWARD
    assert changes(c) == [(1.0, 7, 1)]


def test_the_home_switch() -> None:
    c = machine(axis__0__home_switch=[-4.0, -3.0], axis__0__home_input=2, axis__0__start=-3.5)
    assert c.is_on_home_switch(0)
    c.move_to(0, 8.0)
    c.clock.advance(0.1)
    assert c.is_on_home_switch(0)
    c.clock.advance(5.0)
    assert not c.is_on_home_switch(0)
    assert changes(c) == [(0.0, 2, 1), (0.25, 2, 0)]


@pytest.mark.parametrize(("value", "enabled"), [(1, True), (0, False)])
def test_a_drive_is_off_while_its_enable_input_is_off_and_asks_no_other(value: int, enabled: bool) -> None:
    c = machine(
        axis__0__enable_input=3,
        input=[
            {"channel": 3, "at": 0.0},
            {"channel": 4, "at": 0.5},
            {"channel": 3, "at": 1.0, "value": value},
        ],
    )
    c.clock.advance(0.1)
    c.enable(0)
    c.clock.advance(0.9)
    assert c.is_enabled(0)
    c.clock.advance(2.0)
    assert c.is_enabled(0) is enabled


def test_a_fault_at_a_time_switches_the_axis_off() -> None:
    c = machine(fault=[{"axis": 0, "kind": "following-error", "at": 1.0}])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert (c.position(0), c.faults(0), c.is_enabled(0)) == (6.0, FOLLOWING_ERROR, False)
    assert c.log.moves[0].ended == "fault"


def test_an_input_follows_the_level_of_an_output_after_a_delay() -> None:
    c = machine(input=[{"channel": 5, "output": 1, "delay": 0.25}, {"channel": 6, "output": 1, "value": 0}])
    assert changes(c) == [(0.0, 6, 1)]
    c.clock.advance(1.0)
    c.set_output(1, 1)
    c.clock.advance(2.0)
    assert changes(c)[1:] == [(1.0, 6, 0), (1.25, 5, 1)]
    c.outputs.set_active_low({1})  # on means low now
    c.clock.advance(3.0)
    assert changes(c)[3:] == [(2.0, 6, 1), (2.25, 5, 0)]


def test_a_fault_at_a_line_happens_the_first_time_only() -> None:
    c = Controller(1)
    world = World(c, {"fault": [{"axis": 0, "kind": "forward-limit", "line": 12}]})
    world.reach(11)
    assert c.faults(0) == 0
    world.reach(12)
    assert c.faults(0) == LIMIT_FORWARD
    c.clear_faults(0)
    world.reach(12)
    assert c.faults(0) == 0


def test_what_an_axis_does_about_a_fault_is_the_programs_choice() -> None:
    c = Controller(1)
    world = World(c, {"fault": [{"axis": 0, "kind": "following-error", "at": 1.0}]})
    world.actions[0, FOLLOWING_ERROR] = "event"
    c.jog(0, 100.0)
    c.clock.advance(2.0)
    assert (c.faults(0), c.is_enabled(0), c.velocity(0)) == (FOLLOWING_ERROR, True, 100.0)


def test_a_fault_beyond_a_position_happens_where_the_axis_comes_there() -> None:
    c = machine(fault=[{"axis": 0, "kind": "following-error", "above": 6.0}])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert c.position(0) == pytest.approx(6.0)
    assert c.faults(0) == FOLLOWING_ERROR
