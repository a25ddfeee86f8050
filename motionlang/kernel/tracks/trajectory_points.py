"""The trajectory points of an axis: one per cycle, as a controller computes them.

A controller does not follow the closed form. Its trajectory generator computes a point per cycle (PMC: 1
kHz), and the servo loop, which runs faster (4 kHz), interpolates linearly between the points (TN1069). So
velocity is constant during a cycle and acceleration is its change from cycle to cycle. A move from rest
begins with a cycle, so it waits for the next one. Later changes of the motion (a stop, a new speed) are
delayed by the same time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.planners.sample import PieceTable
from motionlang.kernel.servo.demand import Generator

Array = NDArray[np.float64]

# Fraction of a cycle: a time this near to its start counts as the start.
AT_ONCE = 1e-7


class TrajectoryPoints:
    """The trajectory points of an axis, in counts unaffected by new zeros.

    The point for the end of a cycle is computed as the cycle begins, from the profile that is in force then.
    """

    def __init__(self, axis: Axis, period: float) -> None:
        self._profiles, self._period = axis.profiles, period
        self._starts = np.array(axis.starts)
        self._offsets = Generator(axis, period).offsets(0, len(axis.profiles))
        # The cycle from which on a profile is in force, and when the profile begins for its points.
        self._first = np.ceil(self._starts / period - AT_ONCE).astype(np.int64)
        self._begins, late = self._starts.copy(), 0.0
        for k, profile in enumerate(axis.profiles):
            if not profile.start_velocity:
                late = float(self._first[k] * period - self._starts[k])
            self._begins[k] += late

    def between(self, first: int, last: int) -> Array:
        """Return the points at the starts of the cycles `first` to `last`, inclusive."""
        cycles = np.arange(first, last + 1)
        owners = np.maximum(np.searchsorted(self._first, cycles - 1, "right") - 1, 0)
        low, high = int(owners[0]), int(owners[-1]) + 1
        begins = np.minimum.accumulate(self._begins[low:high][::-1])[::-1]
        table = PieceTable(begins.tolist(), self._profiles[low:high])
        made = table.sample(first * self._period, self._period, len(cycles))
        made += self._offsets[owners]
        # Where a profile takes over, the table is a cycle ahead of the generator.
        for i in np.unique(self._first[low:high] - first).tolist():
            if 0 <= i < len(made):
                made[i] = self._point(first + i, int(owners[i]))
        return made

    def renamed(self, times: Array) -> Array:
        """Return the displacement of positions due to new zeros, counts."""
        owners = np.searchsorted(self._starts, times + AT_ONCE * self._period, "right") - 1
        made: Array = self._offsets[np.maximum(owners, 0)]
        return made

    def _point(self, cycle: int, owner: int) -> float:
        time = max(cycle * self._period - float(self._begins[owner]), 0.0)
        return self._profiles[owner].position(time) + float(self._offsets[owner])
