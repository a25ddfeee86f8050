"""Watches: calls at the exact time at which an axis passes a position.

Switches, index marks, software limits, latches, position-triggered inputs and outputs are all watches. Each
new profile of an axis solves them again; nothing polls.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, ulp
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis

# Counts within which an axis is at a position: far below any encoder, far above rounding.
_ON = 1e-6
EVERYWHERE = -inf, inf


class Watch:
    """Calls `call(direction)`, +1 or -1, when the axis passes `position`.

    Reaching the position counts as passing it. Leaving it again on the side it came from counts as passing it back, so
    the directions always alternate. A `physical` position is one of the machine (a switch, a mark): it does not
    move when the program gives the axis a new zero. Others, such as software limits, are positions of the
    program.
    """

    __slots__ = ("call", "event", "physical", "position", "side")

    def __init__(self, position: float, call: Callable[[int], None], physical: bool) -> None:
        self.position, self.call, self.physical = position, call, physical
        self.side = 0  # the last side of the axis: above, below, or not known yet
        self.event: TimedCall | None = None


def begin(axis: Axis, watch: Watch) -> None:
    """Add a watch to those of an axis."""
    axis.watches[watch] = None
    _arm(axis, watch)


def end(axis: Axis, watch: Watch) -> None:
    """Remove a watch from those of an axis."""
    del axis.watches[watch]
    _cancel(watch)


def solve(axis: Axis) -> None:
    """Solve all watches on a new profile, in order of creation; a pass that is due now may end others."""
    reach = _reach(axis.profiles[-1]) if len(axis.watches) > 1 else EVERYWHERE
    for watch in tuple(axis.watches):
        if watch in axis.watches:
            _arm(axis, watch, reach)


def _reach(profile: Profile) -> tuple[float, float]:
    """Return bounds of the positions of a motion, wide enough for rounding."""
    if profile.duration == inf or profile.end_velocity:
        return EVERYWHERE
    low, high = profile.extrema()
    more = _ON + 1e-9 * (abs(low) + abs(high))
    return low - more, high + more


def _arm(axis: Axis, watch: Watch, reach: tuple[float, float] = EVERYWHERE) -> None:
    """Solve one watch on the axis's present profile from now on; `reach` are the bounds of its positions.

    If the axis has a simulated motor, the watch applies to the motor instead. A pass that is due now, such as arrival
    at the position, happens first.
    """
    if axis.feedback is not None:
        axis.feedback.arm(watch)
        return
    pending, now = watch.event, axis.clock.now
    if pending is not None and pending.call is not None and pending.time <= now:
        pass_now = pending.call
        pending.cancel()
        pass_now()
        if watch not in axis.watches:  # it has ended in its own call
            return
    position = watched_position(axis, watch)
    side = side_of(axis.profiles[-1].position(now - axis.starts[-1]) - position, position)
    watch.side = side or watch.side  # at the position itself, the side stays
    if reach[0] <= position <= reach[1]:
        _solve(axis, watch, now, side)
    else:
        _cancel(watch)


def _solve(axis: Axis, watch: Watch, now: float, side: int) -> None:
    """Schedule the next change from the present `side` (0: at the position)."""
    _cancel(watch)
    start, profile = axis.starts[-1], axis.profiles[-1]
    if profile.shape == "hold":
        return
    found, after = _next(profile, watched_position(axis, watch), now - start, side)
    if found is not None:
        watch.event = axis.clock.at(start + found, lambda: _changed(axis, watch, after, reached=side != 0))


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
    if reached:
        axis.cross(axis.clock.now, watched_position(axis, watch))
    _solve(axis, watch, axis.clock.now, 0 if reached else side)
    if before and before != side:
        watch.call(side)


def _cancel(watch: Watch) -> None:
    if watch.event is not None:
        watch.event.cancel()
        watch.event = None


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
