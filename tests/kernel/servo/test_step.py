"""The step of loop and motor by hand: commands, feed-forward, integral, plants, and rest.

The trajectory has 100 points a second and the servo 400 samples, so a cycle of 0.01 s has 4 samples.
"""

from __future__ import annotations

from itertools import pairwise
from math import exp
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Source
from motionlang.kernel.planners import from_curve, hold, plan, plan_trapezoid
from motionlang.kernel.servo import Loop, Motor, Servo, Track, VelocityDrive, simulate
from tests.cases import examples
from tests.kernel.servo.test_oracle import LOOPS, PLANTS, WHOLE

RATES: dict[str, Any] = {"servo_rate": 400.0, "trajectory_rate": 100.0}
# The positions at the beginning of each cycle: the axis moves by 0, 4, 8, 8, -8 and -8 counts.
POINTS = [0.0, 0.0, 4.0, 12.0, 20.0, 12.0, 4.0]
# A quarter of a cycle later is a quarter of the way.
DEMAND = [
    *(0.0, 0.0, 0.0, 0.0),
    *(0.0, 1.0, 2.0, 3.0),
    *(4.0, 6.0, 8.0, 10.0),
    *(12.0, 14.0, 16.0, 18.0),
    *(20.0, 18.0, 16.0, 14.0),
    *(12.0, 10.0, 8.0, 6.0),
]
# Volts by the velocity, in 0.01 V a count/s; and by its change, in 0.0001 V a count/s². 4 counts a cycle are 400
# counts/s, and their change in a cycle is 40 000 counts/s².
BY_VELOCITY = [0.0, 4.0, 8.0, 8.0, -8.0, -8.0]
BY_ACCELERATION = [0.0, 4.0, 4.0, 0.0, -16.0, 0.0]
ALL = LOOPS | WHOLE


def along(points: list[float]) -> Track:
    """Return a track on the lines between points of a trajectory, and at rest behind them."""
    pieces = tuple(
        (here, 100.0 * (there - here), 0.0, 0.0, 0.0, 0.0, 0.0) for here, there in pairwise(points)
    )
    knots = tuple(0.01 * k for k in range(len(points)))
    names = tuple(("segment", k) for k in range(len(pieces)))
    curve = from_curve("pvt", points[0], points[-1], (knots, pieces, names), 0.0, 0.0)
    return Track([0.0], [curve])


def varied() -> Track:
    """Return a track of cubics, a half sine wave, rests, a profile cut short, and a new zero."""
    far = plan_trapezoid(0.0, 4000.0, 12_000.0, 90_000.0, 140_000.0)
    back = plan(
        "scurve", far.position(0.2003), 4500.0, 14_000.0, 90_000.0, 120_000.0, far.velocity(0.2003), 0.3
    )
    wave = plan("sinusoidal", 4500.0, 2500.0, 9_000.0, 80_000.0, 80_000.0).shifted(-4400.0)
    return Track(
        [0.0, 0.05, 0.2503, 0.2503 + back.duration, 0.9, 1.1, 1.1 + wave.duration],
        [hold(0.0), far, back, hold(4500.0), hold(100.0), wave, hold(-1900.0)],
    )


# -------------------------------------------------------------------------------------------- the command


def test_the_command_of_a_sample_is_on_the_line_between_two_points() -> None:
    trace = simulate(along(POINTS), Loop(**RATES), VelocityDrive(), until=23 / 400.0)
    assert trace.commanded.tolist() == pytest.approx(DEMAND)
    slow = simulate(along(POINTS), Loop(servo_rate=100.0, trajectory_rate=100.0), VelocityDrive(), until=0.05)
    assert slow.commanded.tolist() == pytest.approx(POINTS[:6])


@pytest.mark.parametrize(
    ("gains", "volts"),
    [
        ({"velocity_ff": 0.01}, BY_VELOCITY),
        ({"accel_ff": 0.0001, "decel_ff": 0.0001}, BY_ACCELERATION),
        ({"velocity_ff": 0.01, "accel_ff": 0.0001, "decel_ff": 0.0001}, [0.0, 8.0, 12.0, 8.0, -24.0, -8.0]),
        # From 8 to -8 counts a cycle the speed is the same, so the axis does not slow down.
        ({"accel_ff": 0.0001, "decel_ff": 0.0005}, BY_ACCELERATION),
        ({}, [0.0] * 6),
    ],
)
def test_feed_forward_of_each_cycle(gains: dict[str, Any], volts: list[float]) -> None:
    trace = simulate(
        along(POINTS), Loop(**gains, output_limit=99.0, **RATES), VelocityDrive(), until=23 / 400.0
    )
    assert trace.output.tolist() == pytest.approx(np.repeat(volts, 4).tolist(), abs=1e-9)


def test_an_axis_that_slows_down_has_the_gain_of_deceleration() -> None:
    """The axis moves by 1, 3, 2, -1, -4 and -2 counts a cycle.

    A change of 1 is 10 000 counts/s².
    From 3 to 2, from 2 to -1 and from -4 to -2 the speed falls: 2, 3 and 2 times the gain of 0.0005.
    """
    loop = Loop(velocity_ff=0.01, accel_ff=0.0001, decel_ff=0.0005, output_limit=99.0, **RATES)
    points = [0.0, 1.0, 4.0, 6.0, 5.0, 1.0, -1.0]
    by_velocity = [1.0, 3.0, 2.0, -1.0, -4.0, -2.0]
    by_change = [1.0, 2.0, -5.0, -15.0, -3.0, 10.0]
    trace = simulate(along(points), loop, VelocityDrive(), until=23 / 400.0)
    volts = [a + b for a, b in zip(by_velocity, by_change, strict=True)]
    assert trace.output[::4].tolist() == pytest.approx(volts)


def test_an_integral_is_cleared_when_motion_begins() -> None:
    loop = Loop(integral=1e-3, integral_limit=9.0, integral_mode="zeroed", **RATES)
    trace = simulate(along([0.0, 4.0, 4.0, 4.0, 5.0, 6.0, 6.0]), loop, VelocityDrive(1e-9), until=27 / 400.0)
    by_cycle = trace.integral.reshape(-1, 4)
    assert by_cycle[:, -1].tolist() == pytest.approx([0.0, 0.016, 0.032, 0.0, 0.0, 0.024, 0.048])


# ------------------------------------------------------------------------------------------------ the plant


def test_a_drive_without_a_loop_comes_to_its_speed_as_an_exponential() -> None:
    """2 V at 5000 counts/s per volt, with a lag T of 20 ms: v = 10 000 (1 - e^(-t/T)).

    The position p is the integral of v.
    """
    made = Servo(Loop(servo_rate=1000.0), VelocityDrive(5000.0, 0.02), Track([0.0], [hold(0.0)]))
    made.open(2.0)
    trace = made.run(300)
    for k in (0, 1, 17, 100, 299):
        t = k / 1000.0
        lag = 0.02 * (1.0 - exp(-t / 0.02))
        assert trace.velocity[k] == pytest.approx(10_000.0 * lag / 0.02, abs=1e-8)
        assert trace.encoder[k] == pytest.approx(10_000.0 * (t - lag), abs=1e-8)
    assert set(trace.output) == {2.0}


def test_a_loop_of_gain_alone_follows_a_ramp_at_a_distance() -> None:
    """A drive of 5000 counts/s per volt needs 1 V for 5000 counts/s.

    The gain is 0.01 V per count, so the following error is 100 counts.
    """
    ramp = plan_trapezoid(0.0, 1e6, 5000.0, 1e6, 1e6)
    trace = simulate(Track([0.0], [ramp]), Loop(0.01), VelocityDrive(5000.0, 2e-3), until=2.0)
    assert trace.error[-1] == pytest.approx(100.0, abs=1e-9)
    assert trace.velocity[-1] == pytest.approx(5000.0, abs=1e-7)


def test_a_constant_torque_is_a_parabola() -> None:
    """0.1 A at 0.05 N m/A accelerate 2e-5 kg m² at 250 rad/s²: 125 rad in one second.

    A radian has 4000/2π counts.
    """
    motor = Motor(amplifier="current", amplifier_gain=0.1, viscous=0.0, load_inertia=0.0)
    made = Servo(Loop(servo_rate=1000.0), motor, Track([0.0], [hold(0.0)]))
    made.open(1.0)
    trace = made.run(1001)
    assert trace.encoder[1000] == pytest.approx(125.0 * motor.counts_per_radian, rel=1e-12)
    assert trace.current[1000] == pytest.approx(0.1)


# ----------------------------------------------------------------------------------------------- guarantees


@given(
    blocks=st.lists(st.integers(1, 700), min_size=1, max_size=6),
    name=st.sampled_from(sorted(ALL)),
    plant=st.sampled_from(sorted(PLANTS)),
)
@settings(max_examples=examples(40))
def test_a_run_is_the_same_to_the_last_bit_however_it_is_divided(
    blocks: list[int], name: str, plant: str
) -> None:
    divided, whole = (Servo(ALL[name], PLANTS[plant], varied()) for _ in range(2))
    columns = np.concatenate([divided.run(count).columns for count in blocks], axis=1)
    assert columns.tolist() == whole.run(sum(blocks)).columns.tolist()
    assert (divided.state, divided.sample, divided.error) == (whole.state, whole.sample, whole.error)


def test_a_copy_of_a_servo_continues_by_itself() -> None:
    made = Servo(LOOPS["feed-forward"], PLANTS["everything"], varied())
    made.run(301)
    before, state = made.copy(), made.state
    ahead = made.run(500)
    assert (before.state, before.sample) == (state, 301)
    assert before.run(500).columns.tolist() == ahead.columns.tolist()


@pytest.mark.parametrize("derivative", [40.0, 400.0, 1e300])
@pytest.mark.filterwarnings("error")
def test_the_output_of_a_loop_that_runs_away_has_an_end(derivative: float) -> None:
    """Nothing overflows, because the output is limited."""
    loop = Loop(0.04, 2e-5, derivative)
    trace = simulate(varied(), loop, Motor(), until=2.0)
    assert np.isfinite(trace.columns).all()
    assert trace.peak_output == loop.output_limit


def test_gains_that_are_set_during_motion_cause_no_kick() -> None:
    """A gain that was 0 until now takes its differences from the sample before."""
    for later in (Loop(0.01, velocity_feedback=0.1), Loop(0.01, derivative=0.1)):
        made = Servo(Loop(0.01), VelocityDrive(), Track([0.0], [hold(0.0)]))
        made.open(1.0)
        made.run(4000)
        made.close()
        made.run(4000)
        made.retune(later)
        assert np.abs(made.run(10).output).max() < 0.01


def test_figures_may_be_numbers_of_numpy() -> None:
    """They come out of tables and of `np.linspace`."""
    move = plan_trapezoid(0.0, 400.0, 20_000.0, 200_000.0, 200_000.0)
    track = Track([0.0, move.duration], [move, hold(400.0)])
    number: Any = np.float64
    bits: Any = np.int64(12)
    plain = simulate(track, Loop(0.04, dac_bits=12), Motor(coulomb=0.003), until=0.1)
    other = simulate(track, Loop(number(0.04), dac_bits=bits), Motor(coulomb=number(0.003)), until=0.1)
    assert plain.measured.tolist() == other.measured.tolist()
    plain, other = (
        simulate(track, Loop(0.4), VelocityDrive(kind(5e3)), until=0.1) for kind in (float, number)
    )
    assert plain.measured.tolist() == other.measured.tolist()


def test_a_program_that_is_stuck_ends_when_its_motor_has_come_to_rest() -> None:
    """Two blocks of 500 ms after the first 256 ms show that the motor stays.

    The second one is computed at the end of the first one, which begins 256 ms after the stop at 50 ms.
    """
    program = "ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 1000 : GO(0)\nWAIT(50)\nSTOP(0)\nPAUSE IN(3)\n"
    motor = {"kind": "brushless", "torque_constant": 0.06, "inertia": 3e-5, "amplifier_gain": 6.0}
    machine = {f"axis.0.plant.{name}": value for name, value in motor.items()}
    result = run(Source("stuck.mnt", program), machine=machine)
    assert [each.code for each in result.diagnostics] == ["never"]
    assert result.time == pytest.approx(0.806, abs=1e-3)


@pytest.mark.parametrize(
    "plant", [{}, {"load_torque": 0.01}, {"resonance": 80.0}, {"coulomb": 0.003, "quantised": True}]
)
def test_an_hour_at_rest_costs_nothing(plant: dict[str, object], monkeypatch: pytest.MonkeyPatch) -> None:
    """The samples of the rest are neither run nor reported, however the motor is held."""
    ran: list[int] = []
    run_samples = Servo._run

    def counted(made: Servo, count: int) -> object:
        ran.append(count)
        return run_samples(made, count)

    monkeypatch.setattr(Servo, "_run", counted)
    machine = {f"axis.0.plant.{name}": value for name, value in {"load_inertia": 4e-5, **plant}.items()}
    text = "MOVER(0) = 2030 : GO(0) : PAUSE IDLE(0)\nWAIT(3600000)\nMOVER(0) = 20 : GO(0) : PAUSE IDLE(0)\n"
    result = run(Source("rest.mnt", text), machine=machine)
    assert len(result.report["moves"]) == 2
    assert sum(ran) < 100_000


def test_a_dac_ends_one_step_below_full_scale() -> None:
    """A DAC of 12 bits has 2047 steps of 10/2048 V above zero, and 2048 below."""
    for volts, steps in ((10.0, 2047), (-10.0, -2048), (0.004, 1), (0.002, 0)):
        made = Servo(Loop(dac_bits=12), VelocityDrive(), Track([0.0], [hold(0.0)]))
        made.open(volts)
        assert set(made.run(5).output) == {steps * 10.0 / 2048.0}


def test_a_loop_that_is_closed_within_a_cycle_follows_from_the_next_one_on() -> None:
    """A cycle has 4 samples; the command moves by 2 counts in each."""
    jog = plan_trapezoid(0.0, 1e6, 2000.0, 1e9, 1e9)
    made = Servo(Loop(0.01), VelocityDrive(), Track([0.0], [jog]))
    made.open(1.0)
    made.run(202)
    here = made.position
    made.close()
    assert (made.run(11).commanded - here).tolist() == pytest.approx(
        [0.0, 0.0, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0]
    )
