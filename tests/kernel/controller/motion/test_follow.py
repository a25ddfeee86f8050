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


def test_the_log_has_one_entry_for_all_of_the_following() -> None:
    c = machine()
    c.gear(1, 0, 2.0, command="FOLLOW", line=2)
    until(c, 1.0).move_to(0, 20.0)
    until(c, 5.0).move_to(0, 10.0)
    until(c, 9.0).stop(1)
    entry = c.log.moves[0]
    assert (entry.axis, entry.command, entry.line, entry.ended) == (1, "FOLLOW", 2, "stop")
    assert entry.profile is not None
    assert entry.profile.duration == pytest.approx(9.0)
    assert entry.profile.position(2.0) == pytest.approx(19.0)
    assert entry.profile.peak_speed == pytest.approx(20.0)
    (phase,) = entry.profile.cut(9.0).phases
    assert (phase.name, phase.distance) == ("gear", 20.0)
    assert until(c, 12.0).position(1) == 20.0
    assert c.is_idle(1)


def test_slaves_of_slaves() -> None:
    c = machine(3)
    c.gear(1, 0, 2.0)
    c.gear(2, 1, 3.0)
    c.move_to(0, 20.0)
    assert until(c, 1.0).position(2) == pytest.approx(57.0)
    for slave, master in ((0, 2), (0, 0), (0, 1)):
        with pytest.raises(Rejected, match="follow itself"):
            c.gear(slave, master, 1.0)


def test_a_new_zero_of_the_master_does_not_move_the_slave() -> None:
    c = machine()
    c.gear(1, 0, 1.0)
    c.move_to(0, 20.0)
    until(c, 1.0).define_position(0, 1000.0)
    assert until(c, 9.0).position(1) == pytest.approx(20.0)
    c.define_position(1, 7.0)
    c.move_by(0, 1.0)
    assert until(c, 20.0).position(1) == pytest.approx(8.0)


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


def test_a_master_that_changes_during_the_ramp_is_met_all_the_same() -> None:
    c = machine()
    c.configure(1, "accel", 20.0)
    c.jog(0, 10.0)
    until(c, 1.0).gear(1, 0, 1.0, ramp=True)
    until(c, 1.2).jog(0, 20.0)
    until(c, 3.0)
    assert c.velocity(1) == pytest.approx(20.0)
    assert speed(c, 1, 1.5) == pytest.approx(10.0)
    assert speed(c, 1, 1.99) == pytest.approx(19.8)


def test_a_slave_that_is_off_follows_no_master() -> None:
    c = machine()
    c.gear(1, 0, 1.0)
    c.jog(0, 10.0)
    until(c, 1.0).disable(1)
    assert until(c, 2.0).position(1) == pytest.approx(9.5)
    with pytest.raises(Rejected, match="off"):
        c.gear(1, 0, 1.0)


def test_watches_on_a_slave_are_exact() -> None:
    c = machine()
    seen: list[float] = []
    c.watch(1, 5.0, lambda direction: seen.append(c.clock.now))
    c.gear(1, 0, 0.5)
    c.move_to(0, 20.0)
    until(c, 9.0)
    assert seen == pytest.approx([1.05])


# -------------------------------------------------------------------------------------------------- shears


def shear(c: Controller, *segments: tuple[float, float]) -> None:
    for distance, over in segments:
        c.load_fly(1, 0, distance, over, command="FLY")
    c.go([1])


def test_a_shear_rests_when_its_master_does_and_goes_on_with_it() -> None:
    c = machine()
    shear(c, (5.0, 10.0))
    c.move_to(0, 4.0)
    assert until(c, 5.0).position(1) == pytest.approx(5.0 * 0.16)
    assert not c.is_idle(1)
    c.move_to(0, 10.0)
    until(c, 9.0)
    assert c.position(1) == pytest.approx(5.0)


def test_a_shear_whose_master_goes_back_first_ends_where_it_should() -> None:
    c = machine()
    shear(c, (5.0, 10.0))
    c.move_to(0, -4.0)
    c.clock.at(0.1, lambda: c.retarget_to(0, 10.0))  # it reverses before 0 is reached again
    until(c, 9.0)
    assert c.position(1) == pytest.approx(5.0)
    assert c.is_idle(1)


def test_a_shear_that_is_over_at_speed_brakes() -> None:
    c = machine()
    shear(c, (5.0, 10.0))
    c.jog(0, 10.0)
    until(c, 9.0)
    assert c.is_idle(1)
    assert c.position(1) == pytest.approx(5.0 + 0.5)
    c.move_by(1, 1.0)
    assert until(c, 12.0).position(1) == pytest.approx(6.5)


# ---------------------------------------------------------------------------------------------------- cams


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


# ------------------------------------------------------------------------------------------------- offsets


def moving_slave() -> Controller:
    c = machine()
    c.jog(0, 10.0)
    c.gear(1, 0, 1.0)
    return until(c, 1.0)  # both at 9.5, at 10 counts/s


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


def test_a_slave_of_a_slave_on_a_curve_follows_it_to_the_last_bits() -> None:
    """The slave follows the exact motion, not the pieces that are made for drawing it."""
    c = machine(3, shape="scurve", accel_jerk=1000.0, decel_jerk=6000.0)
    c.load_fly(1, 0, 30.0, 20.0)
    c.go([1])
    c.gear(2, 1, -19.42)
    c.move_to(0, 15.0)
    for k in range(1, 60):
        until(c, 0.02 * k)
        assert c.position(2) == pytest.approx(-19.42 * c.position(1), rel=1e-12, abs=1e-15)


def test_a_tie_that_lasts_goes_on_as_another_entry_of_the_log(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("motionlang.kernel.controller.motion.follow.MAX_FOLLOWED", 3)
    c = machine()
    c.gear(1, 0, 1.0, command="FOLLOW", line=2)
    for n in range(6):
        until(c, 2.0 * n).move_to(0, 10.0 * (n % 2 == 0))
    until(c, 20.0)
    entries = [move for move in c.log.moves if move.axis == 1]
    assert len(entries) > 1
    assert {each.command for each in entries} == {"FOLLOW"}
    assert c.position(1) == pytest.approx(c.position(0))


# The time of the resumption, what is left of the offset just before, the times, positions and velocities of the
# slave, and the phases of the offset in the log.
PAUSED: dict[str, tuple[float, float, list[tuple[float, float, float]], list[tuple[str, float, float]]]] = {
    "in the ramp": (
        1.6, 14.75, [(1.6, 20.5, 10.0), (1.65, 21.25, 20.0), (3.1375, 50.5, 10.0), (5.0, 69.125, 10.0)],
        [
            ("accel", 0.1, 0.5), ("slew", 0.4, 4.0), ("stop", 0.1, 0.75), ("accel", 0.05, 0.375),
            ("slew", 1.3875, 13.875), ("decel", 0.1, 0.5),
        ],
    ),
    "at rest": (
        3.0, 14.5, [(1.7, 21.0, 0.0), (3.05, 21.25, 10.0), (3.1, 22.0, 20.0), (4.55, 50.5, 10.0), (5.0, 55.0, 10.0)],
        [
            ("accel", 0.1, 0.5), ("slew", 0.4, 4.0), ("stop", 0.2, 1.0), ("hold", 1.3, 0.0), ("accel", 0.1, 0.5),
            ("slew", 1.35, 13.5), ("decel", 0.1, 0.5),
        ],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PAUSED)
def test_a_suspended_slave_pauses_its_offset(name: str) -> None:
    """The slave is suspended at 1.5 s, at 19 counts and 20 counts/s.

    Half of that speed is the offset's, which has covered 4.5 of 20 counts. The ramp at 100 counts/s² takes 0.2 s and
    2 counts, 1 of them the offset's; after half of that time it is 0.75. The offset goes on at 10 counts/s.
    """
    resumed, left, states, phases = PAUSED[name]
    c = moving_slave()
    offset(c, 1, 20.0, command="OFFSET", line=4)
    until(c, 1.5).suspend(1)
    assert c.offset_remaining(1) == pytest.approx(15.5)
    until(c, resumed)
    assert c.offset_remaining(1) == pytest.approx(left)
    c.resume(1)
    assert c.offset_remaining(1) == pytest.approx(left)
    until(c, 5.0)
    assert [(at(c, 1, t), speed(c, 1, t)) for t, *_ in states] == [
        pytest.approx(state, abs=1e-6) for _, *state in states
    ]
    assert c.offset_remaining(1) == 0.0
    entry = c.log.moves[-1]
    assert entry.profile is not None
    assert (entry.command, entry.line, entry.start_time, entry.ended) == ("OFFSET", 4, 1.0, "")
    assert [phase.name for phase in entry.profile.phases] == [kind for kind, _, _ in phases]
    found = [(phase.duration, phase.distance) for phase in entry.profile.phases]
    assert found == [pytest.approx(figures) for _, *figures in phases]


def test_a_ratio_that_is_written_again_begins_no_new_ramp() -> None:
    """From 1 s on it gains 100 counts/s each second, from 1.1 s on 50 counts/s."""
    c = machine()
    c.jog(0, 10.0)
    until(c, 1.0).gear(1, 0, 2.0, ramp=True)
    a = c.axes[1]
    until(c, 1.1).gear(1, 0, 2.0, ramp=True)
    assert a.starts[-1] == 1.0
    c.configure(1, "accel", 50.0)
    c.gear(1, 0, 2.0, ramp=True)
    assert a.starts[-1] == 1.1
    assert until(c, 1.2).velocity(1) == pytest.approx(15.0)
    assert until(c, 1.3).velocity(1) == pytest.approx(20.0)
    until(c, 2.0).configure(1, "accel", 100.0)
    c.gear(1, 0, 2.0, ramp=True)
    assert a.starts[-1] == 1.1
    c.gear(1, 0, 2.0)
    assert (a.starts[-1], c.velocity(1)) == pytest.approx((2.0, 20.0))
    c.set_ratio(1, 2.0)
    c.set_ratio(0, 3.0)  # no slave
    assert a.starts[-1] == 2.0
    until(c, 2.5).set_ratio(1, -1.0)
    assert (a.starts[-1], c.velocity(1)) == pytest.approx((2.5, -10.0))


@pytest.mark.parametrize("ratio", [1e12, -1e12, math.inf, math.nan])
def test_a_ratio_that_is_too_large_is_rejected(ratio: float) -> None:
    c = machine()
    c.gear(1, 0, 9e11)
    message = rf"an axis cannot follow at a ratio of {ratio:g}".replace("+", r"\+")
    with pytest.raises(Rejected, match=message):
        c.gear(1, 0, ratio)
    with pytest.raises(Rejected, match=message):
        c.set_ratio(1, ratio)


def test_a_slave_that_leaves_its_master_completes_its_profile() -> None:
    """The master takes 2.1 s for 20 counts, unless it is stopped at 1.5 s."""
    c = machine()
    c.gear(1, 0, 0.5, command="FOLLOW")
    c.move_to(0, 20.0)
    until(c, 1.0).leave_master(1)
    assert c.master_of(1) is None
    assert (c.target(1), c.idle_time(1)) == pytest.approx((10.0, 2.1))
    until(c, 1.5).stop(0)
    until(c, 9.0)
    assert (c.position(0), c.position(1)) == pytest.approx((15.0, 10.0))
    entry = c.log.moves[0]
    assert (entry.command, entry.ended, entry.target) == ("FOLLOW", "", 10.0)
    assert entry.profile is not None
    assert entry.profile.duration == pytest.approx(2.1)
    c.leave_master(1)  # a no-op
    assert c.is_idle(1)


@cases(
    "cut, distance, ended",
    [(lambda c: None, 5.0, ""), (lambda c: c.stop(1), 3.0, "stop"), (lambda c: c.abort(1), 3.0, "cancel"),
     (lambda c: c.suspend(1), 3.0, "stop")],
)  # fmt: skip
def test_a_slave_that_leaves_its_master_completes_its_offset(
    cut: Callable[[Controller], None], distance: float, ended: str
) -> None:
    """The offset of 5 takes 0.6 s, of which the slave has covered 2 as it leaves, and 3 at the cut."""
    c = machine()
    c.gear(1, 0, 0.5)
    c.move_to(0, 20.0)
    offset(until(c, 1.0), 1, 5.0, command="OFFSET")
    until(c, 1.25).leave_master(1)
    cut(until(c, 1.35))
    until(c, 9.0)
    (entry,) = (move for move in c.log.moves if move.command == "OFFSET")
    assert entry.profile is not None
    assert entry.profile.end == pytest.approx(distance)
    assert entry.ended == ended
    assert ended or c.position(1) == pytest.approx(15.0)


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


def test_a_stop_after_an_offset_leaves_its_entry() -> None:
    c = machine()
    c.gear(1, 0, 0.5)
    c.move_to(0, 20.0)
    offset(until(c, 1.0), 1, 5.0, command="OFFSET")
    until(c, 1.25).leave_master(1)
    until(c, 1.7).stop(1)
    (entry,) = (move for move in c.log.moves if move.command == "OFFSET")
    assert entry.profile is not None
    assert entry.profile.duration == pytest.approx(0.6)
    assert not entry.ended


def test_a_slave_at_rest_that_leaves_its_master_is_idle() -> None:
    c = machine(buffer_size=3)
    c.gear(1, 0, 0.5)
    c.move_to(0, 20.0)
    until(c, 5.0)
    c.load_to(1, 13.0)
    c.axes[1].buffer[0].released = True
    assert not c.is_idle(1)
    c.leave_master(1)
    assert c.log.moves[0].profile is not None
    assert c.log.moves[0].profile.duration == pytest.approx(5.0)
    assert until(c, 9.0).position(1) == pytest.approx(13.0)
    c.gear(1, 0, 0.5)
    c.leave_master(1)
    c.move_to(0, 0.0)
    assert c.is_idle(1)
    assert c.target(1) == pytest.approx(13.0)
    assert until(c, 20.0).position(1) == pytest.approx(13.0)


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


def test_a_slave_that_returns_to_where_it_is_does_not_rest() -> None:
    """At 1 s the master has 10 counts/s at 9.5; its new target is there, too."""
    c = machine()
    c.gear(1, 0, 1.0)
    a = c.axes[1]
    assert a.is_at_standstill
    c.move_to(0, 20.0)
    assert not a.is_at_standstill
    until(c, 1.0).move_to(0, c.position(0))
    assert a.profiles[-1].start == pytest.approx(a.profiles[-1].end)
    assert not a.is_at_standstill
    assert until(c, 5.0).position(1) == pytest.approx(9.5)
    assert a.is_at_standstill
    c.move_to(0, 30.0)
    assert not a.is_at_standstill
    until(c, 9.0)
    assert (a.is_at_standstill, c.is_idle(1)) == (True, False)


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
