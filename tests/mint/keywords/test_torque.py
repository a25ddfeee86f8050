"""Torque references on a pure inertia: the speed is the integral of the torque.

The motor has a current amplifier.
"""

from __future__ import annotations

from math import pi

import pytest

from motionlang import run
from motionlang.fast.closed_form import closed_form
from motionlang.result import Run
from motionlang.source import Source

MOTOR = {
    "axis.0.plant.amplifier": "current",
    "axis.0.plant.amplifier_gain": 1.0,
    "axis.0.plant.torque_constant": 0.05,
    "axis.0.plant.inertia": 1e-4,
    "axis.0.plant.viscous": 0.0,
}
# Counts per second for each volt second: torque constant, inertia, counts per radian.
PER_IMPULSE = 0.05 / 1e-4 * 4000.0 / (2.0 * pi)


def ran(text: str, **machine: object) -> Run:
    result = run(Source("a.mnt", text), machine={**MOTOR, **machine}, cache=False, until=20.0)
    assert [each.message for each in result.diagnostics] == []
    return result


def numbers(text: str, **machine: object) -> list[float]:
    return [float(line) for line in ran(text, **machine).output]


def test_a_torque_that_rises_makes_no_table_for_each_of_its_values() -> None:
    """The torque rises in loops of 1 ms for half a second; few values need a table."""
    before = closed_form.cache_info().misses
    text = "TORQUEREFRISETIME(0) = 1000\nTORQUEREF(0) = 50 : WAIT = 1000\nPRINT TORQUEDEMAND(0)\nCANCEL(0)"
    assert numbers(text) == [50.0]
    assert closed_form.cache_info().misses - before <= 4


def test_at_once_it_is_the_output() -> None:
    """20 % are 2 V and 2 A: an integral of 0.2 V s in 100 ms."""
    text = "LOOPTIME = 100\nTORQUEREF(0) = 20\nWAIT = 100\nPRINT VEL(0)\n"
    text += "PRINT TORQUEDEMAND(0)\nPRINT CURRENTMEAS(0, 0)\nCANCEL(0)"
    velocity, demand, current = numbers(text)
    assert velocity == pytest.approx(0.2 * PER_IMPULSE, rel=3e-3)
    assert (demand, current) == (20.0, 2.0)


def test_it_rises_in_steps_of_a_servo_loop() -> None:
    """200 steps of 0.1 % in 20 ms give 0.0201 V s, then 100 ms at 20 % give 0.2 V s."""
    ramp = (
        "LOOPTIME = 100 : TORQUEREFRISETIME(0) = 100\nTORQUEREF(0) = 20\nWAIT = 120\nPRINT VEL(0)\nCANCEL(0)"
    )
    (velocity,) = numbers(ramp)
    assert velocity == pytest.approx(0.2201 * PER_IMPULSE, rel=3e-3)


def test_it_falls_in_its_own_time_and_through_0() -> None:
    """From 10 % to 0 in 50 ms, on to -10 % in 10 ms; then -0.1 V s in 100 ms."""
    ramps = "LOOPTIME = 100 : TORQUEREFRISETIME(0) = 100 : TORQUEREFFALLTIME(0) = 500\n"
    text = ramps + "TORQUEREF(0) = 10\nWAIT = 200\nPRINT VEL(0)\nTORQUEREF(0) = -10\nWAIT = 160\nPRINT VEL(0)"
    first, last = numbers(text + "\nCANCEL(0)")
    assert last - first == pytest.approx((0.025 - 0.005 - 0.1) * PER_IMPULSE, rel=5e-3)


def test_enabled_or_not() -> None:
    text = "TORQUEREF(0) = 20\nWAIT = 10\nTORQUEREFENABLE(0) = 0\nWAIT = 2\nPRINT TORQUEDEMAND(0)\n"
    assert numbers(text + "TORQUEREFENABLE(0) = 1\nWAIT = 2\nPRINT TORQUEDEMAND(0)\nCANCEL(0)") == [0.0, 20.0]


def test_an_analogue_input_is_the_reference() -> None:
    analogue = [{"channel": 2, "at": 0.1, "value": -30.0}]
    text = "TORQUEREFSOURCE(0) = 3\nWAIT = 200\nPRINT TORQUEDEMAND(0)\nPRINT EFFORT(0)\nCANCEL(0)"
    assert numbers(text, analogue=analogue) == [-30.0, 30.0]


def test_a_move_ends_it_and_it_stays_ended() -> None:
    text = (
        "KPROP(0) = 1 : KDERIV(0) = 20\nTORQUEREFRISETIME(0) = 1000\nTORQUEREF(0) = 5\nWAIT = 20\nSTOP(0)\n"
    )
    assert abs(numbers(text + "WAIT = 1000\nPRINT VEL(0)")[0]) < 1.0


@pytest.mark.parametrize("word", ["TORQUEREF", "TORQUE"])
def test_repeated_writes_are_reported_once(word: str) -> None:
    loop = f"For i = 1 To 10\n{word}(0) = 20\nWAIT = 10\nNext\nPRINT VEL(0)\nCANCEL(0)"
    feedback = ran(loop).controller.axes[0].feedback
    assert feedback is not None
    assert [what for _, what in feedback.changes if what == 2.0] == [2.0]


@pytest.mark.parametrize("wait", ["PAUSE EFFORT(0) > 5", "While EFFORT(0) <= 5\nEnd While"])
def test_a_program_waits_for_the_effort_of_a_motor_under_control(wait: str) -> None:
    """The acceleration at the start needs more than 5 % within the first ticks."""
    text = "KPROP(0) = 20 : KDERIV(0) = 200\nSPEED(0) = 20000 : ACCEL(0) = 200000\nJOG(0) = 20000\nTIME = 0\n"
    (time,) = numbers(text + f"{wait}\nPRINT TIME\nCANCEL(0)")
    assert 0 < time < 50  # without an event the wait would last until the end of a block, half a second


def test_without_a_motor_it_is_reported_and_values_are_0() -> None:
    result = run(Source("a.mnt", "TORQUEREF(0) = 20"), cache=False)
    assert [each.code for each in result.diagnostics] == ["not-simulated"]
    text = "PRINT TORQUEDEMAND(0), EFFORT(0), CURRENTDEMAND(0, 0)"
    assert run(Source("a.mnt", text), cache=False).output == ["0.00000.00000.0000"]


def test_other_currents_are_refused() -> None:
    result = run(Source("a.mnt", "PRINT CURRENTMEAS(0, 1)"), cache=False)
    assert [each.message for each in result.diagnostics] == ["CURRENTMEAS: there is no current 1"]
