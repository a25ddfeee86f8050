"""Waits for a time, for axes to stop, and for a position.

Each wait ends at its exact time, without polling.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.steps import BRANCH, TRY, WAIT
from motionlang.kernel.lang.waits import Standstill, Wait, until_idle, wait_until
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.motion_phase import at_target_time
from motionlang.kernel.mccl.keywords.row import Group, pure, written

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.board import Board
    from motionlang.kernel.mccl.runtime.task import CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter

BEFORE_NEVER = 1e300
# Counts within which a position counts as reached: far below one, far above rounding.
_REACHED = 1e-6


@pure
def wait(task: CommandTask, command: Command) -> Wait | None:
    """Wait for the time that is the parameter."""
    seconds = task.board.seconds(float(task.value(command)))
    if seconds <= 0.0:
        return None
    now = task.board.controller.clock.now
    task.board.loops.waits(seconds)
    return wait_until(task.board.controller, now, now + seconds)


@written
def wait_stop(line: LineWriter, command: Command) -> None:
    """Wait until the trajectory is complete, then for the given time."""
    first = line.act(TRY, _paths)
    line.act(WAIT, _standstill)
    line.act(BRANCH, _has_no_path, to=first)
    line.act(WAIT, wait)


def _has_no_path(task: CommandTask, command: Command) -> bool:
    """True if no contour path of the axes waits."""
    board = task.board
    return not board.contours or not any(map(board.awaits_path, task.axes(command)))


def _paths(task: CommandTask, command: Command) -> Wait | None:
    if _has_no_path(task, command):
        return None
    axes = tuple([axis.number for axis in task.axes(command)])
    return Wait(
        task.board.controller.clock.now,
        lambda: _has_no_path(task, command),
        lambda: INFINITY,
        until_idle(axes),
        "axis",
        axes,
    )


def _standstill(task: CommandTask, command: Command) -> Wait | None:
    controller = task.board.controller
    axes = tuple([axis.number for axis in task.axes(command)])
    if all(map(controller.is_at_standstill, axes)):
        return None
    return Standstill(controller, controller.clock.now, axes)


@written
def wait_target(line: LineWriter, command: Command) -> None:
    """Wait until each axis in turn has been within DB of its target for DT.

    Then wait for the given time.
    """
    for index in range(1 if command.axis else len(line.board.all_axes)):
        line.act(TRY, _target(index))
    line.act(WAIT, wait)


def wait_position(task: CommandTask, command: Command) -> Wait | None:
    axis = task.axis(command)
    return passing(task.board, axis, axis.position(float(task.value(command))))


def wait_relative(task: CommandTask, command: Command) -> Wait | None:
    axis = task.axis(command)
    here = task.board.controller.position(axis.number)
    return passing(task.board, axis, here + axis.distance(float(task.value(command))))


def passing(board: Board, axis: AxisState, position: float) -> Wait | None:
    """Return a wait until the axis reaches or passes a position, counts.

    The breakpoint bit is set then.
    """
    controller, number = board.controller, axis.number
    board.forget_breakpoint(number)
    axis.breakpoint, axis.breakpoint_reached = position, False
    margin = _REACHED + 1e-12 * abs(position)
    side = 1.0 if controller.position(number) < position else -1.0

    def ready() -> bool:
        reached = (position - controller.position(number)) * side <= margin
        # If time is too coarse for the position, the crossing time decides.
        reached = reached or controller.crossing_time(number, position) <= controller.clock.now
        axis.breakpoint_reached = axis.breakpoint_reached or reached
        return reached

    if ready():
        return None
    shown = axis.say(position)
    return Wait(
        controller.clock.now,
        ready,
        lambda: controller.crossing_time(number, position),
        f"for axis {number} to pass {shown}",
        "axis",
        (number,),
    )


def passing_flag(board: Board, ready: Callable[[], bool], why: str) -> Wait:
    """Return a wait for a condition that an event makes true."""
    return Wait(board.controller.clock.now, ready, lambda: INFINITY, why)


def _target(index: int) -> Callable[[CommandTask, Command], Wait | None]:
    def until_target(task: CommandTask, command: Command) -> Wait | None:
        axis, now = task.axes(command)[index], task.board.controller.clock.now
        until = at_target_time(task.board, axis)
        return _until_target(task.board, axis, now, until) if until > now else None

    return until_target


def _until_target(board: Board, axis: AxisState, now: float, until: float) -> Wait:
    clock = board.controller.clock
    has_motor = board.controller.axes[axis.number].feedback is not None
    if until < INFINITY and not has_motor:
        why = f"for axis {axis.number} to be at target"
        return Wait(now, lambda: clock.now >= until, lambda: until, why, "axis", (axis.number,))
    return Wait(
        now,
        lambda: at_target_time(board, axis) <= (clock.now if has_motor else BEFORE_NEVER),
        lambda: at_target_time(board, axis),
        f"for axis {axis.number} to be at target",
        "axis",
        (axis.number,),
    )


def break_at(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        _breakpoint(task.board, axis, axis.position(float(task.value(command))))


def break_after(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        here = task.board.controller.position(axis.number)
        _breakpoint(task.board, axis, here + axis.distance(float(task.value(command))))


def _breakpoint(board: Board, axis: AxisState, position: float) -> None:
    """Have status bit 10 set when the axis passes the position, without a wait."""
    controller, number = board.controller, axis.number
    board.forget_breakpoint(number)
    axis.breakpoint = position
    axis.breakpoint_reached = abs(controller.position(number) - position) <= _REACHED

    def reach(direction: int) -> None:
        axis.breakpoint_reached = True

    board.breakpoints[number] = controller.watch(number, position, reach)


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("flow").row
_motion_row = Group("motion").row


ROWS = (
    _row("WA", "statement", "W", "none", "s", wait, "Wait for a time.", "WA0.5", low=0,
         meant="WAIT SLEEP DELAY DWELL", waits="time"),
    _row("WS", "statement", "W", "axes", "s", wait_stop,
         "Wait for stop: until the trajectory is complete, then for a time.", "1WS0.1", low=0, effect="rest",
         meant="WAIT IDLE", waits="axis"),
    _row("WT", "statement", "W", "axes", "s", wait_target,
         "Wait for target: until the axis has been in the deadband for DT, then for a time.", "1WT0.1", low=0,
         effect="rest", meant="WAIT", waits="axis"),
    _row("WP", "statement", "W", "axis", "uu", wait_position, "Wait until the axis passes a position.",
         "1MN,1MR1000,1WP500", waits="axis"),
    _row("WR", "statement", "W", "axis", "uu", wait_relative,
         "Wait until the axis has moved this far from where it is now.", "1MN,1MR1000,1WR500", waits="axis"),
    _motion_row("IP", "command", "W", "axes", "uu", break_at, "Set a breakpoint at a position: status bit 10 shows it.",
                "1IP500"),
    _motion_row("IR", "command", "W", "axes", "uu", break_after,
                "Set a breakpoint at a distance from the present position.", "1IR500"),
)  # fmt: skip
