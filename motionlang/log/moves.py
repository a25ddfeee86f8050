"""The moves of a log: as they are, as rows where nobody has looked at them yet, and packed."""

from __future__ import annotations

from marshal import dumps, loads

from motionlang import log as record
from motionlang.controller.move import Move
from motionlang.log.plain_moves import move_of
from motionlang.log.stream import Stream

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.log.log import Log
    from motionlang.log.older_profiles import Profiles
    from motionlang.log.plain_moves import Row
    from motionlang.log.stream import Place, Store
    from motionlang.planners import Profile

# Pieces of entries that were continued which may wait for being packed.
MOST_WAITING = 16_000


class Moves(Stream[Move]):
    """Moves as they are; of one that is packed all is kept but its `action`: only whether it has one.

    A move that is under way as its neighbours are packed stays as it is until it is over. What an axis did by a move is
    in its track, and not packed twice.
    """

    __slots__ = ("_left_out", "_store", "_waiting", "axes")

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        # Moves that were under way as their neighbours were packed; where they lie, when they have been packed since.
        self._left_out: dict[int, Move | Place] = {}
        self._waiting = 0  # pieces of continued entries that are not packed
        # The axes whose moves these are; none before power-up.
        self.axes: Mapping[int, Axis] = {}

    def show(self, row: Row, move: Move) -> None:
        """Somebody looks at a plain move: from now on it is the `Move` that he sees."""
        place = self._place(row)
        if place >= 0:
            self.tail[place] = move

    def has(self, row: Row) -> bool:
        """Whether a plain move that begins now is in the log."""
        return any(each is row for each in reversed(self.tail))  # type: ignore[comparison-overlap]

    def pack(self, count: int) -> None:
        """Pack the oldest records of the tail, so many of them."""
        self._live()  # looks at all that is under way
        super().pack(count)

    def __iter__(self) -> Iterator[Move]:
        for number in range(len(self._parts)):
            yield from self._parts.part(number)
        self._live()
        rows: list[Any] = self.tail[:]
        for each in rows:  # one at a time, as who goes through many wants none of them back
            yield move_of(each) if each.__class__ is tuple else each

    def number(self, move: Move) -> int:
        """The number of the entry that a move under way has in the log."""
        place = self._place(move)
        if place >= 0:
            return self.packed + place
        return next(number for number, each in self._left_out.items() if each is move)

    def as_kept(self) -> Iterator[Move | Row]:
        """All of them, the plain ones that are not packed as rows."""
        self._live()
        return super().as_kept()

    def moved(self) -> set[int]:
        """The axes that have moved."""
        parts = (self._parts.part(number) for number in range(len(self._parts)))
        found = {move.axis for part in parts for move in part}
        rows: list[Any] = self.tail
        return found | {each[0] if each.__class__ is tuple else each.axis for each in rows}

    def _newest(self, place: int) -> Move:
        tail: list[Any] = self.tail
        self._live()
        if tail[place].__class__ is tuple:
            tail[place] = move_of(tail[place])
        return tail[place]  # type: ignore[no-any-return]

    def _typed(self, rows: list[Any]) -> list[Move]:
        self._live()
        return [move_of(each) if each.__class__ is tuple else each for each in rows]

    def split(self, move: Move, done: Profile, now: float) -> None:
        """A move goes on as another entry: the one that it was keeps what it has done up to now."""
        sealed, place = record.move_rows.sealed(move, done), self._place(move)
        if place >= 0:
            self.tail[place] = sealed
        else:
            self._left_out[self.number(move)] = sealed
        move.start_time, move.offset = now, 0.0
        self.add(move)
        self._waiting += len(done.knots)
        if self._waiting >= MOST_WAITING:
            self.pack(len(self) - self.packed)
            self._waiting = 0

    def _place(self, record: Move | Row) -> int:
        """Where a record is in the tail; -1 where it is not."""
        tail = self.tail
        for place in range(len(tail) - 1, -1, -1):
            if tail[place] is record:
                return place
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

    def _late(self, left_out: Move | Place) -> Move:
        if isinstance(left_out, Move):
            return left_out
        return record.move_rows.move_of(loads(self._store.get(left_out)), self.axes)

    def _live(self) -> set[int]:
        """The identities of the moves that are under way."""
        moves = [move for a in self.axes.values() for move in a.entries]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        return {id(move) for move in (*moves, *on_top)}


def power_up(log: Log, axes: Mapping[int, Axis]) -> None:
    """A controller with these axes begins to write into a log."""
    log.moves.axes = log.dropped.axes = axes
    log.older = _older_profiles


def _older_profiles(store: Store) -> Profiles:
    return record.older_profiles.Profiles(store)
