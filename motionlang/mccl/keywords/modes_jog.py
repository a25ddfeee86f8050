"""Jogging: an axis follows its joystick, the analogue input of its own number."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def jog_on(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.joysticks.switch_on(axis, task.source_line)


def jog_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.board.joysticks.switch_off(axis)


def jog_accel(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.accel = axis.rate(float(task.value(command)), "uu/s2")


def jog_minimum(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.minimum = axis.rate(float(task.value(command)), "uu/s")


def jog_gain(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.gain = axis.rate(float(task.value(command)), "uu/s")


def jog_deadband(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.deadband = float(task.value(command))


def jog_offset(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.offset = float(task.value(command))


ACTIONS: dict[str, Action] = {
    "jog_on": jog_on,
    "jog_off": jog_off,
    "jog_accel": jog_accel,
    "jog_minimum": jog_minimum,
    "jog_gain": jog_gain,
    "jog_deadband": jog_deadband,
    "jog_offset": jog_offset,
}
