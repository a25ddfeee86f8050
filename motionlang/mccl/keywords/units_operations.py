"""User units: kept until the axis is next switched on."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def _unit(field: str) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        value = float(task.value(command))
        for axis in task.axes(command):
            setattr(axis.units, field, value)

    return keep


def time_unit(task: CommandTask, command: Command) -> None:
    task.board.time_unit = float(task.value(command))


ACTIONS: dict[str, Action] = {
    "scale": _unit("counts"),
    "rate": _unit("rate"),
    "constant": _unit("constant"),
    "offset": _unit("offset"),
    "zero": _unit("zero"),
    "time_unit": time_unit,
}
