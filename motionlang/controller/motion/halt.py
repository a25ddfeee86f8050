"""Coming to rest before the end, and going on: stop, suspend, resume, and a new end for the move in progress."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.controller.move import Action
from motionlang.profile import halted
from motionlang.profile.relief import stop_under_way

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core
    from motionlang.profile import Profile


class Stopping(Action):
    """Coming to rest after a stop: nothing changes that any more."""

    __slots__ = ()

    def stop(self, controller: Core, a: Axis, ended: str) -> bool:
        if ended == "fault":
            return False
        controller.empty(a)
        return True

    def suspend(self, controller: Core, a: Axis) -> bool:
        return True


def stop(controller: Core, a: Axis, ended: str) -> None:
    """Decelerate to rest at the set rate, at `error_decel` for a fault."""
    move = a.move
    if move is None:
        return
    profile = braking(controller, a, a.error_decel if ended == "fault" else _decel(controller, a))
    if move.action is not None:
        move.action.leave(controller, a, ended)
    move.action = Stopping()
    controller.continue_with(a, profile, ended)
    a.target = move.target = profile.end


def braking(controller: Core, a: Axis, decel: float) -> Profile:
    """From the state of the axis to rest."""
    now = controller.clock.now
    try:
        return stop_under_way(
            a.profiles[-1], now - a.starts[-1], a.shape, decel, a.ramp, a.accel_jerk, a.decel_jerk
        )
    except ValueError as problem:
        raise Refusal("range", f"axis {a.index} cannot stop: {problem}") from None


def standing(controller: Core, a: Axis) -> Profile:
    """From the state of the axis to rest, and at rest for as long as nothing else is said."""
    return halted(braking(controller, a, _decel(controller, a)), "suspend")


def _decel(controller: Core, a: Axis) -> float:
    speed = a.speed if a.move is None or a.move.speed is None else a.move.speed
    decel = controller.rates(a, speed)[1]
    if a.move is not None and a.move.rates is not None:
        decel = a.move.rates[1] or decel
    return min(decel, a.max_decel)


def suspend(controller: Core, a: Axis) -> None:
    """Ramp to rest and keep the moves; what is started while the axis is suspended waits too."""
    if a.suspended:
        return
    action = a.move.action if a.move is not None else None
    held = action is not None and action.suspend(controller, a)
    a.suspended = True
    if a.move is not None and not held:
        controller.replan_move(a)


def resume(controller: Core, a: Axis) -> None:
    """Go on to where the axis was going."""
    if not a.suspended:
        return
    a.suspended = False
    if a.move is None:
        return
    if a.move.action is None:
        controller.replan_move(a)
    else:
        a.move.action.resume(controller, a)


def retarget(controller: Core, a: Axis, position: float, command: str, line: int) -> None:
    """Give the position move in progress another end; at rest it is a move of its own."""
    move = a.move
    if move is None:
        controller.move_to(a.index, position, command, line)
        return
    if move.action is not None:
        raise Refusal(
            "moving",
            f"axis {a.index} is not on a move to a position",
            "only a positional move in progress can be given a new end point",
        )
    if position == move.target == a.target:
        return
    before, move.target = move.target, position
    try:
        controller.replan_move(a)
    except Refusal:
        move.target = before
        raise
    a.target = position
