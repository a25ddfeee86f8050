"""Which moment of the run a moment of the recording is: the delay that makes the two most alike.

A recording begins when somebody or something triggers it. The delay is found coarsely by correlating velocities, which
do not depend on where zero is, and then exactly, by least squares over all signals, each with an offset of its own.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from motionlang.profile.formula import summit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from motionlang.controller.record.trace import Trace

    Array = NDArray[np.float64]

# Steps of the coarse grid at most, and points that the fine search looks at.
COARSE, FINE = 1 << 16, 20_000


class Signal(NamedTuple):
    """One measured quantity of one axis in user units, at `times` (s) of the recording; no NaN is in it."""

    axis: int
    quantity: str
    column: str
    times: Array
    values: Array

    @property
    def name(self) -> str:
        """What a command line calls it: position.0."""
        return f"{self.quantity}.{self.axis}"


def simulated(trace: Trace, signal: Signal, times: Array) -> Array:
    """What the run has at `times` (s) of its own; the first and the last value hold before and after it."""
    return trace.at(signal.axis, signal.quantity, np.clip(times, 0.0, trace.end))


def find_delay(trace: Trace, signals: Sequence[Signal]) -> float | None:
    """Seconds that the recording is later than the run; None where nothing moves in one of the two."""
    coarse = _coarse(trace, signals)
    if coarse is None:
        return None
    middle, step = coarse
    low, high = middle - 2.0 * step, middle + 2.0 * step
    return summit(lambda delay: -_misfit(trace, signals, delay), low, high)


def lag(trace: Trace, signal: Signal, delay: float, begin: float, end: float) -> float | None:
    """Seconds that a signal is behind the run between two times of the run, to first order; None at rest."""
    inside = (signal.times - delay >= begin) & (signal.times - delay <= end)
    times = signal.times[inside] - delay
    order = {"position": "velocity", "velocity": "acceleration", "acceleration": "jerk"}.get(signal.quantity)
    if order is None or len(times) < 3:
        return None
    slope = trace.at(signal.axis, order, np.clip(times, 0.0, trace.end))
    energy = float(slope @ slope)
    residual = signal.values[inside] - simulated(trace, signal, times)
    return -float(residual @ slope) / energy if energy > 0.0 else None


def _coarse(trace: Trace, signals: Sequence[Signal]) -> tuple[float, float] | None:
    """The delay to about two steps of a grid, and the step."""
    first = min(float(signal.times[0]) for signal in signals)
    last = max(float(signal.times[-1]) for signal in signals)
    span = max(last - first, trace.end)
    usual = min(float(np.median(np.diff(signal.times))) for signal in signals)
    step = max(usual, 2.0 * span / COARSE)
    count = int(span / step) + 2
    total = np.zeros(2 * count)
    for signal in signals:
        grid = first + np.arange(count) * step
        measured = np.interp(grid, signal.times, signal.values)
        expected = simulated(trace, signal, np.arange(count, dtype=np.float64) * step)
        if signal.quantity == "position":
            measured, expected = np.diff(measured), np.diff(expected)
        energy = float(np.sqrt((measured @ measured) * (expected @ expected)))
        if energy > 0.0:
            spectrum = np.fft.rfft(measured, 2 * count) * np.conj(np.fft.rfft(expected, 2 * count))
            total += np.fft.irfft(spectrum, 2 * count) / energy
    if not total.any():
        return None
    best = int(np.argmax(total))
    return first + (best if best < count else best - 2 * count) * step, step


def _misfit(trace: Trace, signals: Sequence[Signal], delay: float) -> float:
    """The squares of what is left, each signal measured by what it does at all."""
    total = 0.0
    for signal in signals:
        stride = max(1, len(signal.times) // FINE)
        times, values = signal.times[::stride], signal.values[::stride]
        left = values - simulated(trace, signal, times - delay)
        left -= left.mean()
        total += float(left @ left) / (float(np.var(values)) * len(values) or 1.0)
    return total


def fit(expected: Array, values: Array) -> tuple[float, float]:
    """Scale and offset that make `expected` most like `values`, by least squares; scale 1 where nothing moves."""
    spread = expected - expected.mean()
    energy = float(spread @ spread)
    scale = float(spread @ values) / energy if energy > 0.0 else 1.0
    return scale, float(values.mean() - scale * expected.mean())
