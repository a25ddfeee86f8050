"""Which moves stay rows, and what an axis answers from its rows."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.controller.controller import Controller
from motionlang.fast import everything
from motionlang.fast.moves import FastAxis
from tests.cases import cases

# Up to 100 counts/s in 0.2 s and 10 counts, down in 0.1 s and 5 counts.
SETTINGS: dict[str, Any] = {"speed": 100.0, "accel": 500.0, "decel": 1000.0, "feedrate_mode": 0}


def axis(**given: Any) -> tuple[Any, Any]:
    """Return an axis at rest at 10 counts, of 4 counts per unit, and its controller."""
    controller = Controller(2, accelerators=everything())
    found: Any = controller.axes[0]
    assert isinstance(found, FastAxis)
    controller.define_position(0, 10.0)
    found.scale.set(4.0)
    for name, value in {**SETTINGS, **given}.items():
        setattr(found, name, value)
    return found, controller


@cases(
    "value, relative, given, entry",
    (
        (100.0, False, {}, (400.0, None, "MOVE", 7, None, 0)),
        (100.0, True, {}, (410.0, 10.0, "MOVE", 7, None, 0)),
        (-100.0, True, {"target": 50.0}, (-350.0, 50.0, "MOVE", 7, None, 0)),
        (100.0, False, {"feedrate_mode": 1, "move_id": 3}, (400.0, None, "MOVE", 7, 100.0, 3)),
        (100.0, False, {"buffer_size": 1}, (400.0, None, "MOVE", 7, None, 0)),
        (100.0, False, {"faults": 1, "locks": 2}, (400.0, None, "MOVE", 7, None, 0)),
        (9e299, False, {}, (3.6e300, None, "MOVE", 7, None, 0)),
        (100.0, False, {"faults": 3, "locks": 2}, None),
        (100.0, False, {"feedrate_mode": 2}, None),
        (100.0, False, {"buffer_size": 0}, None),
        (100.0, False, {"own_rates": (1.0, 2.0)}, None),
        (100.0, False, {"feedback": 1}, None),
        (100.0, False, {"enabled": False}, None),
        (100.0, False, {"in_motion": True}, None),
        (100.0, False, {"_move": 1}, None),
        (100.0, False, {"_buffer": [1]}, None),
        (100.0, False, {"loaded": (1.0, None, "MOVE", 7, None, 0)}, None),
        (1e300, False, {}, None),
        (-1e300, False, {}, None),
        (1.0, True, {"target": 1e300}, None),
        (1.0, True, {"target": -1e300}, None),
    ),
)
def test_a_move_is_loaded_as_an_entry(
    value: float, relative: bool, given: dict[str, Any], entry: tuple[object, ...] | None
) -> None:
    """It has target, base, command, line, speed and number.

    The speed is its own with FEEDRATEMODE 1. None if the axis needs a `Move`.
    """
    found, controller = axis(**given)
    before = found.loaded
    assert found.loader(controller, relative, "MOVE")(value, 7) == (entry is not None)
    assert found.loaded == (before if entry is None else entry)


def test_a_braked_axis_loads_no_move_and_starts_none() -> None:
    found, controller = axis()
    controller.braked.add(1)
    assert found.loader(controller, False, "MOVE")(100.0, 7)
    controller.braked.add(0)
    assert not found.start_loaded(controller)
    found.loaded = None
    assert not found.loader(controller, False, "MOVE")(100.0, 7)


def test_a_loaded_move_starts_as_a_row() -> None:
    """The move has 10 counts in 0.2 s, 385 at 100 counts/s and 5 in 0.1 s."""
    found, controller = axis(move_id=5, last_id=2)
    controller.clock.advance(1.5)
    room, fired = controller.log.room, controller.clock.fired
    assert found.loader(controller, False, "MOVE")(102.5, 7)
    entry = found.loaded
    assert found.start_loaded(controller)
    (row,) = found.rows
    assert row[:4] == (0, 1.5, 10.0, 410.0)
    assert row[4] == pytest.approx(4.15, rel=1e-15)
    assert row[6:] == (100.0, 4.0, 0.0, entry)
    assert (found.loaded, found.target, found.last_id, found.in_motion) == (None, 410.0, 5, True)
    assert (found.present, found.ends, controller.clock.horizon) == (None, 1.5 + row[4], 1.5 + row[4])
    assert found.plan == (400.0, 100.0, 500.0, 1000.0, (row[4], row[5]))
    assert controller.log.room == room - 1
    controller.clock.advance(9.0)
    assert (found.in_motion, found.rows, controller.log.room) == (False, [row], room - 2)
    assert (controller.clock.fired, found.arrival_event is not None) == (fired + 1, True)


@cases(
    "given, starts",
    (
        ({}, True),
        ({"max_speed": 100.0, "max_accel": 500.0, "max_decel": 1000.0}, True),
        ({"max_speed": 99.0}, False),
        ({"max_accel": 499.0}, False),
        ({"max_decel": 999.0}, False),
        ({"accel_time": 0.25, "decel_time": 0.5, "max_accel": 400.0, "max_decel": 200.0}, True),
        ({"accel_time": 0.25, "max_accel": 399.0}, False),
        ({"decel_time": 0.5, "max_decel": 199.0}, False),
        ({"_move": 1}, False),
        ({"faults": 3, "locks": 2}, False),
        ({"faults": 1, "locks": 2}, True),
        ({"enabled": False}, False),
        ({"suspend_reasons": 1}, False),
        ({"shape": "sine"}, False),
        ({"feedback": 1}, False),
        ({"followers": [print]}, False),
        ({"buffer_low": 0}, False),
        ({"speed": 0.0}, False),
        ({"loaded": None}, False),
    ),
)
def test_a_move_with_anything_special_is_not_started_as_a_row(given: dict[str, Any], starts: bool) -> None:
    """Ramps to 100 counts/s in 0.25 s and 0.5 s are 400 and 200 counts/s²."""
    found, controller = axis()
    found.loader(controller, False, "MOVE")(100.0, 7)
    for name, value in given.items():
        setattr(found, name, value)
    entry = found.loaded
    assert found.start_loaded(controller) == starts
    assert len(found.rows) == starts
    assert found.loaded == (None if starts else entry)


def test_an_axis_that_is_homing_starts_no_move() -> None:
    found, controller = axis()
    found.loader(controller, False, "MOVE")(100.0, 7)
    homing: Any = SimpleNamespace()
    controller.homings[0] = homing
    assert not found.start_loaded(controller)
    controller.homings = {1: homing}
    assert found.start_loaded(controller)


def test_a_move_starts_where_the_last_one_ends() -> None:
    """A relative one also follows a target that has changed."""
    found, controller = axis()
    load = found.loader(controller, True, "MOVE")
    for distance in (5.0, -20.0):
        load(distance, 7)
        assert found.start_loaded(controller)
        controller.clock.advance(controller.clock.now + 5.0)
    load(5.0, 7)
    found.target += 3.0
    assert found.start_loaded(controller)
    assert [row[2:4] for row in found.rows] == [(10.0, 30.0), (30.0, -50.0), (-50.0, -27.0)]


def test_a_move_out_of_a_jog_is_not_started_as_a_row() -> None:
    found, controller = axis()
    controller.jog(0, 10.0)
    controller.stop(0)
    assert found.move is not None
    found._move = None
    found.loader(controller, False, "MOVE")(100.0, 7)
    assert not found.start_loaded(controller)


@cases(
    "free, limits, watches, starts",
    (
        ((9.0, 411.0), [1], {}, True),
        ((9.0, 411.0), [], {1: None}, True),
        ((10.0, 411.0), [1], {}, False),
        ((9.0, 410.0), [1], {}, False),
        ((9.0, 10.0), [1], {}, False),
        ((11.0, 411.0), [], {1: None}, False),
        ((10.0, 410.0), [], {}, True),
    ),
)
def test_a_move_to_a_watch_or_a_limit_is_not_started_as_a_row(
    free: tuple[float, float], limits: list[Any], watches: dict[Any, None], starts: bool
) -> None:
    """It leads from 10 to 410 counts, and both must be within the free interval."""
    found, controller = axis()
    found.loader(controller, False, "MOVE")(102.5, 7)
    found.limits, found.watches.all, found.watches.free = limits, watches, free
    assert found.start_loaded(controller) == starts


def test_the_plan_before_the_last_one_is_used_again() -> None:
    """Cycles alternate between two distances. The start makes the plan the last one."""
    found, controller = axis()
    there, back = (
        (400.0, 100.0, 500.0, 1000.0, (4.0, (1.0,))),
        (-400.0, 100.0, 500.0, 1000.0, (5.0, (2.0,))),
    )
    found.plan_before, found.plan = there, back
    found.loader(controller, False, "MOVE")(102.5, 7)
    assert found.start_loaded(controller)
    assert (found.plan, found.plan_before, found.rows[-1][4:6]) == (there, back, (4.0, (1.0,)))


@pytest.mark.parametrize("index", range(4))
def test_a_plan_of_another_speed_or_rate_is_not_used(index: int) -> None:
    """It would take 4 s; the move takes 4.15 s."""
    plan: list[Any] = [400.0, 100.0, 500.0, 1000.0, (4.0, (1.0,))]
    plan[index] += 1.0
    found, controller = axis()
    found.plan_before, last = tuple(plan), found.plan
    found.loader(controller, False, "MOVE")(102.5, 7)
    assert found.start_loaded(controller)
    assert found.rows[-1][4] == pytest.approx(4.15, rel=1e-15)
    assert found.plan_before is last


@cases(
    "given, target, starts",
    (
        ({}, 400.0, True),
        ({"feedrate_mode": 1}, 400.0, True),
        ({"feedrate_mode": 2}, 400.0, False),
        ({"own_rates": (1.0, 2.0)}, 400.0, False),
        ({"in_motion": True}, 400.0, False),
        ({"_move": 1}, 400.0, False),
        ({"_buffer": [1]}, 400.0, False),
        ({"loaded": (1.0, None, "MOVE", 7, None, 0)}, 400.0, False),
        ({}, 1e300, False),
        ({}, -1e300, False),
        ({"enabled": False}, 400.0, False),
    ),
)
def test_a_move_that_starts_at_once(given: dict[str, Any], target: float, starts: bool) -> None:
    """The number of the buffer's last move stays, and the buffer is empty."""
    found, controller = axis(last_id=2, move_id=5, **given)
    loaded = found.loaded
    assert found.start_at_once(controller, target, "MA", 9) == starts
    assert (found.last_id, found.loaded) == (2, loaded)
    if starts:
        speed = 100.0 if "feedrate_mode" in given else None
        assert found.rows[-1][-1] == (400.0, None, "MA", 9, speed, 5)
        assert found.logged is controller.log.moves


def test_an_axis_answers_from_its_rows() -> None:
    """The move from 10 to 410 counts takes 4.15 s.

    After it no profile is made to answer.
    """
    found, controller = axis()
    assert (found.moves, found.is_at_standstill, found.end_of_move()) == (False, True, -1.0)
    is_idle = found.idle_reader()
    assert is_idle()
    assert found.start_at_once(controller, 410.0, "MA", 9)
    end = found.ends
    assert (found.moves, found.is_at_standstill, is_idle()) == (True, False, False)
    assert (found.end_of_move(), found.end_of_motion()) == (end, end)
    controller.clock.advance(5.0)
    assert (found.moves, found.is_at_standstill, is_idle()) == (False, True, True)
    assert (found.end_of_move(), found.end_of_motion()) == (-1.0, end)
    assert [found.position(time) for time in (end + 1e-9, 5.0)] == [410.0, 410.0]
    assert [found.velocity(time) for time in (end + 1e-9, 5.0)] == [0.0, 0.0]
    assert len(found.rows) == 1
    assert [found.position(time) for time in (0.0, 0.2, end)] == pytest.approx([10.0, 20.0, 410.0])
    assert found.rows == []
    assert found.velocity(0.2) == pytest.approx(100.0)
    assert found.velocity(0.1) == pytest.approx(50.0)


def test_a_position_of_zero_has_no_sign() -> None:
    found, controller = axis()
    found.start_at_once(controller, -0.0, "MA", 9)
    controller.clock.advance(5.0)
    assert str(found.position(5.0)) == "0.0"


def test_a_move_that_is_read_becomes_an_object() -> None:
    """Three rows are five profiles if the third one is in motion."""
    found, controller = axis()
    for time, target in ((0.0, 410.0), (5.0, 10.0), (10.0, 110.0)):
        controller.clock.advance(time)
        assert found.start_at_once(controller, target, "MA", 9 + round(time))
    event = found.arrival_event
    move = found.move
    assert move is not None
    assert (move.command, move.line, move.target, move.start_time) == ("MA", 19, 110.0, 10.0)
    assert (found.in_motion, found.rows, found.writing, found.arrival_event) == (False, [], None, None)
    assert found.arrival is event
    assert found.starts[-5:] == pytest.approx([0.0, 4.15, 5.0, 9.15, 10.0])
    shapes = ["trapezoid", "hold", "trapezoid", "hold", "trapezoid"]
    assert [each.shape for each in found.profiles][-5:] == shapes
    assert move.profile is found.present is found.profiles[-1]
    assert (found.moves, found.end_of_move()) == (True, pytest.approx(11.15))
    assert [type(each).__name__ for each in controller.log.moves.as_stored()] == ["tuple", "tuple", "Move"]
    controller.clock.advance(20.0)
    assert (found.moves, found.move, found.position(20.0)) == (False, None, 110.0)


def test_a_move_that_was_read_ends_as_an_object() -> None:
    """Its event wakes tasks, as that of any `Move`."""
    found, controller = axis()
    found.start_at_once(controller, 410.0, "MA", 9)
    event, end = found.arrival_event, found.ends
    assert event is not None
    assert event.call is not None
    assert found.move is not None
    controller.clock.now = end
    assert event.call() is False
    assert found.move is None


@cases("listens", (False, True))
def test_the_end_of_a_move_notifies_those_that_want_it(listens: bool) -> None:
    """The event wakes no task unless a listener wants axes that come to rest."""
    found, controller = axis()
    heard: list[tuple[str, int]] = []
    if listens:
        controller.listeners.append(lambda what, number: heard.append((what, number)), "idle")
    found.start_at_once(controller, 410.0, "MA", 9)
    event = found.arrival_event
    assert event is not None
    assert event.call is not None
    controller.clock.now = found.ends
    assert event.call() == (not listens)
    assert heard == [("idle", 0)] * listens


def test_a_log_that_is_full_makes_room() -> None:
    """The start of a move and its end each take one record."""
    for room, made in ((2, 0), (1, 1), (0, 1)):
        found, controller = axis()
        calls: list[float] = []
        controller.make_room = lambda calls=calls: calls.append(1.0)
        controller.log.room = room
        found.start_at_once(controller, 410.0, "MA", 9)
        assert len(calls) == (room == 0)
        controller.log.room = max(controller.log.room, 0)
        controller.clock.advance(9.0)
        assert len(calls) == made + (room == 0)


def test_a_buffer_that_is_read_has_the_loaded_move() -> None:
    found, controller = axis()
    assert found.buffer == []
    found.loader(controller, True, "MOVE")(100.0, 7)
    (move,) = found.buffer
    assert (move.axis, move.command, move.line, move.target, move.base) == (0, "MOVE", 7, 410.0, 10.0)
    assert found.loaded is None
    found.loaded = (1.0, None, "MOVE", 7, None, 0)
    found.buffer = []
    assert (found.loaded, found.buffer) == (None, [])


def test_an_interrupted_start_is_rolled_back() -> None:
    """The row of 15 s is not in the log yet.

    Without it the axis is at rest since the end of the row before.
    """
    found, controller = axis()
    for target in (410.0, 20.0, 210.0):
        found.start_at_once(controller, target, "MA", 9)
        controller.clock.advance(controller.clock.now + 5.0)
    end, logged = found.ends, [*found.rows]
    entry: Any = (10.0, None, "MA", 12, None, 0)
    row: Any = (0, 15.0, 210.0, 10.0, 2.15, (1.0,), 100.0, 4.0, 0.0, entry)
    found.rows.append(row)
    found.in_motion, found.ends = True, 17.15
    found.finish_updates(14.9)
    assert len(found.rows) == 4
    found.finish_updates(15.0)
    assert (found.rows, found.in_motion, found.loaded, found.ends) == (logged, False, entry, end)
    assert (end, found.present) == (pytest.approx(10.0 + 2.05), None)
    found.finish_updates(10.0)  # it is in the log
    assert found.rows == logged
    assert found.profiles[-1].end == 210.0
    found.rows[:] = [row]
    found.finish_updates(15.0)
    assert (found.rows, found.ends) == ([], 15.0)
    assert found.present is found.profiles[-1]
