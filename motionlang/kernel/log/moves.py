"""The moves of a log: as objects, and the older ones as rows."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, cast

from motionlang.kernel.log.move import CONTINUED, LoggedMove
from motionlang.kernel.log.profiles import joined, parted
from motionlang.kernel.log.records import MoveRow
from motionlang.kernel.log.stream import CHUNK, Records, Store, Stream
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.controller.queue.action import Action

# The number of moves after which the oldest become rows, and how many of the newest do not.
MAX_OBJECTS, LEFT = 24_576, 8_192
# Pieces of continued entries that may wait to become rows.
MAX_WAITING = 16_000
# The action of a row that was a path, a jog or the like; its kind is not stored.
_OTHER = cast("Action", object())


class _Overlaid(LoggedMove):
    __slots__ = ()
    overlaid = True


class LoggedMoves(Records[LoggedMove]):
    """All moves in order of start; an older one is made from its row when it is read.

    A row retains everything except the `action`, of which only the existence is stored. A move in progress stays an
    object until it is over, even while its neighbours become rows. The motion of an axis in a move is in its track, and
    not stored twice.
    """

    # The attributes that `cut` restores.
    GROWING = ("packed", "_rows", "_tail", "_late")

    def __init__(self, store: Store) -> None:
        self._rows: Stream[MoveRow] = Stream(store, MoveRow)
        # The number of moves that are rows, and the others.
        self.packed = 0
        self._tail: list[LoggedMove] = []
        # Moves that were in progress when their neighbours became rows, by number.
        self._late: dict[int, LoggedMove] = {}
        self._waiting = 0  # pieces of continued entries that are no rows
        # The axes of the moves; none before power-up.
        self.axes: Mapping[int, Axis] = {}
        # Called with each move that is added, for what ends a run.
        self.heard: Callable[[LoggedMove], None] | None = None

    @property
    def first(self) -> int:
        """The number of the oldest move that is left."""
        return self._rows.first

    # ------------------------------------------------------------------------------------------- writing

    def add(self, move: LoggedMove) -> None:
        """Append a move."""
        self._tail.append(move)
        if len(self._tail) >= MAX_OBJECTS:
            self.pack(MAX_OBJECTS - LEFT)
        if self.heard is not None:
            self.heard(move)

    def pack(self, count: int) -> None:
        """Make rows of the `count` oldest objects."""
        live = self._live()
        while count > 0 and self._tail:
            chunk = self._tail[: min(CHUNK, count)]
            for number, move in enumerate(chunk, self.packed):
                if id(move) in live:
                    self._late[number] = move
                self._rows.add(_row(move, self.axes.get(move.axis), id(move) in live))
            self.packed, self._tail = self.packed + len(chunk), self._tail[len(chunk) :]
            count -= len(chunk)

    def split(self, move: LoggedMove, done: Profile, now: float, size: int) -> None:
        """Continue a move as another entry; the old one ends now, with the profile `done` of `size` pieces."""
        number = self.number(move)
        sealed = _move(_row(move, None, True), {})
        sealed.profile, sealed.ended = done, CONTINUED
        if number < self.packed:
            self._late[number] = sealed
        else:
            self._tail[number - self.packed] = sealed
        move.start_time, move.offset = now, 0.0
        self.add(move)
        self._waiting += size
        if self._waiting >= MAX_WAITING:
            self.pack(len(self._tail))
            self._waiting = 0

    def forget(self, retained: int) -> None:
        """Drop all but about `retained` newest moves; the others retain their numbers."""
        if len(self._tail) > 2 * retained:
            self.pack(len(self._tail) - retained)
        self._rows.forget(max(retained - len(self._tail), 0))
        self._late = {number: move for number, move in self._late.items() if number >= self.first}

    def finish_updates(self) -> None:
        """Drop incomplete rows after an interrupt."""
        self._rows.finish_updates()
        self._rows.cut(self.packed)

    def extent(self) -> tuple[int, dict[int, LoggedMove], dict[int, LoggedMove]]:
        """Return the number of moves, those that are late, and those in progress by their numbers."""
        live = self._live()
        numbers = {self.packed + k: move for k, move in enumerate(self._tail) if id(move) in live}
        return len(self), dict(self._late), numbers

    def cut(self, extent: tuple[int, dict[int, LoggedMove], dict[int, LoggedMove]]) -> None:
        """Drop later moves; those that were in progress are in progress again, as the same objects."""
        count, late, live = extent
        first = min((self.packed, count, *live))
        self._tail[:0] = self.between(first, self.packed)
        del self._tail[count - first :]
        for number, move in live.items():
            self._tail[number - first] = move
        self._rows.cut(first)
        self.packed, self._late = first, dict(late)

    # ------------------------------------------------------------------------------------------- reading

    def __len__(self) -> int:
        return self.packed + len(self._tail)

    def between(self, first: int, past: int) -> Iterator[LoggedMove]:
        """Yield the moves from number `first` to `past` (exclusive)."""
        for number, row in enumerate(self._rows.between(first, min(past, self.packed)), first):
            late = self._late.get(number)
            yield _move(row, self.axes) if late is None else late
        yield from self._tail[max(first - self.packed, 0) : max(past - self.packed, 0)]

    def rows(self) -> Iterator[MoveRow | LoggedMove]:
        """Yield all moves, the older ones as they are stored, which have no profile."""
        for number, row in enumerate(self._rows, self.first):
            yield self._late.get(number, row)
        yield from self._tail

    def newest(self, most: int) -> list[LoggedMove]:
        """Return the newest moves that are objects, at most so many; another thread may call it during a run."""
        return self._tail[-most:]

    def number(self, move: LoggedMove) -> int:
        """Return the number of a move in progress."""
        for index in range(len(self._tail) - 1, -1, -1):
            if self._tail[index] is move:
                return self.packed + index
        return next(number for number, each in self._late.items() if each is move)

    def moved(self) -> set[int]:
        """Return the axes that have moved."""
        return {row.axis for row in self._rows} | {move.axis for move in self._tail}

    def _live(self) -> set[int]:
        """Return the identities of the moves in progress."""
        moves = [move for a in self.axes.values() for move in a.entries]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        return {id(move) for move in (*moves, *on_top)}


def _row(move: LoggedMove, a: Axis | None, is_live: bool) -> MoveRow:
    """Return a move as a row; a complete profile of the track is stored as its number."""
    number = None if a is None or is_live else _number(a, move)
    form, numbers = parted(None if is_live or number is not None else move.profile)
    return MoveRow(
        move.axis, move.command, move.line, move.target, move.commanded_speed, move.start_time, move.scale,
        move.ended, move.zero, move.offset, move.action is not None, move.overlaid, number, form, numbers,
        move.chain,
    )  # fmt: skip


def _move(row: MoveRow, axes: Mapping[int, Axis]) -> LoggedMove:
    move = (_Overlaid if row.overlaid else LoggedMove)(row.axis, row.command, row.line, row.target)
    move.commanded_speed, move.start_time, move.scale = row.commanded_speed, row.start_time, row.scale
    move.ended, move.zero, move.offset, move.chain = row.ended, row.zero, row.offset, row.chain
    move.action = _OTHER if row.acts else None
    if row.number is not None:
        move.profile = axes[row.axis].profile(row.number)
    else:
        move.profile = joined(row.form, row.numbers)
    return move


def _number(a: Axis, move: LoggedMove) -> int | None:
    """Return the number of the profile of the track that is the whole move, or None."""
    k = bisect_right(a.starts, move.start_time) - 1
    while k >= 0 and a.starts[k] == move.start_time:
        if a.profiles[k] is move.profile:
            return k + (0 if a.older is None else a.older.count)
        k -= 1
    return None
