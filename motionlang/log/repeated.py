"""Records of actions that repeat, as a template that is read like a list.

A handler that toggles an output every millisecond writes 58 million records in eight hours. They differ only
in their times, which are times of statements: a base, such as a tick of a timer, plus a number of statements.
So the records of all repetitions are one `Template`, and a record is created when it is read.

The base of tick k is `start + (first + k) * period`. A record of repetition r has the time

    start + (first + r * ticks + tick) * period + (count + r * statements) * cost

with the `tick` and `count` of its template. The run computes the times with the same expression, so they are
equal to the last bit. A loop that never waits has one base (`period` 0), and `statements` is the number per
iteration; a handler has 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

# A tick, the counts of the times in it, and the record without these.
Row = tuple[int, tuple[float, ...], tuple[object, ...]]
# The rows of a repetition, the number of repetitions, and of each its ticks and statements.
Shape = tuple[list[Row], int, int, float]
# The start, the first tick, the period and the duration of a statement.
Pace = tuple[float, int, float, float]

# Records that are made at once.
_BATCH = 1024


class RepeatedRecords:
    """The records of a template, in order; `make` converts plain tuples to records."""

    __slots__ = ("_make", "_pace", "_shape")

    def __init__(self, template: tuple[Shape, Pace], make: Callable[[list[Any]], list[Any]]) -> None:
        self._shape, self._pace = template
        self._make = make

    def __len__(self) -> int:
        return length(self._shape)

    def __iter__(self) -> Iterator[Any]:
        for first in range(0, len(self), _BATCH):
            yield from self._records(range(first, min(first + _BATCH, len(self))))

    def __reversed__(self) -> Iterator[Any]:
        for past in range(len(self), 0, -_BATCH):
            yield from self._records(range(past - 1, max(past - _BATCH, 0) - 1, -1))

    def __getitem__(self, index: int | slice) -> Any:
        numbers = range(len(self))[index]
        return self._records(numbers) if isinstance(numbers, range) else self._records((numbers,))[0]

    def _records(self, numbers: Sequence[int]) -> list[Any]:
        rows, _, ticks, statements = self._shape
        start, first, period, cost = self._pace
        if len(rows) == 1 and rows[0][1] == (0.0,) and not statements:  # most are: a handler at each tick
            ((tick, _, rest),) = rows
            first += tick
            return self._make([(start + (first + k * ticks) * period, *rest) for k in numbers])
        made: list[tuple[object, ...]] = []
        for number in numbers:
            repetition, row = divmod(number, len(rows))
            tick, counts, rest = rows[row]
            base = start + (first + repetition * ticks + tick) * period
            if len(counts) == 1:
                made.append((base + (counts[0] + repetition * statements) * cost, *rest))
            else:
                times = [base + (count + repetition * statements) * cost for count in counts]
                made.append(_with_times(times, rest))
        return self._make(made)


def length(shape: Shape) -> int:
    """Return the number of records of all repetitions."""
    rows, repetitions, _, _ = shape
    return len(rows) * repetitions


def _with_times(times: list[float], rest: tuple[object, ...]) -> tuple[object, ...]:
    """Return a record with its times.

    A record with two times also ends with their difference.
    """
    if len(times) == 1:
        return times[0], *rest
    began, ended = times
    return began, ended, *rest, (ended - began,)


def rows_of(records: Sequence[tuple[Any, ...]], tick: int, base: float, cost: float) -> list[Row] | None:
    """Return the rows of the records of one tick, relative to its first statement.

    That statement is at `base`. None if a time is not that of a statement. Records with a tuple of a duration
    at the end have two times.
    """
    rows: list[Row] = []
    for record in records:
        times = record[:1] if not isinstance(record[-1], tuple) else record[:2]
        rest = record[1:] if len(times) == 1 else record[2:-1]
        counts = tuple(float(round((time - base) / cost)) for time in times)
        again = _with_times([base + count * cost for count in counts], rest)
        if again != tuple(record):
            return None
        rows.append((tick, counts, rest))
    return rows
