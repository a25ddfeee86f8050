"""What the commands do: one function a verb of the keyword table, in one module a group.

`ACTIONS` maps each verb to its function, `PURE` names the verbs that touch nothing but the accumulator.
"""

from __future__ import annotations

from motionlang.mccl.keywords import (
    contour_operations,
    filter_operations,
    filter_stages,
    flow_operations,
    flow_waits,
    io_operations,
    limits_operations,
    macros_operations,
    miscellaneous_operations,
    miscellaneous_texts,
    modes_gearing,
    modes_jog,
    motion_auxiliary,
    motion_homing,
    motion_operations,
    motion_points,
    motion_record,
    registers_functions,
    registers_operations,
    registers_variables,
    reports_operations,
    trajectory_backlash,
    trajectory_operations,
    units_operations,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

ACTIONS: dict[str, Action] = {}
for _group in (
    motion_auxiliary,
    trajectory_backlash,
    contour_operations,
    filter_operations,
    flow_operations,
    registers_functions,
    modes_gearing,
    motion_homing,
    io_operations,
    modes_jog,
    limits_operations,
    macros_operations,
    miscellaneous_operations,
    motion_operations,
    motion_points,
    motion_record,
    registers_operations,
    reports_operations,
    filter_stages,
    miscellaneous_texts,
    trajectory_operations,
    units_operations,
    registers_variables,
    flow_waits,
):
    ACTIONS.update(_group.ACTIONS)

PURE = (
    flow_operations.PURE
    | flow_waits.PURE
    | registers_functions.PURE
    | macros_operations.PURE
    | registers_operations.PURE
    | registers_variables.PURE
    | io_operations.PURE
)


def not_simulated(task: CommandTask, command: Command) -> None:
    """The board would take the command; here it has no effect, which is said once."""
    assert command.row is not None
    task.board.warn(
        task,
        "not-simulated",
        f"{command.name} is not simulated: the command has no effect",
        command.row.help,
    )
