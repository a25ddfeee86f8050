"""The search for gains ends even if there are none."""

from __future__ import annotations

from math import pi

import pytest

from motionlang.servo import tuning
from motionlang.servo.axis_loop import axis_loop
from motionlang.servo.loop import Loop
from motionlang.servo.plant import Drive, Motor
from motionlang.servo.response import bandwidth
from motionlang.servo.tuning import BeyondPlant, suggest


@pytest.mark.parametrize(("amplifier", "resistance"), [("voltage", 2.0), ("current", 1.0)])
def test_feed_forward_is_the_output_that_the_motion_needs(amplifier: str, resistance: float) -> None:
    """A volt gives gain / R amperes in a voltage amplifier and gain in a current one.

    Each ampere gives 0.05 N m, on 2e-5 kg m².
    """
    motor = Motor(amplifier=amplifier, resistance=2.0, inductance=0.0, coulomb=0.01)
    loop = suggest(motor, 20.0).loop
    per_volt = 2.4 / resistance * 0.05 / 2e-5 * 4000.0 / (2.0 * pi)  # counts/s²
    assert loop.accel_ff == loop.decel_ff == pytest.approx(1.0 / per_volt)
    assert loop.velocity_ff == pytest.approx(1.0 / motor.speed_per_volt)


@pytest.mark.parametrize("inductance", [10.0, 1e6, 1e12])
def test_a_plant_that_no_gains_close_is_given_up_after_few_searches(
    inductance: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bandwidth takes a hundred times as long as a check of stability."""
    calls: list[float] = []

    def counted(loop: Loop, plant: Motor | Drive) -> float:
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
