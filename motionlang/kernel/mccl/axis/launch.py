"""Start of position moves; a stepper starts and stops at velocity MV at once."""

from __future__ import annotations

from math import copysign, sqrt
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.errors import Rejected
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.planners import Profile, plan_trapezoid
from motionlang.kernel.planners.curve import from_curve

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board


def check_unslaved(board: Board, axis: AxisState) -> None:
    """Raise Fault if the axis has a master, because it then accepts no other motion."""
    master = board.controller.master_of(axis.number)
    if master is not None:
        words = f"axis {axis.number} is slaved to axis {master}"
        raise Fault(codes.INVALID, words, f"{axis.number}SM0 frees it", "moving")


def aim(board: Board, axis: AxisState) -> float:
    """Return the target of an axis, counts.

    In a contour it is the end of the last path. For a slave it follows from the target of its master. While the
    axis runs without a target, it is the current position.
    """
    controller = board.controller
    target = board.path_end(axis)
    if target is None:
        target = controller.target(axis.number)
    if abs(target) == INFINITY and controller.master_of(axis.number) is not None:
        target = controller.axes[axis.number].profiles[-1].end + _later_paths(board, axis)
    return target if abs(target) < INFINITY else controller.demand(axis.number)


def _later_paths(board: Board, axis: AxisState) -> float:
    """Return how far the paths after the current one take the axis, counts."""
    controller = board.controller
    master = controller.master_of(axis.number)
    if master is not None and master in board.axes:
        return axis.slave_ratio * _later_paths(board, board.axes[master])
    end = board.path_end(axis)
    return 0.0 if end is None else end - controller.target(axis.number)


def launch(board: Board, axis: AxisState, target: float, word: str, line: int) -> None:
    """Start a position move to `target`, counts."""
    controller, number = board.controller, axis.number
    if not controller.setting(number, "speed"):
        words = f"axis {number} cannot move: its speed is 0"
        raise Rejected("zero-speed", words, "set a speed above zero; the move would never end")
    made = _from_minimum(controller, axis, target)
    if made is None:
        controller.move_to(number, target, word, line)
    else:
        controller.play(number, made[0], word, line, step=made[1])


def _from_minimum(controller: Controller, axis: AxisState, target: float) -> tuple[Profile, float] | None:
    """Return the trapezoid between two velocity steps of MV, and the step size.

    Returns None if MV does not apply. The trapezoid is the one from rest with both ends cut off: v from MV to
    the peak, v² = MV² + distance/(1/2A + 1/2D).
    """
    number = axis.number
    if axis.minimum <= 0.0 or controller.setting(number, "shape") != "trapezoid":
        return None
    speed, accel, decel = (
        float(controller.setting(number, name) or 0.0) for name in ("speed", "accel", "decel")
    )
    start = controller.demand(number)
    if not (speed > 0.0 and accel > 0.0 and decel > 0.0) or start == target:
        return None
    low = min(axis.minimum, speed)
    if controller.is_idle(number):
        return _stepped(start, target, low, speed, accel, decel), low
    velocity = controller.demand_velocity(number)
    if velocity * (target - start) <= 0.0 or abs(velocity) < low:
        return None
    return _going_on(start, target, low, speed, accel, decel, velocity), low


def _going_on(
    start: float, target: float, low: float, speed: float, accel: float, decel: float, velocity: float
) -> Profile:
    """Return the profile of a moving axis until it has slowed down to `low`.

    It is the beginning of the trapezoid that would come to rest beyond the target.
    """
    beyond = target + copysign(low * low / (2.0 * decel), velocity)
    whole = plan_trapezoid(start, beyond, speed, accel, decel, velocity)
    until_braking = whole.cut(whole.duration - low / decel)
    return from_curve("trapezoid", start, target, until_braking.curve, velocity, 0.0)


def _stepped(start: float, target: float, low: float, speed: float, accel: float, decel: float) -> Profile:
    """Return the profile from rest: a step to `low`, the trapezoid, a step to rest."""
    size, per_square = abs(target - start), 0.5 / accel + 0.5 / decel
    peak = min(speed, sqrt(low * low + size / per_square))
    slew = (size - (peak * peak - low * low) * per_square) / peak if peak == speed else 0.0
    # The gain in velocity, computed without the cancellation in a difference of two near numbers.
    gain = size / per_square / (peak + low) if peak < speed else peak - low
    rise, fall = gain / accel, gain / decel
    v = copysign(peak, target - start)
    step = copysign(low, v)
    recipe = (0.0, 0.0, 0.0, step, rise, 0.0, v, slew, 0.0, v, fall, 0.0, step, 0.0, 0.0, 0.0)
    return Profile("trapezoid", start, target, rise + slew + fall, recipe)
