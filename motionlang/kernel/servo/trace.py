"""The result of a servo run: columns at the servo rate, and their figures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import inf

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.servo.discrete import discretise
from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.servo.step import COLUMNS, Reading

Array = NDArray[np.float64]

# Every column of a trace, and its unit.
UNITS = {
    "time": "s",
    "demand": "counts",
    "position": "counts",
    "velocity": "counts/s",
    "error": "counts",
    "integral": "V",
    "output": "V",
    "current": "A",
    "torque": "N m",
    "acceleration": "counts/s^2",
    "jerk": "counts/s^3",
}


def columns_of(readings: Sequence[Reading]) -> Array:
    """Return a row for each of `COLUMNS`."""
    return np.array(list(zip(*readings, strict=True)), dtype=np.float64)


def joined(traces: Sequence[ServoTrace]) -> ServoTrace:
    """Return consecutive traces as one, with the loop of the last."""
    shifts = [shift for each in traces for shift in each.shifts]
    return ServoTrace(traces[-1].loop, traces[-1].plant, [each.columns for each in traces], shifts)


class ServoTrace:
    """Columns of one axis, one row per servo sample, as the loop sees it.

    `demand` and `position` are in the program's coordinates. `columns` has a row for each of `step.COLUMNS`, in motor
    coordinates, and `shifts` are the samples of the run from which the program's zero is moved, with the distance.
    """

    def __init__(
        self,
        loop: Loop,
        plant: Motor | VelocityDrive,
        chunks: Sequence[Array],
        shifts: Sequence[tuple[int, float]],
    ) -> None:
        self.loop, self.plant, self.shifts = loop, plant, shifts
        self.columns = np.concatenate([np.zeros((len(COLUMNS), 0)), *chunks], axis=1)

    def __len__(self) -> int:
        return int(self.columns.shape[1])

    def _column(self, name: str) -> Array:
        column: Array = self.columns[COLUMNS.index(name)]
        return column

    @property
    def commanded(self) -> Array:
        """The commanded position in the motor's own coordinates, counts."""
        return self._column("demand")

    @cached_property
    def _offset(self) -> Array:
        """The displacement of the program's zero at every sample, counts."""
        first = self.shifts[0][0]
        edges = [*(sample - first for sample, _ in self.shifts), len(self)]
        made: Array = np.repeat(np.array([value for _, value in self.shifts]), np.diff(edges))
        return made

    def __getitem__(self, name: str) -> Array:
        if name not in UNITS:
            raise KeyError(name)
        column: Array = getattr(self, name)
        return column

    @property
    def time(self) -> Array:
        """Times of the samples, seconds."""
        made: Array = np.arange(len(self), dtype=np.float64) * self.loop.period
        return made

    @property
    def demand(self) -> Array:
        """Commanded position, interpolated, counts."""
        return self.commanded - self._offset

    @property
    def position(self) -> Array:
        """True position of the motor, counts."""
        return self._column("position") - self._offset

    @property
    def measured(self) -> Array:
        """Position measured by the encoder, counts."""
        return self.encoder - self._offset

    @property
    def encoder(self) -> Array:
        """Measured position in the motor's own coordinates, unaffected by a new zero."""
        return self._column("measured")

    @property
    def velocity(self) -> Array:
        """Velocity of the motor, counts/s."""
        return self._column("velocity")

    @property
    def error(self) -> Array:
        """Following error: commanded minus measured position, counts."""
        return self.commanded - self.encoder

    @property
    def integral(self) -> Array:
        """The integral's contribution to the output, volts."""
        return self._column("integral")

    @property
    def output(self) -> Array:
        """The controller's output, volts."""
        return self._column("output")

    @property
    def current(self) -> Array:
        """Motor current, A; zero for a `VelocityDrive`, which does not report it."""
        return self._column("current")

    @property
    def torque(self) -> Array:
        """Motor torque, N m."""
        constant = 0.0 if isinstance(self.plant, VelocityDrive) else self.plant.torque_constant
        return self.current * constant

    @property
    def acceleration(self) -> Array:
        """Mean acceleration from this sample to the next, counts/s²."""
        return np.diff(self.velocity, append=self.velocity[-1:]) * self.loop.servo_rate

    @property
    def onset(self) -> Array:
        """Acceleration just after the output has changed, counts/s².

        It shows the immediate effect of a DAC step, without friction.
        """
        made = discretise(self.plant, self.loop.period)
        if made.has_twist:
            raise ValueError(
                "the onset of the acceleration needs the velocity of the load, which is not recorded"
            )
        _, by_velocity, by_current, _, _, by_output, one = next(iter(made.regimes.values())).drive
        return by_output * self.output + one + by_velocity * self.velocity + by_current * self.current

    @property
    def jerk(self) -> Array:
        """Rate of change of `acceleration` since the sample before, counts/s³."""
        return np.diff(self.acceleration, prepend=0.0) * self.loop.servo_rate

    @property
    def dac_steps(self) -> Array:
        """The output in DAC steps, if the loop has a DAC."""
        if not self.loop.dac_bits:
            raise ValueError("this loop's output is not quantised: it has no DAC steps")
        return np.rint(self.output / self.loop.dac_step)

    def table(self) -> dict[str, Array]:
        """Return every column by name, in the order of `UNITS`."""
        return {name: self[name] for name in UNITS}

    # -- figures

    @property
    def peak_error(self) -> float:
        """Largest following error, counts."""
        return float(np.abs(self.error).max(initial=0.0))

    @property
    def rms_torque(self) -> float:
        """Root mean square of the torque, N m."""
        return float(np.sqrt(np.mean(self.torque**2))) if len(self) else 0.0

    def rms_torque_between(self, begin: float, end: float) -> float:
        """Return the root mean square of the torque, N m, from `begin` to `end` seconds."""
        torque = self.torque[(self.time >= begin) & (self.time <= end)]
        return float(np.sqrt(np.mean(torque**2))) if len(torque) else 0.0

    @property
    def peak_output(self) -> float:
        """Largest output, volts."""
        return float(np.abs(self.output).max(initial=0.0))

    def settled_at(self, window: float, after: float = 0.0) -> float:
        """Return since when the error stays within `window` counts; inf if never.

        The result is not before `after`.
        """
        outside = np.flatnonzero(np.abs(self.error) > window)
        if len(outside) and outside[-1] == len(self) - 1:
            return inf
        settled = float(self.time[outside[-1] + 1]) if len(outside) else 0.0
        return max(settled, after)
