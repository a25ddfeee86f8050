"""A servo that follows the controller's clock equals one with a complete track."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.planners import hold, plan_trapezoid
from motionlang.kernel.servo import Loop, Motor, Servo, Track, VelocityDrive, simulate
from tests.cases import examples

PID = Loop(0.04, 2e-5, 0.9, integral_limit=5.0)
OUT = plan_trapezoid(0.0, 3000.0, 20_000.0, 200_000.0, 200_000.0)
BACK = plan_trapezoid(3000.0, 500.0, 20_000.0, 200_000.0, 200_000.0)


def track() -> Track:
    return Track(
        [0.1, 0.1 + OUT.duration, 0.60013, 0.60013 + BACK.duration], [OUT, hold(3000.0), BACK, hold(500.0)]
    )


@pytest.mark.parametrize("plant", [Motor(), Motor(coulomb=0.003, quantised=True)], ids=["linear", "friction"])
def test_any_cut_gives_the_same_readings(plant: Motor) -> None:
    whole = simulate(track(), PID, plant, until=1.0)
    servo = Servo(PID, plant, track())
    for to in (0.0, 0.0001, 0.10003, 0.1007, 0.25, 0.6002, 0.60025, 0.99, 1.0):
        servo.advance(to)
        row = round(servo.time * 4000)
        assert row == int(to * 4000 + 1e-6)
        for name in ("velocity", "error", "integral", "output", "current", "torque"):
            assert getattr(servo, name) == pytest.approx(float(whole[name][row]), rel=1e-9, abs=1e-9), name
        assert servo.position == pytest.approx(float(whole.measured[row]), rel=1e-9, abs=1e-9)
        assert servo.demand == pytest.approx(float(whole.demand[row]), rel=1e-9, abs=1e-9)


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=6))
@settings(max_examples=examples(25))
def test_cuts_do_not_matter(cuts: list[float]) -> None:
    servo = Servo(PID, Motor(), track())
    for to in sorted(cuts):
        servo.advance(to)
    servo.advance(1.0)
    whole = simulate(track(), PID, Motor(), until=1.0)
    assert (servo.position, servo.output) == (whole.position[-1], whole.output[-1])


def test_time_can_be_queried_twice() -> None:
    servo = Servo(PID, Motor(), track())
    servo.advance(0.3)
    before = servo.position
    servo.advance(0.2)
    servo.advance(0.3)
    assert servo.position == before


def test_a_track_that_grows_while_the_servo_follows() -> None:
    growing = Track([0.0], [hold(0.0)])
    servo = Servo(PID, Motor(), growing)
    servo.advance(0.1)
    for start, profile in zip(track().starts, track().profiles, strict=True):
        servo.advance(start)
        growing.starts.append(start)
        growing.profiles.append(profile)
    servo.advance(1.0)
    known = Track([0.0, *track().starts], [hold(0.0), *track().profiles])
    whole = simulate(known, PID, Motor(), until=1.0)
    assert servo.position == pytest.approx(whole.position[-1], abs=1e-6)


def test_a_new_name_for_a_position_moves_nothing() -> None:
    """After POS = 0 at rest, the program's positions jump but the motor does not."""
    renamed = Track([0.0, 0.5], [plan_trapezoid(0.0, 1000.0, 20_000.0, 200_000.0, 200_000.0), hold(0.0)])
    trace = simulate(renamed, PID, Motor(), until=1.0)
    before, after = trace.position[1990], trace.position[2100]
    assert before == pytest.approx(1000.0, abs=1.5)
    assert after == pytest.approx(0.0, abs=1.5)
    assert float(abs(trace.velocity[1900:]).max()) < 50.0
    assert trace.demand[-1] == 0.0
    long = simulate(renamed, PID, Motor(), until=0.4)
    assert long.position[-1] == trace.position[len(long) - 1]


def test_an_open_loop_coasts_and_a_closed_one_holds() -> None:
    servo = Servo(PID, Motor(), track())
    servo.advance(0.2)
    servo.open()
    servo.advance(0.5)
    assert servo.output == 0.0
    assert abs(servo.velocity) < 1.0
    where = servo.position
    standstill = Track([0.0, 0.5], [hold(0.0), hold(where)])
    servo._generator.track = standstill
    servo.close()
    servo.advance(0.8)
    assert servo._open_output is None
    assert servo.position == pytest.approx(where, abs=1e-6)
    assert abs(servo.error) < 1e-6


def test_an_open_loop_is_a_constant_voltage() -> None:
    servo = Servo(PID, VelocityDrive(5000.0, 2e-3), Track([0.0], [hold(0.0)]))
    servo.open(2.0)
    servo.advance(1.0)
    assert servo.velocity == pytest.approx(10_000.0)
    assert servo.output == 2.0


def test_gains_can_change_while_it_runs_but_rates_cannot() -> None:
    servo = Servo(PID, Motor(), track())
    servo.advance(0.2)
    servo.retune(Loop(0.01, 2e-5, 0.9, integral_limit=5.0))
    servo.advance(0.3)
    assert servo.loop.proportional == 0.01
    with pytest.raises(ValueError, match="servo rate cannot change"):
        servo.retune(Loop(0.01, servo_rate=2000.0))


def test_far_from_zero_nothing_is_lost() -> None:
    """A move 1e9 counts away from zero has the same errors, within 1e-6 counts."""
    far = 1e9
    shifted = Track(track().starts, [profile.shifted(far) for profile in track().profiles])
    near, there = simulate(track(), PID, Motor(), until=1.0), simulate(shifted, PID, Motor(), until=1.0)
    assert np.abs(near.output - there.output).max() < 1e-6


def test_a_servo_that_goes_along_needs_no_numpy() -> None:
    """A program that reads POS only occasionally should not wait for numpy's import."""
    code = """
import sys
from motionlang.kernel.servo import Loop, Motor, Servo, Track
from motionlang.kernel.planners import plan_trapezoid
servo = Servo(Loop(0.04, 0.0, 0.9), Motor(coulomb=0.01), Track([0.0], [plan_trapezoid(0, 900, 1e4, 1e5, 1e5)]))
for k in range(1, 10):
    servo.advance(k * 0.02)
assert servo.position > 850.0, servo.position
assert "numpy" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
