"""Servo loop settings.

Without a simulated motor the values are stored and reported, and motion is ideal.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import nearest_whole
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask


def _keep(function: str) -> Action:
    """Return an action that stores the value under the name of its function."""

    def keep(task: CommandTask, command: Command) -> None:
        value = float(task.value(command))
        if task.board.model.whole_gains:
            value = nearest_whole(value)
        for axis in task.axes(command):
            axis.stored[function] = value
            if function == "kept_error_limit":
                motor.limit_error(task.board, axis)
            else:
                motor.tune(task.board, axis)

    return keep


def deadband(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.deadband = axis.distance(float(task.value(command)))
        motor.settle(task.board, axis)


def deadband_delay(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.deadband_delay = float(task.value(command))
        motor.settle(task.board, axis)


def output_phase(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.reversed_phase = bool(task.value(command))
        motor.tune(task.board, axis)


# ------------------------------------------------------------------------------------------------- keywords


def stored(function: str) -> Actions:
    return Actions(function, do=_keep(function))


_row = Group("servo filter").row


ROWS = (
    _row("SG", "setting", "W", "axes", "number", stored("kept_gain"), "Set the proportional gain.",
         "1SG0.01", default=0, low=0, tunes="proportional"),
    _row("SI", "setting", "W", "axes", "number", stored("kept_integral"), "Set the integral gain.",
         "1SI0.000001", default=0, low=0, tunes="integral"),
    _row("IL", "setting", "W", "axes", "number", stored("kept_integral_limit"), "Set the limit of the integral term.",
         "1IL1000", default=0, low=0, tunes="integral_limit"),
    _row("SD", "setting", "W", "axes", "number", stored("kept_derivative"), "Set the derivative gain.",
         "1SD0.25", default=0, low=0, tunes="derivative"),
    _row("SE", "setting", "W", "axes", "counts", stored("kept_error_limit"),
         "Set the largest following error; beyond it the motor is switched off. 0 means no check.",
         "1SE2500", default=1024, low=0),
    _row("FR", "setting", "W", "axes", "number", stored("kept_derivative_period"),
         "Set the sampling period of the derivative term.", "1FR3", default=0, low=0, tunes="derivative_every"),
    _row("VG", "setting", "W", "axes", "number", stored("kept_velocity_gain"), "Set the velocity feed-forward gain.",
         "1VG0.5", default=0, tunes="velocity_ff", family="feed-forward"),
    _row("AG", "setting", "W", "axes", "number", stored("kept_accel_gain"), "Set the acceleration feed-forward gain.",
         "1AG0.1", default=0, tunes="accel_ff", family="feed-forward"),
    _row("DG", "setting", "W", "axes", "number", stored("kept_decel_gain"), "Set the deceleration feed-forward gain.",
         "1DG0.1", default=0, tunes="decel_ff", family="feed-forward"),
    _row("DB", "setting", "W", "axes", "uu", deadband,
         "Set the band round the target in which the axis is at target.",
         "1DB10", default=0, low=0),
    _row("DT", "setting", "W", "axes", "s", deadband_delay,
         "Set how long the axis must stay in the deadband to be at target.", "1DT0.05", default=0, low=0),
    _row("OB", "setting", "W", "axes", "number", stored("kept_output_deadband"),
         "Set the deadband of the output, volts.",
         "1OB0.1", default=0, low=0, high=10, tunes="output_deadband", family="output control"),
    _row("OO", "setting", "W", "axes", "number", stored("kept_output_offset"), "Set the offset of the output, volts.",
         "1OO0.05", default=0, low=-10, high=10, tunes="output_offset", family="output control"),
    _row("PH", "setting", "W", "axes", "bool", output_phase, "Output phase: 0 standard, 1 reversed.",
         "1PH0", default=0, low=0, high=1, tunes="reversed"),
)  # fmt: skip
