"""What the controller tells: a line an axis, `01 1234`."""

from __future__ import annotations

from motionlang.mccl.axis.axis import real
from motionlang.mccl.axis.launch import aim
from motionlang.mccl.axis.status import word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

    Reading = Callable[[CommandTask, AxisState], str]


def _each(reading: Reading) -> Action:
    """An action that tells one reading of each axis the command speaks to."""

    def tell(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            task.tell(axis.number, reading(task, axis))

    return tell


def _position(task: CommandTask, axis: AxisState) -> str:
    return axis.say(task.board.controller.position(axis.number) + axis.shift)


def _target(task: CommandTask, axis: AxisState) -> str:
    return axis.say(aim(task.board.controller, axis))


def _optimal(task: CommandTask, axis: AxisState) -> str:
    return axis.say(task.board.controller.demand(axis.number) + axis.shift)


def _following(task: CommandTask, axis: AxisState) -> str:
    return axis.say(task.board.controller.following_error(axis.number), "uu")


def _velocity(task: CommandTask, axis: AxisState) -> str:
    return axis.say(task.board.controller.velocity(axis.number), "uu/s")


def _breakpoint(task: CommandTask, axis: AxisState) -> str:
    if axis.breakpoint is None:
        return "NONE" if task.board.readings.get("mccl.no-breakpoint") == "NONE" else axis.say(0.0)
    return axis.say(axis.breakpoint)


def _index(task: CommandTask, axis: AxisState) -> str:
    return axis.say(axis.index_position)


def _kept(name: str) -> Reading:
    def reading(task: CommandTask, axis: AxisState) -> str:
        value = axis.kept.get(name, KEPT_DEFAULTS.get(name, 0.0))
        return str(int(value)) if axis.model.whole_gains else real(value)

    return reading


# What a setting of the servo loop is at power-up, where it is not 0.
KEPT_DEFAULTS = {"kept_torque": 10.0, "kept_error_limit": 1024.0}


def tell_status(task: CommandTask, command: Command) -> None:
    """TS: a status word of each axis, by its number."""
    which = task.whole(command)
    for axis in task.axes(command):
        value, _ = word(task.board, axis, which)
        task.tell(axis.number, task.board.whole(value))


def tell_error(task: CommandTask, command: Command) -> None:
    task.reply(str(task.board.last_error))
    if task.board.readings.get("mccl.error-told") == "cleared":
        task.board.last_error = 0


def tell_segment(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    task.tell(axis.number, str(axis.segments))


ACTIONS: dict[str, Action] = {
    "tell_position": _each(_position),
    "tell_target": _each(_target),
    "tell_optimal": _each(_optimal),
    "tell_following": _each(_following),
    "tell_velocity": _each(_velocity),
    "tell_status": tell_status,
    "tell_error": tell_error,
    "tell_gain": _each(_kept("kept_gain")),
    "tell_integral": _each(_kept("kept_integral")),
    "tell_derivative": _each(_kept("kept_derivative")),
    "tell_integral_limit": _each(_kept("kept_integral_limit")),
    "tell_velocity_gain": _each(_kept("kept_velocity_gain")),
    "tell_torque": _each(_kept("kept_torque")),
    "tell_breakpoint": _each(_breakpoint),
    "tell_index": _each(_index),
    "tell_segment": tell_segment,
}
