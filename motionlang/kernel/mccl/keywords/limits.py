"""Settings of the limits and the amplifier-fault input."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.limits import ALL
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def limit_mode(task: CommandTask, command: Command) -> None:
    """Set the effect of switches and soft limits (LM).

    Raises Fault for an unknown mode.
    """
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
        task.board.limits[axis.number].set_soft_limits()


def soft_low(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.soft_low = axis.position(float(task.value(command)))
        task.board.limits[axis.number].set_soft_limits()


def amplifier_fault_on(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].watch_amplifier(True)


def amplifier_fault_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.limits[axis.number].watch_amplifier(False)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("limits").row


ROWS = (
    _row("LM", "setting", "W", "axes", "bits", limit_mode,
         "Reaction to a limit: hard 0 motor off, 1 abrupt stop, 2 smooth stop, +128 inverted "
         "switches; soft +0 motor off, +4 abrupt, +8 smooth.", "1LM10", default=0, low=0, high=255),
    _row("LN", "command", "W", "axes", "bits", limits_on,
         "Enable limits: 1 hard +, 2 hard -, 4 soft high, 8 soft low; 0 all.", "1LN3", low=0, high=15),
    _row("LF", "command", "W", "axes", "bits", limits_off,
         "Disable limits: 1 hard +, 2 hard -, 4 soft high, 8 soft low; 0 all.", "1LF12", low=0, high=15),
    _row("HL", "setting", "W", "axes", "uu", soft_high, "Set the high soft limit.", "1HL50000", default=0,
         effect="upper", gives="upper limit"),
    _row("LL", "setting", "W", "axes", "uu", soft_low, "Set the low soft limit.", "1LL-50000", default=0,
         effect="lower", gives="lower limit"),
    _row("FN", "command", "W", "axes", "", amplifier_fault_on,
         "Watch the amplifier-fault input: when it comes on the motor is switched off.", "1FN0"),
    _row("FF", "command", "C", "axes", "", amplifier_fault_off, "Do not watch the amplifier-fault input.", "1FF"),
)  # fmt: skip
