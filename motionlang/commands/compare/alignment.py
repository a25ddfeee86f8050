"""The delay of a recording relative to a run, for any scale, sign and offset.

A recording begins when a person or a trigger starts it, and has its own units and zero. For each delay
every signal is fitted with `scale * simulated + offset` by least squares; the best delay leaves the smallest
share of the variance. The share is computed on a grid of delays by FFT first, in O(n log n): the explained
share is the squared correlation coefficient, whose sums over the recorded window are correlations. The best
maxima of the grid are then refined by golden section on the samples themselves.

Motion that repeats itself can fit at several delays. Among delays that fit equally well the one with scales
nearest 1 is chosen, a reversed sign only if no other delay fits, and the shortest delay of several passes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import fsum, log
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners import summit

Array = NDArray[np.float64]

# Maximum steps of the coarse grid, and points of a signal that are used to choose a delay and to refine it.
COARSE, ROUGH, FINE = 1 << 16, 2_000, 20_000
# How many maxima of the grid are refined, and by how much of a signal's variance these may be worse than the
# best.
MAX_CANDIDATES, WORSE = 6, 0.1
# Shares of a variance are equal in so many decimal places.
EQUAL = 3
# Delays fit equally well if their misfits differ by less than this factor, or this share of a signal's variance.
TIE_FACTOR, TIE_SHARE = 1.01, 1e-6
# A simulated signal with less than this share of its largest variance is constant.
STILL = 1e-9


class ComparedMotion(Protocol):
    """The motion with which a recording is compared, from 0 to `end`, s."""

    @property
    def end(self) -> float: ...

    def at(self, axis: int, quantity: str, times: Array) -> Array:
        """Return a quantity of an axis in user units at any `times`, in s."""
        ...


class Signal(NamedTuple):
    """One measured quantity of one axis in user units, at `times` (s), without NaN.

    The values of `events` are points, not a track.
    """

    axis: int
    quantity: str
    column: str
    times: Array
    values: Array
    events: bool = False

    @property
    def name(self) -> str:
        """The name of the signal on a command line, such as position.0."""
        return f"{self.quantity}.{self.axis}"


def simulated(trace: ComparedMotion, signal: Signal, times: Array) -> Array:
    """Return the run's values at `times` (s), constant before and after it."""
    return trace.at(signal.axis, signal.quantity, np.clip(times, 0.0, trace.end))


def find_delay(trace: ComparedMotion, signals: Sequence[Signal]) -> float | None:
    """Return the delay of the recording after the run in seconds, or None.

    The delay is None if nothing moves in the recording or in the run.
    """
    coarse = _coarse(trace, signals)
    if coarse is None:
        return None
    delays, step = coarse
    if len(delays) > 1:
        rough = _thinned(signals, ROUGH)
        delays = [_likeliest(trace, rough, [_refined(trace, rough, delay, step) for delay in delays])]
    return _refined(trace, _thinned(signals, FINE), delays[0], step)


def find_delay_near(trace: ComparedMotion, signals: Sequence[Signal], delay: float) -> float:
    """Return the best delay within two steps of the recording of `delay`, s."""
    step = min(float(np.median(np.diff(signal.times))) for signal in signals)
    return _refined(trace, _thinned(signals, FINE), delay, step)


def _refined(trace: ComparedMotion, signals: Sequence[Signal], delay: float, step: float) -> float:
    """Return the best delay within two grid steps of `delay`."""
    return summit(lambda each: -_misfit(trace, signals, each), delay - 2.0 * step, delay + 2.0 * step)


def _likeliest(trace: ComparedMotion, signals: Sequence[Signal], delays: Sequence[float]) -> float:
    """Return the delay that fits best; among equal ones that with scales nearest 1, and the shortest of these."""
    misfits = [_misfit(trace, signals, delay) for delay in delays]
    worst = TIE_FACTOR * min(misfits) + TIE_SHARE * len(signals)
    tied = [(misfit, delay) for misfit, delay in zip(misfits, delays, strict=True) if misfit <= worst]
    return min(tied, key=lambda each: (_unlikeness(trace, signals, each[1]), abs(each[1])))[1]


def lag(trace: ComparedMotion, signal: Signal, delay: float, begin: float, end: float) -> float | None:
    """Return the lag of a signal behind the run between two times, s, or None.

    The lag is computed to first order. It is None at rest.
    """
    inside = (signal.times - delay >= begin) & (signal.times - delay <= end)
    times = signal.times[inside] - delay
    order = {"position": "velocity", "velocity": "acceleration", "acceleration": "jerk"}.get(signal.quantity)
    if order is None or len(times) < 3:
        return None
    slope = trace.at(signal.axis, order, np.clip(times, 0.0, trace.end))
    energy = float(slope @ slope)
    residual = signal.values[inside] - simulated(trace, signal, times)
    return -float(residual @ slope) / energy if energy > 0.0 else None


def _coarse(trace: ComparedMotion, signals: Sequence[Signal]) -> tuple[list[float], float] | None:
    """Return the likeliest delays to about one grid step, and that step, or None.

    The result is None if nothing moves in the recording or in the run.
    """
    first = min(float(signal.times[0]) for signal in signals)
    length = max(float(signal.times[-1]) for signal in signals) - first
    usual = min(float(np.median(np.diff(signal.times))) for signal in signals)
    step = max(usual, 2.0 * max(length, trace.end) / COARSE)
    recorded: Array = first + np.arange(int(length / step) + 1, dtype=np.float64) * step
    count = int((length + trace.end) / step) + 2
    # Correlation k pairs the first point of the recording with point k of the run, from a complete recording
    # before it.
    run_times: Array = trace.end + np.arange(1 - count, len(recorded), dtype=np.float64) * step
    explained = np.zeros(count)
    for signal in signals:
        explained += _explained(trace, signal, recorded, run_times)
    rises = np.diff(explained, prepend=-1.0) > 0.0
    falls = np.diff(explained, append=-1.0) <= 0.0
    maxima = np.flatnonzero(rises & falls & (explained > max(explained.max() - WORSE * len(signals), 0.0)))
    # Repetitions of a motion explain the same share: the shortest delays of them are tried.
    order = np.lexsort((np.abs(first - run_times[maxima]), -np.round(explained[maxima], EQUAL)))
    best = maxima[order][:MAX_CANDIDATES]
    return ([first - float(run_times[k]) for k in best], step) if len(best) else None


def _explained(trace: ComparedMotion, signal: Signal, recorded: Array, run_times: Array) -> Array:
    """Return the share of a signal's variance that the run explains, by delay.

    Each of `run_times` is one delay: the time of the run at which `recorded[0]` was measured.
    """
    count = len(run_times) - len(recorded) + 1
    expected = simulated(trace, signal, run_times)
    expected = expected - expected.mean()
    inside = ((recorded >= signal.times[0]) & (recorded <= signal.times[-1])).astype(np.float64)
    points = float(inside.sum())
    measured = np.interp(recorded, signal.times, signal.values)
    measured = (measured - float(measured @ inside) / max(points, 1.0)) * inside
    energy = float(measured @ measured)
    size = 1 << (len(run_times) - 1).bit_length()

    def correlated(window: Array, values: Array) -> Array:
        spectrum = np.conj(np.fft.rfft(window, size)) * np.fft.rfft(values, size)
        return np.fft.irfft(spectrum, size)[:count]

    spread = correlated(inside, expected**2) - correlated(inside, expected) ** 2 / max(points, 1.0)
    moves = spread > STILL * float(spread.max())
    if not energy > 0.0 or not moves.any():
        return np.zeros(count)
    shared = correlated(measured, expected)
    return np.clip(shared**2 / np.where(moves, spread * energy, np.inf), 0.0, 1.0)


def _misfit(trace: ComparedMotion, signals: Sequence[Signal], delay: float) -> float:
    """Return the total share of the signals' variance that remains after the fit."""
    total = 0.0
    for values, expected in _pairs(trace, signals, delay):
        scale, offset = fit(expected, values)
        left = values - scale * expected - offset
        total += float(left @ left) / (float(values @ values) or 1.0)
    return total


def _unlikeness(trace: ComparedMotion, signals: Sequence[Signal], delay: float) -> tuple[int, float]:
    """Return the count of reversed signs, and how far scales are from 1, to a percent."""
    scales = [fit(expected, values)[0] for values, expected in _pairs(trace, signals, delay)]
    reversals = [scale for scale in scales if scale <= 0.0]
    return len(reversals), round(fsum(abs(log(abs(scale))) for scale in scales if scale), 2)


def _pairs(trace: ComparedMotion, signals: Sequence[Signal], delay: float) -> Iterator[tuple[Array, Array]]:
    """Yield each signal's measured values, minus their mean, and the run's values."""
    for signal in signals:
        values = signal.values - signal.values.mean()
        yield values, simulated(trace, signal, signal.times - delay)


def _thinned(signals: Sequence[Signal], points: int) -> list[Signal]:
    strides = [max(1, len(signal.times) // points) for signal in signals]
    return [
        signal._replace(times=signal.times[::stride], values=signal.values[::stride])
        for signal, stride in zip(signals, strides, strict=True)
    ]


def fit(expected: Array, values: Array) -> tuple[float, float]:
    """Return scale and offset that fit `expected` to `values` by least squares.

    The scale is 1 if nothing moves.
    """
    spread = expected - expected.mean()
    energy = float(spread @ spread)
    scale = float(spread @ values) / energy if energy > 0.0 else 1.0
    return scale, float(values.mean() - scale * expected.mean())
