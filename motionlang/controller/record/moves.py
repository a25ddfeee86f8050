"""The moves of a log, and the older profiles of its axes: both as they are packed."""

from __future__ import annotations

from _bisect import bisect_right
from marshal import dumps, loads

from motionlang.controller.move import CONTINUED, Action, Move
from motionlang.controller.plain_moves import move_of
from motionlang.controller.record.stream import PART, Parts, Place, Store, Stream
from motionlang.profile.packed import packed, unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.controller.plain_moves import Row
    from motionlang.controller.record.log import Log
    from motionlang.profile import Profile

# What a move is told by that was a path, a jog or the like: what it was is not kept.
_OTHER = Action()
# Velocities at both ends, which are all of a recipe that is none of ramps.
_ENDS = 2
# Pieces of entries that were continued which may wait for being packed.
MOST_WAITING = 16_000


class Moves(Stream[Move]):
    """Moves as they are; of one that is packed all is kept but its `action`: only whether it has one.

    A move that is under way as its neighbours are packed stays as it is until it is over. What an axis did by a move is
    in its track, and not packed twice.
    """

    __slots__ = ("_left_out", "_store", "_waiting", "axes")

    def __init__(self, store: Store, axes: Mapping[int, Axis]) -> None:
        super().__init__(store)
        self._store = store
        # Moves that were under way as their neighbours were packed; where they lie, when they have been packed since.
        self._left_out: dict[int, Move | Place] = {}
        self._waiting = 0  # pieces of continued entries that are not packed
        self.axes = axes

    def show(self, row: Row, move: Move) -> None:
        """Somebody looks at a plain move: from now on it is the `Move` that he sees."""
        tail = self.tail
        for place in range(len(tail) - 1, -1, -1):
            if tail[place] is row:  # type: ignore[comparison-overlap]
                tail[place] = move
                return

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
        self._replace(move, _sealed(move, done))
        move.start_time, move.offset = now, 0.0
        self.add(move)
        self._waiting += len(done.knots)
        if self._waiting >= MOST_WAITING:
            self.pack(len(self) - self.packed)
            self._waiting = 0

    def _replace(self, move: Move, other: Move) -> None:
        tail = self.tail
        for place in range(len(tail) - 1, -1, -1):
            if tail[place] is move:
                tail[place] = other
                return
        for number, each in self._left_out.items():
            if each is move:
                self._left_out[number] = other
                return

    def _rows(self, records: list[Move], first: int) -> list[Any]:
        live, tracks = self._live(), self.axes
        for number, each in self._left_out.items():
            if isinstance(each, Move) and id(each) not in live:
                self._left_out[number] = self._store.put(dumps(_row(each, None)))  # type: ignore[arg-type]
        rows: list[tuple[object, ...] | None] = []
        for number, move in enumerate(self._typed(records), first):
            if id(move) in live:
                self._left_out[number] = move
                rows.append(None)
                continue
            a = tracks.get(move.axis)
            rows.append(_row(move, None if a is None else _place(a, move)))
        return rows

    def _records(self, rows: list[Any], first: int) -> list[Move]:
        return [
            self._late(self._left_out[number]) if row is None else self._move(row)
            for number, row in enumerate(rows, first)
        ]

    def _late(self, left_out: Move | Place) -> Move:
        if isinstance(left_out, Move):
            return left_out
        return self._move(loads(self._store.get(left_out)))

    def _live(self) -> set[int]:
        """The identities of the moves that are under way."""
        moves = [a.move for a in self.axes.values() if a.move is not None]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        return {id(move) for move in (*moves, *on_top)}

    def _move(self, row: tuple[Any, ...]) -> Move:
        (
            axis,
            command,
            line,
            target,
            asked,
            start_time,
            scale,
            zero,
            ended,
            offset,
            other,
            overlaid,
            profile,
        ) = row
        move = (_Overlaid if overlaid else Move)(axis, command, line, target)
        move.start_time, move.scale, move.zero = start_time, scale, zero or 0.0
        move.ended, move.offset = ended, offset or 0.0
        move.asked = asked
        if other:
            move.action = _OTHER
        if profile is not None:
            of_track = isinstance(profile, int)
            move.profile = _profile(self.axes[axis], profile) if of_track else unpacked(profile)
        return move


def _sealed(move: Move, done: Profile) -> Move:
    """What a move was until now, when it goes on as another entry."""
    made = (_Overlaid if move.overlaid else Move)(move.axis, move.command, move.line, move.target)
    made.start_time, made.scale, made.zero, made.offset = move.start_time, move.scale, move.zero, move.offset
    made.profile, made.ended, made.asked = done, CONTINUED, move.asked
    made.action = None if move.action is None else _OTHER
    return made


class _Overlaid(Move):
    __slots__ = ()
    overlaid = True


def _row(move: Move, place: int | None) -> tuple[object, ...]:
    profile: object = place
    if place is None and move.profile is not None:
        profile = packed(move.profile)
    return (
        move.axis,
        move.command,
        move.line,
        move.target,
        move.asked,
        move.start_time,
        move.scale,
        move.zero or None,
        move.ended,
        move.offset or None,
        move.action is not None,
        move.overlaid,
        profile,
    )


def _place(a: Axis, move: Move) -> int | None:
    """The number of the profile in the track of the axis that is all of a move; None where there is none."""
    k = bisect_right(a.starts, move.start_time) - 1
    while k >= 0 and a.starts[k] == move.start_time:
        if _is_of(a.profiles[k], move.profile):
            return k + (0 if a.older is None else a.older.count)
        k -= 1
    return None


def _is_of(profile: Profile, other: Profile | None) -> bool:
    """Whether they are one, or one is what the row of a plain move tells of the other."""
    return profile is other or (
        other is not None and len(profile._recipe) > _ENDS and profile._recipe is other._recipe
    )


def _profile(a: Axis, number: int) -> Profile:
    """A profile of the track of an axis."""
    older = a.older
    packed_ones = 0 if older is None else older.count
    if number >= packed_ones:
        return a.profiles[number - packed_ones]
    assert older is not None
    return older.profile(number)


class Profiles:
    """The older profiles of an axis, packed: `count` of them, each with the time at which it began."""

    __slots__ = ("_begins", "_parts", "_total")

    def __init__(self, store: Store) -> None:
        self._total = 0  # how many profiles the axis has, while a packed part takes the place of some
        self._parts = Parts(store, lambda rows, _: rows)
        # When the first profile of each part began.
        self._begins: list[float] = []

    @property
    def count(self) -> int:
        """How many there are."""
        return self._parts.count

    @property
    def first(self) -> int:
        """The number of the oldest that is kept."""
        return self._parts.first

    def take_from(self, a: Axis, most: int) -> int:
        """Pack a part of the axis's profiles, the oldest ones, at most so many of them: how many those were."""
        count = min(PART, most)
        starts, profiles = a.starts[:count], a.profiles[:count]
        place = self._parts.pack(list(zip(starts, map(packed, profiles), strict=True)))
        self._total = self.count + len(a.starts)
        self._parts.append(place, len(starts))
        self._begins.append(starts[0])
        del a.starts[:count]
        del a.profiles[:count]
        self._total = 0
        return count

    def keep_whole(self, a: Axis) -> None:
        """Complete what was half packed, or forget that part, as somebody ended the run at that moment."""
        self._parts.keep_whole()
        del self._begins[len(self._parts) :]
        if len(self._begins) < len(self._parts):
            self._begins.append(self.start(self._parts.firsts[-1]))
        if self._total:
            for track in a.starts, a.profiles:
                del track[: self.count + len(track) - self._total]
            self._total = 0

    def __iter__(self) -> Iterator[tuple[float, Profile]]:
        for number in range(len(self._parts)):
            for start, row in self._parts.part(number):
                yield start, unpacked(row)

    def start(self, number: int) -> float:
        """When a profile began."""
        start: float = self._parts.record(number)[0]
        return start

    def profile(self, number: int) -> Profile:
        """A profile."""
        return unpacked(self._parts.record(number)[1])

    def forget(self, time: float) -> None:
        """Forget what was over at a time; the numbers of the others stay what they are."""
        while len(self._begins) > 1 and self._begins[1] <= time:
            self._parts.forget()
            del self._begins[0]

    def in_force(self, time: float) -> int:
        """The number of the profile that was in force at a time; that of the first one where none was."""
        part = max(bisect_right(self._begins, time) - 1, 0)
        rows = self._parts.part(part)
        return max(self._parts.firsts[part] + bisect_right(rows, time, key=_start) - 1, 0)


def _start(row: tuple[float, object]) -> float:
    return row[0]


def power_up(log: Log, axes: Mapping[int, Axis]) -> None:
    """A controller with these axes begins to write into a log."""
    log.moves, log.dropped, log.older = Moves(log.store, axes), Moves(log.store, axes), Profiles
    for a in axes.values():
        a.logged = log.moves
