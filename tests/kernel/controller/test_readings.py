"""Edge cases of readings: jogs, slaves at rest, the last one of several motions."""

from __future__ import annotations

from math import inf, sqrt

import pytest

from motionlang.kernel import Controller, Machine
from motionlang.kernel.planners import from_curve


def controller() -> Controller:
    c = Machine({}).controller
    for axis in (0, 1):
        for name, value in (("speed", 50.0), ("accel", 100.0), ("decel", 100.0)):
            c.configure(axis, name, value)
    return c


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


def test_times_at_which_axes_will_be_idle() -> None:
    """30 at 50 with rates of 100 takes 0.5 + 0.1 + 0.5 s.

    12.5 takes 2 sqrt(12.5 / 100).
    """
    c = controller()
    assert (c.idle_time(0), c.standstill_time(0), c.rest_time(0), c.settled_time(0)) == (0.0, 0.0, 0.0, 0.0)
    assert (c.moving(), c.settling()) == ([], [])
    assert c.end_of_moves((0,))() == -1.0
    assert c.end_of_moves((0, 1))() == -1.0
    assert c.end_of_moves(())() == -1.0
    c.move_to(1, 30.0)
    c.clock.advance(0.2)
    assert (c.idle_time(0), c.standstill_time(0)) == (0.2, 0.2)
    assert c.idle_time(1) == c.standstill_time(1) == pytest.approx(1.1)
    assert c.moving() == [1]
    c.move_to(0, 12.5)
    end = 0.2 + 2.0 * sqrt(12.5 / 100.0)
    assert c.end_of_moves((0,))() == pytest.approx(end)
    assert c.end_of_moves((0, 1))() == pytest.approx(1.1)
    assert c.moving() == [0, 1]
    c.clock.advance(1.0)
    assert c.end_of_moves((0, 1))() == pytest.approx(1.1)
    assert c.moving() == [1]
    c.jog(0, -20.0)
    assert c.idle_time(0) == c.standstill_time(0) == c.end_of_moves((0, 1))() == inf
    assert not c.is_still(0)


def test_crossing_times_of_a_position() -> None:
    """50 t² during the first 0.5 s, then 50 counts/s, and 0.5 s down."""
    c = controller()
    assert c.crossing_time(0, 5.0) == inf
    c.move_to(0, 30.0)
    c.clock.advance(0.2)
    for position, time in (
        (4.5, 0.3),
        (12.5, 0.5),
        (17.5, 0.6),
        (30.0, 1.1),
        (31.0, inf),
        (1.0, inf),
        (inf, inf),
    ):
        assert c.crossing_time(0, position) == c.demand_crossing_time(0, position) == pytest.approx(time)
    for left, time in ((25.5, 0.3), (17.5, 0.5), (0.0, 1.1), (inf, inf), (-1.0, inf)):
        assert c.remaining_crossing_time(0, left) == pytest.approx(time)
    assert c.error_crossing_time(0, 1.0) == inf
    assert c.error_crossing_time(0, inf) == c.error_crossing_time(0, -inf) == inf
    assert c.velocity_crossing_time(0, 30.0) == pytest.approx(0.3)
    c.clock.advance(2.0)
    assert c.crossing_time(0, 30.0) == inf
    assert c.demand_velocity_crossing_time(0, 0.0) == inf


def test_an_encoder_from_outside() -> None:
    """From rest to 50 counts/s in 0.5 s, and at 1 s back to rest until 1.5 s."""
    c = controller()
    assert not c.turns(7)
    assert (c.encoder_position(7), c.encoder_velocity(7), c.encoder_crossing_time(7, 5.0)) == (0.0, 0.0, inf)
    c.drive_encoder(7, 50.0, 100.0)
    assert c.turns(7)
    assert c.encoder_crossing_time(7, 12.5) == pytest.approx(0.5)
    c.clock.advance(1.0)
    assert c.turns(7)
    assert (c.encoder_position(7), c.encoder_velocity(7)) == pytest.approx((37.5, 50.0))
    assert c.encoder_crossing_time(7, 62.5) == pytest.approx(1.5)
    c.drive_encoder(7, 0.0, 100.0)
    moves = []
    for time in (1.0, 1.4, 1.6):
        c.clock.advance(time)
        moves.append(c.turns(7))
    assert moves == [True, True, False]
    assert c.encoder_position(7) == pytest.approx(50.0)
    c.drive_encoder(7, -50.0, 0.0)
    assert c.turns(7)
    c.drive_encoder(7, 0.0, 0.0)
    assert not c.turns(7)


def test_gains_are_those_of_the_program_or_the_default() -> None:
    c = controller()
    assert c.gain(0, "proportional", 5.0) == 5.0
    c.set_gain(0, "proportional", 2.0, "KPROP")
    c.set_gain(0, "integral", 3.0, "KINT")
    assert [c.gain(0, name, 5.0) for name in ("proportional", "integral", "derivative")] == [2.0, 3.0, 5.0]
    assert c.gain(1, "proportional", 5.0) == 5.0
    c.set_gains(0, {"derivative": (4.0, "KDERIV")})
    assert [c.gain(0, name, 5.0) for name in ("proportional", "integral", "derivative")] == [5.0, 5.0, 4.0]


def test_when_the_velocity_on_a_curve_reaches_a_value_or_may_turn_back() -> None:
    """18 t² - 12 t³ has 36 t - 36 t² counts/s: 5.76 at 0.2 s and 0.8 s."""
    c = controller()
    curve = ((0.0, 1.0), ((0.0, 0.0, 18.0, -12.0, 0.0, 0.0, 0.0),), (("segment", 0),))
    c.play(0, from_curve("table", 0.0, 6.0, curve, 0.0, 0.0))
    for velocity, time in ((inf, inf), (-inf, inf), (5.76, 0.2), (100.0, 0.5)):
        assert c.demand_velocity_crossing_time(0, velocity) == pytest.approx(time)
    c.clock.advance(0.6)
    for velocity, time in ((inf, inf), (5.76, 0.8), (100.0, 1.0)):
        assert c.demand_velocity_crossing_time(0, velocity) == pytest.approx(time)
