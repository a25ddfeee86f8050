"""Streams of a log: records of one kind in time order, older ones packed.

Problem. A run may take weeks of machine time and write millions of records. They are read like a list, during
the run and after it, and must not fill the memory. Writing one happens while the program runs and must be
cheap.

Idea. The newest records stay in a list, the tail. When the tail is long, its oldest records are packed into
chunks. A chunk is one `marshal` of plain tuples. The first 16 MB of chunks stay in memory, the others go to a
file. Reading a packed record brings back its whole chunk.

    record      0          2048       4096               count               len
                ├─ chunk ──┼─ chunk ──┼─ … ──────────────┼────── tail ───────┤
                  memory     memory     file               list of up to 24 576

Data. `Store` has the bytes of all streams of a log. `Chunks` has the chunks of one stream: the number of the
first record of each, and where its bytes are. `Stream` is the sequence that callers see. A record is written
as a plain tuple and read as the named tuple of its kind (`records.py`). A subclass whose records are objects,
such as moves, defines in `_rows` and `_records` how they become tuples and objects again. A chunk may also be a
template of records that repeat (`repeated.py`) or that follow from a motion (`sampled.py`).

Invariants.
- Records are only appended, until `cut` goes back to an earlier time, and packed ones never change. A record
  keeps its number when it is packed, and when older ones are dropped (`forget`); `first` is then the oldest
  that is left.
- Packed records read the same as others, but an object is created again when its chunk is unpacked again.
- An interrupt at any time leaves the stream consistent. `Chunks.pack` sets `_total` while a chunk replaces
  records of the tail, and `finish_updates` completes that step or drops the chunk.
- The file has no name, so it is gone when the process ends, however that happens. If it exceeds `DISK` bytes
  or cannot be written, the run ends with a diagnostic.

Cost. Writing is one append; every 16 384 records the oldest are packed. Reading from one end to the other
unpacks each chunk once. A single old record costs a bisection and the unpacking of its chunk; a stream caches
its last one. Memory is bounded by 16 MB for the log, and one tail and one chunk for each stream.
"""

from __future__ import annotations

from bisect import bisect_right
from itertools import chain
from marshal import dumps, loads

from motionlang.controller.faults import Rejected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import IO, Any, Generic, TypeVar, overload

    from motionlang.log.repeated import Pace, Shape
    from motionlang.log.sampled import Template

    T = TypeVar("T")
    # The location of a packed chunk: its bytes, or offset and length in the file.
    ChunkLocation = bytes | tuple[int, int]

    class _Of(Generic[T]):
        """A generic base."""
else:
    # Importing typing takes longer than a short run.
    T = ChunkLocation = None

    class _Of:
        """A generic base."""

        __slots__ = ()

        def __class_getitem__(cls, item):
            return cls


# Bytes of packed records stored in memory; later ones are on the disk.
MEMORY = 16_000_000
# Default bytes that a log may have on the disk before the run ends.
DISK = 8_000_000_000
# Unpacked records of a stream, before and after packing.
MAX_TAIL, LEFT = 24_576, 8_192
# Records of a packed chunk.
CHUNK_SIZE = 2048


class Store:
    """Packed chunks of a log: up to `memory` bytes in memory, then in an unnamed file.

    The file disappears when the process ends, however that happens. Raises Rejected if the file would exceed
    `disk` bytes or cannot be written.
    """

    __slots__ = ("__weakref__", "_file", "_written", "disk", "in_memory", "memory")

    def __init__(self, memory: int = MEMORY, disk: int = DISK) -> None:
        self.memory, self.disk = memory, disk
        self.in_memory = self._written = 0
        self._file: IO[bytes] | None = None

    @property
    def size(self) -> int:
        """Packed bytes, in memory and on the disk."""
        return self.in_memory + self._written

    def put(self, chunk: bytes) -> ChunkLocation:
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
            from motionlang.files import reason

            words = f"the log of the run cannot be written: {reason(problem)}"
            raise Rejected("limit", words, "shorten the run with --until, or free disk space") from None
        location = self._written, size
        self._written += size
        return location

    def _append(self, chunk: bytes) -> None:
        if self._file is None:
            from weakref import finalize

            from motionlang.files import scratch

            self._file = scratch()
            finalize(self, self._file.close)  # before the file itself, if both are in a cycle
        self._file.seek(self._written)
        self._file.write(chunk)

    def get(self, location: ChunkLocation) -> bytes:
        """Return a chunk."""
        if isinstance(location, bytes):
            return location
        assert self._file is not None
        self._file.seek(location[0])
        return self._file.read(location[1])

    def drop(self, location: ChunkLocation) -> None:
        """Drop a chunk; its space on disk is not reused."""
        if isinstance(location, bytes):
            self.in_memory -= len(location)


class Chunks:
    """Packed records in chunks; `count` is the number after the last record."""

    __slots__ = ("_cached", "_locations", "_read", "_store", "_total", "count", "firsts")

    def __init__(self, store: Store, read: Callable[[list[Any], int], list[Any]]) -> None:
        """Take a function `read(rows, first)` that creates records from packed rows.

        `first` is the number of the first record.
        """
        self._store, self._read = store, read
        self.firsts: list[int] = []
        self._locations: list[ChunkLocation] = []
        self.count = 0
        self._total = 0  # packed records plus those of a tail, while a chunk replaces some
        self._cached: tuple[int, Sequence[Any]] = (-1, [])

    def __len__(self) -> int:
        return len(self._locations)

    @property
    def first(self) -> int:
        """The number of the oldest record that is stored."""
        return self.firsts[0] if self.firsts else self.count

    def pack(self, rows: list[Any], *tails: list[Any]) -> None:
        """Pack a chunk in place of the oldest records of each tail.

        Raises Rejected if there is no space.
        """
        location, count = self._store.put(dumps(rows)), len(rows)
        self._total = self.count + len(tails[0])
        self._locations.append(location)
        self.firsts.append(self.count)
        self.count += count
        for tail in tails:
            del tail[:count]
        self._total = 0

    def finish_updates(self, *tails: list[Any]) -> None:
        """Complete partial packing after an interrupt, or drop the chunk."""
        while self.firsts and self.firsts[-1] >= self.count:
            del self.firsts[-1]
        del self._locations[len(self.firsts) :]
        if self._total:
            for tail in tails:
                del tail[: self.count + len(tail) - self._total]
            self._total = 0

    def add_template(self, kind: str, template: tuple[Any, ...], count: int) -> None:
        """Store a chunk of `count` records that are created from a template on reading.

        `kind` is "repeated" or "sampled".
        """
        self._locations.append(self._store.put(dumps((kind, template))))
        self.firsts.append(self.count)
        self.count += count

    def chunk(self, number: int) -> Sequence[Any]:
        """Return the records of a chunk."""
        first = self.firsts[number]
        if self._cached[0] != first:
            rows: Any = loads(self._store.get(self._locations[number]))
            if rows.__class__ is tuple:
                kind, template = rows
                rows = _from_template(kind, template, lambda made: self._read(made, first))
            else:
                rows = self._read(rows, first)
            self._cached = first, rows
        return self._cached[1]

    def cut(self, number: int) -> None:
        """Drop the chunks from `number` on."""
        for location in self._locations[number:]:
            self._store.drop(location)
        self.count = self.firsts[number]
        del self._locations[number:], self.firsts[number:]
        self.reread()

    def reread(self) -> None:
        """Discard the cached chunk, because one of its records has changed."""
        self._cached = -1, []

    def record(self, index: int) -> Any:
        """Return a record by its number; IndexError if it is not stored."""
        number = bisect_right(self.firsts, index) - 1
        if number < 0:
            raise IndexError(index)
        return self.chunk(number)[index - self.firsts[number]]

    def records(self, first: int, past: int) -> list[Any]:
        """Return the records from `first`, which must be stored, to `past` (exclusive)."""
        found: list[Any] = []
        number = bisect_right(self.firsts, first) - 1
        while first < past:
            begin, chunk = self.firsts[number], self.chunk(number)
            found += chunk[first - begin : past - begin]
            first, number = begin + len(chunk), number + 1
        return found

    def forget(self) -> int:
        """Drop the oldest chunk and return how many records it had."""
        dropped = (self.firsts[1] if len(self.firsts) > 1 else self.count) - self.firsts[0]
        self._store.drop(self._locations.pop(0))
        del self.firsts[0]
        return dropped


class Stream(_Of[T]):
    """Records of one kind, read as a sequence; a run only calls `add`.

    A record is written as a plain tuple of numbers, texts and tuples, and read as the type of that name in
    `records`, if there is one. A subclass that stores other objects defines how they are packed.
    """

    __slots__ = ("_chunks", "_kind", "tail")

    # The attributes that `cut` restores.
    GROWING: tuple[str, ...] = ("tail", "_chunks")

    def __init__(self, store: Store, kind: str = "") -> None:
        self._kind = kind
        self._chunks = Chunks(store, self._records)
        # The newest records, which are not packed.
        self.tail: list[T] = []

    def add(self, record: T | tuple[object, ...]) -> None:
        """Append a record."""
        tail = self.tail
        tail.append(record)  # type: ignore[arg-type]
        if len(tail) >= MAX_TAIL:
            self.pack(MAX_TAIL - LEFT)

    def extend(self, records: Sequence[tuple[object, ...]]) -> None:
        """Append records."""
        for first in range(0, len(records), LEFT):
            self.tail.extend(records[first : first + LEFT])  # type: ignore[arg-type]
            if len(self.tail) >= MAX_TAIL:
                self.pack(len(self.tail) - LEFT)

    def repeat(self, shape: Shape, pace: Pace) -> None:
        """Append the records of actions that repeat, as one chunk (`repeated.py`)."""
        from motionlang.log.repeated import length

        if length(shape):
            self.pack(len(self.tail))
            self._chunks.add_template("repeated", (shape, pace), length(shape))

    def add_samples(self, template: Template) -> None:
        """Append samples of a moving axis, as one chunk (`sampled.py`)."""
        from motionlang.log.sampled import length

        self.pack(len(self.tail))
        self._chunks.add_template("sampled", template, length(template))

    @property
    def first(self) -> int:
        """The number of the oldest record that is stored."""
        return self._chunks.first

    @property
    def packed(self) -> int:
        """The number of records that are packed or dropped."""
        return self._chunks.count

    def __len__(self) -> int:
        return self._chunks.count + len(self.tail)

    def __bool__(self) -> bool:
        return bool(self.tail) or len(self._chunks) > 0

    def __iter__(self) -> Iterator[T]:
        for number in range(len(self._chunks)):
            yield from self._chunks.chunk(number)
        yield from self._typed(self.tail)

    def as_stored(self) -> Iterator[Any]:
        """Yield all records; unpacked ones are yielded as the plain tuples written."""
        chunks = map(self._chunks.chunk, range(len(self._chunks)))
        return chain(chain.from_iterable(chunks), self.tail)

    def __reversed__(self) -> Iterator[T]:
        yield from reversed(self._typed(self.tail))
        for number in reversed(range(len(self._chunks))):
            yield from reversed(self._chunks.chunk(number))

    if TYPE_CHECKING:

        @overload
        def __getitem__(self, index: int) -> T: ...

        @overload
        def __getitem__(self, index: slice) -> list[T]: ...

        def __getitem__(self, index: int | slice) -> T | list[T]: ...

    else:

        def __getitem__(self, index):
            if isinstance(index, slice):
                begin, end, step = index.indices(len(self))
                return [self[i] for i in range(max(begin, self._chunks.first), end, step)]
            index += len(self) if index < 0 else 0
            behind = index - self._chunks.count
            return self._newest(behind) if behind >= 0 else self._chunks.record(index)

    def forget(self, retained: int) -> None:
        """Drop all but about `retained` newest records; the others retain their numbers."""
        while len(self._chunks) and len(self) - self._chunks.first > 2 * retained:
            self._chunks.forget()
        if not len(self._chunks) and len(self.tail) > 2 * retained:
            dropped = len(self.tail) - retained
            del self.tail[:dropped]
            self._chunks.count += dropped

    def extent(self) -> Any:
        """Return what `cut` needs to drop all records that are added from now on."""
        return len(self)

    def cut(self, extent: Any) -> None:
        """Drop the records that have been added since `extent` was taken."""
        self._cut(extent, extent)

    def _cut(self, count: int, first: int) -> None:
        """Drop all but the first `count` records; unpack those from number `first` on."""
        chunks = self._chunks
        if first < chunks.count:
            number = max(bisect_right(chunks.firsts, first) - 1, 0)
            rows: list[Any] = chunks.records(chunks.firsts[number], min(count, chunks.count))
            self.tail[:0] = [tuple(row) if isinstance(row, tuple) else row for row in rows]  # type: ignore[misc]
            chunks.cut(number)
        del self.tail[count - chunks.count :]

    def pack(self, count: int) -> None:
        """Pack the `count` oldest records of the tail."""
        while count > 0 and self.tail:
            chunk = self.tail[: min(CHUNK_SIZE, count)]
            self._chunks.pack(self._rows(chunk, self._chunks.count), self.tail)
            count -= len(chunk)

    def finish_updates(self) -> None:
        """Complete partial packing after an interrupt, or drop the chunk."""
        self._chunks.finish_updates(self.tail)

    # ------------------------------------------------------------------------------- overridden by a subclass

    def _rows(self, records: list[T], first: int) -> list[Any]:
        """Return records in packed form; `first` is the number of the first one."""
        return records

    def _records(self, rows: list[Any], first: int) -> list[T]:
        """Return records from their packed form; `first` is the number of the first one."""
        return self._typed(rows)

    def _newest(self, index: int) -> T:
        """Return a record by its index in the tail."""
        return self._typed([self.tail[index]])[0]

    # -------------------------------------------------------------------------------------------- inside

    def _typed(self, rows: list[Any]) -> list[T]:
        if not self._kind:
            return rows
        if not rows:  # most reports have no event and need not import the type
            return []
        from motionlang.log.records import makers

        return list(map(makers[self._kind], rows))


def _from_template(kind: str, template: Any, make: Callable[[list[Any]], list[Any]]) -> Sequence[Any]:
    """Return the records of a template, which are created on reading."""
    if kind == "repeated":
        from motionlang.log.repeated import RepeatedRecords

        return RepeatedRecords(template, make)  # type: ignore[return-value]
    from motionlang.log.sampled import SampledRecords

    return SampledRecords(template, make)  # type: ignore[return-value]
