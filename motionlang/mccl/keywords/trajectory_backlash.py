"""Compensation of backlash: BD says how far, BN and BF switch it."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def backlash_distance(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.backlash = axis.distance(float(task.value(command)))


def backlash_on(task: CommandTask, command: Command) -> None:
    """The axis stands in the middle of its backlash now; the next move takes it up."""
    for axis in task.axes(command):
        axis.compensates, axis.takeup = True, 0.0


def backlash_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.compensates, axis.takeup = False, 0.0


ACTIONS: dict[str, Action] = {
    "backlash_distance": backlash_distance,
    "backlash_on": backlash_on,
    "backlash_off": backlash_off,
}
