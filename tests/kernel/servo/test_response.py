"""Step response, bandwidth, margins and gains against the `control` library."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import cache
from math import pi, radians, sin
from typing import TYPE_CHECKING

import numpy as np
import pytest

from motionlang.kernel.planners import hold, plan
from motionlang.kernel.servo import (
    Loop,
    LoopFigures,
    Motor,
    Track,
    VelocityDrive,
    loop_figures,
    simulate,
    step_figures,
    step_response,
    suggest,
)

if TYPE_CHECKING:
    from typing import Any

PAIRS: dict[str, tuple[Loop, Motor | VelocityDrive]] = {
    "motor": (Loop(0.04, 2e-5, 0.9), Motor()),
    "no integral": (Loop(0.02, 0.0, 0.5), Motor(load_inertia=2e-5)),
    "current": (Loop(0.03, 2e-4, 1.3), Motor(amplifier="current", amplifier_gain=0.5)),
    "drive": (Loop(0.02, 2e-5), VelocityDrive(5000.0, 2e-3)),
    "velocity feedback": (Loop(0.03, 0.0, 0.0, velocity_feedback=0.8), Motor()),
    "resonance": (Loop(0.01, 1e-6, 0.4), Motor(load_inertia=1e-5, resonance=200.0, resonance_damping=0.05)),
}


@cache
def control() -> Any:
    """Return the library, whose import takes a second."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip("control")


def plant_of(plant: Motor | VelocityDrive, period: float) -> Any:
    """Return the textbook model of a plant, discretised by `control`."""
    if isinstance(plant, VelocityDrive):
        a = [[0, 1], [0, -1 / plant.time_constant]]
        b = [[0], [plant.speed_per_volt / plant.time_constant]]
        return control().c2d(control().ss(a, b, [[1, 0]], [[0]]), period, "zoh")
    k, j = plant.counts_per_radian, plant.total_inertia
    if plant.amplifier == "current":
        a = [[0, 1], [0, -plant.viscous / j]]
        b = [[0], [k * plant.torque_constant * plant.amplifier_gain / j]]
        return control().c2d(control().ss(a, b, [[1, 0]], [[0]]), period, "zoh")
    electric = [-plant.torque_constant / k / plant.inductance, -plant.resistance / plant.inductance]
    drive = plant.amplifier_gain / plant.inductance
    if not plant.resonance:
        a = [[0, 1, 0], [0, -plant.viscous / j, k * plant.torque_constant / j], [0, *electric]]
        return control().c2d(control().ss(a, [[0], [0], [drive]], [[1, 0, 0]], [[0]]), period, "zoh")
    jm, jl = plant.inertia, plant.load_inertia
    omega, together = 2 * pi * plant.resonance, jm * jl / (jm + jl)
    s, d = omega**2 * together, 2 * plant.resonance_damping * omega * together
    a = [
        [0, 1, 0, 0, 0],
        [-s / jm, -(plant.viscous + d) / jm, k * plant.torque_constant / jm, s / jm, d / jm],
        [0, *electric, 0, 0],
        [0, 0, 0, 0, 1],
        [s / jl, d / jl, 0, -s / jl, -d / jl],
    ]
    return control().c2d(
        control().ss(a, [[0], [0], [drive], [0], [0]], [[1, 0, 0, 0, 0]], [[0]]), period, "zoh"
    )


def closed_by_control(loop: Loop, plant: Motor | VelocityDrive) -> tuple[Any, Any]:
    """Return the open and the closed loop.

    Velocity feedback is an inner loop of the position's difference.
    """
    h = loop.period
    made = plant_of(plant, h)
    change = control().tf([1, -1], [1, 0], h)
    if loop.velocity_feedback:
        made = control().feedback(made, control().ss(loop.velocity_feedback * change))
    pid = loop.proportional + loop.integral * control().tf([1, 0], [1, -1], h) + loop.derivative * change
    opened = made * control().ss(pid) if not isinstance(pid, float) else made * pid
    return opened, control().feedback(opened, 1)


@pytest.fixture(autouse=True, scope="module")
def _imported() -> None:
    """Import the library before the first test, whose time is limited."""
    control()


@pytest.mark.parametrize("name", PAIRS)
def test_step_response_is_controls(name: str) -> None:
    loop, plant = PAIRS[name]
    _, closed = closed_by_control(loop, plant)
    trace = step_response(loop, plant, 1.0, 1.0)
    _, expected = control().step_response(closed, T=np.arange(len(trace)) * loop.period)
    assert np.abs(trace.position - expected).max() < 1e-8


@pytest.mark.parametrize("name", ["motor", "current", "resonance"])
def test_step_figures_are_controls(name: str) -> None:
    loop, plant = PAIRS[name]
    _, closed = closed_by_control(loop, plant)
    trace = step_response(loop, plant, 1.0, 2.0)
    ours = step_figures(trace, 1.0)
    theirs = control().step_info(closed, T=np.arange(len(trace)) * loop.period)
    assert ours.overshoot * 100.0 == pytest.approx(theirs["Overshoot"], abs=1e-6)
    assert ours.peak_time == pytest.approx(theirs["PeakTime"])
    assert ours.settling == pytest.approx(theirs["SettlingTime"], abs=1.5 * loop.period)
    assert ours.rise == pytest.approx(theirs["RiseTime"], abs=1.5 * loop.period)


@pytest.mark.parametrize("name", PAIRS)
def test_bandwidth_and_margins_are_controls(name: str) -> None:
    loop, plant = PAIRS[name]
    opened, closed = closed_by_control(loop, plant)
    figures = loop_figures(loop, plant)
    at = np.array([figures.bandwidth]) * 2 * pi
    assert abs(control().frequency_response(closed, at).complex[0]) == pytest.approx(
        10 ** (-3 / 20), abs=1e-6
    )
    if loop.velocity_feedback:
        return  # control opens the loop outside the velocity feedback, we at the position, so margins differ
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        gains, _, _, _, _, _ = control().stability_margins(opened, returnall=True)
        _, phase, _, crossover = control().margin(opened)
    assert figures.phase_margin == pytest.approx(float(phase), abs=1e-4)
    assert figures.crossover == pytest.approx(float(crossover) / 2 / pi, rel=1e-6)
    assert figures.gain_margin == pytest.approx(min(gains[gains > 1.0], default=np.inf), rel=1e-5)


@pytest.mark.parametrize("hz", [10.0, 40.0, 120.0])
@pytest.mark.parametrize(
    "plant",
    [
        Motor(),
        Motor(load_inertia=5e-5),
        Motor(amplifier="current", amplifier_gain=0.5, viscous=0.0),
        VelocityDrive(5000.0, 2e-3),
    ],
    ids=["motor", "load", "current", "drive"],
)
@pytest.mark.parametrize("integral", [True, False])
def test_a_suggestion_has_the_requested_bandwidth(
    plant: Motor | VelocityDrive, hz: float, integral: bool
) -> None:
    made = suggest(plant, hz, integral=integral)
    _, closed = closed_by_control(made.loop, plant)
    gain = abs(control().frequency_response(closed, np.array([hz]) * 2 * pi).complex[0])
    assert gain == pytest.approx(10 ** (-3 / 20), abs=1e-4)
    assert np.abs(closed.poles()).max() < 1.0
    assert made.figures.phase_margin > 40.0
    assert bool(made.loop.integral) == integral


def test_feed_forward_takes_the_error_away() -> None:
    made = suggest(Motor(), 40.0)
    profile = plan("sinusoidal", 0.0, 20_000.0, 40_000.0, 100_000.0, 100_000.0)
    track = Track([0.0, profile.duration], [profile, hold(20_000.0)])
    without = replace(made.loop, velocity_ff=0.0, accel_ff=0.0, decel_ff=0.0)
    assert (
        simulate(track, made.loop, Motor(), until=1.5).peak_error
        < 0.05 * simulate(track, without, Motor(), until=1.5).peak_error
    )


def test_too_much_bandwidth_is_refused_with_what_is_possible() -> None:
    with pytest.raises(
        ValueError, match=r"900 Hz is beyond this plant at 4000 servo samples a second: about 2\d\d Hz"
    ):
        suggest(Motor(), 900.0)


def test_nonlinear_loops_have_no_frequency_response() -> None:
    for loop, plant in (
        (Loop(0.04, dac_bits=12), Motor()),
        (Loop(0.04), Motor(coulomb=0.01)),
        (Loop(0.04, 0.0, 0.9, derivative_every=2), Motor()),
    ):
        with pytest.raises(ValueError, match="frequency response"):
            loop_figures(loop, plant)


def test_an_unstable_loop_is_known_as_one() -> None:
    figures = loop_figures(Loop(0.2, 0.0, 5.0), Motor())
    assert isinstance(figures, LoopFigures)
    assert not figures.stable


@pytest.mark.parametrize("degrees", [1.0, 15.0, 30.0, 45.0, 80.0])
def test_the_margin_of_a_loop_that_only_integrates(degrees: float) -> None:
    """The open loop is K/(z - 1).

    K are the counts per sample that a count of error gives.

    On the unit circle at an angle w the gain is K / (2 sin(w/2)) and the phase is -90 degrees - w/2. So K = 2 sin a has
    its crossover at w = 2a, that is at a / 180 degrees of 4000 Hz, and a phase margin of 90 degrees - a.
    """
    loop = Loop(2.0 * sin(radians(degrees)) / 1.25)
    figures = loop_figures(loop, VelocityDrive(5000.0, 1e-9))
    assert figures.crossover == pytest.approx(4000.0 * degrees / 180.0, rel=1e-4)
    assert figures.phase_margin == pytest.approx(90.0 - degrees, abs=0.01)


def test_a_loop_that_hardly_acts_has_no_crossover() -> None:
    """It would be at 5000 * 1e-6 / 2 pi, 0.0008 Hz.

    That is below all frequencies that are searched.
    """
    figures = loop_figures(Loop(1e-6), VelocityDrive(5000.0, 1e-6))
    assert (figures.bandwidth, figures.crossover, figures.phase_margin) == (0.0, 0.0, np.inf)
