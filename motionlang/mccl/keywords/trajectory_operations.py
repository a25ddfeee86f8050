"""Velocity, acceleration and the shape of profiles."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords.motion_operations import run_in_velocity_mode

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


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
    """Without a number the sinusoidal S-curve, with n the one of ramp ratio n (TN1069: 0 < n < 0.5)."""
    ramp = float(task.value(command))
    if ramp == 0.0:
        _shape(task, command, "sinusoidal")
        return
    if ramp >= 0.5:
        raise Fault(
            codes.PARAMETER,
            f"PS accepts a ramp below 0.5, not {ramp:g}",
            "PS alone is the sinusoidal S-curve",
            "range",
        )
    for axis in task.axes(command):
        axis.write["ramp"](ramp)
    _shape(task, command, "scurve")


def full_step(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.half_steps = False


def half_step(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.half_steps = True


def _write(task: CommandTask, command: Command, name: str, unit: str) -> tuple[AxisState, ...]:
    value, axes = task.value(command), task.axes(command)
    for axis in axes:
        axis.write[name](axis.rate(value, unit))
    return axes


def _shape(task: CommandTask, command: Command, shape: str) -> None:
    for axis in task.axes(command):
        axis.write["shape"](shape)


ACTIONS: dict[str, Action] = {
    "accel": accel,
    "decel": decel,
    "speed": speed,
    "minimum_speed": minimum_speed,
    "shape_trapezoid": shape_trapezoid,
    "shape_parabolic": shape_parabolic,
    "shape_scurve": shape_scurve,
    "full_step": full_step,
    "half_step": half_step,
}
