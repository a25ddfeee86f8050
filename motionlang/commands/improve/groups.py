"""The numbers of axes that move together, which are scaled by one factor or not at all.

A driver follows the thread of its screw, though no path and no gear ties the two: both start with one GO, at speeds
that fit. So moves of several axes belong together if they start or end within a tick of each other, or while one of the
axes follows another. The numbers that such moves follow are a group. If one of the moves follows no number of the
group, the axes would part, so the group stays as it is.

Cost: n log n in the moves, and linear in the moves that each number changes.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from math import inf

from motionlang.commands.improve.process import MoveChange
from motionlang.kernel import Run
from motionlang.kernel.log import LoggedMove

# Moves start or end together within this, s.
TICK = 1e-3
# A move by its axis and its begin.
MoveKey = tuple[int, float]


class Groups:
    """The numbers that are scaled with each number, itself included, from the moves that each changes in a run.

    `parts` has the axis that would part from each number, if there is one.
    """

    def __init__(self, run: Run, changes: Mapping[str, Sequence[MoveChange]]) -> None:
        self.of: dict[str, list[str]] = {name: [name] for name in changes}
        self.parts: dict[str, int] = {}
        together = [keys for keys in _together(run) if len({axis for axis, _ in keys}) > 1]
        clusters: dict[MoveKey, list[int]] = {}
        for n, keys in enumerate(together):
            for key in keys:
                clusters.setdefault(key, []).append(n)
        first: dict[tuple[int, str, int], str] = {}
        moved: dict[tuple[int, str, int], set[MoveKey]] = {}
        for name, found in changes.items():
            for each in found:
                key = each.move.axis, each.move.start_time
                for n in clusters.get(key, ()):
                    shared = n, each.quantity, each.rate
                    moved.setdefault(shared, set()).add(key)
                    self._join(first.setdefault(shared, name), name)
        for shared, name in first.items():
            left = together[shared[0]] - moved[shared]
            if left:
                self.parts.update(dict.fromkeys(self.of[name], min(left)[0]))

    def _join(self, one: str, other: str) -> None:
        mine, others = self.of[one], self.of[other]
        if mine is not others:
            mine += others
            self.of.update(dict.fromkeys(others, mine))


def _together(run: Run) -> Iterator[set[MoveKey]]:
    """Yield the moves that start together, that end together, and those of axes while one follows the other."""
    homes = run.dialect.table().homes
    moves = [
        each
        for each in run.machine.log.moves
        # An axis that a path leaves where it is moves with no other.
        if each.profile is not None and each.profile.peak_speed and not homes(each.command)
    ]
    followers = [each for each in moves if each.follows]
    moves = sorted((each for each in moves if not each.follows), key=_start)
    for time in (_start, _end):
        begin, keys = -inf, set[MoveKey]()
        for move in sorted(moves, key=time):
            if time(move) - begin > TICK:
                yield keys
                begin, keys = time(move), set()
            keys.add((move.axis, move.start_time))
        yield keys
    starts = [move.start_time for move in moves]
    for each in followers:
        master = getattr(getattr(each.action, "master", None), "index", None)
        until = bisect_left(starts, _end(each))
        during = moves[bisect_left(starts, each.start_time) : until]
        yield {
            (move.axis, move.start_time)
            for move in during
            if master is None or move.axis in (master, each.axis)
        }


def _start(move: LoggedMove) -> float:
    return move.start_time


def _end(move: LoggedMove) -> float:
    assert move.profile is not None
    return move.start_time + move.profile.duration
