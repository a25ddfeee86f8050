"""Reported events of an axis: limits, faults, clamps, velocity jumps, stops.

Each is logged when it happens, as an `Event` in user units by the scale of that time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.faults import (
    ABORT,
    ERROR_INPUT,
    FOLLOWING_ERROR,
    HOMING,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
    fault_names,
)

if TYPE_CHECKING:
    from motionlang.kernel.log.move import LoggedMove
    from motionlang.kernel.planners import Profile

# The name of a fault of each bit; the others are "fault".
KINDS = {
    ABORT: "abort",
    ERROR_INPUT: "e-stop",
    LIMIT_FORWARD: "limit",
    LIMIT_REVERSE: "limit",
    SOFT_LIMIT_FORWARD: "soft limit",
    SOFT_LIMIT_REVERSE: "soft limit",
    FOLLOWING_ERROR: "following error",
}
Rates = tuple[float, float]

# The cause of a jump of velocity that is no event: the profile is planned with it.
BY_DESIGN = "by design"
# A smaller relative jump of velocity is rounding.
_ROUNDING = 1e-6


def note(
    a: Axis,
    kind: str,
    value: float | None = None,
    limit: float | None = None,
    text: str = "",
) -> None:
    """Log an event of an axis; `value` and `limit` are in user units."""
    line = 0 if a.move is None else a.move.line
    a.controller.log.note(a.clock.now, kind, a.index, value, limit, line, text)


def raised(a: Axis, bit: int, action: str) -> None:
    """Log a fault that is about to be raised, and its `action`."""
    if not _is_listed(a, bit):
        return
    kind, value, limit = KINDS.get(bit, "fault"), None, None
    if kind in ("limit", "soft limit"):
        value = a.scale.position_to_user(a.here(a.clock.now))
        positions = [each.watch.position for each in a.limits if each.bit == bit and each.watch is not None]
        limit = a.scale.position_to_user(positions[0]) if positions else None
    elif a.feedback is not None and bit == FOLLOWING_ERROR:
        size = abs(a.scale.counts or 1.0)
        value, limit = abs(a.feedback.error) / size, a.feedback.error_limit / size
    if a.homing is not None:
        text = HOMING
    else:
        text = "" if action == kind else f"{fault_names(bit)}, {action}"
    note(a, kind, value, limit, text)


def cleared(a: Axis) -> None:
    """Log that the faults of an axis are about to be cleared."""
    if _is_listed(a, a.faults):
        note(a, "cleared", text=fault_names(a.faults))


def _is_listed(a: Axis, faults: int) -> bool:
    """True if faults of an axis are events: ABORT is for every axis, and is one of those that moved, if any did."""
    moved = [each for each in a.controller.axes.values() if len(each.starts) > 1]
    return faults != ABORT or not moved or a in moved


def check_velocity(a: Axis, profile: Profile, cause: str, move: LoggedMove | None) -> None:
    """Log a jump of velocity from the track of an axis to the profile that continues it now.

    The jumps of one move by one cause are one event, with their number.
    """
    now = a.clock.now
    before, after = a.profiles[-1].velocity(now - a.starts[-1]), profile.start_velocity + 0.0  # never -0.0
    if abs(after - before) <= _ROUNDING * (1.0 + abs(before) + abs(after)):
        return
    log, about = a.controller.log, (move, cause)
    number = log.jumps.get(a.index)
    if number is not None and number[0] == about:
        log.repeated[number[1]] = log.repeated.get(number[1], 1) + 1
        return
    log.jumps[a.index] = about, log.events.past
    line, text = 0 if move is None else move.line, f"{cause or 'a new motion'}, an infinite acceleration"
    log.note(now, "velocity jump", a.index, _speed(a, before), _speed(a, after), line, text)


def stopped(a: Axis, kind: str, hard: bool = False) -> None:
    """Log a stop by a keyword: "stop" decelerates, "cancel" is immediate.

    A stop that changes nothing, because the axis is stopping already, is no event.
    """
    if a.move is None:
        return
    action = a.move.action
    if kind == "cancel" or a.buffer or action is None or not action.is_stopping(hard):
        note(a, kind, _speed(a, a.velocity(a.clock.now)))


def clamped(a: Axis, line: int, speed: float, limit: float) -> None:
    """Log, once, a commanded speed above a limit, both counts/s."""
    if speed > limit:
        _once(a, "clamp", "speed", line, _speed(a, speed), _speed(a, limit))


def too_late(a: Axis, move: LoggedMove, k: int, written: Rates, in_force: Rates) -> None:
    """Log, once, the rate, number `k` of the two, with which the axis would pass its target."""
    what = ("acceleration", "deceleration")[k]
    _once(a, "too late", what, move.line, _speed(a, written[k]), _speed(a, in_force[k]))


def _once(a: Axis, kind: str, what: str, line: int, commanded: float, got: float) -> None:
    about = line, commanded, got
    if a.controller.log.clamped.get((a.index, what)) != about:
        a.controller.log.clamped[a.index, what] = about
        a.controller.log.note(a.clock.now, kind, a.index, commanded, got, line, what)


def _speed(a: Axis, speed: float) -> float:
    return speed / (a.scale.counts or 1.0)
