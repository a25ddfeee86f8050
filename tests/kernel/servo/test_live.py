"""Runs with motors in the machine file, which readings, waits and faults follow."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import motionlang
from motionlang.kernel import Run, Source
from motionlang.kernel.servo import simulate
from motionlang.kernel.tracks import servo_trace

MOTOR: dict[str, object] = {"load_inertia": 4e-5, "viscous": 2e-5}
ROUGH: dict[str, object] = {**MOTOR, "coulomb": 0.003, "quantised": True}
RATE = 1000.0  # LOOPTIME is 1000 microseconds
GAINS: dict[str, object] = {"proportional": 0.02, "integral": 2e-5, "derivative": 0.5}


def run(text: str, plant: dict[str, object], dialect: str = "mint", **sections: Any) -> Run:
    """Return the run of a program on a machine whose first axis has a motor.

    `servo` is the machine file's section of this name; `sections` are other settings.
    """
    axis = 0 if dialect == "mint" else 1
    servo = sections.pop("servo", {})
    assert isinstance(servo, dict)
    machine = {f"axis.{axis}.plant.{name}": value for name, value in plant.items()}
    machine |= {f"axis.{axis}.servo.{name}": value for name, value in servo.items()}
    machine |= {name.replace("__", "."): value for name, value in sections.items()}
    return motionlang.run(Source("x", text), dialect=dialect, machine=machine)


def printed(
    text: str, plant: dict[str, object], dialect: str = "mint", **sections: object
) -> list[list[float]]:
    result = run(text, plant, dialect, **sections)
    assert result.diagnostics == [], result.diagnostics[0].message
    return [[float(word) for word in line.replace(",", " ").split()] for line in result.output]


# --------------------------------------------------------------------------------- equality with a later
# simulation


# ------------------------------------------------------------------------------------------------- readings

MOVE = "SCALE(0) = 100 : SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 20 : GO(0)\n"


def test_position_lags_behind_the_demand() -> None:
    ((pos, demand, error, vel),) = printed(
        MOVE + 'WAIT = 100 : PRINT POS(0), " ", POSDEMAND(0), " ", FOLERROR(0), " ", VEL(0)',
        MOTOR,
        servo={"proportional": 0.02, "derivative": 0.5},
    )
    assert demand == pytest.approx(5.0, abs=0.01)
    assert demand - pos == pytest.approx(error, abs=0.11)  # the loop gets the command a cycle later
    assert 0.05 < error < 1.0
    assert 50.0 < vel < 101.0


def test_mccl_reports_both() -> None:
    position, optimal, error, _ = (
        reply[1]
        for reply in printed(
            "1SG0.02,1SD0.5,1MN,1SV10000,1SA100000,1DS100000,1MR2000,WA0.1,1TP,1TO,1TF,1TV", ROUGH, "mccl"
        )
    )
    assert 0.0 < error == pytest.approx(optimal - position, abs=11.0)


def test_new_zero_renames_the_motor_s_position() -> None:
    before, after, later = printed(
        MOVE
        + "PAUSE IDLE(0) : WAIT = 200 : PRINT POS(0) : POS(0) = 3 : PRINT POS(0) : WAIT = 50 : PRINT POS(0)",
        {**ROUGH, "load_torque": 0.01},
        servo={"proportional": 0.02, "derivative": 0.5},
    )
    assert before[0] < 20.0  # gravity opposes it
    assert after == later == [3.0]


# ------------------------------------------------------------------------------------------------ waits


def test_a_wait_for_a_position_ends_at_the_sample_of_the_motor() -> None:
    result = run("PRINT 1\n" + MOVE + "PAUSE POS(0) > 10\nPRINT POS(0)", MOTOR, servo=GAINS)
    trace = servo_trace(result.controller.axes[0], result.time)
    assert trace is not None
    first = int(np.flatnonzero(trace.measured > 1000.0)[0])
    assert result.output[1] == f"{trace.measured[first] / 100.0:.4f}"


def test_idle_waits_for_the_windows() -> None:
    window = "SCALE(0) = 100 : IDLEMODE(0) = {} : IDLEPOS(0) = 0.002 : IDLETIME(0) = 5\n"
    text = window + MOVE + "PAUSE IDLE(0) : PRINT TIME"
    soft: dict[str, object] = {"proportional": 0.008, "derivative": 0.15}
    ideal, settled = (printed(text.format(mode), MOTOR, servo=soft)[0][0] for mode in (0, 1))
    assert settled > ideal + 5.0


def test_idle_comes_at_the_sample_at_which_the_window_was_met() -> None:
    text = f"SCALE(0) = 100 : IDLEMODE(0) = 1 : IDLEPOS(0) = 0.002 : IDLETIME(0) = 5\n{MOVE}PAUSE IDLE(0)\nPRINT TIME"
    result = run(text, MOTOR, servo={"proportional": 0.008, "derivative": 0.15})
    trace = servo_trace(result.controller.axes[0], result.time + 0.2)
    assert trace is not None
    last = int(np.flatnonzero(np.abs(trace.error) > 0.2)[-1])
    assert result.output == [f"{int((last + 1) / trace.loop.servo_rate * 1000.0 + 5.0)}"]


def test_wait_for_target_of_mccl() -> None:
    text = "1SG0.008,1SD0.15,1MN,1DB2,1DT0.01,1SV10000,1SA100000,1DS100000,1MR2000,1WS0,1TF,1WT0,1TF,1TS"
    stopped, settled, status = printed(text, MOTOR, "mccl")
    assert abs(stopped[1]) > 2.0 >= abs(settled[1])
    assert int(status[1]) >> 2 & 1


def test_a_wait_that_the_motor_can_never_end_is_found() -> None:
    result = run(MOVE + "PAUSE POS(0) > 30\nPRINT 1", ROUGH, servo=GAINS)
    assert [each.code for each in result.diagnostics] == ["never"]
    assert result.time < 60.0


# ------------------------------------------------------------------------------------------------ faults

STALLED = {**MOTOR, "coulomb": 5.0}


def test_a_motor_whose_oscillation_decays_is_at_standstill_after_two_blocks() -> None:
    """The blocks of 64, 192 and 500 samples end at 0.756 s; the next one reaches no further."""
    slow: dict[str, object] = {"proportional": 0.001, "integral": 5e-5, "derivative": 0.2}
    result = run("MOVER(0) = 10 : GO(0)\nPAUSE POS(0) > 100", {**MOTOR, "load_inertia": 1e-4}, servo=slow)
    assert [each.code for each in result.diagnostics] == ["never"]
    assert result.time == pytest.approx(0.756, abs=1e-3)


def test_a_stalled_motor_faults_at_the_very_sample() -> None:
    """The trip is at the first sample beyond the limit of a later simulation."""
    result = run(
        "FOLERRORFATAL(0) = 3\n" + MOVE + "WAIT = 1000\nPRINT AXISERROR(0), DRIVEENABLE(0)",
        STALLED,
        servo=GAINS,
    )
    assert result.output == ["640"]
    a = result.controller.axes[0]
    move: Any = result.report["moves"][0]
    trip = move["start_time"] + move["duration"]
    assert a.feedback is not None
    assert a.feedback.chosen is not None
    error = simulate(a, a.feedback.chosen.loop, a.feedback.plant, until=1.0).error
    assert np.flatnonzero(np.abs(error) > 3.0)[0] / RATE == pytest.approx(trip, abs=1e-9)


def test_the_handler_of_errors_is_called() -> None:
    text = (
        "FOLERRORFATAL(0) = 3\nFOLERRORMODE(0) = _emCALL_EVENT\n" + MOVE + "PAUSE IDLE(0)\nEnd\n"
        'Event ONERROR\n  PRINT "tripped ", AXISERROR(0)\n  AXISERROR(0) = 0\n  CANCEL(0)\nEnd Event\n'
    )
    assert run(text, STALLED, servo=GAINS).output[:1] == ["tripped 64"]


def test_mccl_trips_at_its_own_limit_and_takes_no_motion_until_mn() -> None:
    text = "1SG0.02,1SE300,1MN,1MR2000,WA1,1TF,1TS\n1MR1\n1MN,1TS,1TF"
    result = run(text, STALLED, "mccl")
    error, tripped, ready = (int(result.output[k].split()[1]) for k in (0, 1, -2))
    assert 300 <= error < 320
    assert tripped >> 11 & 1
    assert not tripped >> 1 & 1  # the motor is off
    assert not ready >> 11 & 1


def test_no_limit_no_trip() -> None:
    assert run("1SG0.02,1SE0,1MN,1MR2000,WA1,1TS", STALLED, "mccl").output[0] == "01 4106"


def test_a_hard_limit_is_where_the_motor_is() -> None:
    """The switch opens when the motor reaches it, which is later than the command."""
    machine: dict[str, Any] = {"axis__0__travel": [-1000.0, 1000.0]}
    ideal = motionlang.run(
        Source("x", "JOG(0) = 5000 : PAUSE IDLE(0)"),
        dialect="mint",
        machine={"axis.0.travel": [-1000.0, 1000.0]},
    )
    real = run(
        "JOG(0) = 5000 : PAUSE IDLE(0)", MOTOR, servo={"proportional": 0.02, "derivative": 0.5}, **machine
    )
    ends = [each.report["moves"][0]["duration"] for each in (ideal, real)]
    assert ends[1] > ends[0] + 0.001
    assert real.controller.faults(0) == 4


# ----------------------------------------------------------------------------------------- samples ahead


# ------------------------------------------------------------------------------------------------ torque, off and on


def test_torque_turns_the_motor_until_it_is_cancelled() -> None:
    report = 'PRINT VEL(0), " ", TORQUE(0)'
    text = f"TORQUE(0) = 10 : WAIT = 200 : {report}\nCANCEL(0) : WAIT = 300 : {report}"
    turning, held = printed(text, ROUGH, servo=GAINS)
    assert turning[0] > 5000.0
    assert turning[1] == 10.0
    assert held == [0.0, 0.0]


def test_torque_needs_a_motor() -> None:
    result = motionlang.run(Source("x", "TORQUE(0) = 10"), dialect="mint")
    assert result.diagnostics[0].code == "not-simulated"
    assert "[axis.0.plant]" in result.diagnostics[0].hint


def test_torque_mode_of_mccl_takes_sq_for_the_output() -> None:
    text = "1SG0.02,1SD0.5,1MN,1SE0,1QM,1SQ1,WA0.2,1TV,1DI1,WA0.2,1TV,1PM,1WT0.2,1TV"
    forward, back, held = (reply[1] for reply in printed(text, ROUGH, "mccl"))
    assert forward > 5000.0
    assert back < -5000.0
    assert held == 0.0


def test_the_torque_limit_is_in_the_user_units_of_torque() -> None:
    """UK is volts per unit from the next MN on: half a unit of 2 V is 1 V."""
    speeds = {}
    for units, limit in (("", 1), ("1UK2,", 0.5)):
        reply = printed(f"{units}1SG0.02,1SD0.5,1MN,1SE0,1QM,1SQ{limit},1TQ,WA0.2,1TV", ROUGH, "mccl")
        assert reply[0][1] == limit
        speeds[limit] = reply[1][1]
    assert speeds[0.5] == speeds[1] > 5000.0
    reply = printed("1SQ3,1TQ,1UK2,1TQ,1MN,1TQ", ROUGH, "mccl")
    assert [values[1] for values in reply] == [3.0, 3.0, 1.5]


def test_a_motor_that_is_switched_off_coasts_and_is_taken_over_where_it_is() -> None:
    text = (
        MOVE
        + 'WAIT = 100 : DRIVEENABLE(0) = 0 : WAIT = 200 : PRINT POS(0), " ", POSDEMAND(0)\n'
        + 'DRIVEENABLE(0) = 1 : PRINT POS(0) - POSDEMAND(0), " ", FOLERROR(0)'
    )
    off, on = printed(text, MOTOR, servo=GAINS)
    assert off[0] > off[1] + 0.5
    assert on[0] == 0.0


# ------------------------------------------------------------------------------------------------ gains


def test_gains_that_nobody_sets_are_suggested_and_the_report_says_so() -> None:
    result = run(MOVE, MOTOR, servo={"bandwidth": 30.0})
    assert result.notes == ["axis 0: its motor has no gains; it ran with those suggested for 30 Hz"]
    motor = result.report["moves"][0]["motor"]
    assert motor["peak_following_error"] < 0.1
    assert motor["rms_torque"] > 0.0


def test_gains_of_zero_move_nothing_and_the_report_says_so() -> None:
    result = run("KPROP(0) = 0\n" + MOVE + "PAUSE IDLE(0) : PRINT POS(0)", MOTOR)
    assert result.output == ["0.0000"]
    assert result.notes == ["axis 0: all gains of its motor are 0, so it does not follow its demand"]


def test_new_gains_act_at_once() -> None:
    text = "JOG(0) = 5000\nWAIT = 300 : PRINT FOLERROR(0)\nKPROP(0) = 8\nWAIT = 300 : PRINT FOLERROR(0)\nCANCEL(0)"
    weak, strong = printed("KPROP(0) = 2 : KDERIV(0) = 20\n" + text, MOTOR)
    assert weak[0] == pytest.approx(4.0 * strong[0], rel=0.01)


def test_keywords_without_a_motor_are_stored_and_named() -> None:
    result = motionlang.run(Source("x", "KPROP(0) = 2\nPRINT KPROP(0)"), dialect="mint")
    assert result.output == ["2.0000"]
    assert "KPROP" in result.notes[0]


def test_the_rate_of_the_loop_cannot_change_in_motion() -> None:
    result = run("LOOPTIME = 500\n" + MOVE + "WAIT = 50\nLOOPTIME = 250", MOTOR)
    assert [each.line for each in result.diagnostics] == [5]


# ------------------------------------------------------------------------------------------------ cost


def test_a_motor_at_rest_costs_nothing() -> None:
    """Hours of rest are a few blocks: a motor at final standstill is not simulated."""
    result = run(MOVE + "PAUSE IDLE(0) : WAIT = 20000000 : PRINT POS(0)", ROUGH, servo=GAINS)
    assert result.time == pytest.approx(20000.3, abs=0.2)


def test_a_motor_that_hunts_for_ever_ends_no_run_and_no_search() -> None:
    """A loop too stiff for its backlash oscillates for ever, but the run ends.

    A wait that never ends is still detected.
    """
    plant = {**MOTOR, "quantised": True, "resonance": 60.0, "backlash": 40.0, "encoder": "load"}
    loose: dict[str, object] = {"proportional": 0.02, "derivative": 0.5, "output_limit": 2.0}
    result = run("MOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nPAUSE POS(0) > 5000", plant, servo=loose)
    assert [each.code for each in result.diagnostics] == ["never"]
    assert result.time < 60.0
    trace = servo_trace(result.controller.axes[0], result.time)
    assert trace is not None
    assert np.ptp(trace.position[-2000:]) > 5.0


def test_blocks_do_not_depend_on_who_reads() -> None:
    """The motor moves alike whether the program reads its position or not."""
    quiet = run(MOVE + "PAUSE IDLE(0)", MOTOR, servo=GAINS)
    busy = run(MOVE + "Dim x As Float\nRepeat\n x = POS(0)\nUntil IDLE(0)", MOTOR, servo=GAINS)
    traces = [servo_trace(each.controller.axes[0], 0.25) for each in (quiet, busy)]
    assert traces[0] is not None
    assert traces[1] is not None
    assert np.abs(traces[0].position - traces[1].position).max() < 1e-6


def test_trace_has_columns_of_the_motor() -> None:
    result = run(MOVE, MOTOR, servo=GAINS)
    samples = result.trace.sample(1000.0)
    demand, actual = samples["axis0_position_uu"], samples["axis0_actual_uu"]
    assert np.abs(demand - actual).max() < 1.0
    assert samples["axis0_output_V"].max() > 0.1
    assert samples["axis0_torque_Nm"].max() > 0.0
    assert np.all(np.isfinite(samples["axis0_following_error_uu"]))
    assert all(b >= a for a, b in pairwise(samples.time))


def test_a_move_that_comes_after_a_long_rest() -> None:
    """The samples of a rest are dropped while the next move reads the position."""
    assert printed("1MN,1MR400,WA2\nWA2.1\n1MR10\n1WS,1TP", {"inertia": 1e-5}, "mccl") == [[1.0, 410.0]]
