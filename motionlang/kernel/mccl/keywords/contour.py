"""Contour paths: several axes on lines and arcs at one vector velocity."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import CONTOUR, AxisState
from motionlang.kernel.mccl.axis.launch import check_unslaved
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group
from motionlang.kernel.mccl.motion.path import Path

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


def contour_mode(task: CommandTask, command: Command) -> None:
    """Make the axis join the contour of axis n (CM).

    Raises Fault while it moves, has a master, or belongs to another contour.
    """
    axis, number = task.axis(command), task.whole(command)
    task.board.axis(number)
    check_unslaved(task.board, axis)
    if not task.board.controller.is_idle(axis.number):
        raise Fault(codes.INVALID, f"axis {axis.number} is moving", f"{axis.number}WS waits for it", "moving")
    if axis.mode == CONTOUR and axis.controlling not in (None, number):
        raise Fault(
            codes.ALREADY_ASSIGNED,
            f"axis {axis.number} is in contour mode under axis {axis.controlling} already",
            f"{axis.number}PM frees it",
            "axis",
        )
    before, axis.mode, axis.controlling = axis.mode, CONTOUR, number
    motor.changed_mode(task.board, axis, before)


def path(task: CommandTask, command: Command) -> None:
    """Begin a path of kind n on the contour's axes (CP).

    The commands that follow describe it.
    """
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
    """Set a factor on the vector velocity, including that of the current path.

    Raises Fault for 0, which would suspend the path for ever.
    """
    value = float(task.value(command)) if task.given(command) else 1.0
    if value == 0.0:
        raise Fault(codes.PARAMETER, "VO0 would hold the path forever", "ST stops it", "zero-speed")
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


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("contour").row
_trajectory_row = Group("trajectory").row
_modes_row = Group("modes").row


ROWS = (
    _row("CP", "move", "W", "axis", "number", path,
         "Begin a contour path on the controlling axis: 0 user defined, 1 line, 2 clockwise arc, 3 anticlockwise arc; "
         "the commands that follow on the line say where it goes.",
         "1MN,2MN,1CM1,2CM1,1CP1,1MA100,2MA50", low=0, high=3, family="contours", effect="act", topic="move"),
    _row("CA", "setting", "W", "axis", "uu", arc_center, "Centre of the arc of this path, absolute.",
         "1MN,2MN,1CM1,2CM1,1CP2,1CA100,2CA0,1MA200,2MA0", family="contours"),
    _row("CR", "setting", "W", "axis", "uu", arc_center_by, "Centre of the arc of this path, from its start.",
         "1MN,2MN,1CM1,2CM1,1CP2,1CR100,2CR0,1MR200,2MR0", family="contours"),
    _row("EA", "setting", "W", "axis", "number", arc_end,
         "Ending angle of the arc of this path, degrees, absolute.",
         "1MN,2MN,1CM1,2CM1,1CP3,1CR-100,2CR0,1EA90", family="contours"),
    _row("ER", "setting", "W", "axis", "number", arc_end_by,
         "Ending angle of the arc of this path, degrees from its start.",
         "1MN,2MN,1CM1,2CM1,1CP3,1CR-100,2CR0,1ER90", family="contours"),
    _row("RR", "setting", "W", "axis", "uu", arc_radius,
         "Radius of the arc of this path; negative takes the longer way.",
         "1MN,2MN,1CM1,2CM1,1CP2,1RR100,1MR200,2MR0", family="contours"),
    _row("CD", "setting", "W", "axis", "uu", path_distance, "Length along a user-defined path.",
         "1MN,2MN,1CM1,2CM1,1CP0,1CD100,1MR60,2MR80", low=0, family="contours"),
    _trajectory_row("VO", "setting", "W", "axes", "number", override,
                    "Velocity override of contour paths: the vector velocity is multiplied by it.",
                    "1VO0.5", default=1, low=0, high=10, family="contours"),
    _trajectory_row("VV", "setting", "W", "axis", "uu/s", vector_velocity,
                    "Vector velocity of contour paths, on the controlling axis.", "1VV20000", default=40000, low=0,
                    gives="vector speed", family="contours"),
    _trajectory_row("VA", "setting", "W", "axis", "uu/s2", vector_accel,
                    "Vector acceleration of contour paths, on the controlling axis.", "1VA100000",
                    default=100000, low=0, gives="vector accel", family="contours"),
    _trajectory_row("VD", "setting", "W", "axis", "uu/s2", vector_decel,
                    "Vector deceleration of contour paths, on the controlling axis.", "1VD100000",
                    default=100000, low=0, gives="vector decel", family="contours"),
    _modes_row("CM", "command", "W", "axis", "number", contour_mode,
               "Contour mode under the controlling axis n.", "1CM1", low=0, effect="mode hands-over",
               family="contours"),
    _modes_row("SN", "command", "C", "axis", "", sync_on,
               "Synchronise contour moves: the paths that follow wait for GO.", "1SN", family="contours"),
    _modes_row("NS", "command", "C", "axis", "", sync_off, "Contour moves start at once.", "1NS", family="contours"),
)  # fmt: skip
