"""The moves of a run by end time, to find what ended a wait.

Axes that begin and end together on one line are one motion.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from functools import cached_property
from heapq import merge
from math import isclose
from operator import itemgetter
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang.kernel.planners import Profile, Recipe, named_ramps

# The name of a link in each phase of a move, and the duration of the phase, s.
Phases = tuple[tuple[str, float], ...]

# Phases of a move, and the name of a link in each. An axis that holds does not travel.
DWELL, OTHER = "dwell", "in motion"
TRAVEL = {"accel": "accelerating", "slew": "at speed", "decel": "decelerating", "stop": "stopping"}
PHASES = {**TRAVEL, "hold": DWELL}
MOVING = (*TRAVEL.values(), OTHER)


class Motion(NamedTuple):
    """A motion, with the axes of all moves in it, and the profile, or its recipe of ramps, of the first that moves."""

    end: float
    begin: float
    line: int
    axes: tuple[int, ...]
    shape: Profile | Recipe


class Motions:
    """The moves of a run, each as a motion of one axis: `moves` in order of their `ends`, then their begins.

    A move that is in progress at the end of the run ends there.
    """

    def __init__(self, run: Run) -> None:
        self.moves: list[Motion] = []
        self._tracks = run.controller.axes
        for move in run.controller.log.moves:
            profile = move.profile
            if profile is not None:
                shape = profile._recipe if profile.pieced and len(profile._recipe) > 2 else profile
                end = min(move.start_time + profile.duration, run.time)
                self.moves.append(Motion(end, move.start_time, move.line, (move.axis,), shape))
        self.moves.sort(key=itemgetter(0, 1))
        self.ends = [move.end for move in self.moves]
        self._phases: dict[object, Phases] = {}

    @cached_property
    def _begun(self) -> set[tuple[int, float]]:
        """The axis and the begin of each move."""
        return {(move.axes[0], move.begin) for move in self.moves}

    def together(self) -> list[list[Motion]]:
        """Return the moves that began together on one line, in order of their ends."""
        found: dict[tuple[float, int], list[Motion]] = defaultdict(list)
        for move in self.moves:
            found[move.begin, move.line].append(move)
        return [each for each in found.values() if len(each) > 1]

    def phases(self, shape: Profile | Recipe) -> Phases:
        """Return the phases of a profile or a recipe of ramps; equal ones share an object."""
        key = shape if isinstance(shape, tuple) else id(shape)  # the moves keep a reference
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
        low = time - near
        found, best = -1, (0.0, 0.0)
        for index in range(bisect_right(self.ends, time + near) - 1, -1, -1):
            end, begin, _, own, _ = self.moves[index]
            if end <= since or (end < low and (found >= 0 or axes is None)):
                break
            if not axes or own[0] in axes:
                if end < low:
                    return self._whole(index)
                if found < 0 or (begin, end) >= best:
                    found, best = index, (begin, end)
        return None if found < 0 else self._whole(found)

    def before(self, axes: tuple[int, ...], begin: float, near: float) -> Motion | None:
        """Return the earlier motion of given axes that leads up to `begin`.

        It ended within `near` of `begin`.
        """
        first = bisect_right(self.ends, begin + near)
        index = first - 1
        while index >= 0 and self.ends[index] >= begin - near:
            move = self.moves[index]
            if move.axes[0] in axes and move.begin < begin:
                return self._whole(index)
            index -= 1
        for index in range(first, len(self.ends)):
            move = self.moves[index]
            if move.axes[0] not in axes:
                continue
            if move.begin < begin:
                return self._whole(index)
            if move.begin > begin:  # so has any later end
                return None
        return None

    def changes(self, motion: Motion, time: float) -> Iterator[float]:
        """Yield when a motion was given another end or at least twice the speed before `time`, the last first.

        Such a change shortens the run more if it comes sooner than the motion before it does if it is faster.
        """
        return merge(*(self._changes(axis, motion.begin, time) for axis in motion.axes), reverse=True)

    def _changes(self, axis: int, begin: float, time: float) -> Iterator[float]:
        track = self._tracks[axis]
        for index in range(track.index_at(time), track.index_at(begin), -1):
            start, after, before = track.starts[index], track.profiles[index], track.profiles[index - 1]
            if start < time and (axis, start) not in self._begun:
                left = before.end - before.position(start - track.starts[index - 1])
                has_same_end = isclose(left, after.distance, rel_tol=1e-9, abs_tol=1e-3)
                if not has_same_end or 0.0 < 2.0 * before.peak_speed <= after.peak_speed:
                    yield start

    def last(self, after: float, time: float) -> Motion | None:
        """Return the last motion that ended after `after` and not after `time`."""
        index = bisect_right(self.ends, time) - 1
        return self._whole(index) if index >= 0 and self.ends[index] > after else None

    def last_end(self, axis: int | None, after: float, until: float) -> float | None:
        """Return the last end of a motion of `axis`, or any for None, in (after, until]."""
        index = bisect_right(self.ends, until) - 1
        while index >= 0 and self.ends[index] > after:
            if axis is None or self.moves[index].axes[0] == axis:
                return self.ends[index]
            index -= 1
        return None

    def moving_at(self, axis: int | None, time: float) -> int | None:
        """Return the axis that is in motion at a time: `axis`, or any axis if it is None."""
        found = self.crossing(axis, time)
        return None if found is None else found.axes[0]

    def crossing(self, axis: int | None, time: float) -> Motion | None:
        """Return the motion of `axis`, or of any for None, at a time, as if it ended then."""
        for index in range(bisect_right(self.ends, time), len(self.ends)):
            move = self.moves[index]
            if (axis is None or move.axes[0] == axis) and move.begin < time:
                return self._whole(index)._replace(end=time)
        return None

    def _whole(self, index: int) -> Motion:
        """Return the motion of a move, with all moves that begin and end together with it on its line."""
        move, first, last = self.moves[index], index, index + 1
        while first and self.ends[first - 1] == move.end:
            first -= 1
        while last < len(self.ends) and self.ends[last] == move.end:
            last += 1
        same = [each for each in self.moves[first:last] if each[:3] == move[:3]]
        shape = next((each.shape for each in same if _moves(each.shape)), same[0].shape)
        return move._replace(axes=tuple(each.axes[0] for each in same), shape=shape)


def _moves(shape: Profile | Recipe) -> bool:
    """True unless the axis is at rest, such as on a path that moves only other axes."""
    if isinstance(shape, tuple):
        return any(shape[::3])
    return shape.start != shape.end or shape.peak_speed > 0.0
