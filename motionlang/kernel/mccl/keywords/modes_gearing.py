"""Gearing one axis to another."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl.axis.motor import check_on
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def slave(task: CommandTask, command: Command) -> None:
    """Make the axis follow axis n; 0 frees it (SM).

    Raises Rejected if the axis is off or would follow itself.
    """
    board, axis, number = task.board, task.axis(command), task.whole(command)
    controller = board.controller
    if number == 0:
        controller.leave_master(axis.number)
        return
    master = board.axis(number)
    check_on(board, axis)
    axis.running = False
    controller.gear(axis.number, master.number, axis.slave_ratio, command=task.word, line=task.source_line)


def slave_ratio(task: CommandTask, command: Command) -> None:
    """Set the slave's counts per count of its master, with immediate effect (SS)."""
    axis = task.axis(command)
    axis.slave_ratio = float(task.value(command)) if task.given(command) else 1.0
    task.board.controller.set_ratio(axis.number, axis.slave_ratio)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("modes").row


ROWS = (
    _row("SM", "command", "W", "axis", "number", slave, "Slave the axis to master axis n; 0 ends it.",
         "1MN,2MN,2SM1", low=0, effect="follows", topic="master"),
    _row("SS", "setting", "W", "axis", "number", slave_ratio, "Set the ratio of slave counts to master counts.",
         "2SS0.5", default=1, topic="master"),
)  # fmt: skip
