"""Velocity, acceleration and the shape of profiles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.keywords.motion import run_in_velocity_mode
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def accel(task: CommandTask, command: Command) -> None:
    both = not task.board.model.separate_decel
    for axis in _write(task, command, "accel", "uu/s2"):
        if both:
            axis.write["decel"](task.board.controller.setting(axis.number, "accel"))


def decel(task: CommandTask, command: Command) -> None:
    _write(task, command, "decel", "uu/s2")


def speed(task: CommandTask, command: Command) -> None:
    for axis in _write(task, command, "speed", "uu/s"):
        if axis.running:
            run_in_velocity_mode(task, axis)


def minimum_speed(task: CommandTask, command: Command) -> None:
    value = task.value(command)
    for axis in task.axes(command):
        axis.minimum = axis.rate(value, "uu/s")


def shape_trapezoid(task: CommandTask, command: Command) -> None:
    _shape(task, command, "trapezoid")


def shape_parabolic(task: CommandTask, command: Command) -> None:
    _shape(task, command, "parabolic")


def shape_scurve(task: CommandTask, command: Command) -> None:
    """Select the sinusoidal S-curve (PS, TN1069).

    With n, select the trapezoidal S-curve with ramp ratio n.
    """
    ramp = float(task.value(command))
    if ramp == 0.0:
        _shape(task, command, "sinusoidal")
        return
    for axis in task.axes(command):
        axis.write["ramp"](ramp)
    _shape(task, command, "scurve")


def torque(task: CommandTask, command: Command) -> None:
    value = float(task.value(command))
    for axis in task.axes(command):
        axis.stored["kept_torque"] = value * axis.constant
        motor.tune(task.board, axis)


def full_step(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.half_steps = False


def half_step(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.half_steps = True


def _write(task: CommandTask, command: Command, name: str, unit: str) -> tuple[AxisState, ...]:
    value, axes = task.value(command), task.axes(command)
    for axis in axes:
        rate = axis.rate(value, unit)
        if value and not rate:
            fault = codes.rounded(command.text, float(value), rate)
            task.board.warn(task, fault.kind, fault.message, fault.hint)
        axis.write[name](rate)
    return axes


def _shape(task: CommandTask, command: Command, shape: str) -> None:
    for axis in task.axes(command):
        axis.write["shape"](shape)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("trajectory").row


ROWS = (
    _row("SA", "setting", "W", "axes", "uu/s2", accel, "Set the acceleration; a whole number until a scale is set.",
         "1SA100000", default=100000, low=0, gives="accel", meant="ACCEL ACCELERATION"),
    _row("DS", "setting", "W", "axes", "uu/s2", decel,
         "Set the deceleration; a whole number until a scale is set.", "1DS100000", default=100000, low=0,
         gives="decel", meant="DECEL DECELERATION", family="deceleration"),
    _row("SV", "setting", "W", "axes", "uu/s", speed,
         "Set the velocity of moves, a whole number until a scale is set; in velocity mode a running axis changes to "
         "it at once.",
         "1SV40000", default=40000, low=0, gives="speed", meant="SPEED VEL VELOCITY"),
    _row("MV", "setting", "W", "axes", "uu/s", minimum_speed,
         "Set the minimum velocity, at which a stepper starts and stops at once: trapezoidal moves begin and end with "
         "it; 0 for none.", "1MN,1MV1000,1MR5000,1WS,1TP", default=0, low=0, gives="minimum"),
    _row("PT", "setting", "C", "axes", "", shape_trapezoid,
         "Trapezoidal profile: constant acceleration, the fastest to velocity.", "1PT", gives="shape"),
    _row("PS", "setting", "W", "axes", "number", shape_scurve,
         "S-curve: PS or PS0 is the sinusoidal one, PSn the trapezoidal one, whose acceleration rises over the "
         "fraction n of the acceleration time.",
         "1PS0.1", default=0, low=0, high=0.5, below=True, gives="shape", family="profiles"),
    _row("PP", "setting", "C", "axes", "", shape_parabolic,
         "Parabolic profile: the acceleration falls linearly from its peak to zero.", "1PP", gives="shape",
         family="profiles"),
    _row("SQ", "setting", "W", "axes", "number", Actions("kept_torque", do=torque),
         "Set the torque limit, the largest output in volts or units of UK; stored and reported as written, though no "
         "output exceeds 10 V.",
         "1SQ3.5,1TQ", default=10, low=0, tunes="output_limit"),
    _row("FS", "setting", "C", "axes", "", full_step, "Full steps (stepper); shows in the status.", "1FS"),
    _row("SH", "setting", "C", "axes", "", half_step, "Half steps (stepper); shows in the status.", "1SH"),
)  # fmt: skip
