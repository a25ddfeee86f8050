"""Figures of a loop and a plant: step response, bandwidth, margins and stability.

All but the step response need a linear pair.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from math import inf, pi

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners import hold
from motionlang.kernel.servo.demand import Track
from motionlang.kernel.servo.discrete import STATES, Discrete, discretise
from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.servo.servo import Servo
from motionlang.kernel.servo.step import MEMORY, LoopStep, State, at_rest
from motionlang.kernel.servo.trace import ServoTrace
from motionlang.kernel.tools import bisected

Array = NDArray[np.float64]

Complex = NDArray[np.complex128]

# -3 dB.
DROP = 10.0 ** (-3.0 / 20.0)
SETTLING = 0.02
LOW, HIGH = 0.1, 0.9
_POINTS = 2000
# The grid points between two that are computed both ways, how closely these must agree, and how far from the
# level a gain must be that is computed only the quick way.
_TRIED, _AGREED, _CLEAR = 50, 1e-8, 1e-6


@dataclass(frozen=True, slots=True)
class StepFigures:
    """Figures of a step response: times in s, errors in counts.

    The overshoot is a fraction of the step. `rise` is from 10 to 90 %; `settling` is the time after which the response
    stays within 2 %. Both are inf if that never happens. `bandwidth` (Hz) is 0.35/rise: a rule of thumb for any loop,
    nonlinear ones included.
    """

    size: float
    rise: float
    overshoot: float
    peak: float
    peak_time: float
    settling: float
    final_error: float
    peak_output: float

    @property
    def bandwidth(self) -> float:
        """The bandwidth, Hz, estimated from the rise time."""
        return 0.35 / self.rise if 0.0 < self.rise < inf else 0.0


@dataclass(frozen=True, slots=True)
class LoopFigures:
    """Figures of the linear loop at the servo rate.

    Frequencies are in Hz and margins in degrees, except that the gain margin is a factor.
    """

    stable: bool
    bandwidth: float
    crossover: float
    phase_margin: float
    gain_margin: float
    # Largest closed-loop gain.
    peak: float


def step_response(loop: Loop, plant: Motor | VelocityDrive, size: float, seconds: float) -> ServoTrace:
    """Simulate a step of the command from 0 to `size` counts at time 0.

    Feed-forward sees no motion.
    """
    servo = Servo(loop, plant, Track([0.0], [hold(size)]))
    servo.state = at_rest(0.0)
    return servo.run(max(2, round(seconds * loop.servo_rate)))


def step_figures(trace: ServoTrace, size: float) -> StepFigures:
    """Return rise, overshoot and settling of a step response of `size` counts."""
    share = trace.measured / size
    time = trace.time
    last = float(share[-1])
    peak = int(share.argmax())
    outside = np.flatnonzero(np.abs(share - 1.0) > SETTLING)
    settled = (
        time[outside[-1] + 1]
        if len(outside) and outside[-1] + 1 < len(time)
        else inf
        if len(outside)
        else 0.0
    )
    rise = _crossing(share, time, HIGH) - _crossing(share, time, LOW)
    return StepFigures(
        size=size,
        rise=rise if rise < inf else inf,
        overshoot=max(0.0, float(share[peak]) - 1.0),
        peak=float(share[peak]) * size,
        peak_time=float(time[peak]),
        settling=float(settled),
        final_error=(1.0 - last) * size,
        peak_output=trace.peak_output,
    )


def _crossing(share: Array, time: Array, level: float) -> float:
    """Return when the response first reaches `level`, by linear interpolation."""
    above = np.flatnonzero(share >= level)
    if not len(above):
        return inf
    i = int(above[0])
    if i == 0:
        return float(time[0])
    fraction = (level - share[i - 1]) / (share[i] - share[i - 1])
    return float(time[i - 1] + fraction * (time[i] - time[i - 1]))


# ------------------------------------------------------------------------------------------ in the frequency domain


def loop_figures(loop: Loop, plant: Motor | VelocityDrive) -> LoopFigures:
    """Return bandwidth and margins of a linear loop.

    Raises ValueError if the loop or the plant is not linear. The derivative must be sampled at the servo
    rate; limits, encoder steps and interpolation are neglected.
    """
    f, g, c = closed_loop(loop, plant)
    stable = bool(np.abs(np.linalg.eigvals(f)).max() < 1.0)
    top = 0.5 * loop.servo_rate
    grid = np.geomspace(top * 1e-5, top, _POINTS)
    closed = _gain(f, g, c, grid, loop.period)
    ring = closed / (1.0 - closed)
    crossover = _last_fall(grid, np.abs(ring), lambda w: abs(_open(f, g, c, w, loop.period)))
    phase = 180.0 / pi * float(np.angle(_open(f, g, c, crossover, loop.period))) if crossover else 0.0
    return LoopFigures(
        stable=stable,
        bandwidth=_first_fall(
            grid, np.abs(closed), lambda w: abs(_gain(f, g, c, np.array([w]), loop.period)[0])
        ),
        crossover=crossover,
        phase_margin=(phase + 180.0) % 360.0 if crossover else inf,
        gain_margin=_gain_margin(grid, ring, lambda w: _open(f, g, c, w, loop.period)),
        peak=float(np.abs(closed).max()),
    )


def closed_loop(loop: Loop, plant: Motor | VelocityDrive) -> tuple[Array, Array, Array]:
    """Return F, G, C of z' = F z + G demand, position = C z.

    This is one servo sample of the linear loop, without limits.
    """
    if not (loop.is_linear and plant.is_linear):
        raise ValueError(
            "only a linear loop and plant have a frequency response: leave out quantisation and friction"
        )
    if loop.derivative and loop.derivative_every > 1:
        raise ValueError("a frequency response needs the derivative sampled at the servo rate")
    states = _states(loop, discretise(plant, loop.period))
    unlimited = replace(loop, output_limit=inf, integral_limit=inf if loop.has_integral else 0.0)
    step, size = LoopStep(unlimited, plant), len(states)

    def after(*values: float) -> Array:
        full = [0.0] * (len(STATES) + len(MEMORY))
        for index, value in zip(states, values, strict=False):
            full[index] = value
        state: State = tuple(full[: len(STATES)]), tuple(full[len(STATES) :])  # type: ignore[assignment]
        (motion, memory), _ = step(state, values[-1], 0.0, True)
        return np.array([(*motion, *memory)[index] for index in states])

    zero = after(*[0.0] * (size + 1))
    *f, g = (after(*unit) - zero for unit in np.eye(size + 1).tolist())
    return np.array(f).T, g, np.eye(size)[0]


def _states(loop: Loop, plant: Discrete) -> list[int]:
    """Return the indices of the states that the linear loop has, among those of `State`."""
    memory = {
        "total": loop.has_integral,
        "last_error": bool(loop.derivative),
        "last_measured": bool(loop.velocity_feedback),
    }
    has_current = bool(plant.current[STATES.index("current")])
    return [
        *range(2 + has_current),
        *[STATES.index("twist"), STATES.index("load_velocity")] * plant.has_twist,
        *(len(STATES) + MEMORY.index(name) for name, used in memory.items() if used),
    ]


def is_stable(loop: Loop, plant: Motor | VelocityDrive) -> bool:
    """True if the linear loop is stable."""
    f, _, _ = closed_loop(loop, plant)
    return bool(np.abs(np.linalg.eigvals(f)).max() < 1.0)


def bandwidth(loop: Loop, plant: Motor | VelocityDrive) -> float:
    """Return the frequency (Hz) at which the closed-loop gain first falls below -3 dB."""
    return _bandwidth(loop, plant, None)


def reaches(loop: Loop, plant: Motor | VelocityDrive, target: float) -> bool:
    """True if the bandwidth is `target` Hz or more; mostly faster than `bandwidth`."""
    return _bandwidth(loop, plant, target) >= target


def _bandwidth(loop: Loop, plant: Motor | VelocityDrive, target: float | None) -> float:
    """Return the bandwidth, or with a `target` any value on the same side of it."""
    f, g, c = closed_loop(loop, plant)
    grid = _grid(loop.servo_rate)
    below = _first_below(f, g, c, loop.period, grid)
    if below is None:
        gain = np.abs(_gain(f, g, c, grid, loop.period))
        return _first_fall(grid, gain, lambda w: abs(_gain(f, g, c, np.array([w]), loop.period)[0]))
    if below in (0, len(grid)):
        return float(grid[-1]) if below else 0.0
    low, high = float(grid[below - 1]), float(grid[below])
    if target is not None and not low < target <= high:
        return low if low >= target else 0.0
    negative, driven = (-f).astype(np.complex128), g[:, None].astype(np.complex128)
    diagonal = np.arange(len(f))

    def exact(w: float) -> float:
        matrix = negative.copy()
        matrix[diagonal, diagonal] += np.exp(2j * pi * w * loop.period)
        return float(abs(np.linalg.solve(matrix, driven)[:, 0] @ c))

    return bisected(low, high, lambda w: exact(w) >= DROP)


@lru_cache(maxsize=8)
def _grid(rate: float) -> Array:
    return np.geomspace(0.5e-5 * rate, 0.5 * rate, _POINTS)


def _first_below(f: Array, g: Array, c: Array, period: float, grid: Array) -> int | None:
    """Return the first index of the grid with a gain below -3 dB.

    If there is none, return the grid's length; None if rounding leaves that open. The transfer function is computed as
    two polynomials in z - 1, which keep their precision at low frequencies. They are trusted if they agree with the
    matrices at every fiftieth index, and never come too near to the level.
    """
    difference = f - np.eye(len(f))
    below = np.poly(difference)
    above = np.poly(difference - np.outer(g, c)) - below
    w = np.expm1(2j * pi * grid * period)
    with np.errstate(all="ignore"):
        gain = np.abs(np.polyval(above, w) / np.polyval(below, w))
    some = np.abs(_gain(f, g, c, grid[::_TRIED], period))
    if not (np.abs(gain[::_TRIED] - some) <= _AGREED * (1.0 + some)).all():
        return None
    found = np.flatnonzero(gain < DROP + _CLEAR)
    if not len(found):
        return len(grid)
    first = int(found[0])
    return first if gain[first] < DROP - _CLEAR else None


def _gain(f: Array, g: Array, c: Array, frequencies: Array, period: float) -> Complex:
    z = np.exp(2j * pi * frequencies * period)
    matrices = z[:, None, None] * np.eye(len(f)) - f
    driven = np.broadcast_to(g, (len(z), len(g)))[:, :, None].astype(np.complex128)
    found: Complex = np.linalg.solve(matrices, driven)[:, :, 0] @ c
    return found


def _open(f: Array, g: Array, c: Array, frequency: float, period: float) -> complex:
    closed = complex(_gain(f, g, c, np.array([frequency]), period)[0])
    return closed / (1.0 - closed)


def _first_fall(grid: Array, gain: Array, exact: Callable[[float], float]) -> float:
    """Return the first frequency at which the gain is below `DROP`."""
    below = np.flatnonzero(gain < DROP)
    if not len(below) or below[0] == 0:
        return float(grid[-1]) if not len(below) else 0.0
    return bisected(float(grid[below[0] - 1]), float(grid[below[0]]), lambda w: exact(w) >= DROP)


def _last_fall(grid: Array, gain: Array, exact: Callable[[float], float]) -> float:
    """Return the highest frequency at which the gain falls through 1."""
    falls = np.flatnonzero((gain[:-1] >= 1.0) & (gain[1:] < 1.0))
    if not len(falls):
        return 0.0
    return bisected(float(grid[falls[-1]]), float(grid[falls[-1] + 1]), lambda w: exact(w) >= 1.0)


def _gain_margin(grid: Array, ring: Complex, exact: Callable[[float], complex]) -> float:
    """Return the gain margin, at the first frequency with a phase of -180 degrees."""
    above = (ring.imag[:-1] < 0.0) & (ring.imag[1:] >= 0.0) & (ring.real[:-1] < 0.0)
    margins = []
    for i in np.flatnonzero(above):
        w = bisected(float(grid[i]), float(grid[i + 1]), lambda x: exact(x).imag <= 0.0)
        margins.append(1.0 / abs(exact(w)))
    return min((m for m in margins if m > 1.0), default=inf)
