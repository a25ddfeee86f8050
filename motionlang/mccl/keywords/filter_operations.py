"""Settings of the servo loop, kept for reports and for a simulated motor, and the at-target band."""

from __future__ import annotations

from motionlang.mccl.axis import motor
from motionlang.mccl.axis.axis import nearest_whole
from motionlang.mccl.keywords import TABLE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def _keep(verb: str) -> Action:
    """An action that keeps the value under the name of its verb."""

    def keep(task: CommandTask, command: Command) -> None:
        value = float(task.value(command))
        if task.board.model.whole_gains and verb != "kept_torque":
            value = nearest_whole(value)
        for axis in task.axes(command):
            axis.kept[verb] = value
            if verb == "kept_error_limit":
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


ACTIONS: dict[str, Action] = {row.verb: _keep(row.verb) for row in TABLE if row.verb.startswith("kept_")}
ACTIONS |= {"deadband": deadband, "deadband_delay": deadband_delay, "output_phase": output_phase}
