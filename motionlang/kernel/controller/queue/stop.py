"""Stop, suspend and resume motion, halt it at once, and change the end of a move."""

from __future__ import annotations

from motionlang.kernel.controller.axis import BY_WORD, Axis
from motionlang.kernel.controller.events import stopped
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import (
    close_loop,
    continue_with,
    empty,
    move_to,
    replan_move,
    start_next,
)
from motionlang.kernel.controller.queue.plan import braking, stop_rate
from motionlang.kernel.controller.queue.track import end_move, extend_track
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners import hold


class Stopping(Action):
    """Coming to rest after a stop; only a harder stop changes it.

    `rate` is the deceleration of the stop itself, or 0 for that of the axis.
    """

    __slots__ = ("hard", "rate")

    def __init__(self, hard: bool = False, rate: float = 0.0) -> None:
        self.hard, self.rate = hard, rate

    def stops_itself(self, ended: str, hard: bool) -> bool:
        return not hard or (self.hard and ended != "fault")

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        empty(a, ended)

    def is_stopping(self, hard: bool) -> bool:
        return self.hard or not hard

    def suspend(self, a: Axis) -> bool:
        return True


def decelerate(a: Axis, ended: str, hard: bool = False) -> None:
    """Decelerate to rest at the set rate; a `hard` stop uses `error_decel`.

    The deceleration is limited to `max_decel`, except in a fault.
    """
    move = a.move
    if move is None:
        return
    if hard:
        decel = a.error_decel if ended == "fault" else min(a.error_decel, a.max_decel)
    else:
        decel = stop_rate(a, move)
    profile = braking(a, decel)
    if move.action is not None:
        move.action.leave(a, ended)
    move.action = Stopping(hard)
    continue_with(a, profile, ended)
    a.target = move.target = profile.end


def stop(a: Axis, ended: str = "stop", hard: bool = False) -> None:
    """Decelerate to rest at the set rate and empty the move buffer.

    A `hard` stop uses `error_decel`.
    """
    if not hard and a.move is not None and _own_stop(a, ended, hard) is None:
        # Raises Rejected before anything changes. The stop of a homing is one at the rates of the axis.
        stop_rate(a, a.move if a.homing is None else None)
    if ended == "stop":
        stopped(a, ended, hard)
    a.controller.motion_listener.stop(a, ended)
    close_loop(a)
    freed = release(a)
    if a.homing is not None:
        a.homing.cancel()
    action = _own_stop(a, ended, hard)
    if action is not None:
        action.stop(a, ended, hard)
    else:
        empty(a, ended)
        decelerate(a, ended, hard)
    a.controller.motion_listener.heed(a)
    for each in freed:
        if each is not a and not each.suspended:
            start_next(each)


def _own_stop(a: Axis, ended: str, hard: bool) -> Action | None:
    """Return the action of the move in progress if it makes such a stop itself."""
    action = None if a.move is None else a.move.action
    return action if action is not None and action.stops_itself(ended, hard) else None


def come_to_rest(a: Axis, ended: str = "") -> None:
    """Decelerate to rest at the set rate; the move buffer stays and runs next."""
    if ended == "stop" and not a.is_at_standstill:
        stopped(a, ended)
    if ended:
        a.controller.motion_listener.stop(a, ended)
    decelerate(a, ended)


def give_up(a: Axis, rejected: Rejected) -> None:
    """End a motion that cannot continue: come to rest, and raise a run-time fault.

    An axis without a deceleration halts at once.
    """
    assert a.move is not None
    rejected.line = rejected.line or a.move.line
    try:
        come_to_rest(a, "fault")
    except Rejected:
        freeze(a, "fault")
    a.controller.run_time_fault_later(rejected)


def abort(a: Axis, ended: str = "cancel") -> None:
    """Halt at once, without a ramp, and empty the move buffer."""
    if ended == "cancel":
        stopped(a, ended)
    freeze(a, ended)
    close_loop(a)


def freeze(a: Axis, ended: str) -> None:
    """Stop the axis at once at its present position."""
    a.controller.motion_listener.freeze(a, ended)
    release(a)
    if a.homing is not None:
        a.homing.cancel()
    empty(a, ended)
    if a.arrival is not None:
        a.arrival.cancel()
        a.arrival = None
    move = a.move
    if move is None:
        return
    a.target = here = a.here(a.clock.now)
    end_move(a, ended)
    extend_track(a, hold(here), ended, move)
    a.controller.notify("idle", a.index)


def suspend(a: Axis, reason: int = BY_WORD) -> None:
    """Ramp to rest and keep the moves until every reason has been removed by `resume`."""
    _suspend(a, reason)
    a.controller.motion_listener.heed(a)


def _suspend(a: Axis, reason: int) -> None:
    """Ramp to rest and keep the moves; motion commanded meanwhile waits too.

    A keyword suspends all axes of a path. An input suspends its own axis, together with the path that it is on. If a
    keyword would be rejected, an input raises a run-time fault: its reason remains and suspends the axis once the
    present motion is over.
    """
    move, sharing = a.move, _sharing(a)
    fresh = not any(each.suspended for each in sharing)
    for each in sharing if reason == BY_WORD else (a,):
        each.suspend_reasons |= reason
        if reason == BY_WORD:
            each.suspended_with = tuple(dict.fromkeys((*each.suspended_with, *sharing)))
    if not fresh or move is None:
        return
    try:
        is_handled = move.action is not None and move.action.suspend(a)
    except Rejected as rejected:
        if reason == BY_WORD:
            release(a)
            raise
        a.controller.run_time_fault(rejected)
        return
    if not is_handled:
        replan_move(a)


def resume(a: Axis, reason: int = BY_WORD) -> None:
    """Remove a reason for suspension; continue if none remains."""
    _resume(a, reason)
    if not a.suspended and a.move is None and a.buffer:
        start_next(a)


def _resume(a: Axis, reason: int) -> None:
    """Remove a reason for suspension; if none remains, continue to the target."""
    sharing = _sharing(a)
    if reason == BY_WORD:
        if not any(each.suspend_reasons & reason for each in sharing):
            return
        freed = [other for each in sharing for other in release(each)]
        for each in dict.fromkeys(freed):
            if each not in sharing and not each.suspended and each.move is None:
                start_next(each)
    elif not a.suspend_reasons & reason:
        return
    else:
        a.suspend_reasons &= ~reason
    if a.move is None or any(each.suspended for each in sharing):
        return
    if a.move.action is None:
        replan_move(a)
    else:
        a.move.action.resume(a)


def release(a: Axis) -> tuple[Axis, ...]:
    """End the suspension by a keyword of an axis and of the axes suspended with it.

    Return these axes.
    """
    freed = (a, *(each for each in a.suspended_with if each is not a))
    for each in freed:
        each.suspend_reasons &= ~BY_WORD
        each.suspended_with = ()
    return freed


def _sharing(a: Axis) -> tuple[Axis, ...]:
    return (a,) if a.move is None or a.move.action is None else a.move.action.together_with(a)


def retarget(a: Axis, position: float, command: str = "", line: int = 0) -> None:
    """Change the end of the move in progress to `position`.

    An axis at rest starts at once. Loaded moves keep their ends.
    """
    before = a.target
    _give_end(a, position, command, line)
    buffer.keep_ends(a, position - before)


def _give_end(a: Axis, position: float, command: str, line: int) -> None:
    move = a.move
    if move is None:
        move_to(a, position, command, line)
        return
    if move.action is not None:
        raise Rejected(
            "moving",
            f"axis {a.index} is not on a move to a position",
            "only a positional move in progress can be given a new end point",
        )
    if position == move.target == a.target:
        return
    before, move.target = move.target, position
    try:
        replan_move(a)
    except Rejected:
        move.target = before
        raise
    a.target = position
