"""The moves of a log."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from motionlang.kernel.log.move import CONTINUED, LoggedMove
from motionlang.kernel.log.stream import Budget, Stream
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis


class LoggedMoves(Stream[LoggedMove]):
    """All moves in order of start."""

    size = 260

    def __init__(self, budget: Budget) -> None:
        super().__init__(budget)
        # The axes of the moves; none before power-up.
        self.axes: Mapping[int, Axis] = {}

    def split(self, move: LoggedMove, done: Profile, now: float) -> None:
        """Continue a move as another entry; the old one ends now, with the profile `done`."""
        sealed = LoggedMove(move.axis, move.command, move.line, move.target)
        sealed.commanded_speed, sealed.chain, sealed.action = move.commanded_speed, move.chain, move.action
        sealed.scale, sealed.zero, sealed.offset = move.scale, move.zero, move.offset
        sealed.start_time, sealed.profile, sealed.ended = move.start_time, done, CONTINUED
        # It is no longer there if it began before the oldest one left.
        k = next((k for k in reversed(range(len(self.rows))) if self.rows[k] is move), None)
        if k is not None:
            self.rows[k] = sealed
        move.start_time, move.offset = now, 0.0
        self.add(move)

    def extent(self) -> tuple[int, dict[int, LoggedMove]]:
        """Return the number of moves, and those in progress by their places."""
        moves = [move for a in self.axes.values() for move in a.entries]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        live = {id(move) for move in (*moves, *on_top)}
        return len(self.rows), {k: move for k, move in enumerate(self.rows) if id(move) in live}

    def cut(self, extent: tuple[int, dict[int, LoggedMove]]) -> None:
        """Drop later moves; those that were in progress are in progress again, as the same objects."""
        count, live = extent
        del self.rows[count:]
        for k, move in live.items():
            self.rows[k] = move
