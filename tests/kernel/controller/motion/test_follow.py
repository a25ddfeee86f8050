"""Master and slave: gearing, ramps, cams, flying shears, offsets."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from motionlang.kernel import Controller, Rejected
from motionlang.kernel.planners import plan, plan_pvt
from tests.cases import cases
from tests.kernel.controller.machines import cam, machine, offset, until


def at(c: Controller, axis: int, time: float) -> float:
    return c.axes[axis].position(time)


def speed(c: Controller, axis: int, time: float) -> float:
    return c.axes[axis].velocity(time)


# ------------------------------------------------------------------------------------------------ gearing


@pytest.mark.parametrize(("speed", "back"), [(9.0, 0.0), (-9.0, 0.0), (6.0, -2.0)])
def test_a_ramp_may_take_up_to_a_million_seconds(speed: float, back: float) -> None:
    """At 1e-5 counts/s² a velocity of 9 takes 900 000 s; from -2 to 6 it is 800 000 s."""
    c = machine()
    c.configure(1, "accel", 1e-5)
    c.configure(1, "decel", 1e-5)
    c.jog(0, 2.0)
    until(c, 1.0)
    if back:
        c.gear(1, 0, back / 2.0)
    c.gear(1, 0, speed / 2.0, ramp=True)
    end = 1.0 + 1e5 * abs(speed - back)
    assert until(c, 0.5 * end).velocity(1) == pytest.approx(0.5 * (speed + back), abs=1e-4)
    assert until(c, end + 1.0).velocity(1) == pytest.approx(speed)


@pytest.mark.parametrize("speed", [15.0, -15.0])
def test_a_ramp_of_more_than_a_million_seconds_is_refused(speed: float) -> None:
    """At 1e-5 counts/s² a velocity of 15 takes 1.5 million s."""
    c = machine()
    c.configure(1, "accel", 1e-5)
    c.jog(0, 10.0)
    with pytest.raises(Rejected, match=f"axis 1 cannot ramp to {speed:g} counts/s, the speed of its master"):
        until(c, 1.0).gear(1, 0, speed / 10.0, ramp=True)


def test_a_slave_that_is_off_follows_no_master() -> None:
    c = machine()
    c.gear(1, 0, 1.0)
    c.jog(0, 10.0)
    until(c, 1.0).disable(1)
    assert until(c, 2.0).position(1) == pytest.approx(9.5)
    with pytest.raises(Rejected, match="off"):
        c.gear(1, 0, 1.0)


# -------------------------------------------------------------------------------------------------- shears


def shear(c: Controller, *segments: tuple[float, float]) -> None:
    for distance, over in segments:
        c.load_fly(1, 0, distance, over, command="FLY")
    c.go([1])


# ---------------------------------------------------------------------------------------------------- cams


# ------------------------------------------------------------------------------------------------- offsets


def test_an_offset_on_a_cam() -> None:
    c = machine()
    cam(c, 1, 0, [0.0, 10.0, 20.0], [0.0, 5.0, 0.0], cyclic=True)
    c.jog(0, 10.0)
    plain = machine()
    cam(plain, 1, 0, [0.0, 10.0, 20.0], [0.0, 5.0, 0.0], cyclic=True)
    plain.jog(0, 10.0)
    offset(until(c, 1.0), 1, 3.0)
    until(plain, 6.0)
    until(c, 6.0)
    for k in range(140, 600):
        assert at(c, 1, 0.01 * k) == pytest.approx(at(plain, 1, 0.01 * k) + 3.0, abs=1e-9)
    for k in range(600):
        assert abs(at(c, 1, 0.01 * k + 0.01) - at(c, 1, 0.01 * k)) < 0.35


def test_a_slave_that_leaves_the_master_of_its_arc_can_be_suspended() -> None:
    """The arc of 10 π takes 3.24 s, and the suspension 0.5: its ramps cover half of their 0.2 s."""
    c = machine(3, suspend_time=0.2)
    c.load_arc([0, 1], (10.0, 0.0), 180.0)
    c.gear(2, 0, 0.5)
    c.go([0])
    until(c, 1.0).leave_master(2)
    c.suspend(2)
    until(c, 1.5)
    assert (speed(c, 2, 1.5), c.position(0) > 2.0 * c.position(2)) == (0.0, True)
    c.resume(2)
    assert c.idle_time(2) == pytest.approx(0.1 + math.pi + 0.5)
    assert until(c, 9.0).position(2) == pytest.approx(10.0)


def test_a_slave_locks_where_the_velocity_of_its_master_jumps_past_its_own() -> None:
    """The slave has reached 8 as the master turns from 10 to -10 at 1 s."""
    c = machine(accel=8.0)
    c.play(0, plan_pvt((0.0, 10.0, 0.0), (), (1.0, 1.0)))
    c.gear(1, 0, 1.0, ramp=True)
    assert until(c, 2.0).position(1) == pytest.approx(4.0 - 10.0)


def test_a_slave_that_has_left_its_master_needs_a_deceleration_to_stop() -> None:
    c = machine()
    c.gear(1, 0, 0.5)
    c.move_to(0, 20.0)
    until(c, 1.0).leave_master(1)
    c.load_to(1, 13.0)
    c.configure(1, "decel", 0.0)
    with pytest.raises(Rejected, match="axis 1 cannot stop: its deceleration is 0"):
        c.stop(1)
    assert len(c.axes[1].buffer) == 1
    assert not list(c.log.dropped)


def test_the_shortest_segment_of_a_shear_is_one_count_of_its_master() -> None:
    """The ratio grows to 2 * 5 / 1: at 100 counts/s the slave stops over 50 more."""
    c = machine()
    shear(c, (5.0, 1.0))
    c.jog(0, 10.0)
    assert until(c, 9.0).position(1) == pytest.approx(55.0)
    for over in (0.999, -0.999, 0.0):
        with pytest.raises(Rejected, match=rf"a segment cannot go 5 counts while its master goes {over:g}$"):
            c.load_fly(1, 0, 5.0, over)
    c.load_fly(1, 0, 5.0, -1.0)
    c.go([1])
    c.jog(0, -10.0)
    assert until(c, 20.0).position(1) == pytest.approx(110.0)


def follow(c: Controller, begin: Callable[[Controller], object]) -> None:
    c.gear(2, 0, 1.0)
    begin(c)


def arc(c: Controller, axis: int = 0) -> None:
    c.load_arc([axis, 1], [10.0, 0.0], 360.0, (), True)
    c.go([axis])


@cases(
    "begin, time, is_eased",
    [(lambda c: c.move_to(2, 90.0), 0.3, True), (lambda c: c.jog(2, 20.0), 0.3, True),
     (lambda c: follow(c, lambda c: c.move_to(0, 90.0)), 0.3, False), (lambda c: follow(c, arc), 0.3, False),
     (lambda c: follow(c, arc), 0.9, False),  # at uniform speed: a wave
     (lambda c: arc(c, 2), 0.3, False), (lambda c: arc(c, 2), 0.9, False),
     (lambda c: c.play(2, plan("sinusoidal", 0.0, 90.0, 20.0, 50.0, 50.0)), 0.3, False)],
)  # fmt: skip
def test_only_a_ramp_of_the_axis_itself_is_eased_along_its_flank(
    begin: Callable[[Controller], None], time: float, is_eased: bool
) -> None:
    """A stop from v takes v π / 100, and begins at once if the acceleration is that of a master or a table.

    After 0.3 s an own ramp is at 1.5 rad of its wave, and has v = 10 - 10 cos 1.5. Its flank leads to 2 v in 0.3 s.
    """
    c = machine(3, speed=20.0, accel=50.0, decel=50.0, shape="sinusoidal")
    begin(c)
    until(c, time).come_to_rest(2)
    v = speed(c, 2, time)
    until(c, 8.0)
    at_once = 0.5 * v * v * math.pi / 100.0
    eased = 0.3 * 2.0 * v - 10.0 * (0.3 - 0.2 * math.sin(1.5)) + 4.0 * at_once
    assert abs(at(c, 2, 8.0) - at(c, 2, time)) == pytest.approx(eased if is_eased else at_once)


def test_a_shear_rests_when_its_master_does_and_goes_on_with_it() -> None:
    c = machine()
    shear(c, (5.0, 10.0))
    c.move_to(0, 4.0)
    assert until(c, 5.0).position(1) == pytest.approx(5.0 * 0.16)
    assert not c.is_idle(1)
    c.move_to(0, 10.0)
    until(c, 9.0)
    assert c.position(1) == pytest.approx(5.0)


@pytest.mark.parametrize("rise", [2.0, 0.5])
def test_a_slave_that_leaves_its_cam_in_motion_brakes_beyond_it(rise: float) -> None:
    """At the cam's end the slave has `rise` counts/s: the table takes one second.

    It brakes at 1 count/s².
    """
    c = machine()
    c.configure(1, "decel", 1.0)
    c.jog(0, 10.0)
    cam(until(c, 1.0), 1, 0, [0.0, 10.0], [0.0, rise])
    assert until(c, 9.0).position(1) == pytest.approx(rise + 0.5 * rise * rise)
    assert c.is_idle(1)
