"""Stop, suspend and resume motion, and change the end of a move."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import BY_WORD, Axis
from motionlang.kernel.controller.triggers.conditions import release
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import Action, keeps_rates
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.dwell import with_rest
from motionlang.kernel.planners.ramp_down import stop_in_motion

if TYPE_CHECKING:
    from motionlang.kernel.controller.queue.life import Core


class Stopping(Action):
    """Coming to rest after a stop; only a harder stop changes it.

    `rate` is the deceleration of the stop itself, or 0 for that of the axis.
    """

    __slots__ = ("hard", "rate")

    def __init__(self, hard: bool = False, rate: float = 0.0) -> None:
        self.hard, self.rate = hard, rate

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        if hard and (ended == "fault" or not self.hard):
            return False
        controller.empty(a, ended)
        return True

    def is_stopping(self, hard: bool) -> bool:
        return self.hard or not hard

    def suspend(self, controller: Core, a: Axis) -> bool:
        return True


def stop(controller: Core, a: Axis, ended: str, hard: bool = False) -> None:
    """Decelerate to rest at the set rate; a `hard` stop uses `error_decel`.

    The deceleration is limited to `max_decel`, except in a fault.
    """
    move = a.move
    if move is None:
        return
    if hard:
        decel = a.error_decel if ended == "fault" else min(a.error_decel, a.max_decel)
    else:
        decel = _decel(controller, a)
    profile = braking(controller, a, decel)
    if move.action is not None:
        move.action.leave(controller, a, ended)
    move.action = Stopping(hard)
    controller.continue_with(a, profile, ended)
    a.target = move.target = profile.end


def check_stop(controller: Core, a: Axis) -> None:
    """Raise Rejected, before anything changes, if a stop has no deceleration."""
    move = a.move
    if move is not None and (move.action is None or type(move.action).stop is Action.stop):
        _decel(controller, a)


def braking(controller: Core, a: Axis, decel: float) -> Profile:
    """Return the motion from the state of the axis to rest."""
    now, (speed, own_accel, own_decel) = controller.clock.now, a.speed_and_rates(a.move)
    jerks = a.jerks(speed, own_accel, own_decel)
    accel = None if keeps_rates(a.move) else min(own_accel, a.max_accel)
    try:
        made = stop_in_motion(a.profiles[-1], now - a.starts[-1], a.shape, decel, a.ramp, *jerks, accel)
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot stop: {problem}") from None
    rounding = a.here(now) - made.start
    return made.shifted(rounding) if rounding else made


def to_rest(controller: Core, a: Axis) -> Profile:
    """Return the motion from the state of the axis to rest at its set rate."""
    return braking(controller, a, _decel(controller, a))


def with_standstill(controller: Core, a: Axis) -> Profile:
    """Return the motion to rest, followed by rest until another command."""
    return with_rest(to_rest(controller, a))


def _decel(controller: Core, a: Axis) -> float:
    speed, _, decel = a.speed_and_rates(a.move)
    if not decel and not speed and a.move is not None and a.move.rates_in_force is not None:
        decel = a.move.rates_in_force[1]  # a ramp time says nothing about a stop at speed 0
    return min(decel or controller.decel(a, speed), a.max_decel)


def suspend(controller: Core, a: Axis, reason: int) -> None:
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
            before = controller.suspended_with.get(each.index, ())
            controller.suspended_with[each.index] = tuple(dict.fromkeys((*before, *sharing)))
    if not fresh or move is None:
        return
    try:
        is_handled = move.action is not None and move.action.suspend(controller, a)
    except Rejected as rejected:
        if reason == BY_WORD:
            release(controller, a)
            raise
        controller.run_time_fault(rejected)
        return
    if not is_handled:
        controller.replan_move(a)


def resume(controller: Core, a: Axis, reason: int) -> None:
    """Remove a reason for suspension; if none remains, continue to the target."""
    sharing = _sharing(a)
    if reason == BY_WORD:
        if not any(each.suspend_reasons & reason for each in sharing):
            return
        freed = [other for each in sharing for other in release(controller, each)]
        for each in dict.fromkeys(freed):
            if each not in sharing and not each.suspended and each.move is None:
                controller.start_next(each)
    elif not a.suspend_reasons & reason:
        return
    else:
        a.suspend_reasons &= ~reason
    if a.move is None or any(each.suspended for each in sharing):
        return
    if a.move.action is None:
        controller.replan_move(a)
    else:
        a.move.action.resume(controller, a)


def _sharing(a: Axis) -> tuple[Axis, ...]:
    return (a,) if a.move is None or a.move.action is None else a.move.action.together_with(a)


def retarget(controller: Core, a: Axis, position: float, command: str, line: int) -> None:
    """Change the end of the position move in progress; at rest start a new move."""
    move = a.move
    if move is None:
        controller.move_to(a.index, position, command, line)
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
        controller.replan_move(a)
    except Rejected:
        move.target = before
        raise
    a.target = position
