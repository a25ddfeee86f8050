"""The numbers of axes that move together, which are scaled by one factor of time or not at all.

A driver follows the thread of its screw, though no path and no gear ties the two: both start with one GO, at speeds
that fit. An arm leaves as the slide has passed a place, and meets it further on. So moves of several axes belong
together if they move at the same time, or while one of the axes follows another. The numbers that such moves follow are
a group: in 1/k of the time speeds are k times as large, rates k², jerks k³, and the times of ramps 1/k. If one of the
moves follows no number of the group, the axes would part, so the group stays as it is. A path ties its axes itself, and
tasks that read nothing of each other share no work.

Cost: n log n in the moves, and linear in the moves that each number changes.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from math import inf

from motionlang.kernel import Run
from motionlang.kernel.log import LoggedMove
from motionlang_explore.improve.process import MoveChange
from motionlang_explore.improve.tasks import Tasks

# Moves that share less than this have one after the other, s.
TICK = 1e-3
# A move by its axis, its line and its begin.
MoveKey = tuple[int, int, float]


class Groups:
    """The numbers that are scaled with each number, itself included, from the moves that each changes in a run.

    `powers` are those of k by which each is scaled. `parts` has the axis that would part from each number, if there is
    one.
    """

    def __init__(self, run: Run, tasks: Tasks, changes: Mapping[str, Sequence[MoveChange]]) -> None:
        self.of: dict[str, list[str]] = {name: [name] for name in changes}
        # MCCL has no time of a ramp, but the share of an S in it, which no factor of time changes.
        lowest = 0 if run.dialect.name == "mccl" else -1
        scaled = {name: [each for each in found if each.power >= lowest] for name, found in changes.items()}
        self.powers = {
            name: max((each.power for each in some), key=abs) for name, some in scaled.items() if some
        }
        self.parts: dict[str, int] = {}
        together = list(_together(run, tasks))
        clusters: dict[MoveKey, list[int]] = {}
        for n, keys in enumerate(together):
            for key in keys:
                clusters.setdefault(key, []).append(n)
        first: dict[int, str] = {}
        # A trial may end before a move; then the others of its line decide.
        moved: dict[int, set[tuple[str, int]]] = {}
        lines: dict[tuple[str, int], set[tuple[int, int]]] = {}
        for name, some in scaled.items():
            for each in some:
                lines.setdefault((each.quantity, each.rate), set()).add(_key(each.move)[:2])
                for n in clusters.get(_key(each.move), ()):
                    moved.setdefault(n, set()).add((each.quantity, each.rate))
                    self._join(first.setdefault(n, name), name)
        for n, quantities in moved.items():
            left = [
                axis
                for axis, line, _ in sorted(together[n])
                for each in quantities
                if (axis, line) not in lines[each]
            ]
            if left:
                self.parts.update(dict.fromkeys(self.of[first[n]], left[0]))

    def _join(self, one: str, other: str) -> None:
        mine, others = self.of[one], self.of[other]
        if mine is not others:
            mine += others
            self.of.update(dict.fromkeys(others, mine))


def _together(run: Run, tasks: Tasks) -> Iterator[set[MoveKey]]:
    """Yield the moves of two axes that move at the same time, and those of axes while one follows the other."""
    homes = run.dialect.table().homes
    moves = [
        each
        for each in run.machine.log.moves
        # An axis that a path leaves where it is moves with no other.
        if each.profile is not None and each.profile.peak_speed and not homes(each.command)
    ]
    followers = [each for each in moves if each.follows]
    # An endless move would tie all that moves.
    moves = sorted((each for each in moves if not each.follows and _end(each) < inf), key=_start)
    going: list[LoggedMove] = []
    for move in moves:
        going = [each for each in going if _end(each) - TICK > move.start_time]
        yield from ({_key(each), _key(move)} for each in going if _are_tied(each, move, tasks))
        going.append(move)
    starts = [move.start_time for move in moves]
    for each in followers:
        master = getattr(getattr(each.action, "master", None), "index", None)
        until = bisect_left(starts, _end(each))
        during = moves[bisect_left(starts, each.start_time) : until]
        keys = {_key(move) for move in during if master is None or move.axis in (master, each.axis)}
        if len({axis for axis, _, _ in keys}) > 1:
            yield keys


def _key(move: LoggedMove) -> MoveKey:
    return move.axis, move.line, move.start_time


def _are_tied(one: LoggedMove, other: LoggedMove, tasks: Tasks) -> bool:
    """True if moves of two axes that go on at the same time are no single path, and their tasks work together."""
    is_path = one.commanded_speed is other.commanded_speed is None and one.start_time == other.start_time
    first, second = tasks.at(one.line), tasks.at(other.line)
    is_shared = first == second or tasks.reads(first, second) or tasks.reads(second, first)
    return one.axis != other.axis and is_shared and not is_path


def _start(move: LoggedMove) -> float:
    return move.start_time


def _end(move: LoggedMove) -> float:
    assert move.profile is not None
    return move.start_time + move.profile.duration
