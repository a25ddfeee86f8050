"""Contour mode: describing paths, and letting them go."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis.axis import CONTOUR
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords.modes_gearing import check_unslaved
from motionlang.mccl.motion.path import Path

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def contour_mode(task: CommandTask, command: Command) -> None:
    """CM: the axis joins the contour of axis n. Fault while it moves, has a master, or belongs to another contour."""
    axis, number = task.axis(command), task.whole(command)
    task.board.axis(number)
    check_unslaved(task, axis)
    if not task.board.controller.is_idle(axis.number):
        raise Fault(codes.INVALID, f"axis {axis.number} is moving", f"{axis.number}WS waits for it", "moving")
    if axis.mode == CONTOUR and axis.controlling not in (None, number):
        raise Fault(
            codes.ALREADY_ASSIGNED,
            f"axis {axis.number} is in contour mode under axis {axis.controlling} already",
            f"{axis.number}PM frees it",
            "axis",
        )
    axis.mode, axis.controlling = CONTOUR, number


def path(task: CommandTask, command: Command) -> None:
    """CP: begin a path of kind n on the contour's axes; the commands that follow describe it."""
    axis = task.axis(command)
    if axis.mode != CONTOUR or axis.controlling != axis.number:
        raise Fault(
            codes.NOT_ASSIGNED,
            f"axis {axis.number} does not control a contour",
            f"{axis.number}CM{axis.number} makes it",
            "axis",
        )
    task.path_open = Path(axis, task.board.contour(axis), task.whole(command), task.word, task.source_line)


def vector_velocity(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    axis.vector.velocity = axis.rate(float(task.value(command)), "uu/s")


def vector_accel(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    axis.vector.accel = axis.rate(float(task.value(command)), "uu/s2")


def vector_decel(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    axis.vector.decel = axis.rate(float(task.value(command)), "uu/s2")


def override(task: CommandTask, command: Command) -> None:
    """Multiplies the vector velocity, also of the path under way; 0 would hold it for ever and is refused."""
    value = float(task.value(command)) if task.given(command) else 1.0
    if value == 0.0:
        raise Fault(codes.PARAMETER, "VO0 would hold the path for ever", "ST stops it", "zero-speed")
    for axis in task.axes(command):
        axis.vector.override = value
        contour = task.board.contours.get(axis.number)
        if contour is not None:
            contour.set_speed()


def arc_center(task: CommandTask, command: Command) -> None:
    axis, described = _described(task, command)
    described.center[axis.number] = float(task.value(command))


def arc_center_by(task: CommandTask, command: Command) -> None:
    axis, described = _described(task, command)
    start = axis.scale.position_to_user(described.end_of(axis))
    described.center[axis.number] = start + float(task.value(command))


def arc_end(task: CommandTask, command: Command) -> None:
    _described(task, command)[1].end_angle = float(task.value(command))


def arc_end_by(task: CommandTask, command: Command) -> None:
    _described(task, command)[1].sweep = float(task.value(command))


def arc_radius(task: CommandTask, command: Command) -> None:
    _described(task, command)[1].radius = float(task.value(command))


def path_distance(task: CommandTask, command: Command) -> None:
    _described(task, command)[1].distance = float(task.value(command))


def sync_on(task: CommandTask, command: Command) -> None:
    task.axis(command).synchronised = True


def sync_off(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    axis.synchronised = False
    contour = task.board.contours.get(axis.number)
    if contour is not None:
        contour.go()


def _described(task: CommandTask, command: Command) -> tuple[AxisState, Path]:
    axis, described = task.axis(command), task.path_open
    if described is None:
        raise Fault(
            codes.INVALID,
            f"{command.name} belongs to a contour path",
            f"CP comes first on the line, such as 1CP2,{command.text}",
            "values",
        )
    described.member(axis)
    return axis, described


ACTIONS: dict[str, Action] = {
    "contour_mode": contour_mode,
    "path": path,
    "vector_velocity": vector_velocity,
    "vector_accel": vector_accel,
    "vector_decel": vector_decel,
    "override": override,
    "arc_center": arc_center,
    "arc_center_by": arc_center_by,
    "arc_end": arc_end,
    "arc_end_by": arc_end_by,
    "arc_radius": arc_radius,
    "path_distance": path_distance,
    "sync_on": sync_on,
    "sync_off": sync_off,
}
