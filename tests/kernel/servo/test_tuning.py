"""The search for gains ends even if there are none."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from motionlang.kernel.servo import Loop, LoopFigures, Motor, VelocityDrive, suggest, tuning
from motionlang.kernel.servo.axis_loop import axis_loop
from motionlang.kernel.servo.response import bandwidth
from motionlang.kernel.servo.tuning import BeyondPlant, _least, _shape, _warnings, linearised, suggested_loop


@pytest.mark.parametrize(("amplifier", "resistance"), [("voltage", 2.0), ("current", 1.0)])
def test_feed_forward_is_the_output_that_the_motion_needs(amplifier: str, resistance: float) -> None:
    """A volt gives gain / R amperes in a voltage amplifier and gain in a current one.

    Each ampere gives 0.05 N m, on 2e-5 kg m². The damping is 1e-5 N m s; a voltage amplifier adds that of the back-EMF.
    """
    motor = Motor(amplifier=amplifier, resistance=2.0, inductance=0.0, coulomb=0.01)
    loop = suggest(motor, 20.0).loop
    per_volt = 2.4 / resistance * 0.05 / 2e-5 * 4000.0 / (2.0 * pi)  # counts/s²
    assert loop.accel_ff == loop.decel_ff == pytest.approx(1.0 / per_volt)
    damping = 1e-5 + (0.05**2 / resistance if amplifier == "voltage" else 0.0)
    assert loop.velocity_ff == pytest.approx(damping / 2e-5 / per_volt)


@pytest.mark.parametrize("inductance", [10.0, 1e6, 1e12])
def test_a_plant_that_no_gains_close_is_given_up_after_few_searches(
    inductance: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bandwidth takes a hundred times as long as a check of stability."""
    calls: list[float] = []

    def counted(loop: Loop, plant: Motor | VelocityDrive) -> float:
        calls.append(bandwidth(loop, plant))
        return calls[-1]

    monkeypatch.setattr(tuning, "bandwidth", counted)
    suggest.cache_clear()
    with pytest.raises(BeyondPlant):
        axis_loop({}, {}, Motor(inductance=inductance))
    assert len(calls) <= 16


@pytest.mark.parametrize(
    ("section", "mode", "limit"), [({"integral": 5.0}, "always", 10.0), ({}, "never", 10.0)]
)
def test_an_integral_of_the_machine_file_acts_beside_gains_of_the_program(
    section: dict[str, object], mode: str, limit: float
) -> None:
    """The program sets a gain, with which the language's own integral never acts.

    The machine file requests an integral.
    """
    loop = axis_loop(section, {"proportional": (2.0, "KPROP")}, Motor(inductance=1e-3)).loop
    assert (loop.integral_mode, loop.integral_limit) == (mode, limit)


SWINGING = Motor(load_inertia=2e-5, resonance=60.0)
# The plant, the phase margin, the bandwidth, and the beginnings of the warnings.
WARNINGS: dict[str, tuple[Motor | VelocityDrive, float, float, tuple[str, ...]]] = {
    "a margin just large enough": (Motor(), 30.0, 20.0, ()),
    "a margin too small": (VelocityDrive(), 29.6, 20.0, ("the phase margin is only 30 degrees",)),
    "friction": (Motor(coulomb=0.01), 60.0, 20.0, ("Coulomb friction",)),
    "a resonance three times as high": (SWINGING, 60.0, 20.0, ()),
    "a resonance less than three times as high": (SWINGING, 60.0, 20.1, ("the resonance at 60 Hz",)),
    "play": (replace(SWINGING, backlash=4.0), 60.0, 20.0, ("backlash is not",)),
    "all of these": (
        replace(SWINGING, backlash=4.0, coulomb=0.01), 10.0, 40.0,
        ("the phase margin is only 10", "Coulomb friction", "backlash is not", "the resonance at 60 Hz"),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", WARNINGS)
def test_what_the_linear_figures_leave_out_is_a_warning(name: str) -> None:
    plant, margin, reached, beginnings = WARNINGS[name]
    found = _warnings(plant, LoopFigures(True, reached, reached, margin, 4.0, 1.0))
    assert len(found) == len(beginnings)
    assert all(each.startswith(begin) for each, begin in zip(found, beginnings, strict=True))


# The pole frequency, whether there is an integral, and the gains: derivative, proportional and integral of
# K/tau = 4000 counts/s² per volt, 1/tau = 100/s.
POLES: dict[str, tuple[float, bool, tuple[float, float, float]]] = {
    "three poles: 3w - 100, 3w², w³": (200.0, True, (500.0, 120_000.0, 8e6)),
    "the drive damps just as much": (100.0 / 3.0, True, (0.0, 1e4 / 3.0, 1e6 / 27.0)),
    "the drive damps more: 2w 100, w² 100": (20.0, True, (0.0, 4000.0, 40_000.0)),
    "two poles: 2w - 100, w²": (200.0, False, (300.0, 40_000.0, 0.0)),
    "two poles of a drive that damps more: 50w": (20.0, False, (0.0, 1000.0, 0.0)),
}  # fmt: skip


@pytest.mark.parametrize("name", POLES)
def test_the_gains_put_all_poles_at_one_frequency(name: str) -> None:
    w, integral, (derivative, proportional, sums) = POLES[name]
    base = Loop(servo_rate=2000.0, integral_limit=99.0, output_limit=7.0)
    loop = _shape(VelocityDrive(speed_per_volt=40.0, time_constant=0.01), base, integral)(w)
    assert loop.derivative == pytest.approx(derivative / 4000.0 * 2000.0, abs=1e-9)
    assert loop.proportional == pytest.approx(proportional / 4000.0)
    assert loop.integral == pytest.approx(sums / 4000.0 / 2000.0)
    assert (loop.velocity_ff, loop.accel_ff, loop.decel_ff) == pytest.approx((0.025, 1 / 4000.0, 1 / 4000.0))
    assert (loop.integral_limit, loop.velocity_feedback) == (7.0, 0.0)


def test_gains_are_found_for_the_plant_without_what_is_not_linear() -> None:
    motor = replace(SWINGING, backlash=4.0, coulomb=0.01, breakaway=0.02, load_torque=0.1, quantised=True)
    assert linearised(motor) == SWINGING
    assert linearised(VelocityDrive(quantised=True)) == VelocityDrive()


def test_a_suggested_loop_has_the_bandwidth() -> None:
    """DAC steps, a deadband and integer arithmetic are left out of it."""
    base = Loop(dac_bits=12, output_deadband=0.5, derivative_every=3)
    loop = suggested_loop(Motor(), 20.0, base)
    assert bandwidth(loop, Motor()) == pytest.approx(20.0, rel=1e-9)
    assert (loop.dac_bits, loop.output_deadband, loop.arithmetic, loop.derivative_every) == (
        0,
        0.0,
        "real",
        1,
    )


@pytest.mark.parametrize("target", [0.0, -1.0, float("inf"), float("nan")])
def test_a_bandwidth_must_be_a_positive_number(target: float) -> None:
    with pytest.raises(ValueError, match="the bandwidth must be greater than zero"):
        suggested_loop(Motor(), target, Loop())


@pytest.mark.parametrize("power", [1, 3, 5])
@pytest.mark.parametrize("root", [0.001, 0.3, 0.99])
def test_the_root_of_a_steep_or_a_flat_function_takes_few_values(root: float, power: int) -> None:
    """Bisection needs 40 values for 10⁻¹², a secant that keeps one end thousands."""
    values = []

    def value(x: float) -> float:
        values.append(x)
        return (x**power) - root**power

    assert _least(value, 0.0, 1.0) == pytest.approx(root, rel=1e-11)
    assert len(values) <= 60
