"""Waits for a time, for axes to stop, and for a position.

Each wait ends at its exact time, without polling.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.lang.waits import Wait, until_idle, wait_idle, wait_until
from motionlang.mccl.axis.motion_phase import at_target_time
from motionlang.mccl.keywords.row import Group, pure

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.board import Board
    from motionlang.mccl.runtime.task import CommandTask

BEFORE_NEVER = 1e300
# Counts within which a position counts as reached: far below one, far above rounding.
_REACHED = 1e-6


@pure
def wait(task: CommandTask, command: Command) -> Wait | None:
    found = _dwell(task, command, task.board.controller.clock.now)
    if found is not None:
        task.poll.wait(task.board.seconds(float(task.value(command))))
    return found


def wait_stop(task: CommandTask, command: Command) -> Wait | None:
    """Wait until the trajectory is complete, then for the given time."""
    board, controller = task.board, task.board.controller
    now = controller.clock.now
    stopping = task.axes(command)
    axes = tuple([axis.number for axis in stopping])
    if board.contours and any(map(board.awaits_path, stopping)):
        task.then = lambda time: wait_stop(task, command)
        return Wait(
            now,
            lambda: not any(map(board.awaits_path, stopping)),
            lambda: INFINITY,
            until_idle(axes),
            "axis",
            axes,
        )
    for number in axes:
        if not controller.is_at_standstill(number) and not task.comes_to_rest(axes):
            task.then = lambda time: _stopped(task, command, stopping, time)
            return wait_idle(controller, now, axes)
    return _stopped(task, command, stopping, controller.clock.now)


def _stopped(task: CommandTask, command: Command, axes: Iterable[AxisState], now: float) -> Wait | None:
    """Dwell, unless a contour path of an axis waits."""
    board = task.board
    if board.contours and any(map(board.awaits_path, axes)):
        return wait_stop(task, command)
    return _dwell(task, command, now)


def wait_target(task: CommandTask, command: Command) -> Wait | None:
    """Wait until each axis has been within DB of its target for DT.

    Then wait for the given time.
    """
    axes = list(task.axes(command))
    return _next_target(task, command, axes, task.board.controller.clock.now)


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


def _next_target(task: CommandTask, command: Command, axes: list[AxisState], now: float) -> Wait | None:
    board = task.board
    while axes:
        axis = axes[0]
        until = at_target_time(board, axis)
        if until > now:
            return _until_target(task, command, axes, now, until)
        axes.pop(0)
    return _dwell(task, command, now)


def _until_target(
    task: CommandTask, command: Command, axes: list[AxisState], now: float, until: float
) -> Wait:
    board, axis = task.board, axes[0]
    clock = board.controller.clock
    task.then = lambda time: _next_target(task, command, axes, time)
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


def _dwell(task: CommandTask, command: Command, now: float) -> Wait | None:
    seconds = task.board.seconds(float(task.value(command)))
    if seconds <= 0.0:
        return None
    return wait_until(task.board.controller, now, now + seconds)


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
         meant="WAIT SLEEP DELAY DWELL"),
    _row("WS", "statement", "W", "axes", "s", wait_stop,
         "Wait for stop: until the trajectory is complete, then for a time.", "1WS0.1", low=0, meant="WAIT IDLE"),
    _row("WT", "statement", "W", "axes", "s", wait_target,
         "Wait for target: until the axis has been in the deadband for DT, then for a time.", "1WT0.1", low=0,
         meant="WAIT"),
    _row("WP", "statement", "W", "axis", "uu", wait_position, "Wait until the axis passes a position.",
         "1MN,1MR1000,1WP500"),
    _row("WR", "statement", "W", "axis", "uu", wait_relative,
         "Wait until the axis has moved this far from where it is now.", "1MN,1MR1000,1WR500"),
    _motion_row("IP", "command", "W", "axes", "uu", break_at, "Set a breakpoint at a position: status bit 10 shows it.",
                "1IP500"),
    _motion_row("IR", "command", "W", "axes", "uu", break_after,
                "Set a breakpoint at a distance from the present position.", "1IR500"),
)  # fmt: skip
