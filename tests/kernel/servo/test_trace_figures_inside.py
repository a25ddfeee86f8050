"""Seen from inside: figures of a short trace, and the matrix exponential, by hand."""

from __future__ import annotations

import pytest

from motionlang.kernel.tracks.history import MotorFigures, MoveFigures
from tests.kernel.servo.test_trace_figures import of_errors, trace


@pytest.mark.parametrize("cut", range(11))
@pytest.mark.parametrize(
    ("window", "settled"),
    [(5.0, 0.0), (4.0, 0.002), (1.0, 0.002), (0.75, 0.003), (0.5, 0.003), (0.25, None), (0.0, None)],
)
def test_the_figures_of_a_move(cut: int, window: float, settled: float | None) -> None:
    """The move takes the samples at 2, 3 and 4 ms, its rest those at 5, 6 and 7 ms.

    The samples before and after belong to other moves. The currents 6 and 8 A are 3 and 4 N m: the root mean square of
    0, 3 and 4 is sqrt(25 / 3). The errors that follow are 5, 1 and 0.5: the last one that is outside the window counts,
    with its period, from the end of the move at 4 ms on.
    """
    errors = [9.0, 9.0, 1.0, -3.0, 2.0, 5.0, 1.0, 0.5, 7.0, 7.0]
    outputs = [8.0, 8.0, 4.0, -6.0, 5.0, 8.0, 8.0, 8.0, 8.0, 8.0]
    currents = [50.0, 50.0, 0.0, 6.0, 8.0, 50.0, 50.0, 50.0, 50.0, 50.0]
    move = MoveFigures(0.002, 0.004, 0.008)
    for begin, end in ((0, cut), (cut, 10)):
        block = trace(errors[begin:end], outputs[begin:end], currents[begin:end])
        move.take(begin * 0.001, block, window)
    found = MotorFigures(move.peak_error, move.peak_output, move.rms_torque, move.settle_time)
    assert found[:3] == pytest.approx((3.0, 6.0, (25.0 / 3.0) ** 0.5))
    assert found.settle_time == (None if settled is None else pytest.approx(settled))


@pytest.mark.parametrize(("begin", "peak"), [(0.0012, 5.0), (0.001, 5.0), (0.0009, 1.0), (7.0, 0.0)])
def test_a_short_move_has_the_sample_before_it_and_has_settled(begin: float, peak: float) -> None:
    """It takes 0.05 ms, and the next begins another 0.05 ms later.

    A sample is in force until the next.
    """
    move = MoveFigures(begin, begin + 0.00005, begin + 0.0001)
    move.take(0.0, of_errors(1.0, 5.0, 2.0), 0.5)
    assert (move.peak_error, move.peak_output, move.rms_torque, move.settle_time) == (peak, 0.0, 0.0, 0.0)
