"""The moves of a log: as objects, and packed."""

from __future__ import annotations

from marshal import dumps, loads

from motionlang import log as record
from motionlang.controller.move import Move
from motionlang.log.stream import Stream

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.log.log import Log
    from motionlang.log.older_profiles import Profiles
    from motionlang.log.stream import ChunkLocation, Store
    from motionlang.planners import Profile

# Pieces of continued entries that may wait to be packed.
MAX_WAITING = 16_000


class Moves(Stream[Move]):
    """The stream of moves; a packed move retains everything except its `action`.

    Only the existence of the action is stored. A move in progress stays unpacked until it is over, even while
    its neighbours are packed. The motion of an axis in a move is in its track, and not packed twice.
    """

    __slots__ = ("_left_out", "_store", "_waiting", "axes")

    GROWING = (*Stream.GROWING, "_left_out")

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        # Moves in progress while their neighbours were packed, and their positions if they have been packed
        # since.
        self._left_out: dict[int, Move | ChunkLocation] = {}
        self._waiting = 0  # pieces of continued entries that are not packed
        # The axes of the moves; none before power-up.
        self.axes: Mapping[int, Axis] = {}

    def pack(self, count: int) -> None:
        """Pack the `count` oldest records of the tail."""
        self._live()  # checks all moves in progress
        super().pack(count)

    def extent(self) -> Any:
        """Return the number of moves, those left out of chunks, and those in progress by their numbers."""
        live = self._live()
        numbers = {self.packed + k: move for k, move in enumerate(self.tail) if id(move) in live}
        return len(self), dict(self._left_out), numbers

    def cut(self, extent: Any) -> None:
        """Drop later moves; those that were in progress are in progress again, as the same objects."""
        count, left_out, live = extent
        self._cut(count, min(live, default=count))
        self._left_out = dict(left_out)
        for number, move in live.items():
            self.tail[number - self.packed] = move

    def __iter__(self) -> Iterator[Move]:
        for number in range(len(self._chunks)):
            yield from self._chunks.chunk(number)
        self._live()
        yield from self.tail[:]

    def number(self, move: Move) -> int:
        """Return the log number of a move in progress."""
        index = self._tail_index(move)
        if index >= 0:
            return self.packed + index
        return next(number for number, each in self._left_out.items() if each is move)

    def moved(self) -> set[int]:
        """Return the axes that have moved."""
        chunks = (self._chunks.chunk(number) for number in range(len(self._chunks)))
        return {move.axis for chunk in (*chunks, self.tail) for move in chunk}

    def _newest(self, index: int) -> Move:
        self._live()
        return self.tail[index]

    def _typed(self, rows: list[Any]) -> list[Move]:
        self._live()
        return list(rows)

    def split(self, move: Move, done: Profile, now: float, size: int) -> None:
        """Continue a move as another entry; the old one ends now, with the profile `done`.

        The old entry has `size` pieces.
        """
        sealed, index = record.move_rows.sealed(move, done), self._tail_index(move)
        if index >= 0:
            self.tail[index] = sealed
        else:
            self._left_out[self.number(move)] = sealed
            self._chunks.reread()
        move.start_time, move.offset = now, 0.0
        self.add(move)
        self._waiting += size
        if self._waiting >= MAX_WAITING:
            self.pack(len(self) - self.packed)
            self._waiting = 0

    def _tail_index(self, record: Move) -> int:
        """Return the index of a record in the tail; -1 if it is not in it."""
        tail = self.tail
        for index in range(len(tail) - 1, -1, -1):
            if tail[index] is record:
                return index
        return -1

    def _rows(self, records: list[Move], first: int) -> list[Any]:
        live, tracks = self._live(), self.axes
        for number, each in self._left_out.items():
            if isinstance(each, Move) and id(each) not in live:
                self._left_out[number] = self._store.put(dumps(record.move_rows.row(each, None)))  # type: ignore[arg-type]
        rows: list[tuple[object, ...] | None] = []
        for number, move in enumerate(self._typed(records), first):
            if id(move) in live:
                self._left_out[number] = move
                rows.append(None)
                continue
            rows.append(record.move_rows.row(move, tracks.get(move.axis)))
        return rows

    def _records(self, rows: list[Any], first: int) -> list[Move]:
        return [
            self._late(self._left_out[number]) if row is None else record.move_rows.move_of(row, self.axes)
            for number, row in enumerate(rows, first)
        ]

    def _late(self, left_out: Move | ChunkLocation) -> Move:
        if isinstance(left_out, Move):
            return left_out
        return record.move_rows.move_of(loads(self._store.get(left_out)), self.axes)

    def _live(self) -> set[int]:
        """Return the identities of the moves in progress."""
        moves = [move for a in self.axes.values() for move in a.entries]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        return {id(move) for move in (*moves, *on_top)}


def power_up(log: Log, axes: Mapping[int, Axis]) -> None:
    """Connect the axes of a controller to a log."""
    log.moves.axes = log.dropped.axes = axes
    log.older = _older_profiles


def _older_profiles(store: Store) -> Profiles:
    return record.older_profiles.Profiles(store)
