"""Learned points: positions of the axes under a number."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.launch import aim
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.motion import Targets, movable, moves
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def learn_position(task: CommandTask, command: Command) -> None:
    controller, point = task.board.controller, task.whole(command)
    for axis in task.axes(command):
        task.board.points[point, axis.number] = controller.position(axis.number)


def learn_target(task: CommandTask, command: Command) -> None:
    point = task.whole(command)
    for axis in task.axes(command):
        if abs(task.board.controller.target(axis.number)) == inf:
            raise Fault(codes.PARAMETER, f"axis {axis.number} runs without a target", "LP learns where it is")
        task.board.points[point, axis.number] = aim(task.board, axis)


@moves
def move_to_point(task: CommandTask, command: Command) -> Targets:
    """Move to a point.

    Without an axis, every axis for which the point was learned moves.
    """
    point, points = task.whole(command), task.board.points
    axes = movable(task, command)
    targets = [(axis, points[point, axis.number]) for axis in axes if (point, axis.number) in points]
    if not targets:
        raise Fault(
            codes.PARAMETER, f"point {point} has not been learned", "LP and LT learn points", "unknown-word"
        )
    return targets


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("motion").row


ROWS = (
    _row("LP", "command", "W", "axes", "number", learn_position, "Learn the actual position as point n.",
         "1LP1", low=0, high=255),
    _row("LT", "command", "W", "axes", "number", learn_target, "Learn the target as point n.",
         "1LT1", low=0, high=255, effect="target"),
    _row("MP", "move", "W", "axes", "number", move_to_point, "Move to the learned point n.",
         "1MN,1LP1,1MR500,1WS,1MP1", low=0, high=255, effect="act", topic="move"),
)  # fmt: skip
