"""Edge cases of readings: jogs, slaves at rest, the last one of several motions."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.controller.controller import Controller
from motionlang.controller.move import Action
from motionlang.lang.machine.machine import Machine


def controller() -> Controller:
    c = Machine({}).controller
    for axis in (0, 1):
        for name, value in (("speed", 50.0), ("accel", 100.0), ("decel", 100.0)):
            c.configure(axis, name, value)
    return c


def test_a_jog_has_nothing_remaining_and_a_move_has() -> None:
    c = controller()
    c.jog(0, 20.0)
    c.move_to(1, 30.0)
    c.clock.advance(0.2)
    assert c.target(0) == inf
    assert c.remaining(0) == 0.0
    assert c.remaining(1) == pytest.approx(30.0 - 0.5 * 100.0 * 0.2**2)
    c.clock.advance(10.0)
    assert c.remaining(1) == 0.0


def test_a_slave_whose_master_rests_passes_nothing_not_even_where_it_is() -> None:
    c = controller()
    c.gear(0, 1, 1.0)
    assert c.demand_crossing_time(0, 0.0) == inf
    c.jog(1, 20.0)
    c.clock.advance(1.0)
    here = c.position(0)
    assert c.demand_crossing_time(0, here + 20.0) == pytest.approx(2.0)
    assert c.demand_crossing_time(0, here - 1.0) == inf


def test_while_a_velocity_is_what_it_is_it_changes_when_that_ends() -> None:
    """30 at 50 with rates of 100: 0.5 s up to 50, 0.1 s constant, 0.5 s down."""
    c = controller()
    c.move_to(0, 30.0)
    c.clock.advance(0.2)
    assert c.demand_velocity_crossing_time(0, 30.0) == pytest.approx(0.3)
    c.clock.advance(0.55)
    assert c.demand_velocity_crossing_time(0, 50.0) == pytest.approx(0.6)
    assert c.demand_velocity_crossing_time(0, 30.0) == pytest.approx(0.8)
    c.clock.advance(0.7)
    assert c.demand_velocity_crossing_time(0, 30.0) == pytest.approx(0.8)


def test_a_velocity_that_the_rest_of_a_move_does_not_have_is_not_reached_before_its_end() -> None:
    """30 at 50 with rates of 100 takes 0.5 s up, 0.1 s at 50 and 0.5 s down."""
    c = controller()
    c.move_to(0, 30.0)
    c.clock.advance(0.1)
    assert c.demand_velocity_crossing_time(0, 0.0) == pytest.approx(1.1)
    assert c.demand_velocity_crossing_time(0, 60.0) == pytest.approx(1.1)
    assert c.demand_velocity_crossing_time(0, inf) == pytest.approx(0.5)  # the trend changes


def test_what_remains_of_a_motion_is_that_of_the_last_one() -> None:
    """A buffer entry without a plan of its own has the plan of the motion's rest."""
    c = controller()
    c.move_to(0, 10.0)
    c.clock.advance(5.0)
    c.move_to(0, -40.0)
    c.clock.advance(5.5)
    a = c.axes[0]
    left = Action().plan(c, a)
    assert len(a.profiles) > 2
    assert left.start == pytest.approx(c.position(0))
    assert left.end == pytest.approx(-40.0)
    assert left.velocity(0.0) == pytest.approx(a.velocity(5.5)) != 0.0
    assert left.duration == pytest.approx(a.end_of_motion() - 5.5)
