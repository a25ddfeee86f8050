"""Jogging: an axis follows its joystick, the analogue input with its own number."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


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
        task.board.joysticks.update(axis)


def jog_gain(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.gain = axis.rate(float(task.value(command)), "uu/s")
        task.board.joysticks.update(axis)


def jog_deadband(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.deadband = float(task.value(command))
        task.board.joysticks.update(axis)


def jog_offset(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.jog.offset = float(task.value(command))
        task.board.joysticks.update(axis)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("modes").row


ROWS = (
    _row("JN", "command", "C", "axes", "", jog_on, "Jogging on: the axis follows its joystick input.", "1MN,1JN",
         effect="act hands-over", selects="analogue input"),
    _row("JF", "command", "C", "axes", "", jog_off, "Jogging off: the axis stops.", "1JF", effect="stop"),
    _row("JA", "setting", "W", "axes", "uu/s2", jog_accel, "Set the acceleration of jogging.",
         "1JA50000", default=100000, low=0),
    _row("JV", "setting", "W", "axes", "uu/s", jog_minimum, "Set the least velocity of jogging.",
         "1JV100", default=0, low=0),
    _row("JB", "setting", "W", "axes", "number", jog_deadband,
         "Set the deadband of the joystick, volts either side of its offset.", "1JB0.2", default=0.1, low=0),
    _row("JG", "setting", "W", "axes", "uu/s", jog_gain, "Set the velocity of jogging per volt.",
         "1JG2000", default=1000),
    _row("JO", "setting", "W", "axes", "number", jog_offset, "Set the voltage of the joystick at rest.",
         "1JO2.5", default=0, low=-10, high=10),
)  # fmt: skip
