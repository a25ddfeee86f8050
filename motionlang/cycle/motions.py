"""The moves of a run by their ends: what the chain asks when it looks for what a wait waited for.

Axes that begin and end together on one line are one motion.
"""

from __future__ import annotations

from bisect import bisect_right
from itertools import compress, pairwise
from operator import gt, itemgetter, ne
from typing import TYPE_CHECKING

from motionlang.profile.ramps import named_ramps

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from motionlang.controller.move import Move
    from motionlang.profile import Profile
    from motionlang.profile.ramps import Recipe
    from motionlang.result import Run

    # End, begin, number in the log, line, axes, and the profile or its recipe of ramps: those that are one motion have
    # the axes of all of them, and the profile of the first.
    Motion = tuple[float, float, int, int, tuple[int, ...], Profile | Recipe]
    # What a stretch is called in each phase of a move, and how many seconds that takes.
    Phases = tuple[tuple[str, float], ...]

# Phases of a move, and what a stretch of the chain is called in which one runs.
PHASES = {"accel": "accelerating", "slew": "at speed", "decel": "decelerating", "stop": "stopping"}
OTHER = "in motion"
MOVING = (*PHASES.values(), OTHER)


class Motions:
    """Every motion of a run by its end, at the latest that of the run."""

    def __init__(self, run: Run) -> None:
        over = run.time
        alone = {axis: (axis,) for axis in run.controller.axes}
        log: list[Any] = list(run.controller.log.moves.as_kept())
        # A plain move is read as it lies there: (axis, start time, _, _, duration, recipe, _, _, _, (…, line, …)).
        rows: list[Motion] = [
            (row[1] + row[4], row[1], number, row[9][3], alone[row[0]], row[5])
            if row.__class__ is tuple
            else _motion(row, number, alone)
            for number, row in enumerate(log)
            if row.__class__ is tuple or row.profile is not None
        ]
        rows.sort()
        late = bisect_right(rows, (over, float("inf")))
        if late < len(rows):
            rows[late:] = [(over, *row[1:]) for row in rows[late:]]
            rows.sort()
        self._rows = rows
        self._ends = [row[0] for row in rows]
        self._phases: dict[object, Phases] = {}

    def together(self) -> tuple[list[Motion], list[int]]:
        """The motions by their begins and lines, those that are alike in both by their ends; where the next ones begin.

        The last of those places is behind the last motion.
        """
        rows = sorted(self._rows, key=itemgetter(1))  # those of one begin stay in the order of their ends
        later = list(map(ne, map(itemgetter(1), rows), map(itemgetter(1), rows[1:])))
        lines = list(map(itemgetter(3), rows))
        other_line = list(map(ne, lines, lines[1:]))
        if any(map(gt, other_line, later)):  # several lines began some at the same moment
            rows.sort(key=itemgetter(1, 3))
            later = [row[1] != after[1] or row[3] != after[3] for row, after in pairwise(rows)]
        return rows, [0, *compress(range(1, len(rows)), later), len(rows)] if rows else []

    def phases(self, shape: Profile | Recipe) -> Phases:
        """The phases of a profile, or of a recipe of ramps, the same object for all that are alike."""
        key = shape if isinstance(shape, tuple) else id(shape)  # the rows keep it
        known = self._phases.get(key)
        if known is None:
            if isinstance(shape, tuple):
                steps, whole = [ramp[:2] for ramp in named_ramps(shape)], 0.0
            else:
                steps, whole = [(phase.name, phase.duration) for phase in shape.phases], shape.duration
            known = tuple((PHASES.get(name, OTHER), seconds) for name, seconds in steps)
            known = self._phases[key] = known or ((OTHER, whole),)
        return known

    def that_ended(
        self, since: float, time: float, near: float, axes: tuple[int, ...] | None = None
    ) -> Motion | None:
        """The motion that ended within `near` of `time`, and behind `since`: of several the one that began last.

        With `axes` one of theirs (with () of any axis), and where none ended then the last one before.
        """
        rows, ends, low = self._rows, self._ends, time - near
        place = bisect_right(ends, time + near) - 1
        if place > 0 and ends[place - 1] < low <= ends[place] > since:
            row = rows[place]  # the only one near to it
            if not axes or row[4][0] in axes:
                return row
        found, best = -1, (0.0, 0.0)
        while place >= 0:
            end, begin, _, _, (axis,), _ = rows[place]
            if end <= since or (end < low and (found >= 0 or axes is None)):
                break
            if not axes or axis in axes:
                if end < low:
                    return self._whole(place)
                if found < 0 or (begin, end) >= best:
                    found, best = place, (begin, end)
            place -= 1
        return None if found < 0 else self._whole(found)

    def before(self, axes: tuple[int, ...], begin: float, near: float) -> Motion | None:
        """The motion of one of some axes that began before `begin`, and ended within `near` of it."""
        place = bisect_right(self._ends, begin + near) - 1
        while place >= 0:
            end, began, _, _, (axis,), _ = self._rows[place]
            if end < begin - near:
                return None
            if axis in axes and began < begin:
                return self._whole(place)
            place -= 1
        return None

    def last(self, after: float, time: float) -> Motion | None:
        """The last one that ended behind `after`, and by `time`."""
        place = bisect_right(self._ends, time) - 1
        return self._whole(place) if place >= 0 and self._ends[place] > after else None

    def _whole(self, place: int) -> Motion:
        """The motion of a row, with the axes of all rows that are it."""
        rows, ends = self._rows, self._ends
        end, begin, _, line, _, _ = row = rows[place]
        first, last = place, place + 1
        while first and ends[first - 1] == end:
            first -= 1
        while last < len(ends) and ends[last] == end:
            last += 1
        if last - first == 1:
            return row
        same = [each for each in rows[first:last] if each[1] == begin and each[3] == line]
        _, _, number, _, _, profile = same[0]
        return end, begin, number, line, tuple(axes[0] for _, _, _, _, axes, _ in same), profile


def _motion(move: Move, number: int, alone: Mapping[int, tuple[int]]) -> Motion:
    """A move of the log that is a `Move`, and has a profile."""
    profile = move.profile
    assert profile is not None
    shape = profile._recipe if profile.pieced and len(profile._recipe) > 2 else profile
    begin = move.start_time
    return begin + profile.duration, begin, number, move.line, alone[move.axis], shape
