"""Two runs compared move by move.

A move that begins later because an earlier one takes longer does not wait longer. The wait of a move is
counted from the last move that ended before it began. If moves were inserted or removed just before, each run
has its own such move.
"""

from __future__ import annotations

import heapq
from typing import Any

Move = dict[str, Any]
# When a move was over in its run, and how much later it is in the new one (None if only one has it).
End = tuple[float, int, float | None]

_BEGIN: End = (0.0, 0, 0.0)
# Times that differ by less are equal.
_NEAR = 1e-9


class Timeline:
    """Moves of an old and a new run, in the order of their alignment."""

    def __init__(self) -> None:
        self._ends: tuple[list[End], list[End]] = ([], [])
        self._lasts = [_BEGIN, _BEGIN]
        self._number = 0

    def wait(self, a: Move, b: Move) -> float:
        """Return how much longer `b` of the new run waited than `a` of the old one."""
        start, other = a["start_time"], b["start_time"]
        was, is_ = self._before(0, start), self._before(1, other)
        if was[2] is None or is_[2] is None:
            wait: float = (other - is_[0]) - (start - was[0])
        else:
            wait = other - start - was[2]
        if a["duration"] is not None and b["duration"] is not None:
            ends = start + a["duration"], other + b["duration"]
            self._put(0, ends[0], ends[1] - ends[0])
            self._put(1, ends[1], ends[1] - ends[0])
        return wait

    def alone(self, move: Move, side: int) -> None:
        """Add a move that only one of the runs has: the old one if `side` is 0, the new one if 1."""
        if move["duration"] is not None:
            self._put(side, move["start_time"] + move["duration"], None)

    def _put(self, side: int, end: float, shift: float | None) -> None:
        self._number += 1
        heapq.heappush(self._ends[side], (end, self._number, shift))

    def _before(self, side: int, start: float) -> End:
        ends = self._ends[side]
        while ends and ends[0][0] <= start + _NEAR:
            last = heapq.heappop(ends)
            if last[0] >= self._lasts[side][0]:
                self._lasts[side] = last
        return self._lasts[side]
