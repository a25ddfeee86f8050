"""Switching axes on and off, moving and stopping them.

There is no queue of single-axis moves: a move command replaces the target. With the trapezoidal profile this
happens in motion, unless the axis must reverse. In that case the interpreter stalls until the axis has
stopped (DCX-PCI firmware 1.0a). With the other profiles the interpreter stalls until the axis is at rest. An
axis that runs continuously in velocity mode rejects the move.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, TypeAlias

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.steps import DO, WAIT
from motionlang.kernel.lang.waits import Wait, wait_idle
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import CONTOUR, GAIN, POSITION, TORQUE, VELOCITY, AxisState
from motionlang.kernel.mccl.axis.launch import aim, check_unslaved, launch
from motionlang.kernel.mccl.codes import Fault, LineAbandoned
from motionlang.kernel.mccl.keywords.row import Group, written

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter

Targets: TypeAlias = list[tuple[AxisState, float]]


def motor_on(task: CommandTask, command: Command) -> None:
    """Apply the pending units, clear faults and switch on the axes (MN)."""
    controller = task.board.controller
    for axis in task.axes(command):
        axis.apply_units()
        axis.forget_faults()
        controller.set_scale(axis.number, axis.scale.counts, axis.scale.rate, axis.scale.zero)
        controller.enable(axis.number)
        motor.tune(task.board, axis)


def motor_off(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        axis.running = False
        task.board.release(axis)
        task.board.controller.disable(axis.number)


def moves(targets: Callable[[CommandTask, Command], Targets]) -> Action:
    """Make a command that starts moves from a function that returns their targets, counts.

    An axis that must reverse comes to rest first.
    """

    @written
    @wraps(targets)
    def write(line: LineWriter, command: Command) -> None:
        line.act(WAIT, lambda task, command: _start_moves(task, command, targets(task, command)))
        line.act(DO, _start_later)

    return write


@moves
def move_to(task: CommandTask, command: Command) -> Targets:
    value = float(task.value(command))
    return [(axis, axis.position(value)) for axis in movable(task, command)]


@moves
def move_by(task: CommandTask, command: Command) -> Targets:
    """Move by n user units relative to the target (MR).

    On a path, the move is relative to the end of the path so far.
    """
    if command.is_bare:
        fault = codes.no_distance(command.text)
        task.board.warn(task, fault.kind, fault.message, fault.hint)
    value = float(task.value(command))
    path = task.path_open
    targets = []
    for axis in movable(task, command):
        target = path.end_of(axis) if path is not None else aim(task.board, axis)
        distance = axis.distance(value)
        inexact = codes.inexact(command.text, axis.number, value, distance, axis.scale.counts)
        if inexact is not None:
            task.board.warn(task, inexact.kind, inexact.message, inexact.hint)
        targets.append((axis, target + distance))
    return targets


@moves
def go_home(task: CommandTask, command: Command) -> Targets:
    return [(axis, axis.position(0.0)) for axis in movable(task, command)]


def go(task: CommandTask, command: Command) -> None:
    """Run in velocity mode, or start the queued paths in contour mode."""
    for axis in task.axes(command):
        if axis.mode == VELOCITY:
            _check_fit(task, axis)
            run_in_velocity_mode(task, axis)
        elif axis.mode == CONTOUR and axis.controlling == axis.number:
            task.board.contour(axis).go()
        elif command.axis:
            hint = f"{axis.number}VM switches it; position moves start with MA or MR"
            if axis.mode == CONTOUR:
                hint = f"{axis.controlling}GO starts the paths of its contour"
            raise Fault(
                codes.INVALID,
                f"GO needs axis {axis.number} in velocity mode; it is in {axis.mode} mode",
                hint,
            )


def stop(task: CommandTask, command: Command) -> None:
    """Stop with deceleration (ST).

    A contour stops as a whole; gearing and joysticks are switched off.
    """
    board = task.board
    for axis in task.axes(command):
        axis.running = False
        board.joysticks.switch_off(axis)
        contour = board.contour_including(axis)
        if contour is not None:
            contour.stop()
        else:
            board.controller.stop(axis.number)


def abort(task: CommandTask, command: Command) -> None:
    """Stop the axes instantly (AB), or decelerate them at DS if so configured."""
    for axis in task.axes(command):
        axis.running = False
        contour = task.board.contour_including(axis)
        if contour is not None:
            contour.abort()
        task.board.release(axis)
        if task.board.assumptions.get("mccl.abort-rate") == "DS":
            task.board.controller.stop(axis.number)
        else:
            task.board.controller.abort(axis.number)


def direction(task: CommandTask, command: Command) -> None:
    sign = -1 if task.value(command) else 1
    for axis in task.axes(command):
        axis.direction = sign
        if axis.mode == TORQUE:
            motor.drive(task.board, axis)


def define_home(task: CommandTask, command: Command) -> None:
    value = float(task.value(command))
    for axis in task.axes(command):
        task.board.define_position(axis, axis.position(value) - axis.shift)


def position_mode(task: CommandTask, command: Command) -> None:
    _mode(task, command, POSITION)


def velocity_mode(task: CommandTask, command: Command) -> None:
    _mode(task, command, VELOCITY)


def torque_mode(task: CommandTask, command: Command) -> None:
    _mode(task, command, TORQUE)


def gain_mode(task: CommandTask, command: Command) -> None:
    _mode(task, command, GAIN)


def reset(task: CommandTask, command: Command) -> None:
    """Reset the axis, or without an axis the board, its outputs and all tasks (RT)."""
    if command.axis:
        task.board.reset_axis(task.axis(command))
        return
    board = task.board
    board.reset()
    for levels in (board.controller.outputs, board.controller.analogue_outputs):
        levels.clear()
    raise LineAbandoned


def run_in_velocity_mode(task: CommandTask, axis: AxisState) -> None:
    """Run at SV in the direction of DI until another command."""
    controller = task.board.controller
    velocity = float(controller.setting(axis.number, "speed") or 0.0)
    controller.jog(axis.number, axis.direction * velocity, task.word, task.source_line)
    axis.running = True


def _mode(task: CommandTask, command: Command, mode: str) -> None:
    for axis in task.axes(command):
        task.board.leave_contour(axis)
        before, axis.mode = axis.mode, mode
        motor.changed_mode(task.board, axis, before)


def movable(task: CommandTask, command: Command) -> tuple[AxisState, ...]:
    """Return the axis that the command names, or all axes that are on."""
    axes = task.axes(command)
    if command.axis:
        return axes
    return tuple(axis for axis in axes if task.board.controller.is_enabled(axis.number)) or axes


def _start_moves(task: CommandTask, command: Command, targets: Targets) -> Wait | None:
    """Start moves; return the wait for axes that must reverse, whose moves `_start_later` starts.

    Raises Fault unless in position mode (PM).
    """
    task.later = []
    path = task.path_open
    if path is not None:
        path.move(task, targets)
        return None
    for axis, _ in targets:
        _check_fit(task, axis)
        if axis.mode != POSITION:
            hint = f"{axis.number}PM switches it back"
            if axis.mode == CONTOUR:
                hint = f"{axis.controlling}CP1 begins a path and comes before it on the line; {hint}"
            raise Fault(
                codes.INVALID,
                f"{command.name} needs axis {axis.number} in position mode; it is in {axis.mode} mode",
                hint,
            )
    stalled = [axis.number for axis, target in targets if _must_rest(task, axis, target)]
    if not stalled:
        _start(task, command, targets)
        return None
    _check_rest(task, command, stalled)
    at_once = [pair for pair in targets if pair[0].number not in stalled]
    task.later = [(axis.number, target) for axis, target in targets if axis.number in stalled]
    _start(task, command, at_once)
    now = task.board.controller.clock.now
    return wait_idle(task.board.controller, now, stalled)


def _start_later(task: CommandTask, command: Command) -> None:
    later, task.later = task.later, []
    _start(task, command, [(task.board.axes[number], target) for number, target in later])


def _start(task: CommandTask, command: Command, targets: Targets) -> None:
    for axis, target in targets:
        axis.running = False
        launch(task.board, axis, target, command.name, task.source_line)


def _check_fit(task: CommandTask, axis: AxisState) -> None:
    """Raise Rejected or Fault if the axis cannot accept a motion command now."""
    number = axis.number
    motor.check_on(task.board, axis)
    check_unslaved(task.board, axis)
    if axis.jogging:
        raise Fault(codes.INVALID, f"axis {number} follows its joystick", f"{number}JF frees it", "moving")


def _check_rest(task: CommandTask, command: Command, stalled: list[int]) -> None:
    """Raise Fault if the standstill that a move waits for never comes.

    This is the case if its axis runs continuously in velocity mode.
    """
    for number in stalled:
        if task.board.controller.idle_time(number) == INFINITY:
            words = f"{command.name} needs axis {number} at rest with its profile, and it runs on in velocity mode"
            raise Fault(
                codes.INVALID, words, f"{number}ST stops it; with {number}PT it may be running", "moving"
            )


def _must_rest(task: CommandTask, axis: AxisState, target: float) -> bool:
    """True if the axis must come to rest before it can accept the target.

    For a reversal it begins to decelerate at once.
    """
    controller = task.board.controller
    number = axis.number
    if controller.is_idle(number):
        return False
    if controller.setting(number, "shape") != "trapezoid":
        return True
    velocity = controller.demand_velocity(number)
    decel = float(controller.setting(number, "decel") or 0.0)
    if decel <= 0.0 or velocity == 0.0:
        return False
    rest = controller.demand(number) + velocity * abs(velocity) / (2.0 * decel)
    if (target - rest) * velocity >= 0.0 or abs(target - rest) <= 1e-6:
        return False
    controller.stop(number)
    return True


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("motion").row
_modes_row = Group("modes").row


ROWS = (
    _row("MN", "command", "C", "axes", "", motor_on,
         "Motor on: target, optimal and actual position become one, faults are forgotten, user units take effect.",
         "1MN", effect="enable", meant="ON ENABLE", topic="enable"),
    _row("MF", "command", "C", "axes", "", motor_off, "Motor off: motion ends, the output is 0 V.",
         "1MF", effect="stop abrupt off", meant="OFF DISABLE", topic="enable"),
    _row("MA", "move", "W", "axes", "uu", move_to, "Move to a position.", "1MN,1MA1000", effect="start",
         meant="MOVE MOVEA", topic="move"),
    _row("MR", "move", "W", "axes", "uu", move_by, "Move by a distance, counted from the present target.",
         "1MN,1MR-500", effect="start relative", meant="MOVE MOVER", topic="move"),
    _row("GH", "move", "C", "axes", "", go_home, "Go home: move to position 0.", "1MN,1GH", effect="start",
         meant="HOME", topic="move"),
    _row("GO", "move", "W", "axes", "number", go,
         "Start: run in velocity mode, or release the contour paths that wait.", "1MN,1VM,1GO,WA0.1,1ST",
         effect="run", topic="move"),
    _row("DI", "setting", "W", "axes", "bool", direction, "Direction of velocity mode: 0 positive, 1 negative.",
         "1DI1", default=0, low=0, high=1, topic="move"),
    _row("ST", "command", "C", "axes", "", stop, "Stop at the programmed deceleration.", "1ST", effect="stop",
         meant="STOP", topic="stop"),
    _row("AB", "command", "C", "axes", "", abort, "Abort: stop at once, the motor stays on.", "1AB",
         effect="stop abrupt", meant="ABORT", topic="stop"),
    _row("DH", "command", "W", "axes", "uu", define_home, "Define home: the present position becomes this one.",
         "1DH0", effect="zero", topic="home"),
    _row("RT", "command", "C", "axes", "", reset, "Reset the axis, or without an axis the whole controller.",
         "1RT", effect="stop abrupt datum off", meant="RESET", topic="stop"),
    _modes_row("PM", "command", "C", "axes", "", position_mode, "Position mode: moves to targets.", "1PM",
               effect="mode targets"),
    _modes_row("VM", "command", "C", "axes", "", velocity_mode, "Velocity mode: GO runs at SV in the direction of DI.",
               "1VM", effect="mode endless"),
    _modes_row("QM", "command", "C", "axes", "", torque_mode,
               "Torque mode: SQ sets the output directly; shows in the status, moves nothing without a "
               "simulated motor.", "1QM", effect="mode"),
    _modes_row("GM", "command", "C", "axes", "", gain_mode,
               "Gain mode: proportional gain only; shows in the status.", "1GM", effect="mode"),
)  # fmt: skip
