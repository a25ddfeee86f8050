"""Learned points: positions of the axes under a number."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis.launch import aim
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords.motion_operations import movable, start_moves

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.task import Wait
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def learn_position(task: CommandTask, command: Command) -> None:
    controller, point = task.board.controller, task.whole(command)
    for axis in task.axes(command):
        task.board.points[point, axis.number] = controller.position(axis.number)


def learn_target(task: CommandTask, command: Command) -> None:
    point = task.whole(command)
    for axis in task.axes(command):
        if abs(task.board.controller.target(axis.number)) == float("inf"):
            raise Fault(codes.PARAMETER, f"axis {axis.number} runs without a target", "LP learns where it is")
        task.board.points[point, axis.number] = aim(task.board.controller, axis)


def move_to_point(task: CommandTask, command: Command) -> Wait | None:
    """Move to a point; without an axis, every axis that has learned it moves."""
    point, points = task.whole(command), task.board.points
    axes = movable(task, command)
    targets = [(axis, points[point, axis.number]) for axis in axes if (point, axis.number) in points]
    if not targets:
        raise Fault(
            codes.PARAMETER, f"point {point} has not been learned", "LP and LT learn points", "unknown-word"
        )
    return start_moves(task, command, targets)


ACTIONS: dict[str, Action] = {
    "learn_position": learn_position,
    "learn_target": learn_target,
    "move_to_point": move_to_point,
}
