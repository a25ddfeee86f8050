"""Jogs: ramps, limits, rates of their own, and when they are over, by hand.

The rates of the axis are 100 counts/s2, and its speed, which jogs do not use, is 10 counts/s.
"""

from __future__ import annotations

from math import inf, pi

import pytest

from tests.cases import cases
from tests.kernel.controller.machines import machine, until

Rates = tuple[float | None, float | None]


@cases(
    "velocity, rates, settings, reached, time",
    [
        (20.0, None, {}, 20.0, 0.2),
        (-20.0, None, {}, -20.0, 0.2),
        (20.0, (50.0, 25.0), {}, 20.0, 0.4),
        (20.0, (50.0, None), {}, 20.0, 0.4),
        (20.0, (None, 25.0), {}, 20.0, 0.2),
        (20.0, None, {"max_speed": 15.0}, 15.0, 0.15),
        (-20.0, None, {"max_speed": 15.0}, -15.0, 0.15),
        (20.0, None, {"max_speed": 20.0}, 20.0, 0.2),
        (20.0, None, {"max_accel": 50.0}, 20.0, 0.4),
        (20.0, (80.0, 80.0), {"max_accel": 50.0}, 20.0, 0.4),
        (20.0, None, {"max_decel": 50.0}, 20.0, 0.2),
        (20.0, None, {"accel_time": 0.5}, 20.0, 1.0),
    ],
)
def test_the_ramp_to_the_velocity_of_a_jog(
    velocity: float, rates: Rates | None, settings: dict[str, float], reached: float, time: float
) -> None:
    c = machine(1, **settings)
    c.jog(0, velocity, rates=rates)
    assert until(c, 0.5 * time).velocity(0) == pytest.approx(0.5 * reached)
    assert until(c, 3.0).velocity(0) == reached
    assert c.position(0) == pytest.approx(reached * (3.0 - 0.5 * time))
    assert c.target(0) == inf
    (entry,) = c.log.moves
    assert entry.commanded_speed == 20.0


@cases(
    "velocity, rates, settings, time",
    [
        (5.0, None, {}, 0.15),
        (5.0, (None, 25.0), {}, 0.6),
        (5.0, (25.0, None), {}, 0.15),
        (5.0, None, {"max_decel": 30.0}, 0.5),
        (-10.0, None, {}, 0.3),
        (-10.0, (25.0, 50.0), {}, 0.4 + 0.4),
        (30.0, (25.0, 50.0), {}, 0.4),
        (0.0, None, {}, 0.2),
    ],
)
def test_the_ramp_from_one_jog_to_another(
    velocity: float, rates: Rates | None, settings: dict[str, float], time: float
) -> None:
    """From 20 counts/s at 1 s it slows down at the deceleration.

    It speeds up, or beyond rest, at the acceleration.
    """
    c = machine(1, **settings)
    c.jog(0, 20.0)
    until(c, 1.0).jog(0, velocity, rates=rates)
    assert abs(until(c, 1.0 + time - 0.01).velocity(0) - velocity) > 0.1
    assert until(c, 1.0 + time + 1e-9).velocity(0) == pytest.approx(velocity)
    assert [move.ended for move in c.log.moves] == ["retarget", ""]
    assert not c.is_idle(0)


def test_the_same_jog_again_changes_nothing() -> None:
    """The command, the velocity, or other settings during the ramp make another one."""
    c = machine(1)
    c.jog(0, 20.0, "JOG", 1)
    until(c, 0.1).jog(0, 20.0, "JOG", 2)
    assert len(c.log.moves) == 1
    c.jog(0, 20.0, "JOG", 3, rates=(50.0, None))
    assert len(c.log.moves) == 2
    assert until(c, 0.25).velocity(0) == pytest.approx(10.0 + 50.0 * 0.15)
    until(c, 1.0).jog(0, 20.0, "JOG", 4)  # at the velocity the rates do not matter
    assert len(c.log.moves) == 2
    c.jog(0, 20.0, "VEL", 5)
    assert len(c.log.moves) == 3
    c.jog(0, 19.0, "VEL", 6)
    assert len(c.log.moves) == 4
    assert [move.line for move in c.log.moves] == [1, 3, 5, 6]


def test_a_jog_to_standstill_is_over_only_if_it_ends() -> None:
    c = machine(1)
    c.jog(0, 0.0, ends=True)
    assert (c.is_idle(0), len(c.log.moves)) == (True, 0)
    c.jog(0, 20.0)
    until(c, 1.0).jog(0, 0.0, ends=True)
    assert c.target(0) == pytest.approx(18.0 + 2.0)
    assert c.idle_time(0) == pytest.approx(1.2)
    assert not until(c, 1.19).is_idle(0)
    assert until(c, 1.21).is_idle(0)
    c.jog(0, 20.0)
    until(c, 2.0).jog(0, 0.0)
    assert (c.target(0), c.idle_time(0)) == (inf, inf)
    assert until(c, 9.0).velocity(0) == 0.0
    assert not c.is_idle(0)


def test_a_limit_that_changes_acts_on_a_jog_at_once() -> None:
    c = machine(1)
    c.jog(0, 20.0)
    until(c, 1.0).configure(0, "max_speed", 5.0)
    assert until(c, 1.1).velocity(0) == pytest.approx(10.0)
    assert until(c, 2.0).velocity(0) == 5.0
    c.configure(0, "max_speed", inf)
    assert until(c, 3.0).velocity(0) == 20.0
    assert len(c.log.moves) == 1


def test_a_suspended_jog_comes_to_rest_and_goes_on() -> None:
    c = machine(1)
    c.jog(0, 20.0)
    until(c, 1.0).suspend(0)
    assert until(c, 1.1).velocity(0) == pytest.approx(10.0)
    assert until(c, 2.0).velocity(0) == 0.0
    assert not c.is_idle(0)
    c.jog(0, 30.0)
    assert until(c, 3.0).velocity(0) == 0.0
    c.resume(0)
    assert until(c, 3.1).velocity(0) == pytest.approx(10.0)
    assert until(c, 4.0).velocity(0) == 30.0


def test_another_jog_at_its_beginning_replaces_one_without_an_acceleration_yet() -> None:
    """A sinusoidal ramp to 20 at 100 takes 0.1 pi s, at 50 twice that."""
    c = machine(1, shape="sinusoidal")
    c.jog(0, 20.0, "JOG")
    assert c.axes[0].profiles[-1].knots == pytest.approx((0.0, 0.1 * pi, inf))
    c.jog(0, 20.0, "JOG", rates=(50.0, None))
    assert c.axes[0].profiles[-1].knots == pytest.approx((0.0, 0.2 * pi, inf))
    assert len(c.log.moves) == 2


def test_a_jog_to_the_end_of_its_own_flank_needs_no_other_ramp() -> None:
    """In the second half of the ramp the flank leads to 20 counts/s, at 0.1 pi s."""
    c = machine(1, shape="sinusoidal")
    c.jog(0, 20.0, "JOG")
    until(c, 0.25).jog(0, 20.0, "JOG", rates=(50.0, None))
    assert c.axes[0].profiles[-1].knots == pytest.approx((0.0, 0.1 * pi - 0.25, inf))
    assert until(c, 1.0).velocity(0) == 20.0


def test_the_same_jog_again_at_its_velocity_changes_nothing_after_another_one() -> None:
    c = machine(1)
    c.jog(0, 15.0, "JOG", 1)
    until(c, 1.0).jog(0, 20.0, "JOG", 2)
    until(c, 2.0).jog(0, 20.0, "JOG", 3, rates=(50.0, None))
    assert [move.line for move in c.log.moves] == [1, 2]
