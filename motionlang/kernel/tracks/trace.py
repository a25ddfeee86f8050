"""The motion of a run as NumPy columns, sampled on request, at any rate.

Rows are at 0, 1/rate, 2/rate …; the last row is at the exact end of the run, even between two steps of the
grid. Lengths are in the user units in force at the time of the row.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil, isfinite

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.planners.evaluate import piece_values
from motionlang.kernel.planners.sample import ORDERS, PieceTable
from motionlang.kernel.tools import in_notebook
from motionlang.kernel.tracks.axes import axes_of
from motionlang.kernel.tracks.history import Reader

# Numbers of a column.
Array = NDArray[np.float64]

# quantity -> unit, and the unit as a component of a column's name.
UNITS: dict[str, tuple[str, str]] = {
    "position": ("uu", "uu"),
    "velocity": ("uu/s", "uu_per_s"),
    "acceleration": ("uu/s2", "uu_per_s2"),
    "jerk": ("uu/s3", "uu_per_s3"),
}
USUAL = ("position", "velocity", "acceleration")
# The columns of a simulated motor; "actual" is the position that its encoder measured.
MOTOR: dict[str, tuple[str, str]] = {
    "actual": ("uu", "uu"),
    "following error": ("uu", "uu"),
    "output": ("V", "V"),
    "torque": ("N m", "Nm"),
}
# The numbers of decimals that a column can have in a file. A nanosecond is a hundredth of the shortest statement time
# in use.
DECIMALS, TIME_DECIMALS = (6, 9, 12), 9
# Rows of one chunk: a few hundred kilobytes per column, which stay in the cache while they are written out.
ROWS = 65_536
MAX_ROWS = 200_000_000


@dataclass(frozen=True, slots=True)
class TraceColumn:
    """A column: `quantity` ("time", "position" …) in `unit`, of `axis` or None."""

    name: str
    quantity: str
    unit: str
    axis: int | None


_TIME = TraceColumn("time_s", "time", "s", None)


def _column(axis: int, quantity: str) -> TraceColumn:
    unit, suffix = UNITS[quantity] if quantity in UNITS else MOTOR[quantity]
    return TraceColumn(f"axis{axis}_{quantity.replace(' ', '_')}_{suffix}", quantity, unit, axis)


@dataclass(frozen=True, slots=True)
class Samples:
    """Columns of equal length, by name or by axis and quantity.

    `samples["axis0_position_uu"]` and `samples.get(0, "position")` return the same array.
    """

    columns: tuple[TraceColumn, ...]
    data: tuple[Array, ...]

    def __len__(self) -> int:
        return len(self.data[0])

    def __getitem__(self, name: str) -> Array:
        for column, values in zip(self.columns, self.data, strict=True):
            if column.name == name:
                return values
        raise KeyError(name)

    @property
    def time(self) -> Array:
        """The time of each row, seconds since power-up."""
        return self.data[0]

    def get(self, axis: int, quantity: str) -> Array:
        """Return the column of a quantity of an axis; KeyError if it was not sampled."""
        for column, values in zip(self.columns, self.data, strict=True):
            if column.axis == axis and column.quantity == quantity:
                return values
        raise KeyError((axis, quantity))


def quantity_of(column: str) -> tuple[str, str]:
    """Return quantity and axis from a column's name, such as "velocity.0".

    Raises ValueError if there is no such quantity.
    """
    text, _, axis = column.partition(".")
    quantity = text.replace("-", " ")
    if quantity not in UNITS and quantity not in MOTOR:
        names = ", ".join(name.replace(" ", "-") for name in (*UNITS, *MOTOR))
        raise ValueError(f"{text!r} is not a quantity of an axis; choose from {names}")
    return quantity, axis


class Trace:
    """The motion of a controller so far; later motion is not included."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self._tables: dict[int, PieceTable] = {}
        self._readers: dict[int, Reader] = {}
        self._chosen: list[tuple[int, str]] | None = None
        self.end = controller.clock.now

    def __repr__(self) -> str:
        axes = self.axes
        return (
            f"<Trace of ax{'i' if len(axes) == 1 else 'e'}s {', '.join(map(str, axes))}: 0 to {self.end:g} s>"
        )

    def _repr_html_(self) -> str:
        return in_notebook("trace_html", self)

    def __call__(
        self,
        rate: float = 1000.0,
        axes: Sequence[int] | None = None,
        quantities: Sequence[str] | None = None,
        until: float | None = None,
    ) -> NDArray[np.void]:
        """Return a structured array of samples: `array["axis0_position_uu"]`.

        It has a row every 1/`rate` s and one at the end. Its fields are `time_s` and the columns of each
        axis. `quantities` are "position", "velocity", "acceleration" and "jerk", and with a simulated motor
        "actual", "following error", "output" and "torque". Raises ValueError, with the choices, for an axis
        or a quantity that does not exist. Also raises it for a rate that is not above 0, or if there would be
        more than 200 million rows.
        """
        for quantity in quantities or ():
            quantity_of(quantity)
        for axis in axes or ():
            self._check_axis(axis)
        samples = self.sample(
            rate, axes, until, [each.replace("-", " ") for each in quantities or ()] or None
        )
        rows = np.empty(len(samples), [(column.name, np.float64) for column in samples.columns])
        for column, values in zip(samples.columns, samples.data, strict=True):
            rows[column.name] = values
        return rows

    def _check_axis(self, axis: object) -> None:
        if axis not in self.controller.axes:
            have = ", ".join(map(str, self.controller.axes))
            raise ValueError(f"there is no axis {axis}; this controller has {have}")

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that ever moved or were given a position; if none, the first axis."""
        return axes_of(self.controller)

    def choose(self, wanted: Sequence[str]) -> None:
        """Select columns and the time: "velocity" for all axes, "velocity.0" for one.

        Raises ValueError, with the alternatives, for an axis or a quantity that does not exist.
        """
        chosen: list[tuple[int, str]] = []
        for each in wanted:
            quantity, axis = quantity_of(each)
            if axis and not (axis.isdecimal() and int(axis) in self.controller.axes):
                have = ", ".join(map(str, self.controller.axes))
                raise ValueError(f"{each!r}: there is no axis {axis}; this controller has {have}")
            chosen += [(number, quantity) for number in ((int(axis),) if axis else self.axes)]
        self._chosen = chosen

    def columns(
        self, axes: Sequence[int] | None = None, quantities: Sequence[str] | None = None
    ) -> tuple[TraceColumn, ...]:
        """Return the columns that `sample` and `chunks` yield.

        Without arguments they are the selected ones. Without `quantities` they are those of `USUAL`, and
        those of `MOTOR` if an axis has a simulated motor. Raises KeyError for an axis or a quantity that does
        not exist.
        """
        if axes is None and quantities is None and self._chosen is not None:
            return (_TIME, *(_column(axis, quantity) for axis, quantity in self._chosen))
        made = [_TIME]
        for axis in self.axes if axes is None else axes:
            usual = USUAL if self.controller.axes[axis].feedback is None else (*USUAL, *MOTOR)
            made += [_column(axis, quantity) for quantity in (usual if quantities is None else quantities)]
        return tuple(made)

    def rows(self, rate: float = 1000.0, until: float | None = None) -> int:
        """Return the number of rows that `sample` would return."""
        return _last_step(rate, self.end if until is None else until) + 1

    def sample(
        self,
        rate: float = 1000.0,
        axes: Sequence[int] | None = None,
        until: float | None = None,
        quantities: Sequence[str] | None = None,
    ) -> Samples:
        """Return all rows at once; `rate` is in samples per second.

        Raises ValueError above 200 million rows; use `chunks` for these.
        """
        count = self.rows(rate, until)
        if count > MAX_ROWS:
            raise ValueError(f"{count} rows are too many to hold at once")
        columns = self.columns(axes, quantities)
        data = tuple(np.empty(count) for _ in columns)
        first = 0
        for chunk in self.chunks(rate, axes, until, quantities):
            for whole, values in zip(data, chunk.data, strict=True):
                whole[first : first + len(values)] = values
            first += len(chunk)
        return Samples(columns, data)

    def chunks(
        self,
        rate: float = 1000.0,
        axes: Sequence[int] | None = None,
        until: float | None = None,
        quantities: Sequence[str] | None = None,
    ) -> Iterator[Samples]:
        """Yield the rows, `ROWS` at a time; each chunk reuses the arrays of the last one."""
        end = self.end if until is None else until
        last = _last_step(rate, end)
        columns = self.columns(axes, quantities)
        buffers = [np.empty(min(ROWS, last + 1)) for _ in columns]
        for first in range(0, last + 1, ROWS):
            count = min(ROWS, last + 1 - first)
            data = tuple(buffer[:count] for buffer in buffers)
            np.divide(np.arange(first, first + count), rate, out=data[0])
            self._fill(columns, data, first / rate, 1.0 / rate, count)
            if first + count > last:
                data[0][-1] = end
                self._fill(columns, tuple(values[-1:] for values in data), end, 1.0 / rate, 1)
            yield Samples(columns, data)

    def table(self, axis: int) -> PieceTable:
        """Return the pieces of an axis's motion, in counts; they are computed once."""
        if axis not in self._tables:
            a = self.controller.axes[axis]
            self._tables[axis] = PieceTable(a.starts, a.profiles)
        return self._tables[axis]

    def at(self, axis: int, quantity: str, times: Array) -> Array:
        """Return a quantity of an axis in user units at any `times` (s), in any order."""
        table = self.table(axis)
        piece = np.clip(np.searchsorted(table.origins, times, "right") - 1, 0, None)
        values = piece_values(table.columns, piece, times - table.origins[piece], ORDERS[quantity])
        self.to_user(axis, quantity, times, values)
        return values

    def decimals(self, column: TraceColumn) -> int:
        """Return the fewest of `DECIMALS` that show a thousandth of a count; `TIME_DECIMALS` for the time."""
        if column.axis is None:
            return TIME_DECIMALS
        thousandth = 1e-3 / max(abs(counts) for _, counts, _ in self.controller.axes[column.axis].scales)
        return next((each for each in DECIMALS if 10.0**-each <= thousandth * (1.0 + 1e-9)), DECIMALS[-1])

    def to_user(self, axis: int, quantity: str, times: Array, values: Array) -> None:
        """Convert values in counts to the user units in force at their times, in place; seconds stay."""
        counts, zeros = units_at(self.controller.axes[axis], times)
        if quantity == "position":
            values -= zeros
        values /= counts

    def _fill(
        self, columns: Sequence[TraceColumn], data: Sequence[Array], start: float, step: float, count: int
    ) -> None:
        for column, out in zip(columns, data, strict=True):
            if column.axis is not None and column.quantity in MOTOR:
                self._fill_motor(column.axis, column.quantity, start, step, data[0], out)
            elif column.axis is not None:
                out[:] = self.table(column.axis).sample(start, step, count, ORDERS[column.quantity])
                self.to_user(column.axis, column.quantity, data[0], out)

    def _fill_motor(
        self, axis: int, quantity: str, start: float, step: float, times: Array, out: Array
    ) -> None:
        """Fill in motor data of an axis, in user units, volts or N m; 0 without a motor."""
        if axis not in self._readers:
            self._readers[axis] = Reader(self.controller.axes[axis], self.end)
        self._readers[axis].fill(quantity, start + np.arange(len(out), dtype=np.float64) * step, out)
        if quantity == "actual":
            self.to_user(axis, "position", times, out)
        elif quantity == "following error":
            self.to_user(axis, "velocity", times, out)  # a difference, which has no zero


def units_at(a: Axis, times: Array) -> tuple[Array, Array]:
    """Return the counts of a user unit of an axis and its zero, in counts, at each time."""
    since, counts, zeros = np.array(a.scales).T
    index = np.maximum(np.searchsorted(since, times, "right") - 1, 0)
    return counts[index], zeros[index]


def _last_step(rate: float, end: float) -> int:
    """Return the number of the last row.

    A step within a billionth of its length before the end counts as the end.
    """
    if not (isfinite(rate) and rate > 0.0):
        raise ValueError(f"the rate must be a number above 0, not {rate!r}")
    if not (isfinite(end) and end >= 0.0):
        raise ValueError(f"the end must be a time of 0 or more, not {end!r}")
    return max(0, ceil(end * rate - 1e-9))
