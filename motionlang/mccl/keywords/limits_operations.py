"""Setting up limits and the amplifier-fault input."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis.limits import ALL
from motionlang.mccl.codes import Fault

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def limit_mode(task: CommandTask, command: Command) -> None:
    """LM: what switches and soft limits do. Fault for a mode that there is not."""
    mode = task.whole(command)
    if mode & 3 == 3 or mode & 12 == 12 or mode & 0x70:
        hint = "one of 0, 1, 2 for the switches, plus 0, 4 or 8 for the soft limits, plus 128"
        raise Fault(codes.PARAMETER, f"LM has no mode {mode}", hint, "range")
    for axis in task.axes(command):
        task.board.limits[axis.number].set_mode(mode)


def limits_on(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].enable(task.whole(command) or ALL)


def limits_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].disable(task.whole(command) or ALL)


def soft_high(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.soft_high = axis.position(float(task.value(command)))
        task.board.limits[axis.number].place_soft()


def soft_low(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.soft_low = axis.position(float(task.value(command)))
        task.board.limits[axis.number].place_soft()


def amplifier_fault_on(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].watch_amplifier(True)


def amplifier_fault_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].watch_amplifier(False)


ACTIONS: dict[str, Action] = {
    "limit_mode": limit_mode,
    "limits_on": limits_on,
    "limits_off": limits_off,
    "soft_high": soft_high,
    "soft_low": soft_low,
    "amplifier_fault_on": amplifier_fault_on,
    "amplifier_fault_off": amplifier_fault_off,
}
