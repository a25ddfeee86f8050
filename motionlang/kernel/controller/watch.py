"""Watches: calls at the exact time at which an axis passes a position.

Switches, index marks, software limits, latches, position-triggered inputs and outputs are all watches. Nothing polls.

Problem. An axis may have thousands of watches, such as a mark every 10 mm, and each profile passes them at other times.

Idea. An axis passes the nearest watch on either side first. Only those next to the axis are solved when a profile
begins, and each pass solves the next one in its direction.

Data. `axis.watches` has all watches in order of creation. `axis.thresholds` has them by position: those of the program
and those of the machine apart, because a new zero shifts them against each other. `solved` are the watches whose
`event` is their next pass on the present profile, or None if there is none.

Invariants.
- A watch that is not solved is behind a solved one that is passed at an earlier time. So of several watches that are
  passed at the same time, all are solved before the first is passed.
- The event of a watch does not depend on when the watch is solved: not its time, which is solved from the start of the
  profile, nor its order among the events of that time, for which `numbers` are reserved in order of creation.
- The side of a watch changes when it is passed, or when a profile does not begin where the one before it ended.

Cost. Two watches on each side for each profile, one for each pass, and their binary search.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Callable
from functools import partial
from math import ulp
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis

# Counts within which an axis is at a position: far below any encoder, far above rounding.
_ON = 1e-6


class Watch:
    """Calls `call(direction)`, +1 or -1, when the axis passes `position`.

    Reaching the position counts as passing it. Leaving it again on the side it came from counts as passing it back, so
    the directions always alternate. A `physical` position is one of the machine (a switch, a mark): it does not
    move when the program gives the axis a new zero. Others, such as software limits, are positions of the
    program.
    """

    __slots__ = ("call", "event", "number", "physical", "position", "side")

    def __init__(self, position: float, call: Callable[[int], None], physical: bool) -> None:
        self.position, self.call, self.physical = position, call, physical
        self.side = 0  # the last side of the axis: above, below, or not known yet
        self.event: TimedCall | None = None
        self.number = 0  # of its creation, among the watches of its axis


class Thresholds:
    """The watches of an axis by position, those of the program and those of the machine."""

    __slots__ = ("count", "numbers", "rows", "seen", "solved")

    def __init__(self) -> None:
        self.rows: tuple[list[_Row], list[_Row]] = [], []
        # The positions, of the program and of the machine, up to which the sides are set.
        self.seen = [0.0, 0.0]
        self.solved: dict[Watch, None] = {}
        self.count = self.numbers = 0


_Row = tuple[float, int, Watch]


def begin(axis: Axis, watch: Watch) -> None:
    """Add a watch to those of an axis; it applies to the simulated motor, if there is one."""
    thresholds = axis.thresholds
    thresholds.count += 1
    watch.number = thresholds.count
    axis.watches[watch] = None
    insort(thresholds.rows[watch.physical], _row(watch))
    if axis.feedback is not None:
        axis.feedback.arm(watch)
    elif not _arm(axis, watch, axis.clock.now - axis.starts[-1]):
        thresholds.seen[watch.physical] = watch.position


def end(axis: Axis, watch: Watch) -> None:
    """Remove a watch from those of an axis."""
    del axis.watches[watch]
    rows = axis.thresholds.rows[watch.physical]
    i = bisect_left(rows, _row(watch))
    del rows[i]
    _cancel(watch)
    if watch in axis.thresholds.solved:
        del axis.thresholds.solved[watch]
        _look_ahead(axis, rows, i, 1)
        _look_ahead(axis, rows, i - 1, -1)


def solve(axis: Axis) -> None:
    """Solve the watches next to the axis on a new profile, after the passes that are due now."""
    thresholds, profile, now = axis.thresholds, axis.profiles[-1], axis.clock.now
    due = [each for each in thresholds.solved if each.event is not None and each.event.time <= now]
    for watch in sorted(due, key=lambda each: each.number):
        pending = watch.event
        if pending is not None and pending.call is not None and pending.time <= now:
            pass_now = pending.call
            pending.cancel()
            pass_now()
            if axis.profiles[-1] is not profile:  # the call began another one, which has solved the watches
                return
    for watch in thresholds.solved:
        _cancel(watch)
    thresholds.solved.clear()
    position = profile.position(0.0)
    if profile.shape != "hold":
        thresholds.numbers = axis.clock.reserve(thresholds.count)
    for physical, rows in enumerate(thresholds.rows):
        if rows:
            here = position - axis.datum if physical else position
            _take_sides(axis, rows, thresholds.seen[physical], here)
            thresholds.seen[physical] = here
            if profile.shape != "hold":
                _solve_neighbours(axis, rows, here)


def _take_sides(axis: Axis, rows: list[_Row], before: float, here: float) -> None:
    """Set the sides of the watches between two positions."""
    low, high = min(before, here), max(before, here)
    more = _ON + 1e-9 * (abs(low) + abs(high))  # wide enough for rounding
    for _, _, watch in rows[bisect_left(rows, (low - more,)) : bisect_left(rows, (high + more,))]:
        _take_side(axis, watch, 0.0)


def _take_side(axis: Axis, watch: Watch, elapsed: float) -> int:
    """Set the side of a watch at a time of the profile; return it, or 0 at the watch itself, where the side stays."""
    position = watched_position(axis, watch)
    side = side_of(axis.profiles[-1].position(elapsed) - position, position)
    watch.side = side or watch.side
    return side


def _solve_neighbours(axis: Axis, rows: list[_Row], here: float) -> None:
    """Solve the watches at a position, and those next to it on both sides."""
    above = bisect_left(rows, (here,))
    for i, step in ((above, 1), (above - 1, -1)):
        while 0 <= i < len(rows) and not _arm_from_start(axis, rows[i][2]):
            i += step
        _look_ahead(axis, rows, i, step)


def _look_ahead(axis: Axis, rows: list[_Row], i: int, step: int) -> None:
    """Solve watches from number `i` on, up to one that is passed later than the one before it."""
    before = INFINITY
    while 0 <= i < len(rows):
        watch = rows[i][2]
        if watch not in axis.thresholds.solved:
            _arm_from_start(axis, watch)
        if watch.event is None or watch.event.time > before:
            return
        before = watch.event.time
        i += step


def _arm_from_start(axis: Axis, watch: Watch) -> int:
    """Solve a watch from the start of the profile on, as if it had been solved then."""
    return _arm(axis, watch, 0.0, axis.thresholds.numbers + watch.number)


def _arm(axis: Axis, watch: Watch, elapsed: float, number: int | None = None) -> int:
    """Solve a watch from a time of the profile on; return its side at that time."""
    side = _take_side(axis, watch, elapsed)
    _solve(axis, watch, elapsed, side, number)
    return side


def _solve(axis: Axis, watch: Watch, elapsed: float, side: int, number: int | None = None) -> None:
    """Schedule the next change from the present `side` (0: at the position)."""
    _cancel(watch)
    axis.thresholds.solved[watch] = None
    profile = axis.profiles[-1]
    if profile.shape == "hold":
        return
    found, after = _next(profile, watched_position(axis, watch), elapsed, side)
    if found is not None:
        changed = partial(_changed, axis, watch, after, reached=side != 0)
        watch.event = axis.clock.at(axis.starts[-1] + found, changed, number)


def _next(profile: Profile, position: float, elapsed: float, side: int) -> tuple[float | None, int]:
    """Return when the axis next changes sides, and the new side."""
    if side:
        return _crossing(profile, position, elapsed, -side), -side
    within = margin(position)
    up = _crossing(profile, position + within, elapsed, 1)
    down = _crossing(profile, position - within, elapsed, -1)
    if up is None or (down is not None and down < up):
        return down, -1
    return up, 1


def _crossing(profile: Profile, position: float, elapsed: float, direction: int) -> float | None:
    """Return when the axis next crosses a position in a direction.

    The time of an event has the resolution of the clock. After some hours at high speed, that is coarser than the
    resolution of a position, so the axis may be slightly before a position that it has just passed. Passing it once
    more is not a new event.
    """
    found = profile.crossing(position, elapsed)
    step = ulp(elapsed + 1.0)
    while found is not None and profile.velocity(found) * direction < 0.0:
        found = profile.crossing(position, found + step)
        step *= 2.0
    return found


def _changed(axis: Axis, watch: Watch, side: int, reached: bool) -> None:
    """Set the new `side` after the axis has `reached` the position, or has left it."""
    watch.event = None
    before, watch.side = watch.side, side
    axis.thresholds.seen[watch.physical] = watch.position
    if reached:
        axis.cross(axis.clock.now, watched_position(axis, watch))
    rows = axis.thresholds.rows[watch.physical]
    _look_ahead(axis, rows, bisect_left(rows, _row(watch)) + side, side)
    _solve(axis, watch, axis.clock.now - axis.starts[-1], 0 if reached else side)
    if before and before != side:
        watch.call(side)


def _cancel(watch: Watch) -> None:
    if watch.event is not None:
        watch.event.cancel()
        watch.event = None


def _row(watch: Watch) -> _Row:
    return watch.position, watch.number, watch


def watched_position(axis: Axis, watch: Watch) -> float:
    """Return the present position of a watch, counts of the program."""
    return watch.position + axis.datum if watch.physical else watch.position


def side_of(distance: float, position: float) -> int:
    """Return the side of `position` at the signed `distance` from it; 0 if reached."""
    within = margin(position)
    return (distance > within) - (distance < -within)


def margin(position: float) -> float:
    """Return how many counts from a position an axis counts as being at it."""
    return _ON + 1e-12 * abs(position)
