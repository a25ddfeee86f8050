"""The motion as the controller commands it: trajectory points, and straight lines between them.

A controller does not follow the closed form. Its trajectory generator computes a point a cycle (PMC: 1 kHz), and the
loop, which runs faster (4 kHz), takes the line between two of them (TN1069). So velocity is constant during a cycle
and acceleration is the change of it from cycle to cycle. A move from rest begins with a cycle: until then it waits,
and what changes the motion later (a stop, a new speed) comes as much later as the motion is.
"""

from __future__ import annotations

from math import ceil
from typing import TYPE_CHECKING

import numpy as np

from motionlang.controller.servo.demand import Generator
from motionlang.controller.trace import MOTOR, Trace
from motionlang.profile.sample import ORDERS, PieceTable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from motionlang.controller.axis import Axis
    from motionlang.controller.controller import Controller
    from motionlang.controller.trace import Array, Column

    Cycles = NDArray[np.int64]

# Of a cycle: what is as near as this to its begin stands there.
_AT_ONCE = 1e-7


class Commanded(Trace):
    """A trace of what the loop is told; it ends a cycle after the one in which the run did.

    Velocity, acceleration and jerk are the differences of the points over one, two and three cycles.
    """

    __slots__ = ("_points", "trajectory_rate")

    def __init__(self, controller: Controller, trajectory_rate: float = 1000.0) -> None:
        super().__init__(controller)
        self.trajectory_rate = trajectory_rate
        self._points: dict[int, Points] = {}
        self.end = (ceil(self.end * trajectory_rate - _AT_ONCE) + 1) / trajectory_rate

    def _fill(
        self, columns: Sequence[Column], data: Sequence[Array], start: float, step: float, count: int
    ) -> None:
        times = start + np.arange(count, dtype=np.float64) * step
        cycles = times * self.trajectory_rate
        whole = np.floor(cycles + _AT_ONCE).astype(np.int64)
        first, last = int(whole[0]) - 2, int(whole[-1]) + 1
        known: dict[int, Array] = {}
        for column, out in zip(columns, data, strict=True):
            if column.axis is None:
                continue
            if column.quantity in MOTOR:
                self._fill_motor(column.axis, column.quantity, start, step, count, out)
                continue
            points = self._of(column.axis)
            if column.axis not in known:
                known[column.axis] = points.between(first, last)
            order = ORDERS[column.quantity]
            if order:
                differences = np.diff(known[column.axis], order)[3 - order :]
                np.multiply(differences[whole - whole[0]], self.trajectory_rate**order, out=out)
            else:
                out[:] = np.interp(cycles, np.arange(first, last + 1), known[column.axis])
                out -= points.renamed(times)
            self.to_user(column.axis, column.quantity, out)

    def _of(self, axis: int) -> Points:
        if axis not in self._points:
            self._points[axis] = Points(self.controller.axes[axis], 1.0 / self.trajectory_rate)
        return self._points[axis]


class Points:
    """The trajectory points of an axis, in counts that no renaming of positions moves.

    The point at the end of a cycle is made as the cycle begins, by the profile that is in force then.
    """

    __slots__ = ("_begins", "_first", "_offsets", "_period", "_profiles", "_starts")

    def __init__(self, axis: Axis, period: float) -> None:
        self._profiles, self._period = axis.profiles, period
        self._starts = np.array(axis.starts)
        generator = Generator(axis, period)
        generator.offset(len(axis.profiles) - 1)
        self._offsets = np.array(generator.offsets)
        # The cycle from which on a profile is in force, and when the profile begins for its points.
        self._first = np.ceil(self._starts / period - _AT_ONCE).astype(np.int64)
        self._begins, late = self._starts.copy(), 0.0
        for k, profile in enumerate(axis.profiles):
            if not profile.start_velocity:
                late = float(self._first[k] * period - self._starts[k])
            self._begins[k] += late

    def between(self, first: int, last: int) -> Array:
        """The points at the begins of the cycles `first` to `last`, included."""
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
        """What positions have been renamed by, counts."""
        owners = np.searchsorted(self._starts, times + _AT_ONCE * self._period, "right") - 1
        made: Array = self._offsets[np.maximum(owners, 0)]
        return made

    def _point(self, cycle: int, owner: int) -> float:
        time = max(cycle * self._period - float(self._begins[owner]), 0.0)
        return self._profiles[owner].position(time) + float(self._offsets[owner])
