"""The move buffer of an axis: loading an entry, where it will end, and its removal."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove


def put(a: Axis, move: LoggedMove) -> None:
    """Load an entry, with a copy of the settings that apply to it."""
    if len(a.buffer) >= a.buffer_size:
        raise Rejected("buffer-full", f"the move buffer of axis {a.index} is full")
    a.buffer.append(stamped(a, move))


def counted(a: Axis, distance: float, command: str, line: int) -> LoggedMove:
    """Return an entry that ends `distance` from the end of the one before it."""
    base = end(a)
    move = LoggedMove(a.index, command, line, base + distance)
    if abs(base) < INFINITY:
        move.base = base
    return move


def resolve(a: Axis, move: LoggedMove) -> None:
    """Compute the end of a relative entry from the axis's position at its start."""
    move.target = _end_from(move, a.target)


def _end_from(move: LoggedMove, start: float) -> float:
    return move.target if move.base is None or move.base == start else move.target + (start - move.base)


def keep_ends(a: Axis, shift: float) -> None:
    """Preserve the ends of relative entries when the present move's end shifts."""
    for move in a.buffer:
        if move.base is None:
            return
        if move.action is None:
            move.base += shift
            return
        if move.action.keep_end(a, move, shift):
            return


def stamped(a: Axis, move: LoggedMove) -> LoggedMove:
    """Return the move with the axis's settings at the time of loading."""
    move.id, move.chain = a.move_id, a.controller.log.chain()
    mode = a.feedrate_mode
    if mode & 1:
        move.speed = a.speed
    move.overridden = mode > 1
    return move


def end(a: Axis) -> float:
    """Return the position of the axis once its buffer is empty.

    Relative moves count from there.
    """
    there = a.target
    for move in a.buffer:
        there = _end_from(move, there)
    return there


def known_end(a: Axis, words: str = "a relative move has no start") -> float:
    """Return `end`; raise Rejected, with `words`, while the axis is in a motion without an end."""
    there = end(a)
    if abs(there) < 1e300:
        return there
    motion = f" in {a.move.command}" if a.move is not None and a.move.command else ""
    raise Rejected("moving", f"axis {a.index} moves without an end{motion}: {words}", "stop it first")


def take(a: Axis, index: int = 0) -> None:
    """Remove an entry, by default the first one, from the buffer.

    The listeners are notified if the number of free entries then exceeds the level set.
    """
    a.last_id = a.buffer.pop(index).id
    if a.buffer_low >= 0 and a.buffer_size - len(a.buffer) == a.buffer_low + 1:
        a.controller.notify("buffer-low", a.index)


def motions(a: Axis) -> Iterator[LoggedMove]:
    """Return the entries other than outputs, which do not delay a path."""
    return (move for move in a.buffer if move.action is None or not move.action.is_instant)


def motion_at(a: Axis, index: int) -> LoggedMove | None:
    """Return the entry with this index among `motions`; None if there is none."""
    return next(islice(motions(a), index, None), None)


def reach(a: Axis, move: LoggedMove) -> None:
    """Remove an entry from the buffer, and execute the outputs before it."""
    while a.buffer[0] is not move:
        head = a.buffer[0]
        assert head.action is not None
        take(a)
        head.action.begin(a, head)
    take(a)
