"""User units: scale, time base, zeros.

The units of an axis take effect when it is next switched on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask


def _unit(field: str) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        value = float(task.value(command))
        for axis in task.axes(command):
            setattr(axis.units, field, value)

    return keep


def time_unit(task: CommandTask, command: Command) -> None:
    task.board.time_unit = float(task.value(command))


# ------------------------------------------------------------------------------------------------- keywords

_G = Group("user units")
_row, _known = _G.row, _G.known


ROWS = (
    _row("US", "setting", "W", "axes", "number", Actions("scale", do=_unit("counts")),
         "Set the counts per user unit; in force from the next MN.",
         "1US1200", default=1, low=1e-9, high=1e12, effect="rescale", meant="SCALE", family="scales"),
    _row("UR", "setting", "W", "axes", "number", Actions("rate", do=_unit("rate")),
         "Set the seconds per user time unit of velocities and accelerations (60: per minute); from the next MN.",
         "1UR60", default=1, low=1e-9, high=1e9, effect="rescale", family="scales"),
    _row("UT", "setting", "W", "none", "number", time_unit, "Set the seconds per unit of WA, WS and WT.",
         "UT0.001", default=1, low=1e-9, high=1e9, family="scales"),
    _row("UK", "setting", "W", "axes", "number", Actions("constant", do=_unit("constant")),
         "Set the volts per user unit of torque; from the next MN.",
         "1UK10", default=1, low=1e-9, high=1e9, family="scales"),
    _row("UO", "setting", "W", "axes", "uu", Actions("offset", do=_unit("offset")),
         "Set the work-area zero, counted from the encoder's zero; from the next MN.", "1UO20", default=0,
         effect="rescale datum", family="scales"),
    _row("UZ", "setting", "W", "axes", "uu", Actions("zero", do=_unit("zero")),
         "Set the part zero, counted from the work-area zero; from the "
         "next MN.", "1UZ50", default=0, effect="rescale datum", family="scales"),
    _known("UA", "command", "none", "Assign an axis; only the name is known."),
)  # fmt: skip
