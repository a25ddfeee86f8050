"""Figures of a short trace, and the matrix exponential, by hand."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest

from motionlang.kernel.servo import Loop, Motor, ServoTrace, make_loop


def trace(error: list[float], output: list[float], current: list[float]) -> ServoTrace:
    """Return a trace of a motor held at 0, with a sample every millisecond."""
    still, position = np.zeros(len(error)), -np.array(error)
    columns = np.array([still, position, position, still, current, still, output])
    motor = Motor(torque_constant=0.5, quantised=False)
    return ServoTrace(Loop(servo_rate=1000.0, trajectory_rate=1000.0), motor, [columns], [(0, 0.0)])


def of_errors(*errors: float) -> ServoTrace:
    return trace([*errors], [0.0] * len(errors), [0.0] * len(errors))


def test_the_root_mean_square_of_the_torque() -> None:
    """Of 3, 4, 0, 0 it is sqrt(25 / 4); from 1 ms up to 2 ms it is sqrt(16 / 2)."""
    made = trace([0.0] * 4, [0.0] * 4, [6.0, 8.0, 0.0, 0.0])
    assert made.rms_torque == pytest.approx(2.5)
    assert made.rms_torque_between(0.001, 0.002) == pytest.approx(8.0**0.5)
    assert made.rms_torque_between(0.0, 1.0) == pytest.approx(2.5)
    assert made.rms_torque_between(1.0, 2.0) == 0.0
    assert of_errors().rms_torque == 0.0


def test_peaks_are_those_of_either_sign() -> None:
    made = trace([1.0, -5.0, 2.0], [-9.0, 3.0, 8.0], [0.0] * 3)
    assert (made.peak_error, made.peak_output) == (5.0, 9.0)
    assert of_errors().peak_error == 0.0


@pytest.mark.parametrize(
    ("window", "after", "settled"),
    [
        (5.0, 0.0, 0.0),
        (4.0, 0.0, 0.001),
        (3.0, 0.0, 0.001),
        (2.0, 0.0, 0.003),
        (1.0, 0.0, 0.003),
        (0.5, 0.0, inf),
        (2.0, 0.002, 0.003),
        (2.0, 0.004, 0.004),
    ],
)
def test_the_time_from_which_the_error_stays_small(window: float, after: float, settled: float) -> None:
    """The errors are 5, -2, 3, 1 and -1. An error on the window is within it."""
    assert of_errors(5.0, -2.0, 3.0, 1.0, -1.0).settled_at(window, after) == pytest.approx(settled)


@pytest.mark.parametrize("bits", [0, 8, 16])
def test_a_dac_has_8_to_16_bits_or_is_not_quantised(bits: int) -> None:
    assert make_loop({"dac_bits": bits}).dac_bits == bits


@pytest.mark.parametrize("bits", [1, 7, 17])
def test_a_dac_of_other_bits_is_refused(bits: int) -> None:
    with pytest.raises(ValueError, match="16"):
        make_loop({"dac_bits": bits})
