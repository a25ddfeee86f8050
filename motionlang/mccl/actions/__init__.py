"""What the commands do: one function a verb of the keyword table, in one module a group.

`ACTIONS` maps each verb to its function, `PURE` names the verbs that touch nothing but the accumulator.
"""

from __future__ import annotations

from motionlang.mccl.actions import (
    auxiliary,
    backlash,
    contour,
    filter,
    flow,
    functions,
    gearing,
    homing,
    io,
    jog,
    limits,
    macros,
    miscellaneous,
    motion,
    points,
    record,
    registers,
    reports,
    stages,
    texts,
    trajectory,
    units,
    variables,
    waits,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.command import Command
    from motionlang.mccl.task import Action, CommandTask

ACTIONS: dict[str, Action] = {}
for _group in (
    auxiliary,
    backlash,
    contour,
    filter,
    flow,
    functions,
    gearing,
    homing,
    io,
    jog,
    limits,
    macros,
    miscellaneous,
    motion,
    points,
    record,
    registers,
    reports,
    stages,
    texts,
    trajectory,
    units,
    variables,
    waits,
):
    ACTIONS.update(_group.ACTIONS)

PURE = flow.PURE | functions.PURE | macros.PURE | registers.PURE | variables.PURE | io.PURE


def not_simulated(task: CommandTask, command: Command) -> None:
    """The board would take the command; here it has no effect, which is said once."""
    assert command.row is not None
    task.board.warn(
        task,
        "not-simulated",
        f"{command.name} is not simulated: the command has no effect",
        command.row.help,
    )
