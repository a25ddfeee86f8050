"""The moves of a run by end time, to find what ended a wait.

Axes that begin and end together on one line are one motion.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from itertools import compress, islice
from operator import add, itemgetter, lt, ne
from typing import Any

from motionlang.kernel.controller.move import Move
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.ramps import Recipe, named_ramps
from motionlang.kernel.result import Run

# End, begin, line, axes, and the profile or its recipe of ramps. Those that are one motion have the axes
# of all of them, and the profile of the first that moves.
Motion = tuple[float, float, int, tuple[int, ...], Profile | Recipe]

# The name of a link in each phase of a move, and the duration of the phase, s.
Phases = tuple[tuple[str, float], ...]

# Phases of a move, and the name of a link in each.
PHASES = {"accel": "accelerating", "slew": "at speed", "decel": "decelerating", "stop": "stopping"}
OTHER = "in motion"
MOVING = (*PHASES.values(), OTHER)
# Of a row: (axis, begin, _, _, duration, recipe, _, _, _, (_, _, command, line, …)).
_AXIS, _BEGIN, _DURATION, _ENTRY, _LINE = map(itemgetter, (0, 1, 4, 9, 3))


class Motions:
    """Every motion of a run, in columns, by its end (at most the end of the run).

    A shift has tens of thousands of motions. `ends` are in order of time. `order[n]` is the number of the
    n-th motion to end; `begins`, `lines` and `rows` are indexed by that number. A row has the
    required fields of a move.
    """

    def __init__(self, run: Run) -> None:
        over = run.time
        self.alone: dict[int, tuple[int, ...]] = {axis: (axis,) for axis in run.controller.axes}
        self.rows: list[tuple[Any, ...]] = [
            _row_of(move) for move in run.controller.log.moves if move.profile is not None
        ]
        self.begins: list[float] = list(map(_BEGIN, self.rows))
        ends: list[float] = list(map(add, self.begins, map(_DURATION, self.rows)))
        self._in_order = self.begins == sorted(self.begins)
        self.ends = sorted(ends)
        if ends and self.ends[-1] > over:
            ends = [min(end, over) for end in ends]
            self.ends = sorted(ends)
        self._ends_of = ends  # by number
        # Those that end together in the order of their begins.
        self.order = sorted(self._by_begin(), key=ends.__getitem__)
        self.lines: list[int] = list(map(_LINE, map(_ENTRY, self.rows)))
        self._phases: dict[object, Phases] = {}

    def together(self) -> tuple[Sequence[int], list[float], list[int], list[int]]:
        """Group the motions by begin; return group bounds, and all ends, axes and lines.

        They are in the order of the begins.
        """
        begins, ends, axes, lines = self.begins, self._ends_of, list(map(_AXIS, self.rows)), self.lines
        if not self._in_order:
            numbers = self._by_begin()
            begins, ends = [begins[number] for number in numbers], [ends[number] for number in numbers]
            axes, lines = [axes[number] for number in numbers], [lines[number] for number in numbers]
        return _cuts(begins), ends, axes, lines

    def _by_begin(self) -> Sequence[int]:
        numbers = range(len(self.rows))
        return numbers if self._in_order else sorted(numbers, key=self.begins.__getitem__)

    def phases(self, shape: Profile | Recipe) -> Phases:
        """Return the phases of a profile or a recipe of ramps; equal ones share an object."""
        key = shape if isinstance(shape, tuple) else id(shape)  # the rows keep a reference
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
        """Return the motion that ended within `near` of `time`, after `since`.

        Of several, it is the one that began last. `axes` restricts the search to these axes; () means every
        axis. With `axes` given, the last motion that ended before is returned if none ended within `near`.
        """
        ends, low = self.ends, time - near
        index = bisect_right(ends, time + near) - 1
        alone = index > 0 and ends[index - 1] < low <= ends[index] > since  # no other one is near to it
        if alone and (not axes or self.axis(index) in axes):
            return self._motion(index)
        found, best = -1, (0.0, 0.0)
        while index >= 0:
            end = ends[index]
            if end <= since or (end < low and (found >= 0 or axes is None)):
                break
            if not axes or self.axis(index) in axes:
                if end < low:
                    return self._whole(index)
                begin = self.begins[self.order[index]]
                if found < 0 or (begin, end) >= best:
                    found, best = index, (begin, end)
            index -= 1
        return None if found < 0 else self._whole(found)

    def before(self, axes: tuple[int, ...], begin: float, near: float) -> Motion | None:
        """Return the earlier motion of given axes that leads up to `begin`.

        It ended within `near` of `begin`, or was blended.
        """
        first = bisect_right(self.ends, begin + near)
        index = first - 1
        while index >= 0 and self.ends[index] >= begin - near:
            if self.axis(index) in axes and self.begins[self.order[index]] < begin:
                return self._whole(index)
            index -= 1
        for index in range(first, len(self.ends)):
            if self.axis(index) not in axes:
                continue
            began = self.begins[self.order[index]]
            if began < begin:
                return self._whole(index)
            if began > begin:  # so has any later end
                return None
        return None

    def last(self, after: float, time: float) -> Motion | None:
        """Return the last motion that ended after `after` and not after `time`."""
        index = bisect_right(self.ends, time) - 1
        return self._whole(index) if index >= 0 and self.ends[index] > after else None

    def last_end(self, axis: int | None, after: float, until: float) -> float | None:
        """Return the last end of a motion of `axis`, or any for None, in (after, until]."""
        index = bisect_right(self.ends, until) - 1
        while index >= 0 and self.ends[index] > after:
            if axis is None or self.axis(index) == axis:
                return self.ends[index]
            index -= 1
        return None

    def moving_at(self, axis: int | None, time: float) -> int | None:
        """Return the axis that is in motion at a time: `axis`, or any axis if it is None."""
        found = self.crossing(axis, time)
        return None if found is None else found[3][0]

    def crossing(self, axis: int | None, time: float) -> Motion | None:
        """Return the motion of `axis`, or of any for None, at a time, as if it ended then."""
        for index in range(bisect_right(self.ends, time), len(self.ends)):
            if (axis is None or self.axis(index) == axis) and self.begins[self.order[index]] < time:
                _, begin, line, axes, shape = self._whole(index)
                return time, begin, line, axes, shape
        return None

    def axis(self, index: int) -> int:
        """Return the axis of the motion at `index` in order of ends."""
        axis: int = self.rows[self.order[index]][0]
        return axis

    def _whole(self, index: int) -> Motion:
        """Return the motion at `index` in order of ends, with all of its axes."""
        ends, order, begins = self.ends, self.order, self.begins
        end, number = ends[index], order[index]
        first, last = index, index + 1
        while first and ends[first - 1] == end:
            first -= 1
        while last < len(ends) and ends[last] == end:
            last += 1
        if last - first == 1:
            return self._motion(index)
        begin, line = begins[number], self.lines[number]
        same = [each for each in order[first:last] if begins[each] == begin and self.lines[each] == line]
        shapes = [self.rows[each][5] for each in same]
        shape = next(filter(_moves, shapes), shapes[0])
        return end, begin, line, tuple(self.rows[each][0] for each in same), shape

    def _motion(self, index: int) -> Motion:
        """Return the motion at `index` in order of ends, with its own axis only."""
        number = self.order[index]
        row = self.rows[number]
        return self.ends[index], self.begins[number], self.lines[number], self.alone[row[0]], row[5]


def _moves(shape: Profile | Recipe) -> bool:
    """True unless the axis is at rest, such as on a path that moves only other axes."""
    if isinstance(shape, tuple):
        return any(shape[::3])
    return shape.start != shape.end or shape.peak_speed > 0.0


def _cuts(begins: list[float]) -> Sequence[int]:
    """Return the first index of each start time, then the total number.

    The result is a range if all groups have the same size.
    """
    if not begins:
        return ()
    width = bisect_right(begins, begins[0])
    firsts = begins[::width]
    is_regular = len(begins) % width == 0 and all(begins[k::width] == firsts for k in range(1, width))
    if is_regular and all(map(lt, firsts, islice(firsts, 1, None))):
        return range(0, len(begins) + 1, width)
    return [0, *compress(range(1, len(begins)), map(ne, begins, islice(begins, 1, None))), len(begins)]


def _row_of(move: Move) -> tuple[Any, ...]:
    """Return the required fields of a move."""
    profile = move.profile
    assert profile is not None
    shape = profile._recipe if profile.pieced and len(profile._recipe) > 2 else profile
    entry = None, None, move.command, move.line
    return move.axis, move.start_time, None, None, profile.duration, shape, None, None, None, entry
