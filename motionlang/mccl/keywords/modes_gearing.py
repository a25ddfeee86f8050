"""Gearing one axis to another."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.motion.gear import Gear

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def slave(task: CommandTask, command: Command) -> None:
    """SM: the axis follows axis n; 0 frees it. Fault where it would follow itself, or is off."""
    board, axis, number = task.board, task.axis(command), task.whole(command)
    if number == 0:
        board.ungear(axis)
        return
    master = board.axis(number)
    if _is_led_by(task, number, axis.number):
        raise Fault(
            codes.PARAMETER,
            f"axis {axis.number} cannot be slaved to axis {number}: it would follow itself",
            kind="axis",
        )
    if not board.controller.is_enabled(axis.number):
        raise Fault(
            codes.INVALID, f"axis {axis.number} is off", f"{axis.number}MN switches it on", "disabled-axis"
        )
    board.ungear(axis)
    board.gears[axis.number] = Gear(board, axis, master.number, task.source_line)


def slave_ratio(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    axis.slave_ratio = float(task.value(command)) if task.given(command) else 1.0
    gear = task.board.gears.get(axis.number)
    if gear is not None:
        gear.couple()


def _is_led_by(task: CommandTask, number: int | None, axis: int) -> bool:
    """Whether the chain of masters from `number` on reaches `axis`."""
    while number is not None:
        if number == axis:
            return True
        number = task.board.axes[number].master
    return False


ACTIONS: dict[str, Action] = {"slave": slave, "slave_ratio": slave_ratio}
