"""Two runs compared move by move, with the times of a third, merged run.

A move that begins later because an earlier one takes longer does not wait longer. The wait of a move is
counted from the last move that ended before it began. If moves were inserted or removed just before, each run
has its own such move.
"""

from __future__ import annotations

import heapq
from typing import Any

Move = dict[str, Any]
# When a move was over in its run, how much later it is in the new one (None if only one has it), and when
# it is over in the merged run (None if that does not have it).
End = tuple[float, int, float | None, float | None]

_BEGIN: End = (0.0, 0, 0.0, 0.0)
# Times that differ by less are equal.
NEAR = 1e-9


class Timeline:
    """Moves of an old and a new run, in the order of their alignment."""

    def __init__(self) -> None:
        self._ends: tuple[list[End], list[End]] = ([], [])
        self._lasts = [_BEGIN, _BEGIN]
        self._number = 0
        self._made = 0.0

    def pair(self, a: Move, b: Move, old: Move | None = None, accepted: bool = True) -> tuple[float, float]:
        """Return how much longer `b` waited than `a`, and its start in the merged run.

        In the merged run it waits like `b` if `accepted`, like `a` if not. `old` is the one of the two whose
        duration the merged run has; the default is `b`.
        """
        start, other = a["start_time"], b["start_time"]
        was, is_ = self._before(0, start), self._before(1, other)
        if was[2] is None or is_[2] is None:
            gaps = start - was[0], other - is_[0]
            wait = gaps[1] - gaps[0]
            over = [each[3] for each in (was, is_) if each[3] is not None]
            begin = max(over, default=self._made) + (gaps[1] if accepted else gaps[0])
        else:
            wait = other - start - was[2]
            begin = start + ((was[3] or 0.0) - was[0]) + (wait if accepted else 0.0)
        if a["duration"] is not None and b["duration"] is not None:
            ends = start + a["duration"], other + b["duration"]
            made = begin + (b if old is None else old)["duration"]
            self._put(0, ends[0], ends[1] - ends[0], made)
            self._put(1, ends[1], ends[1] - ends[0], made)
        return wait, begin

    def alone(self, move: Move, side: int, in_merged: bool) -> float:
        """Return the start in the merged run of a move that only one of the runs has.

        `side` is 0 for the old run, 1 for the new one. The merged run has the move only if `in_merged`.
        """
        start: float = move["start_time"]
        last = self._before(side, start)
        begin = start + (last[3] - last[0] if last[3] is not None else 0.0)
        if move["duration"] is not None:
            self._put(side, start + move["duration"], None, begin + move["duration"] if in_merged else None)
        return begin

    def _put(self, side: int, end: float, shift: float | None, made: float | None) -> None:
        self._number += 1
        heapq.heappush(self._ends[side], (end, self._number, shift, made))
        if made is not None:
            self._made = made

    def _before(self, side: int, start: float) -> End:
        """Return the last move of a run that ended before `start`."""
        ends = self._ends[side]
        while ends and ends[0][0] <= start + NEAR:
            last = heapq.heappop(ends)
            if last[0] >= self._lasts[side][0]:
                self._lasts[side] = last
        return self._lasts[side]
