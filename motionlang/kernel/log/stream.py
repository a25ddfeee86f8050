"""Streams of a log: lists of records of one kind in time order, which share one budget of memory.

What repeats, such as the waits of a loop whose iterations are skipped, is one row: a `Repetition` of the rows before
it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, overload

from motionlang.kernel.errors import Rejected

# The memory of a log with which the run ends, and that of a record, bytes: measured, rounded up.
MAX_MEMORY, RECORD = 2e9, 220
# The fields that are moments, which a repetition moves.
_MOMENTS = ("time", "since", "until")

T = TypeVar("T")


class Budget:
    """The memory that the log of a run may still take, bytes."""

    def __init__(self) -> None:
        self.left = MAX_MEMORY

    def take(self, size: float) -> None:
        """Count memory that is added, or dropped if the size is negative; raise Rejected if it is too much."""
        self.left -= size
        if self.left < 0:
            words = f"the log of the run has reached {MAX_MEMORY / 1e9:g} GB"
            raise Rejected("limit", words, "end the run sooner with --until")


@dataclass(frozen=True, slots=True)
class Repetition:
    """Rows again, so many `times`, `period` seconds apart.

    Moments that are whole statements after a `base`, each of `cost` seconds, are counted in these: so they are the
    same, to the last bit, as those of a repetition that is carried out.
    """

    rows: tuple[Any, ...]
    times: int
    period: float
    base: float
    cost: float

    def __len__(self) -> int:
        return self.times * _count(self.rows)

    def moved(self, record: Any, repetitions: int) -> Any:
        """Return a record as it is in one of the repetitions."""
        later = {
            name: self._later(getattr(record, name), repetitions)
            for name in _MOMENTS
            if hasattr(record, name)
        }
        return record._replace(**later)

    def _later(self, moment: float, repetitions: int) -> float:
        if not self.cost:
            return moment + repetitions * self.period
        count = round((moment - self.base) / self.cost) + repetitions * round(self.period / self.cost)
        return self.base + count * self.cost


def records_of(rows: Iterable[Any]) -> Iterator[Any]:
    """Yield the records of rows, with those of their repetitions."""
    for row in rows:
        if type(row) is not Repetition:
            yield row
            continue
        for k in range(1, row.times + 1):
            for record in records_of(row.rows):
                yield row.moved(record, k)


def _condensed(rows: Iterable[Any], at_once: int) -> Iterator[tuple[Any, int]]:
    for row in rows:
        if type(row) is not Repetition:
            yield row, 1
            continue
        for k in range(1, row.times + 1, at_once):
            count = min(at_once, row.times + 1 - k)
            for record, inner in _condensed(row.rows, at_once):
                yield row.moved(record, k), inner * count


def _count(rows: Iterable[Any]) -> int:
    return sum(len(row) if type(row) is Repetition else 1 for row in rows)


class Stream(Sequence[T], Generic[T]):
    """Records of one kind, read like a list; a run only calls `add` and `repeat`.

    Rows are numbered from `first`, the oldest one left, to `past` (exclusive). They retain their numbers when older
    ones are dropped.
    """

    # The attributes that `cut` restores.
    GROWING: tuple[str, ...] = ("rows", "_repeats")

    # The memory of a row, bytes.
    size = RECORD

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        self.rows: list[Any] = []
        self.first = 0
        self._repeats = False
        # Called with each record that is added, for what ends a run.
        self.heard: Callable[[T], object] | None = None

    @property
    def past(self) -> int:
        """The number of the next row."""
        return self.first + len(self.rows)

    # ------------------------------------------------------------------------------------------- writing

    def add(self, record: T) -> None:
        """Append a record."""
        self.rows.append(record)
        self._budget.take(self.size)
        if self.heard is not None:
            self.heard(record)

    def repeat(self, first: int, times: int, period: float, base: float = 0.0, cost: float = 0.0) -> None:
        """Append the rows from number `first` on so many times again, as `Repetition` says."""
        rows = tuple(self.rows[max(first - self.first, 0) :])
        if rows and times:
            self.rows.append(Repetition(rows, times, period, base, cost))
            self._repeats = True
            self._budget.take(self._memory(self.rows[-1]))

    def _memory(self, row: Any) -> int:
        return self.size + 8 * len(row.rows) if type(row) is Repetition else self.size

    # ------------------------------------------------------------------------------------------- reading

    def __iter__(self) -> Iterator[T]:
        return records_of(self.rows) if self._repeats else iter(self.rows)

    def __len__(self) -> int:
        return _count(self.rows) if self._repeats else len(self.rows)

    @overload
    def __getitem__(self, index: int) -> T: ...

    @overload
    def __getitem__(self, index: slice) -> list[T]: ...

    def __getitem__(self, index: int | slice) -> T | list[T]:
        return self._records()[index]

    def __reversed__(self) -> Iterator[T]:
        return reversed(self._records())

    def _records(self) -> list[T]:
        return list(self) if self._repeats else self.rows

    def written(self) -> Iterator[T]:
        """Yield the records without their repetitions."""
        return (row for row in self.rows if type(row) is not Repetition)

    def condensed(self, most: int) -> Iterator[tuple[T, int]]:
        """Yield records that stand for so many each: if more than `most` are repeated, for several repetitions."""
        repeated = sum(len(row) for row in self.rows if type(row) is Repetition)
        return _condensed(self.rows, max(1, -(-repeated // most)))

    # ------------------------------------------------------------------------------------------- dropping

    def forget(self, retained: int) -> None:
        """Drop all but about `retained` newest rows."""
        count = len(self.rows) - retained
        if count > retained:
            self._budget.take(-sum(map(self._memory, self.rows[:count])))
            del self.rows[:count]
            self.first += count

    def extent(self) -> Any:
        """Return the argument of a later `cut`, which drops all records that are added from now on."""
        return len(self.rows), self._repeats

    def cut(self, extent: Any) -> None:
        """Drop the records that have been added since `extent` was taken."""
        count, self._repeats = extent
        del self.rows[count:]
