"""Streams of a log: records of one kind in time order, as columns.

Problem. A run may take weeks of machine time and write millions of records. They are read like a list, during the run
and after it, and must not fill the memory. Writing one happens while the program runs and must be cheap.

Idea. A row is appended to columns (`columns.py`), and a record is made when it is read. Every `CHUNK` rows the columns
are sealed: their bytes go to the `Store`, whose first 16 MB stay in memory; the others go to a file. What repeats, such
as the waits of a loop whose iterations are skipped, is not written again: `repeat` notes that some records occur so
many times more, a period apart.

    records     0          2048       4096      4200                      104 200
                ├─ chunk ──┼─ chunk ──┼─ rows ──┼─ 100 more, 1000 times ──┼─ rows
                  memory     file       columns   of the rows before it

Invariants.
- Records are only appended, until `cut` goes back to an earlier time. A record keeps its number when older ones are
  dropped (`forget`); `first` is then the oldest that is left.
- A record reads the same whether its chunk is sealed or not.
- An interrupt at any time leaves the stream consistent once `finish_updates` has run: `_rows` counts the complete rows.
- The file has no name, so it is gone when the process ends, however that happens. If it exceeds `DISK` bytes or cannot
  be written, the run ends with a diagnostic.

Cost. Reading from one end to the other reads each chunk once. A single old record costs a bisection and the reading of
its chunk; a stream keeps the last chunk that was read. Memory is bounded by 16 MB for the log, and two chunks and its
repetitions for each stream.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import IO, Any, Generic, TypeVar, overload
from weakref import finalize

from motionlang.kernel.errors import Rejected
from motionlang.kernel.files import reason, scratch
from motionlang.kernel.log.columns import Column, Words, layout

# Bytes of sealed chunks stored in memory; later ones are on the disk.
MEMORY = 16_000_000
# Default bytes that a log may have on the disk before the run ends.
DISK = 8_000_000_000
# Rows of a sealed chunk.
CHUNK = 2048
# The fields that are moments, which a repetition moves.
_MOMENTS = ("time", "since", "until")

T = TypeVar("T")
# Where a sealed chunk is: its bytes, or offset and length in the file.
Location = bytes | tuple[int, int]


class Store:
    """Sealed chunks of a log: up to `memory` bytes in memory, then in an unnamed file.

    The file disappears when the process ends, however that happens. Raises Rejected if the file would exceed
    `disk` bytes or cannot be written. `words` are the values that records have in common.
    """

    __slots__ = ("__weakref__", "_file", "_written", "disk", "in_memory", "memory", "words")

    def __init__(self, memory: int = MEMORY, disk: int = DISK) -> None:
        self.memory, self.disk = memory, disk
        self.in_memory = self._written = 0
        self._file: IO[bytes] | None = None
        self.words = Words()

    @property
    def size(self) -> int:
        """Bytes in memory and on the disk."""
        return self.in_memory + self._written

    def put(self, chunk: bytes) -> Location:
        """Store a chunk and return its location."""
        size = len(chunk)
        if self.in_memory + size <= self.memory:
            self.in_memory += size
            return chunk
        if self._written + size > self.disk:
            words = f"the log of the run has reached {self.disk / 1000000000.0:g} GB"
            raise Rejected("limit", words, "shorten the run with --until")
        try:
            self._append(chunk)
        except OSError as problem:
            words = f"the log of the run cannot be written: {reason(problem)}"
            raise Rejected("limit", words, "shorten the run with --until, or free disk space") from None
        location = self._written, size
        self._written += size
        return location

    def _append(self, chunk: bytes) -> None:
        if self._file is None:
            self._file = scratch()
            finalize(self, self._file.close)  # before the file itself, if both are in a cycle
        self._file.seek(self._written)
        self._file.write(chunk)

    def get(self, location: Location) -> bytes:
        """Return a chunk."""
        if isinstance(location, bytes):
            return location
        assert self._file is not None
        self._file.seek(location[0])
        return self._file.read(location[1])

    def drop(self, location: Location) -> None:
        """Drop a chunk; its space on disk is not reused."""
        if isinstance(location, bytes):
            self.in_memory -= len(location)


@dataclass(slots=True)
class Chunk:
    """The rows of a stream from number `first` on; a sealed one has no columns, but their `location` and `sizes`."""

    first: int
    columns: tuple[Column, ...] = ()
    location: Location = b""
    sizes: tuple[int, ...] = ()

    @property
    def arrays(self) -> list[array[Any]]:
        """The arrays of its columns."""
        return [each for column in self.columns for each in column.arrays]


@dataclass(frozen=True, slots=True)
class Repetition:
    """Records `first` to `past` again, so many `times`: record `past` and those after it, before row `row`.

    They are `period` seconds apart. Moments that are whole statements after a `base`, each of `cost` seconds, are
    counted in these: so they are the same, to the last bit, as those of a repetition that is carried out.
    """

    first: int
    past: int
    times: int
    period: float
    base: float
    cost: float
    row: int

    @property
    def end(self) -> int:
        """The number after its last record."""
        return self.past + self.times * (self.past - self.first)

    def later(self, moment: float, repetitions: int) -> float:
        """Return a moment of the original in one of the repetitions."""
        if not self.cost:
            return moment + repetitions * self.period
        count = round((moment - self.base) / self.cost) + repetitions * round(self.period / self.cost)
        return self.base + count * self.cost


class Records(Sequence[T], Generic[T]):
    """Records that are read like a list, by number from `first`, and made when they are read."""

    @property
    def first(self) -> int:
        """The number of the oldest record that is left."""
        raise NotImplementedError

    def between(self, first: int, past: int) -> Iterator[T]:
        """Yield the records from `first` to `past` (exclusive)."""
        raise NotImplementedError

    @overload
    def __getitem__(self, index: int) -> T: ...

    @overload
    def __getitem__(self, index: slice) -> list[T]: ...

    def __getitem__(self, index: int | slice) -> T | list[T]:
        if isinstance(index, slice):
            numbers = range(len(self))[index]
            if numbers.step == 1:
                return list(self.between(max(numbers.start, self.first), numbers.stop))
            return [self[number] for number in numbers if number >= self.first]
        number = index + len(self) if index < 0 else index
        if not self.first <= number < len(self):
            raise IndexError(index)
        return next(self.between(number, number + 1))

    def __iter__(self) -> Iterator[T]:
        return self.between(self.first, len(self))


class Stream(Records[T]):
    """Records of one kind, a `NamedTuple`, read as a sequence; a run only calls `add` and `repeat`."""

    # The attributes that `cut` restores.
    GROWING: tuple[str, ...] = ("_sealed", "_open", "_rows", "_repetitions", "_loaded")

    def __init__(self, store: Store, kind: type[T]) -> None:
        self._store, self._kind = store, kind
        self._layout = layout(kind)
        self._moments = [name for name in kind._fields if name in _MOMENTS]  # type: ignore[attr-defined]
        self._sealed: list[Chunk] = []
        self._open = self._new_chunk(0)
        # The number of rows, and the repetitions between them.
        self._rows = 0
        self._repetitions: list[Repetition] = []
        # The first row that is left, and the number of its record.
        self._oldest = 0, 0
        # The sealed chunk that was read last, with its columns.
        self._loaded = self._open
        # Called with each record that is added, for what ends a run.
        self.heard: Callable[[tuple[Any, ...]], None] | None = None

    @property
    def fields(self) -> tuple[str, ...]:
        """The names of the fields of a record."""
        return self._kind._fields  # type: ignore[attr-defined, no-any-return]

    # ------------------------------------------------------------------------------------------- writing

    def add(self, row: tuple[Any, ...]) -> None:
        """Append a record, given by its fields."""
        for column, value in zip(self._open.columns, row, strict=True):
            column.append(value)
        self._rows += 1
        if self._rows - self._open.first >= CHUNK:
            self._seal()
        if self.heard is not None:
            self.heard(row)

    def repeat(self, first: int, times: int, period: float, base: float = 0.0, cost: float = 0.0) -> None:
        """Append the records from number `first` on so many times again, as `Repetition` says."""
        past = len(self)
        if first < past and times:
            self._repetitions.append(Repetition(first, past, times, period, base, cost, self._rows))

    def _new_chunk(self, first: int) -> Chunk:
        return Chunk(first, tuple([column(self._store.words) for column in self._layout]))

    def _seal(self) -> None:
        first, arrays = self._open.first, self._open.arrays
        location = self._store.put(b"".join([each.tobytes() for each in arrays]))
        self._sealed.append(Chunk(first, (), location, tuple(map(len, arrays))))
        self._open = self._new_chunk(self._rows)

    def finish_updates(self) -> None:
        """Drop an incomplete row or chunk after an interrupt."""
        if self._sealed and self._sealed[-1].first == self._open.first:
            del self._sealed[-1]
        for column in self._open.columns:
            column.cut(self._rows - self._open.first)

    # ------------------------------------------------------------------------------------------- reading

    @property
    def first(self) -> int:
        """The number of the oldest record that is left."""
        return self._oldest[1]

    def __len__(self) -> int:
        return self._number(self._rows)

    def __bool__(self) -> bool:
        return self.first < len(self)

    def between(self, first: int, past: int) -> Iterator[T]:
        """Yield the records from `first` to `past` (exclusive)."""
        for repetition, begin, end in self._parts(first, past):
            if repetition is None:
                yield from self._written(begin, end)
                continue
            length = repetition.past - repetition.first
            while begin < end:
                k, offset = divmod(begin - repetition.past, length)
                count = min(length - offset, end - begin)
                original = repetition.first + offset
                for record in self.between(original, original + count):
                    yield self._moved(record, repetition, k + 1)
                begin += count

    def written(self) -> Iterator[T]:
        """Yield the records without their repetitions."""
        return self._written(self._oldest[0], self._rows)

    def condensed(self, most: int) -> Iterator[tuple[T, int]]:
        """Yield records that stand for so many each: if more than `most` are repeated, for several repetitions."""
        total = len(self) - self.first - (self._rows - self._oldest[0])
        return self._condensed(self.first, len(self), max(1, -(-total // most)))

    def _condensed(self, first: int, past: int, at_once: int) -> Iterator[tuple[T, int]]:
        for repetition, begin, end in self._parts(first, past):
            if repetition is None:
                yield from ((record, 1) for record in self._written(begin, end))
                continue
            if (begin, end) != (repetition.past, repetition.end):
                yield from ((record, 1) for record in self.between(begin, end))
                continue
            for k in range(1, repetition.times + 1, at_once):
                count = min(at_once, repetition.times + 1 - k)
                for record, inner in self._condensed(repetition.first, repetition.past, at_once):
                    yield self._moved(record, repetition, k), inner * count

    def _parts(self, first: int, past: int) -> Iterator[tuple[Repetition | None, int, int]]:
        """Yield what the records from `first` to `past` are: records of a repetition, or rows (None)."""
        k = bisect_right(self._repetitions, first, key=_begin)
        while first < past:
            last = self._repetitions[k - 1] if k else None
            if last is not None and first < last.end:
                end = min(last.end, past)
                yield last, first, end
            else:
                end = min(self._repetitions[k].past, past) if k < len(self._repetitions) else past
                row, number = self._oldest if last is None else (last.row, last.end)
                yield None, row + first - number, row + end - number
                k += 1
            first = end

    def _moved(self, record: Any, repetition: Repetition, repetitions: int) -> T:
        later = {name: repetition.later(getattr(record, name), repetitions) for name in self._moments}
        return record._replace(**later)  # type: ignore[no-any-return]

    def _written(self, first: int, past: int) -> Iterator[T]:
        """Yield the records of some rows."""
        make = self._kind._make  # type: ignore[attr-defined]
        while first < past:
            chunk, end = self._chunk_of(first)
            begin, end = first - chunk.first, min(past, end) - chunk.first
            yield from map(make, zip(*[column.read(begin, end) for column in chunk.columns], strict=True))
            first = chunk.first + end

    def _chunk_of(self, row: int) -> tuple[Chunk, int]:
        """Return the chunk with a row, and the number after its last row."""
        if row >= self._open.first:
            return self._open, self._rows
        k = bisect_right(self._sealed, row, key=_first) - 1
        sealed = self._sealed[k]
        if self._loaded.first != sealed.first or self._loaded is self._open:
            self._loaded = self._unsealed(sealed)
        return self._loaded, self._sealed[k + 1].first if k + 1 < len(self._sealed) else self._open.first

    def _unsealed(self, chunk: Chunk) -> Chunk:
        """Return a sealed chunk with its columns."""
        made, data, begin = self._new_chunk(chunk.first), self._store.get(chunk.location), 0
        for each, size in zip(made.arrays, chunk.sizes, strict=True):
            end = begin + size * each.itemsize
            each.frombytes(data[begin:end])
            begin = end
        return made

    def _number(self, row: int) -> int:
        k = bisect_right(self._repetitions, row, key=_row)
        last = self._repetitions[k - 1] if k else None
        before, number = self._oldest if last is None else (last.row, last.end)
        return number + row - before

    # ------------------------------------------------------------------------------------------- dropping

    def forget(self, retained: int) -> None:
        """Drop all but about `retained` newest rows; their records retain their numbers."""
        while self._sealed and self._rows - self._sealed[0].first > 2 * retained:
            self._store.drop(self._sealed.pop(0).location)
        if not self._sealed and self._rows - self._open.first > 2 * retained:
            rows = list(self._written(self._rows - retained, self._rows))
            self._open = self._loaded = self._new_chunk(self._rows - retained)
            self._rows -= retained
            for each in rows:
                self.add(each)  # type: ignore[arg-type]
        row = (self._sealed or [self._open])[0].first
        self._oldest = row, self._number(row)
        # A repetition goes with its originals, and so do the records before it.
        for k in reversed(range(len(self._repetitions))):
            if self._repetitions[k].first < self.first:
                last = self._repetitions[k]
                self._oldest = max(self._oldest, (last.row, last.end))
                del self._repetitions[: k + 1]
                break

    def extent(self) -> int:
        """Return what `cut` needs to drop all records that are added from now on."""
        return len(self)

    def cut(self, extent: int) -> None:
        """Drop the records that have been added since `extent` was taken."""
        while self._repetitions and self._repetitions[-1].past >= extent:
            del self._repetitions[-1]
        self._rows -= len(self) - extent
        while self._rows < self._open.first:
            last = self._sealed.pop()
            self._open = self._unsealed(last)
            self._store.drop(last.location)
        for column in self._open.columns:
            column.cut(self._rows - self._open.first)
        self._loaded = self._open


def _first(chunk: Chunk) -> int:
    return chunk.first


def _begin(repetition: Repetition) -> int:
    return repetition.past


def _row(repetition: Repetition) -> int:
    return repetition.row
