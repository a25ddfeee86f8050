"""Findings of generated programs: the smallest program of each kind, proved.

Each test has its hand arithmetic in its docstring. Figures without a unit are in uu, uu/s, uu/s² and uu/s³,
in MCCL in counts instead of uu.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, pi, sqrt

import pytest

from motionlang.kernel import Run, Source
from tests.proof import prove, run

RATES = "SPEED(0, 1) = 20; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 100;\n"


def proved(
    program: str,
    suffix: str = "mnt",
    until: float = 20.0,
    statement: float = 1e-9,
    inputs: Sequence[dict[str, float]] = (),
) -> Run:
    """Return a run that has no diagnostic but of very short ramps, and whose proof passes.

    `statement` is the duration of a statement, s; `inputs` are the machine's inputs.
    """
    machine = {"controller.instruction_time": statement, "input": list(inputs)}
    result = run(Source(f"found.{suffix}", program), machine=machine, until=until)
    assert [each.message for each in result.diagnostics if each.code != "short-ramp"] == []
    assert [each.message for each in prove(result).violations] == []
    return result


def positions(result: Run, *axes: int) -> list[float]:
    return [result.controller.axes[axis].position(result.time) for axis in axes]


def test_an_axis_that_turns_beyond_a_limit_that_was_lowered_brakes_for_it() -> None:
    """At 40 on a radius of 20 the centripetal acceleration is 80.

    Of a MAXDECEL of 30, the centripetal and the tangential acceleration may each have sqrt(1/2). So the path
    brakes at 21.21 to a speed of sqrt(21.21 * 20). Until then the sum of both is at most sqrt(80² + 21.21²).
    """
    arc = "CIRCLER(0, 1) = 20, 0, 360 : GO(0)\nWAIT = 1000\nMAXDECEL(1) = 30\nWAIT = 1000\nPRINT VELDEMANDPATH(0)\n"
    result = proved(f"SPEED(0) = 40 : ACCEL(0) = 100 : DECEL(0) = 100\n{arc}PAUSE IDLE(0)\n")
    rate = 30.0 * sqrt(0.5)
    assert float(result.output[0]) == pytest.approx(sqrt(rate * 20.0), abs=1e-4)
    slowed = (40.0 - sqrt(rate * 20.0)) / rate
    axis = result.controller.axes[1]
    peak = max(abs(axis.at(1.0 + slowed * k / 1000.0).acceleration) for k in range(1000))
    assert 30.0 < peak <= hypot(80.0, rate)


def test_a_last_ramp_may_be_short_next_to_its_path() -> None:
    """Two circles of radius 50 at 0.08 take 2500·pi s, a ramp at 10⁵ 0.8 microseconds."""
    program = "SCALEFACTOR(0, 1) = 100;\nSPEED(0) = 0.08 : ACCEL(0) = 1E5 : DECEL(0) = 1E5\n"
    result = proved(f"{program}CIRCLER(0, 1) = 50, 0, 720 : GO(0)\nPAUSE IDLE(0)\n", until=1e4)
    assert result.time == pytest.approx(2500.0 * pi + 8e-7, abs=1e-7)


def stop_of(program: str) -> tuple[float, float]:
    """Return start and duration, s, of the stop of axis 1 in a proved run."""
    result = proved(program, "mcl")
    axis = result.controller.axes[1]
    index = max(
        k for k, profile in enumerate(axis.profiles) if "stop" in {each.name for each in profile.phases}
    )
    return axis.starts[index], axis.profiles[index].duration


def test_a_stop_out_of_the_first_flank_of_an_s_curve_takes_that_flank_and_its_own_ramp() -> None:
    """The ramp to 1000 takes 1000/(1000 * 0.6) s, and its flank 0.4 of that.

    So the acceleration rises by 1000 in 2/3 s. After 0.3 s it is 450, and falls to zero in another 0.3 s.
    Meanwhile the speed rises to 135 counts/s, twice the 67.5 at 0.3 s. From 135 the axis stops in 135/(5000 *
    0.6) s. An SV written together with the ST has no effect on that.
    """
    program = "1MN,1SV1000,1SA1000,1DS5000,1PS0.4\n1VM,1GO,WA0.3,1SV100,1ST\n1WS\n"
    begin, duration = stop_of(program)
    assert begin == pytest.approx(0.3, abs=1e-6)
    assert duration == pytest.approx(0.3 + 135.0 / 3000.0, abs=1e-5)


def test_a_stop_that_is_given_another_zero_stays_the_stop_it_is() -> None:
    """A DH directly after ST changes neither the flank nor the rest of the stop."""
    program = "1MN,1SV1000,1SA1000,1DS5000,1PS0.4\n1VM,1GO,WA0.3,1ST,WA0.1,1DH0\n1WS\n"
    begin, duration = stop_of(program)
    assert begin == pytest.approx(0.4, abs=1e-6)
    assert duration == pytest.approx(0.2 + 135.0 / 3000.0, abs=1e-5)


S_RAMPS = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 1000 : DECELJERK(0) = 1000\n"


STEEP = "Dim way(2) As Float = 1, 10\nDim slow(2) As Float = 1, 0\n"
STEEP += "SPLINETABLE(0, way, slow, NULL) : SPLINETIME(0) = 20\nSPLINE(0) = 0 : GO(0)\nWAIT = 2\n"


@pytest.mark.parametrize("stop", ["", "STOP(0)\n", "STOP(0)\nPOS(0) = 5\n"])
def test_a_jog_takes_over_from_a_spline_at_no_more_than_the_rate_of_the_axis(stop: str) -> None:
    """The cubic of 10 in 20 ms from rest to rest has a high acceleration at 2 ms.

    It is 6 * 10/0.02² * (1 - 2 * 0.1) = 120 000. A jerk of 1000 would reduce that to zero in two minutes, on
    the way to a velocity of 7 million. So the jog begins with the 100 of ACCEL, which falls to zero in 0.1 s
    and adds 5 to the velocity. A spline that has just been stopped has the same acceleration, and so has one
    with another zero.
    """
    result = proved(f"{RATES}{S_RAMPS}{STEEP}{stop}JOG(0) = 0\nPAUSE IDLE(0)\n")
    jog = next(each for each in result.controller.axes[0].profiles if each.shape == "jog")
    assert jog.acceleration(0.0) == pytest.approx(100.0)
    assert jog.peak_speed == pytest.approx(jog.start_velocity + 100.0**2 / (2.0 * 1000.0))


def test_a_jog_goes_on_where_the_end_of_a_stop_reverses() -> None:
    """Near its end the stop has velocity 1 left, at an acceleration of sqrt(2 * 1000).

    Its jerk is 1000. At a jerk of 500 the acceleration takes twice the time to fall to zero. That leads to a
    velocity of 1 the other way, from where the jog continues.
    """
    stop = "DECELJERK(0) = 1000\nJOG(0) = -20\nWAIT = 600\nJOG(0) = 0\nWAIT = 255\nDECELJERK(0) = 500\nJOG(0) = 20\n"
    result = proved(f"{RATES}{S_RAMPS}{stop}WAIT = 900\nCANCEL(0)\n")
    jog = next(each for each in result.controller.axes[0].profiles[2:] if each.end_velocity == 20.0)
    entry, eased = jog.at(0.0), jog.phases[0].duration
    assert eased == pytest.approx(entry.acceleration / 500.0)
    assert jog.velocity(eased) == pytest.approx(entry.velocity + entry.acceleration**2 / 1000.0)
    assert jog.velocity(eased) > 0.0


CONTOUR = "MOVEBUFFERSIZE(0, 1) = 9; : CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 180\n"


def test_a_stop_may_be_that_of_the_entry_before_one_that_begins_at_that_moment() -> None:
    """FOLLOW 0 ends the following at rest, and the next move begins at the same time.

    It takes 23/20 + 20/100 s.
    """
    program = "FOLLOW(1) = 3\nMOVEA(1) = -23\nGO(1)\nFOLLOW(1) = 0\nPAUSE IDLE(1)\n"
    result = proved(f"{RATES}{program}")
    assert [each.ended for each in result.controller.log.moves] == ["stop", ""]
    assert result.time == pytest.approx(23.0 / 20.0 + 0.2, abs=1e-6)


def test_a_fault_may_be_that_of_the_entry_after_one_that_ends_at_that_moment() -> None:
    """The second segment of the shear exceeds the limit of 0 from its beginning.

    There the master is at 3, after 0.2 + 1/20 s.
    """
    shear = "MASTERDISTANCE(1) = 3 : FLY(1) = 0\nFLY(1) = 10 : GO(1)\n"
    drive = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\nMOVER(0) = 30 : GO(0)\n"
    limit = "SOFTLIMITFORWARD(1) = 0 : SOFTLIMITREVERSE(1) = -5\nPAUSE IDLE(0)\nEnd\n"
    result = proved(f"{RATES}{drive}{shear}{limit}Event ONERROR\n  ERRORCLEAR(_egALL, 0)\nEnd Event\n")
    _, first, second = result.controller.log.moves
    assert (first.ended, second.ended) == ("", "fault")
    assert second.start_time == pytest.approx(0.25, abs=1e-6)


def test_a_ramp_whose_acceleration_peaks_in_its_middle_begins_without_one() -> None:
    """SRAMP 100: the acceleration rises to 586.683 in 8/586.683 s and falls as long.

    So both ramps together take 4 of these times. Rounding once put the peak a last digit after the middle,
    which gave a constant acceleration of half of it.
    """
    ramps = "SPEED(0) = 8 : ACCEL(0) = 586.683 : DECEL(0) = 586.683 : SRAMP(0) = 100\n"
    result = proved(f"{ramps}MOVEA(0) = -12 : GO(0)\nPAUSE IDLE(0)\n")
    flank = 8.0 / 586.683
    assert result.time == pytest.approx(12.0 / 8.0 + 2.0 * flank, abs=1e-6)
    move = result.controller.log.moves[0].profile
    assert move is not None
    for share in (0.0, 0.25, 0.5, 1.0):
        assert move.acceleration(share * flank) == pytest.approx(-586.683 * share, abs=1e-6)


def test_a_flank_that_leads_to_the_speed_is_followed_by_no_ramp() -> None:
    """The parabola to 100 takes 20 ms from 10 000; after 1 ms 9500 of that are left.

    The flank from there ends at 100 within rounding. A sinusoidal ramp over the rounding once had the
    complete 10 000.
    """
    result = proved("1MN,1SV100,1SA10000,1DS5000,1PP\n1VM,1GO,WA0.001,1PS0,1GO,WA1,1TV\n1AB\n", "mcl")
    assert result.output == ["01 100"]
    jog = result.controller.axes[1].profiles[-2]
    assert jog.shape == "jog"
    assert jog.peak_acceleration == pytest.approx(9500.0, abs=1e-2)


def test_a_jog_may_be_faster_in_reverse_before_its_acceleration_is_taken_back() -> None:
    """45 ms before its end, a stop at a jerk of 1000 has a velocity of 1.0125 left.

    It decelerates at 45. At a jerk of 100 that falls to zero in 0.45 s and reduces the velocity by 10.125. So
    the axis runs at 9.1125 the other way, for a jog at 1.
    """
    stop = "DECELJERK(0) = 1000\nJOG(0) = 20\nWAIT = 600\nJOG(0) = 0\nWAIT = 255\nDECELJERK(0) = 100\nJOG(0) = 1\n"
    result = proved(f"{RATES}{S_RAMPS}{stop}WAIT = 1900\nPRINT VELDEMAND(0)\nCANCEL(0)\n")
    jog = next(each for each in result.controller.axes[0].profiles if each.end_velocity == 1.0)
    assert jog.velocity(0.45) == pytest.approx(-9.1125, abs=1e-4)
    assert result.output == ["1.0000"]


def test_an_offset_that_waits_for_the_end_of_a_suspension_has_not_ended() -> None:
    """The offset speeds up for 100 ms and stops in 100 ms, after a distance of 1.

    At the end of the run it is still suspended.
    """
    tie = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0 : FOLLOW(1) = 1\n"
    result = proved(
        f"{RATES}{tie}OFFSET(1) = 29 : GO(1)\nWAIT = 100\nSUSPEND(1) = 1\nWAIT = 500\n", until=0.7
    )
    offset = next(each for each in result.controller.log.moves if each.overlaid).profile
    assert offset is not None
    assert offset.duration > 100.0
    assert [offset.position(time) for time in (0.1, 0.2, 0.6)] == pytest.approx([0.5, 1.0, 1.0])


def test_a_hard_stop_of_a_path_keeps_the_limits_of_its_axes_unless_it_is_a_fault() -> None:
    """MAXDECEL 200 for 4/5 of the path allows 250, so the stop from 20 takes 20/250 s.

    A fault stops at ERRORDECEL, over 20²/2000.
    """
    path = "ERRORDECEL(0) = 1000 : MAXDECEL(1) = 200 : STOPMODE(0) = 1\nVECTORR(0, 1) = 30, 40 : GO(0)\n"
    stopped = proved(f"{RATES}{path}WAIT = 1000\nSTOP(0)\nPAUSE IDLE(0)\n")
    assert stopped.time == pytest.approx(1.0 + 20.0 / 250.0, abs=1e-6)
    limit = "SOFTLIMITMODE(1) = 3 : SOFTLIMITREVERSE(1) = -9 : SOFTLIMITFORWARD(1) = 16\n"
    ended = "PAUSE IDLE(0)\nEnd\nEvent ONERROR\n  ERRORCLEAR(_egALL, 0)\nEnd Event\n"
    at_fault = proved(f"{RATES}{limit}{path}{ended}")
    assert positions(at_fault, 0, 1) == pytest.approx([0.6 * 20.2, 0.8 * 20.2])


def test_a_stop_that_takes_less_than_the_clock_can_tell_has_ended_at_once() -> None:
    """After 10 µs of a jerk the master has covered 1e-13 of the 4 of the shear.

    Its slave stops from a speed of 4e-20 in 4e-25 s.
    """
    master = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 434\nMASTERDISTANCE(1) = 4 : FLY(1) = 8\n"
    result = proved(f"{master}JOG(0) = 40\nGO(1)\nJOG(1) = 0\nWAIT = 100\nCANCEL(0)\n", statement=1e-5)
    stop = result.controller.log.moves[-1].profile
    assert stop is not None
    assert 0.0 < stop.duration < 1e-20


def test_a_jog_may_take_over_a_last_digit_before_a_move_ends() -> None:
    """MR leads to -5e-8 counts in 10 µs; MP reverses in another 10 and is at 0 in 20.

    GO takes over at that moment. The rest of the move that is left for the jog is the rounding of the clock.
    """
    program = "WA0.1\n1MN\n1SA1000,1DS1000\nWA0.1\nNO\n1LP1,1MR-1,1MP1\n1VM,1DI1,1GO,WA1\n1AB\n"
    _, back, jog, *_ = proved(program, "mcl", statement=1e-5).controller.log.moves
    assert back.ended == "retarget"
    assert jog.start_time == pytest.approx(back.start_time + 3e-5, abs=1e-12)


def test_a_path_of_no_length_is_under_way_for_as_long_as_it_is_suspended() -> None:
    """ABORT ends the path after 50 ms; its entries once had no duration in the report."""
    result = proved("SUSPEND(0) = 1\nVECTORR(0, 1) = 0, 0 : GO(0)\nWAIT = 50\nABORT\n")
    for entry in result.controller.log.moves:
        assert entry.ended == "fault"
        assert entry.profile is not None
        assert entry.profile.duration == pytest.approx(0.05, abs=1e-6)


def test_a_slave_that_a_move_follows_at_the_end_of_its_master_is_replaced() -> None:
    """Following has no end of its own: it ends with the other task's MA.

    The MA takes over when the master comes to rest, after 1 + 1 s.
    """
    rates = "1MN,2MN,1SV1000,1SA1000,1DS1000,2SV1000,2SA1000,2DS1000\n"
    result = proved(f"MD1,WA0.2,2MA-4\n{rates}1MR1000,GT1,2MR100,WA0.25,2SS-1,2SM1\n", "mcl")
    _, _, slave, _ = result.controller.log.moves
    assert (slave.command, slave.ended) == ("SM", "retarget")
    assert slave.profile is not None
    assert slave.start_time + slave.profile.duration == pytest.approx(2.0, abs=1e-6)
    assert positions(result, 1, 2) == pytest.approx([1000.0, -4.0])


def test_an_offset_goes_on_from_the_velocity_at_which_a_suspension_ends() -> None:
    """The offset speeds up to 10 in 100 ms, and slows down to 5 in 50 ms.

    That covers 0.5 and 0.375 of its 29. It continues from 5 at once: it takes 0.15 s and 1.875 up to 20, then
    20 over the remaining distance, and 0.2 s and 2 to rest.
    """
    tie = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0 : FOLLOW(1) = 1\n"
    pause = "OFFSET(1) = 29 : GO(1)\nWAIT = 100\nSUSPEND(1) = 1\nWAIT = 50\nSUSPEND(1) = 0\nWAIT = 2000\n"
    result = proved(f"{RATES}{tie}{pause}CANCEL(1)\n")
    assert positions(result, 1) == pytest.approx([29.0])
    offset = next(each for each in result.controller.log.moves if each.overlaid).profile
    assert offset is not None
    assert offset.end == pytest.approx(29.0)
    assert offset.duration == pytest.approx(0.15 + 0.15 + (29.0 - 0.875 - 3.875) / 20.0 + 0.2, abs=1e-6)


HANDLER = "End\nEvent ONERROR\nERRORCLEAR(_egALL, 0)\nEnd Event\n"
BUFFERS = "MOVEBUFFERSIZE(0, 1) = 9; :\n"


def test_a_move_that_is_refused_as_a_path_ends_calls_onerror() -> None:
    """The path takes hypot(30, 40)/20 + 0.2 s.

    Axis 0 stays there. Axis 1 moves on by 8, in 8/20 + 20/100 s.
    """
    entries = "VECTORR(0, 1) = 30, 40 : MOVER(0) = 1 : MOVER(1) = 8 : GO(0, 1)\nWAIT = 100\nACCEL(0) = 0\n"
    result = proved(f"{RATES}{BUFFERS}{entries}PAUSE IDLE(0) And IDLE(1)\n{HANDLER}")
    assert positions(result, 0, 1) == [30.0, 48.0]
    assert result.time == pytest.approx(2.7 + 0.6)
    assert [each.kind for each in result.controller.log.events] == ["handler"] * 2


def test_an_error_ends_the_run_before_what_waits_behind_a_refused_move() -> None:
    """Nothing moves, and the proof takes the run as ended before the second move."""
    program = "ACCEL(0) = 0\nMOVER(0) = 1 : MOVER(0) = 2\nGO(0)\n"
    result = run(Source("found.mnt", program), machine={})
    assert [each.code for each in result.diagnostics] == ["zero-acceleration"]
    assert [each.message for each in prove(result).violations] == []


@pytest.mark.parametrize("distances", [(1.0,), (0.95, 0.05)])
def test_a_path_without_room_for_a_lower_speed_slows_down_to_a_higher_one(
    distances: tuple[float, ...],
) -> None:
    """At a jerk of 400, a ramp from speed 20 to 16 takes 0.2 s over a distance of 3.6.

    A ramp from 16 to rest takes 0.4 s over 3.2, and one from 20 to rest needs 4.4721. After 2.4 s the speed
    is 20 with 6.8 left. SPEED 15 would need 3.913 and 2.905, so the path slows down to 16. One path, or two
    that are joined, takes 3 s.
    """
    length = 20.0 * 2.4 - 20.0 * sqrt(20.0 / 400.0) + 6.8
    smooth = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
    paths = "".join(f"VECTORR(0, 1) = {distance * length!r}, 0\n" for distance in distances)
    program = f"{RATES}{CONTOUR}{smooth}{paths}GO(0)\nWAIT = 2400\nSPEED(0) = 15\nPAUSE IDLE(0)\n"
    result = proved(program)
    assert positions(result, 0) == pytest.approx([length])
    assert result.time == pytest.approx(3.0, abs=1e-5)
    assert result.controller.axes[0].at(2.6).velocity == pytest.approx(16.0, abs=1e-4)


def test_a_move_that_is_given_another_zero_before_its_end_takes_the_rest_of_its_time() -> None:
    """1000 at 20 with a jerk of 400 takes 1000/20 + 2 * sqrt(20/400) s.

    So after 50.447 s there are 0.2 ms and 6e-10 left. That distance is rounded like the 1000. If it were
    planned as a new motion, the rounding would change its time by 2 ns.
    """
    smooth = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 400 : DECELJERK(0) = 400\n"
    move = "MOVER(0) = 1000 : GO(0)\nWAIT = 50447\nPOS(0) = 0\nPAUSE IDLE(0)\n"
    result = proved(f"{RATES}{smooth}{move}", until=100.0)
    assert result.time == pytest.approx(50.0 + 2.0 * sqrt(20.0 / 400.0), abs=1e-6)
    assert positions(result, 0) == pytest.approx([0.0], abs=1e-6)


def test_a_jog_out_of_the_last_flank_of_a_move_begins_at_rest() -> None:
    """The flank brings the axis to rest within rounding, without a further ramp.

    The jog then accelerates for 1951/(10000 * 0.55) s.
    """
    settings = "1MN,2MN,3MN\n1SV1951,1SA10000,1DS5267\n1PS0.45\n"
    source = Source("found.mcl", f"MD1,2PP,1MA-5\n{settings}MC1\n2ST,2WS0.05\n1VM,1DI0,1GO\n")
    result = run(source, machine={"controller.instruction_time": 1e-3}, until=2.0)
    assert [each.message for each in prove(result).violations] == []
    profile = result.controller.log.moves[-1].profile
    assert profile is not None
    assert [each.name for each in profile.phases] == ["decel", "accel", "slew"]
    assert profile.phases[1].duration == pytest.approx(1951.0 / 5500.0)


MOTOR = {
    "axis.{}.plant.amplifier_gain": 6.0,
    "axis.{}.plant.inertia": 3e-5,
    "axis.{}.plant.torque_constant": 0.06,
}


def with_motor(program: str, suffix: str, axis: int) -> Run:
    """Return a run whose `axis` has a motor driven by its own output."""
    machine = {name.format(axis): value for name, value in MOTOR.items()}
    result = run(Source(f"found.{suffix}", program), machine=machine, until=1.0)
    assert [each.message for each in prove(result).violations] == []
    return result


def test_contour_mode_ends_torque_mode() -> None:
    """The centre is 100 before the motor: the axis moves 200 back, and returns."""
    result = with_motor("1MN,2MN,1SQ1,1QM,WA0.1,1CM1,2CM1,1CP3,1CR-100,2CR0\n1WS,2WS\n", "mcl", 1)
    first, second = result.controller.log.moves
    assert first.profile is not None
    assert second.profile is not None
    assert first.profile.start > 1.0
    assert first.profile.extrema() == pytest.approx((first.profile.start - 200.0, first.profile.start))
    assert second.profile.extrema() == pytest.approx((-100.0, 100.0))


@pytest.mark.parametrize("tie", ["FLY(2) = 20 : GO(2)", "CAM(2) = 0 : GO(2)", "FOLLOW(2) = 0.125"])
def test_a_slave_stays_where_the_demand_of_its_master_is_taken_to_the_motor(tie: str) -> None:
    """With its master at 10 of 40, a ratio that rises linearly has led to 10² / 80.

    A cam of one segment or a gear of 1/8 has led as far.
    """
    table = "Dim rise(2) As Float = 1, 5\nCAMTABLE(2, rise, NULL) : MASTERDISTANCE(2) = 40 : MASTERCHANNEL(2) = 0\n"
    drive = (
        "MOVER(0) = 10 : GO(0)\nPAUSE IDLE(0)\nDRIVEENABLE(0) = 0\nDRIVEENABLE(0) = 1\nPRINT POSDEMAND(0)\n"
    )
    result = with_motor(f"{table}{tie}\n{drive}", "mnt", 0)
    assert abs(float(result.output[0]) - 10.0) > 0.1
    assert positions(result, 2) == pytest.approx([1.25])


@pytest.mark.parametrize(("deadband", "position"), [("9", 0.0), ("0.001", 20.0)])
def test_gains_are_suggested_for_a_loop_with_a_deadband(deadband: str, position: float) -> None:
    """An error of 20 counts needs less than 9 V.

    With a deadband of 9 V that counts as none, and the motor does not move; a deadband of 1 mV leaves it near
    its target.
    """
    result = with_motor(f"1MN\n1OB{deadband},1MR20,1WS0.2\n1TP\n", "mcl", 1)
    assert result.diagnostics == []
    assert float(result.output[0].split()[-1]) == pytest.approx(position, abs=3.0)


def test_a_stop_that_is_planned_again_many_times_keeps_its_time() -> None:
    """A jerk of 10⁶ brings the move to v in 2 * sqrt(v / 10⁶) s; it brakes at 31.

    The distance is v/2 times the total time. Each of the 190 plans begins at the rounded position of the plan
    before.
    """
    program = (
        "TIMEREVENT = 20\nDECEL(0) = 31\nPROFILEMODE(0) = 1 : MOVEA(0) = 57\nGO(0)\nPAUSE IDLE(0)\n"
        "Event TIMER\n  MAXSPEED(0) = 38 : MAXSPEED(0) = 53\nEnd Event\n"
    )
    result = proved(program, statement=1e-5)
    speed = result.controller.log.moves[0].profile.peak_speed  # type: ignore[union-attr]
    time = 2.0 * sqrt(speed / 1e6) + speed / 31.0 + 31.0 / 1e6
    assert 0.5 * speed * time == pytest.approx(57.0)
    assert result.time == pytest.approx(time, abs=2e-4)


def test_a_path_loaded_with_its_speed_has_ramps_of_it() -> None:
    """The path keeps its own speed when SPEED becomes 0.001, and the jerk of that speed."""
    proved(
        "MOVER(0) = 18.852\nSRAMP(0) = 100 : FEEDRATEMODE(0) = 3\nCIRCLEA(0, 1) = -1.008, 3.712, -153 : GO(0)\n"
        "SPEED(0) = 0.001\n"
    )


def limit_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let an entry of the log have 50 pieces instead of 500, so that a test needs fewer of them."""
    for module in ("motionlang.kernel.controller.queue.track", "tests.proof.entries"):
        monkeypatch.setattr(f"{module}.MAX_PIECES", 50)


@pytest.mark.parametrize(
    ("path", "changes", "length", "ends"),
    [
        ("VECTORR(0, 1) = 18, 24", 110, 30.0, (18.0, 24.0)),
        ("CIRCLER(0, 1) = 5, 0, 360", 110, 10.0 * pi, (0.0, 0.0)),
        ("CIRCLEA(0, 1) = 10, 0, 180", 60, 10.0 * pi, (20.0, 0.0)),
    ],
)
def test_a_path_that_is_changed_often(
    path: str, changes: int, length: float, ends: tuple[float, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """After 50 changes, 500 without the patch, the path continues as another entry of the log.

    It keeps its original start. ACCEL has no effect after 0.3 s: at 20 with 100 the path takes length/20 + 20/100 s.
    """
    limit_pieces(monkeypatch)
    change = f"WAIT = 300\nFor k = 1 To {changes}\nACCEL(0) = 100 + k Mod 2\nWAIT = 1\nNext\nPAUSE IDLE(0)\n"
    result = proved(f"{RATES}Dim k As Integer\n{path} : GO(0)\n{change}")
    moves = result.controller.log.moves
    assert [each.ended for each in moves if each.axis == 0] == ["continued"] * (changes // 50) + [""]
    assert positions(result, 0, 1) == pytest.approx(ends)
    last = moves[-1]
    assert last.profile is not None
    assert last.start_time + last.profile.duration == pytest.approx(length / 20.0 + 0.2, abs=1e-6)


def test_a_helix_continues_in_the_log_on_all_its_axes_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Axes 0 and 1 turn back at quarters: their entries are full before axis 2's.

    The length is sqrt((10 pi)² + 8²), at 20 with 100.
    """
    limit_pieces(monkeypatch)
    change = "WAIT = 300\nFor k = 1 To 60\nACCEL(0) = 100 + k Mod 2\nWAIT = 1\nNext\nPAUSE IDLE(0)\n"
    result = proved(f"{RATES}Dim k As Integer\nHELIXR(0, 1, 2) = 5, 0, 360, 8 : GO(0)\n{change}")
    moves = result.controller.log.moves
    starts = [[each.start_time for each in moves if each.axis == axis] for axis in (0, 1, 2)]
    assert len(starts[0]) == 2
    assert starts[1:] == [starts[0]] * 2
    assert positions(result, 0, 1, 2) == pytest.approx([0.0, 0.0, 8.0])
    assert result.time == pytest.approx(sqrt(100.0 * pi * pi + 64.0) / 20.0 + 0.2, abs=1e-6)


def test_a_path_is_slowed_down_just_as_it_continues_in_the_log() -> None:
    """After 498 changes and 798 ms the path is at 13.96 with speed 20.

    One more change begins another entry. That is a SPEED of 10, reached in 0.1 s over 1.5; the last ramp
    takes 0.1 s over 0.5.
    """
    change = "WAIT = 300\nFor k = 1 To 498\nACCEL(0) = 100 + k Mod 2\nWAIT = 1\nNext\nSPEED(0) = 10\n"
    result = proved(f"{RATES}Dim k As Integer\nVECTORR(0, 1) = 30, 40 : GO(0)\n{change}PAUSE IDLE(0)\n")
    first, second = (each for each in result.controller.log.moves if each.axis == 0)
    assert first.ended == "continued"
    assert second.start_time == pytest.approx(0.798, abs=1e-5)
    assert result.time == pytest.approx(0.798 + 0.1 + (50.0 - 13.96 - 2.0) / 10.0 + 0.1, abs=1e-5)


@pytest.mark.parametrize(
    ("ramps", "needed"),
    [("", 0.4), ("PROFILEMODE(0) = 1 : ACCELJERK(0) = 1000 : DECELJERK(0) = 1000\n", 0.45)],
)
def test_a_stop_keeps_its_rate_through_a_corner(ramps: str, needed: float) -> None:
    """Axis 0 has a MAXDECEL of 50; its path is stopped from 20, 3 before a corner.

    The stop takes 20/50 s, and with a jerk of 1000 another 50/1000 s. Behind the corner, axis 1 alone could
    brake harder.
    """
    paths = "MAXDECEL(0) = 50\nVECTORR(0, 1) = 30, 0\nVECTORR(0, 1) = 0, 10\nGO(0)\n"
    result = proved(f"{RATES}{CONTOUR}{ramps}{paths}PAUSE POS(0) > 27\nPRINT TIME\nSTOP(0)\nPAUSE IDLE(0)\n")
    begin = float(result.output[0]) / 1000.0
    assert result.time == pytest.approx(begin + needed, abs=1e-3)
    assert sum(positions(result, 0, 1)) == pytest.approx(27.0 + 10.0 * needed, abs=0.1)


def test_the_peak_of_a_shear_that_ends_as_its_master_steps() -> None:
    """A cam covers 10 in 2, then 15 in 2, so its axis runs at 100, then at 150.

    The shear of 2 in 10 ends at that step with a ratio of 2 * 2/10, at a speed of 40. The next shear begins
    at 60.
    """
    ramps = "SPEED(0) = 20\nPROFILEMODE(0) = 1 : MASTERCHANNEL(2) = 1\nACCEL(0) = 1000\n"
    shear = "MASTERDISTANCE(2) = 10 : FLY(2) = 2\nFLY(2) = 29\nGO(2)\n"
    cam = "CAMTABLE(1, rise, NULL) : MASTERDISTANCE(1) = 2\nCAM(1) = 2\nMOVEA(0) = 31\nGO(0, 1)\n"
    table = "Dim rise(5) As Float = 4, 10, 25, 20, 0\n"
    result = proved(table + ramps + shear + cam, statement=1e-3, until=1.0)
    first = result.controller.log.moves[0].profile
    assert first is not None
    assert first.peak_speed == pytest.approx(40.0)


def test_a_trapezoid_that_stops_as_planned_is_left_for_an_s_curve_at_once() -> None:
    """ST with PS0 does not change a trapezoid, as no stop is shorter.

    ST comes after 0.1 s up, 0.05 s at 1000 and 1 s down at 500. 0.5 s later the speed is 250. A half sine has
    no flank along which the 500 could fall, so the change to 100 begins at once. It takes pi/2 * 150/500 s,
    at 175 on average.
    """
    move = "1MN,1SV1000,1SA10000,1DS500,1MR1100,WA1.15,1PS0,1ST,WA0.5,1SV100\n"
    result = proved(f"{move}1VM,1GO,WA1,1TP\n1AB\n", "mcl")
    change = 0.5 * pi * 150.0 / 500.0
    distance = 50.0 + 50.0 + 1.5 * 625.0 + change * 175.0 + (1.0 - change) * 100.0
    assert result.output == ["01 1173"]
    assert result.controller.axes[1].position(2.65) == pytest.approx(distance, abs=1e-4)


def test_a_suspended_slave_comes_to_rest_whatever_its_master_does() -> None:
    """At 9.995 its master has slowed down from 20 to 1 at 100, on the way to -20.

    At a jerk of 1000 the slave's 100 fall to zero in 0.1 s, at a speed of -4 and 0.1 - 0.5 + 1/6 farther on.
    Then the -4 fall to zero in twice sqrt(4/1000) s. Beyond its reversal the slave exceeds ACCEL; a STOP of
    its master does not change that.
    """
    ramps = "PROFILEMODE(1) = 1 : ACCELJERK(1) = 1000 : DECELJERK(1) = 1000 : ACCEL(1) = 50\n"
    follow = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0\nFOLLOW(1) = 1 : JOG(0) = 20\nWAIT = 500\n"
    suspend = "JOG(0) = -20\nWAIT = 190\nSUSPEND(1) = 1\nWAIT = 20\nSTOP(0)\nWAIT = 300\n"
    result = proved(RATES + ramps + follow + suspend)
    rest = 9.995 + 0.1 - 0.5 + 1.0 / 6.0 - 4.0 * sqrt(0.004)
    assert positions(result, 1) == pytest.approx([rest], abs=1e-6)


def test_a_slave_that_a_limit_stops_as_its_master_reverses_never_had_the_new_speed() -> None:
    """On a path of 24 by 18 at 20, axis 0 runs at 16, and at -20 behind the corner.

    Its slave is outside its limits, so it may not run back. It stops at once, 50 * 0.8 * 0.023² short of 24.
    """
    follow = "MASTERSOURCE(2) = _msPOS : MASTERCHANNEL(2) = 0 : CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 180\n"
    path = "VECTORR(0, 1) = 24, 18\nVECTORR(0, 1) = -10, 0\nGO(0)\nWAIT = 23\nFOLLOW(2) = 1\n"
    limits = "SOFTLIMITFORWARD(2) = 1000 : SOFTLIMITREVERSE(2) = 500\nPAUSE IDLE(0)\nEnd\nEvent ONERROR\nEnd Event\n"
    result = proved(RATES + follow + path + limits)
    slave = next(each for each in result.report["moves"] if each["axis"] == 2)
    assert (slave["ended"], slave["peak_speed"]) == ("fault", 16.0)
    assert slave["distance"] == pytest.approx(24.0 - 40.0 * 0.023**2, abs=1e-5)


def test_a_path_resumed_in_its_last_flank_keeps_it_if_the_jerk_was_lowered() -> None:
    """S-ramps at 1000 reach 10 in 0.2 s, peaking at 100: 50 takes 0.2 + 48/10 + 0.2 s.

    At 5.15 s the speed is 1.25 and the acceleration -50. A jerk of 200 would
    take -50 to zero only beyond rest, since that lowers the speed by 50²/400 = 6.25.
    """
    ramps = "SPEED(0) = 10 : PROFILEMODE(0) = 1 : ACCELJERK(0) = 1000 : DECELJERK(0) = 1000\n"
    path = "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 5150\n"
    change = "DECELJERK(0) = 200\nSUSPEND(0) = 1\nWAIT = 10\nSUSPEND(0) = 0\nPAUSE IDLE(0)\n"
    result = proved(RATES + ramps + path + change)
    first = result.controller.log.moves[0]
    assert first.profile is not None
    assert first.start_time + first.profile.duration == pytest.approx(5.2, abs=1e-6)
    assert positions(result, 0, 1) == pytest.approx([30.0, 40.0])


def test_a_shear_that_an_input_holds_runs_through_its_segments() -> None:
    """The master is at 38 at 2 s, and at 41 when it begins to slow down from 20 to 10.

    The slave's ratio rises to 1 in the first 20 of the master, and returns to 0 in the last 20 of 60. From
    2.15 s on the master covers 1.5 in 0.1 s and 8 in 0.8 s. The input is closed from 0.5 to 2 s; the second
    segment begins meanwhile.
    """
    fly = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0 : SUSPENDINPUT(1) = 2 : MOVEBUFFERSIZE(1) = 9\n"
    fly += "MASTERDISTANCE(1) = 20 : FLY(1) = 10 : FLY(1) = 20 : FLY(1) = 10 : GO(1)\n"
    jog = "JOG(0) = 20\nWAIT = 2150\nJOG(0) = 10\nWAIT = 900\nEnd\nEvent ONERROR\nERRORCLEAR(_egALL, 1)\nEnd Event\n"
    result = proved(RATES + fly + jog, until=3.05, inputs=[{"channel": 2, "at": 0.5, "for": 1.5}])
    slave = result.controller.axes[1]
    assert [slave.position(time) for time in (1.1, 2.0)] == pytest.approx([10.0, 28.0], abs=1e-6)
    into = 38.0 + 3.0 + 1.5 + 8.0 - 40.0
    assert positions(result, 1) == pytest.approx([30.0 + into - into * into / 40.0], abs=1e-6)


def test_a_stop_keeps_a_ramp_whose_move_would_run_back_for_less_than_a_count() -> None:
    """The axis has slowed down for 20 µs, from 0.015 counts/s.

    It stops within 0.005 / 500 s as planned. A parabola would take twice as long.
    """
    result = proved(
        "1MN\n1SA500,1DS500\n1VM,1GO\nTA1\n1PM,1MR0,1PP\n1ST\n1WS\n", suffix="mcl", statement=1e-5
    )
    last = result.moves[-1]
    assert last.duration == pytest.approx(20e-6 + 0.005 / 500.0, abs=1e-12)


def test_a_move_keeps_rates_with_whose_jerk_it_would_run_back() -> None:
    """From 20 to 5 at 100 takes 0.15 s and 1.875; it begins at 8, after 0.5 s.

    50 ms later the velocity is 15. A jerk of 100 would reduce its deceleration to zero in 1 s, at a velocity of -35. So
    ACCEL has no effect. Of 210 there are 200 left at 5, and 0.125 for the stop in 0.05 s.
    """
    jerks = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 1000 : DECELJERK(0) = 100 : ACCEL(0) = 50\n"
    lower = "WAIT = 500\nSPEED(0) = 5\nWAIT = 50\n"
    result = proved(RATES + "MOVER(0) = 210 : GO(0)\n" + lower + jerks + "PAUSE IDLE(0)\n", until=60.0)
    assert positions(result, 0) == pytest.approx([210.0])
    assert result.time == pytest.approx(0.5 + 0.15 + (210.0 - 8.0 - 1.875 - 0.125) / 5.0 + 0.05)


def test_a_path_may_end_within_a_ramp_of_an_s_curve() -> None:
    """While a line of 50 is executed, one of 50 and one of 10 000 are buffered.

    They have one direction. A sinusoidal ramp to V at a rate of 1000 takes pi/2 V/1000, in which it covers half of V
    times that. The first line ends at rest, the others are one of 10 050. Two ramps cover d at a V of sqrt(2000 d/pi),
    and take pi V/1000. The first 50 of these take longer than the line of 50, because a ramp to a lower speed begins
    less gently.
    """
    short, long = "1CP1,1MR30,2MR40", "1CP1,1MR6000,2MR8000"
    settings = "1MN,2MN,1PS0\n1CM1,2CM1,1VA1000,1VD1000"
    result = proved(f"{settings},{short},{short},{long}\n1WS\n", suffix="mcl", statement=1e-9)
    alone, together = (pi * sqrt(2000.0 * length / pi) / 1000.0 for length in (50.0, 10050.0))
    assert positions(result, 1, 2) == pytest.approx([6060.0, 8080.0])
    durations = [move.duration for move in result.moves if move.axis == 1]
    assert durations[0] == pytest.approx(alone)
    assert durations[1] + durations[2] == pytest.approx(together)
    assert durations[1] > 1.2 * alone
