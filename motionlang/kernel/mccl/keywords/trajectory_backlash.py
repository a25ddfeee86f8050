"""Backlash compensation: BD sets the size, BN and BF switch it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl.axis.backlash import Backlash
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def backlash_distance(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.set_backlash(axis.distance(float(task.value(command))))


def backlash_on(task: CommandTask, command: Command) -> None:
    """Define the axis as in the middle of its backlash (BN).

    The next move takes the backlash up.
    """
    for axis in task.axes(command):
        _forget(task, axis.number)
        axis.play = Backlash(task.board.controller, axis.number, axis.backlash)


def backlash_off(task: CommandTask, command: Command) -> None:
    """Use the motor's position as the position of the axis from now on (BF)."""
    for axis in task.axes(command):
        _forget(task, axis.number)


def _forget(task: CommandTask, number: int) -> None:
    axis = task.board.axes[number]
    ahead, axis.play = axis.shift, None
    if ahead:
        task.board.define_position(axis, task.board.controller.position(number) + ahead)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("trajectory").row


ROWS = (
    _row("BD", "setting", "W", "axes", "uu", backlash_distance,
         "Set half the backlash: how far the motor goes ahead of the load from BN on.", "1BD10", default=0, low=0),
    _row("BN", "command", "C", "axes", "", backlash_on,
         "Compensate backlash, from the middle of it: TT reports the target of the load, TP where the motor is.",
         "1MN,1BD10,1BN,1MR500,1WS,1TP"),
    _row("BF", "command", "C", "axes", "", backlash_off, "Compensate backlash no longer.", "1BF"),
)  # fmt: skip
