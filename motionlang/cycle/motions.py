"""The moves of a run by their ends: what the chain asks when it looks for what a wait waited for.

Axes that begin and end together on one line are one motion.
"""

from __future__ import annotations

from bisect import bisect_right
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.profile import Profile
    from motionlang.result import Run

    # End, begin, number in the log, line, axes, profile: those that are one motion have the axes of all of them, and
    # the profile of the first.
    Motion = tuple[float, float, int, int, tuple[int, ...], Profile]
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
        rows: list[Motion] = [
            (
                move.start_time + profile.duration,
                move.start_time,
                number,
                move.line,
                alone[move.axis],
                profile,
            )
            for number, move in enumerate(run.controller.log.moves)
            if (profile := move.profile) is not None
        ]
        rows.sort()
        late = bisect_right(rows, (over, float("inf")))
        if late < len(rows):
            rows[late:] = [(over, *row[1:]) for row in rows[late:]]
            rows.sort()
        self._rows = rows
        self._ends = [row[0] for row in rows]
        self._phases: dict[object, Phases] = {}

    def __iter__(self) -> Iterator[Motion]:
        """Each motion of one axis, in the order of their ends."""
        return iter(self._rows)

    def phases(self, profile: Profile) -> Phases:
        """The phases of a profile, the same object for all that are alike."""
        recipe = profile._recipe
        if len(recipe) > 2:
            known = self._phases.get(recipe)
            if known is not None:
                return known
        made = tuple((PHASES.get(phase.name, OTHER), phase.duration) for phase in profile.phases)
        made = made or ((OTHER, profile.duration),)
        self._phases[recipe if len(recipe) > 2 else id(profile)] = (
            made  # it stays, and so do those of the log
        )
        return made

    def that_ended(
        self, since: float, time: float, near: float, axes: tuple[int, ...] | None = None
    ) -> Motion | None:
        """The motion that ended within `near` of `time`, and behind `since`: of several the one that began last.

        With `axes` one of theirs (with () of any axis), and where none ended then the last one before.
        """
        rows, low = self._rows, time - near
        place = bisect_right(self._ends, time + near) - 1
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
