"""The controller's environment: switches and inputs by time and by position."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller, Machine
from motionlang.kernel.controller import fault_names


def machine(**settings: object) -> Controller:
    given = {key.replace("__", "."): value for key, value in settings.items()}
    c = Machine({"controller.axes": 2, **given}).controller
    for axis in c.axes:
        for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
            c.configure(axis, name, value)
    return c


def faults(c: Controller) -> str:
    return fault_names(c.faults(0))


def changes(c: Controller) -> list[tuple[float, int, float]]:
    return [(round(time, 9), channel, value) for time, channel, value in c.log.inputs]


def test_the_home_switch() -> None:
    c = machine(axis__0__home_switch=[-4.0, -3.0], axis__0__home_input=2, axis__0__start=-3.5)
    assert c.is_on_home_switch(0)
    c.move_to(0, 8.0)
    c.clock.advance(0.1)
    assert c.is_on_home_switch(0)
    c.clock.advance(5.0)
    assert not c.is_on_home_switch(0)
    assert changes(c) == [(0.0, 2, 1), (0.25, 2, 0)]


def test_a_fault_beyond_a_position_happens_where_the_axis_comes_there() -> None:
    c = machine(fault=[{"axis": 0, "kind": "following-error", "above": 6.0}])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert c.position(0) == pytest.approx(6.0)
    assert faults(c) == "following error"


def test_marks_along_the_travel() -> None:
    """8 counts/s and 16 counts/s2: 2 counts in the first half second, then 4 in each."""
    c = machine(input=[{"channel": 3, "axis": 0, "between": [2.0, 6.0], "every": 8.0, "times": 2}])
    c.move_to(0, 30.0)
    c.clock.advance(3.0)
    assert changes(c) == [(0.5, 3, 1), (1.0, 3, 0), (1.5, 3, 1), (2.0, 3, 0)]


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        ({"at": 0.0}, [2.5]),
        ({"at": 3.0, "every": 1.0}, [3.0, 4.0]),
        ({"at": 0.5, "every": 1.0}, [2.5, 3.5, 4.5]),
        ({"every": 1.0}, [2.5, 3.0, 4.0]),
        ({"every": 1.0, "times": 4}, [2.5, 3.0]),
        ({"every": 1.0, "times": 2}, [2.5]),
        ({"every": 4.0}, [2.5, 4.0]),
    ],
)
def test_times_that_are_past_count_as_one(entry: dict[str, object], expected: list[float]) -> None:
    """The next ones are those that they would have been."""
    c = machine()
    acted: list[float] = []
    c.clock.advance(2.5)
    c.stimuli.add("comms", entry, lambda: acted.append(c.clock.now))
    c.clock.advance(4.5)
    assert acted == expected


def test_the_travel_is_counted_from_the_start() -> None:
    """The axis starts at 3 within -5 to 9: 8 back and 6 on.

    Marks every 5 from machine position 0.
    """
    settings: dict[str, object] = {
        "axis__0__travel": [-5.0, 9.0],
        "axis__0__start": 3.0,
        "axis__0__forward_input": 7,
        "axis__0__reverse_input": 8,
        "axis__0__index_every": 5.0,
    }
    c = machine(**settings)
    assert (c.axes[0].index_every, c.axes[0].index_origin) == (5.0, -3.0)
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    assert c.position(0) == pytest.approx(6.0)
    assert faults(c) == "forward limit"
    c.clear_faults(0)
    c.enable(0)
    c.move_to(0, -12.0)
    c.clock.advance(10.0)
    assert c.position(0) == pytest.approx(-8.0)
    assert faults(c) == "reverse limit"
    assert [(channel, value) for _, channel, value in changes(c)] == [(7, 1), (7, 0), (8, 1)]
    c = machine(**settings)
    c.set_scale(0, 2.0)
    assert c.axes[0].index_origin == -6.0
    c.move_to(0, 30.0)
    c.clock.advance(9.0)
    assert c.position(0) == pytest.approx(12.0)


def test_a_home_switch_without_an_input_is_only_a_switch() -> None:
    c = machine(axis__1__home_switch=[2.0, 4.0])
    found = []
    for target in (1.0, 3.0, 5.0):
        c.move_to(1, target)
        c.clock.advance(c.clock.now + 5.0)
        found.append((c.is_on_home_switch(1), c.is_on_home_switch(0)))
    assert found == [(False, False), (True, False), (False, False)]
    assert changes(c) == []


def test_a_sensor_along_the_travel_in_user_units() -> None:
    """2 V and 0.5 V per unit from 6 on, in the region up to 10.

    The scale is 4 counts per unit.
    """
    entry = {"channel": 1, "axis": 0, "between": [6.0, 10.0], "value": 2.0, "per_unit": 0.5}
    for start in (0.0, 1.0):
        c = machine(analogue=[entry], axis__0__start=start)
        c.set_scale(0, 4.0)
        found = []
        for position in (5.0, 7.0, 9.0, 11.0):
            c.move_to(0, 4.0 * (position - start))
            c.clock.advance(c.clock.now + 20.0)
            found.append(c.analogue_inputs[1])
        assert found == pytest.approx([0.0, 2.5, 3.5, 0.0])


def test_a_sensor_is_in_user_units_after_a_new_scale_within_its_region() -> None:
    """At 7 it has 2.5 V; at 8, which is 4 counts on, 3 V."""
    entry = {"channel": 1, "axis": 0, "between": [6.0, 10.0], "value": 2.0, "per_unit": 0.5}
    c = machine(analogue=[entry], axis__0__start=7.0)
    assert c.analogue_inputs[1] == pytest.approx(2.5)
    c.set_scale(0, 4.0)
    c.move_to(0, 4.0)
    c.clock.advance(20.0)
    assert c.analogue_inputs[1] == pytest.approx(3.0)
