"""Every engine gives the results of the plain step loop."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from motionlang.kernel.planners import hold, plan, plan_trapezoid
from motionlang.kernel.servo import Loop, Motor, Override, Track, VelocityDrive, simulate
from tests.kernel.servo.plain import Array, run_plain

PID = Loop(0.04, 2e-5, 0.9, integral_limit=5.0)
# Both moves of `there_and_back` and 0.07 s at rest.
LONG = 1.3

LOOPS = {
    "pid": PID,
    "tight output limit": Loop(0.08, 1e-5, 1.8, integral_limit=0.5, output_limit=0.4),
    "sum limit reached": Loop(0.02, 2e-4, 0.4, integral_limit=0.05),
    "term limit reached": Loop(0.02, 2e-4, 0.4, integral_limit=0.05, limit_style="term"),
    "slow derivative": Loop(0.03, 2e-5, 0.5, derivative_every=3),
    "velocity feedback": Loop(0.04, 2e-5, 0.0, velocity_feedback=0.9),
    "feed-forward": Loop(0.02, 0.0, 0.4, velocity_ff=2e-5, accel_ff=3e-7, decel_ff=2e-7),
    "integral at steady speed": Loop(0.02, 2e-4, 0.4, integral_limit=0.2, integral_mode="steady"),
    "integral at rest": Loop(0.02, 2e-4, 0.4, integral_mode="stopped"),
    "integral cleared": Loop(0.02, 2e-4, 0.4, integral_mode="zeroed", integral_limit=0.4),
    "offset and reversal": Loop(-0.04, 0.0, -0.9, output_offset=0.1, reversed=True),
    "deadband": Loop(0.04, 0.0, 0.9, output_deadband=0.05),
    "Mint rates": Loop(0.04, 1e-4, 0.3, servo_rate=1000.0),
    "12-bit output": Loop(0.0411, 0.0, 0.9, dac_bits=12),
}
PLANTS: dict[str, Motor | VelocityDrive] = {
    "motor": Motor(),
    "no inductance": Motor(inductance=0.0),
    "current amplifier": Motor(amplifier="current", amplifier_gain=0.3, viscous=1e-4),
    "gravity": Motor(load_torque=0.01),
    "resonance": Motor(load_inertia=2e-5, resonance=120.0),
    "load encoder": Motor(load_inertia=2e-6, resonance=300.0, resonance_damping=0.2, encoder="load"),
    "friction": Motor(coulomb=0.004, breakaway=0.006),
    "encoder": Motor(quantised=True),
    "backlash": Motor(load_inertia=2e-5, resonance=120.0, backlash=4.0),
    "everything": Motor(
        coulomb=0.003, load_inertia=1e-5, resonance=150.0, backlash=2.0, quantised=True, load_torque=0.002
    ),
    "drive": VelocityDrive(5_000.0, 2e-3),
    "drive with encoder": VelocityDrive(5_000.0, 2e-3, quantised=True),
}
# Of the motor at 10 V, counts/s.
FULL_SPEED = 10.0 * 2.4 / (0.05 + 1e-5 / 0.05) * 4000.0 / (2.0 * pi)
CHAPTER12 = Loop(100, 4, 600, integral_limit=2000, arithmetic="chapter12", dac_bits=12, servo_rate=1000.0)
WHOLE = {
    "chapter 12": CHAPTER12,
    "chapter 12, reversed": replace(
        CHAPTER12, proportional=-100, integral=-4, derivative=-600, reversed=True
    ),
    "chapter 12, 16 bits": Loop(40, 4, 400, integral_limit=4000, arithmetic="chapter12", dac_bits=16),
    "chapter 12, override": Loop(
        100,
        4,
        1200,
        integral_limit=2000,
        arithmetic="chapter12",
        dac_bits=12,
        override=Override(40, 3, FULL_SPEED),
    ),
    "LM628": Loop(300, 30, 2000, integral_limit=500, arithmetic="lm628", dac_bits=12, derivative_every=2),
    "LM628, 8 bits, wrapping": Loop(900, 30, 9000, arithmetic="lm628", dac_bits=8, wrap=True),
    "real with override": Loop(0.04, 0.0, 0.9, dac_bits=14, override=Override(200, 4, FULL_SPEED)),
}


def there_and_back() -> Track:
    out, back = (
        plan("sinusoidal", 0.0, 4000.0, 15_000.0, 150_000.0, 150_000.0),
        plan_trapezoid(4000.0, -1000.0, 12_000.0, 90_000.0, 140_000.0),
    )
    return Track(
        [0.05, 0.05 + out.duration, 0.7, 0.7 + back.duration], [out, hold(4000.0), back, hold(-1000.0)]
    )


def points_of(loop: Loop, track: Track, seconds: float) -> Array:
    # Like in the generator a profile takes effect in the first cycle that begins after it.
    rate = loop.trajectory_rate
    made = []
    for i in range(round(seconds * rate) + 2):
        begun = (i - 1) / rate
        k = max(j for j in range(len(track.starts)) if j == 0 or track.starts[j] <= begun - 1e-12)
        made.append(track.profiles[k].position(i / rate - track.starts[k]))
    return np.array(made)


def assert_plain(loop: Loop, plant: Motor | VelocityDrive, tolerance: float = 1e-9) -> None:
    """Compare every column of a long move in the package with the plain loop."""
    track = there_and_back()
    trace = simulate(track, loop, plant, until=LONG)
    points = points_of(loop, track, LONG)
    time = np.arange(len(trace)) / loop.servo_rate
    assert (
        np.abs(trace.demand - np.interp(time, np.arange(len(points)) / loop.trajectory_rate, points)).max()
        < 1e-8
    )
    plain = run_plain(loop, plant, points, trace.demand)
    for name, column in plain.items():
        if name == "twist":
            continue
        worst = float(np.abs(trace[name] - column).max()) / max(1.0, float(np.abs(column).max()))
        assert worst < tolerance, f"{name} differs by {worst:g}"


@pytest.mark.parametrize("name", LOOPS)
@pytest.mark.parametrize("plant", ["motor", "friction", "drive"])
def test_every_loop_is_the_plain_loop(name: str, plant: str) -> None:
    assert_plain(LOOPS[name], PLANTS[plant])


@pytest.mark.parametrize("plant", PLANTS)
def test_every_plant_is_the_plain_plant(plant: str) -> None:
    assert_plain(PID, PLANTS[plant])


@pytest.mark.parametrize("name", WHOLE)
@pytest.mark.parametrize("plant", ["motor", "encoder", "friction"])
def test_the_whole_number_forms_are_whole(name: str, plant: str) -> None:
    assert_plain(WHOLE[name], PLANTS[plant])
