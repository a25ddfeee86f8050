"""The life of a move: GO releases it, it starts when it is first in its buffer, and ends.

`start_move` plans a profile from the axis's state and settings, puts it on the axis's track and schedules one event
for its end. There `_arrive` starts the next move of the buffer, if it has been released.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.faults import fault_names
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.plan import plan_move
from motionlang.kernel.controller.queue.track import amend_log, end_move, extend_track, log_dropped, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold

# ------------------------------------------------------------------------------------------------------- start


def go(a: Axis) -> None:
    """Release all moves in the buffer of an axis; an idle axis starts now."""
    for move in a.buffer:
        if move.action is None:
            move.released = True
        else:
            move.action.release(move)
    if a.move is None:
        start_next(a)
    elif a.move.action is not None:
        a.move.action.more(a)


def move_to(a: Axis, position: float, command: str = "", line: int = 0) -> None:
    """Move to `position` now, from any state of motion."""
    move = buffer.stamped(a, LoggedMove(a.index, command, line, position))
    move.released = True
    profile = plan_move(a, move)
    end_move(a, "retarget")
    run_profile(a, move, profile)


def move_by(a: Axis, distance: float, command: str = "", line: int = 0) -> None:
    """Move by `distance` now, from the present target, if any, or from the position."""
    base = a.target if abs(a.target) < INFINITY else a.position(a.clock.now)
    move_to(a, base + distance, command, line)


def permit_motion(a: Axis) -> None:
    """Close the loop of an axis that is about to get a motion.

    Raises Rejected while the axis is disabled, is locked by an error, or is in a motion that allows no other.
    """
    if a.faults & a.locks:
        what = fault_names(a.faults)
        raise Rejected(
            "axis-error", f"axis {a.index} has an error: {what}", "clear the error before moving it"
        )
    if not a.enabled:
        raise Rejected("disabled-axis", f"axis {a.index} is off", "enable the axis before moving it")
    if a.move is not None and a.move.action is not None and a.move.action.exclusive:
        words = f"axis {a.index} is in {a.move.command}, which takes no other motion"
        raise Rejected("moving", words, "stop it before another motion")
    close_loop(a)


def require_idle(a: Axis, command: str) -> None:
    """Raise Rejected for a command that needs the axis idle while it has a motion, even one that stands still."""
    if not a.is_moving:
        return
    is_held = a.suspended and not a.velocity(a.clock.now)
    if a.move is not None and (a.is_at_standstill or is_held):
        words = f"axis {a.index} stands still, but {a.move.command} has not ended"
        raise Rejected("moving", words, f"STOP({a.index}) ends it; {command} needs the axis idle")
    raise Rejected("moving", f"axis {a.index} is moving", f"{command} needs the axis at rest")


def close_loop(a: Axis) -> None:
    """Close the loop of a simulated motor whose output was set manually."""
    if a.feedback is not None and a.enabled:
        a.feedback.take_over()


def start_next(a: Axis) -> None:
    """Start the next entry of the buffer, if it is released.

    Raises Rejected for an entry that cannot begin. The entry is skipped, and the ones behind it start once the
    error has been handled.
    """
    while a.move is None and a.homing is None and a.buffer and a.buffer[0].released:
        move = a.buffer[0]
        if move.action is not None and not (
            move.action.ready(a, move) and (move.action.can_stand or not a.suspended)
        ):
            return
        buffer.take(a)
        try:
            if move.action is None:
                buffer.resolve(a, move)
                start_move(a, move)
            else:
                move.action.begin(a, move)
        except Rejected as rejected:
            rejected.line = rejected.line or move.line
            for each in (a,) if move.action is None else move.action.together_with(a):
                a.controller.motion_listener.refuse(each)
                _begin_waiting(each)
            raise


def start_waiting(a: Axis) -> None:
    """Start the next entry like `start_next`, with no statement waiting for it.

    Each rejected entry is a run-time fault.
    """
    while True:
        try:
            start_next(a)
            return
        except Rejected as rejected:
            a.controller.run_time_fault(rejected)


def start_move(a: Axis, move: LoggedMove) -> None:
    """Plan a move and run it."""
    run_profile(a, move, plan_move(a, move))


def run_profile(a: Axis, move: LoggedMove, profile: Profile, cause: str = "") -> None:
    """Log a move and follow its profile from now on."""
    log_move(a, move, profile)
    append_profile(a, profile, cause)


def append_profile(a: Axis, profile: Profile, cause: str = "") -> None:
    """Follow `profile` from now on, and schedule its end."""
    if a.arrival is not None:
        a.arrival.cancel()
    end = a.clock.now + profile.duration
    a.arrival = a.clock.at(end, lambda: _arrive(a)) if end < INFINITY else None
    extend_track(a, profile, cause)


# ---------------------------------------------------------------------------------------------------- changes


def replan_move(a: Axis) -> None:
    """Replan the move in progress to the same target with the present settings."""
    assert a.move is not None
    if a.move.action is None:
        continue_with(a, plan_move(a, a.move), "")
    else:
        a.move.action.replan(a)


def continue_with(a: Axis, profile: Profile, ended: str) -> None:
    """Replace the rest of the present move by `profile`."""
    assert a.move is not None
    amend_log(a.controller.log, a.clock.now, [a.move], [profile], ended)
    append_profile(a, profile)


# -------------------------------------------------------------------------------------------------------- end


def _arrive(a: Axis) -> None:
    """Handle the end of the profile of the move in progress."""
    a.arrival = None
    a.move = None
    extend_track(a, hold(a.profiles[-1].end), BY_DESIGN)
    go_on(a)


def go_on(a: Axis) -> None:
    """Start the next entry of the buffer at rest; skip an entry that cannot begin."""
    if a.homing is not None:
        a.homing.at_rest()
    start_waiting(a)
    if a.move is None:
        a.controller.notify("idle", a.index)


def empty(a: Axis, ended: str) -> None:
    """Discard and log the buffer, with related entries in the buffers of other axes."""
    entries, a.buffer = a.buffer, []
    for move in entries:
        dropped = [move] if move.action is None else [move, *move.action.purge(a)]
        for each in dropped:
            each.ended = ended
        if move.action is None or not move.action.is_sequel:
            for each in dropped:
                log_dropped(a, each)
        for each in dropped:
            if each.axis != a.index:  # entries behind a path continue, unless they are discarded too
                _begin_waiting(a.controller.axes[each.axis])


def _begin_waiting(a: Axis) -> None:
    """Schedule the start of the buffer after all other events of this time."""

    def begin() -> None:
        if a.homing is not None or not a.buffer:
            return
        if a.move is None:
            if not a.suspended:
                go_on(a)
        elif a.move.action is not None:
            a.move.action.more(a)

    a.clock.at(a.clock.now, begin)
