"""The auxiliary encoder of an axis.

The machine file moves it: `[[encoder]]` with `aux` as the number of the axis. It uses the scale of the axis
and is independent of the axis's zeros. It has index marks if the machine file defines them.
"""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.lang.steps import DO, WAIT
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl.axis.axis import AxisState, nearest_whole
from motionlang.kernel.mccl.keywords.row import Group, written

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter

# A mark nearer than this, in counts, is the mark that the encoder is on: the search is for the next one.
_ON = 1e-6


def define_auxiliary(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        _define(task, axis, _counts(task, axis), float(task.value(command)))


def tell_auxiliary(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.tell(axis.number, task.quantity(axis, nearest_whole(_counts(task, axis) - axis.aux_zero), "uu"))


def tell_auxiliary_index(task: CommandTask, command: Command) -> None:
    for axis in task.axes(command):
        task.tell(axis.number, task.quantity(axis, axis.aux_index, "uu"))


@written
def find_auxiliary_index(line: LineWriter, command: Command) -> None:
    """Wait for the next index mark, and define the encoder's position there.

    The position at the mark becomes the parameter.
    """
    line.act(WAIT, _until_index)
    line.act(DO, _at_index)


def _until_index(task: CommandTask, command: Command) -> Wait:
    axis = task.axis(command)
    controller = task.board.controller
    encoder, began = controller.encoder(AUXILIARY + axis.number), controller.clock.now
    every = encoder.index_every
    here = encoder.position(began)
    marks = (
        [(floor((here - _ON) / every)) * every, (floor((here + _ON) / every) + 1) * every]
        if every > 0.0
        else []
    )

    def due() -> float:
        return min((_crossing(task, axis, mark) for mark in marks), default=INFINITY)

    why = f"for the index mark of the auxiliary encoder of axis {axis.number}"
    return Wait(
        began,
        lambda: any(_passed(here, mark, encoder.position(controller.clock.now)) for mark in marks),
        due,
        why,
    )


def _at_index(task: CommandTask, command: Command) -> None:
    axis, value, controller = task.axis(command), float(task.value(command)), task.board.controller
    encoder = controller.encoder(AUXILIARY + axis.number)
    every = encoder.index_every
    _define(task, axis, round(encoder.position(controller.clock.now) / every) * every, value)
    axis.aux_index = axis.distance(value)


def _define(task: CommandTask, axis: AxisState, counts: float, value: float) -> None:
    """Make `counts` of the encoder the position `value` from now on."""
    axis.aux_zero = counts - axis.distance(value)


def _counts(task: CommandTask, axis: AxisState) -> float:
    return task.board.controller.encoder_position(AUXILIARY + axis.number)


def _passed(start: float, mark: float, here: float) -> bool:
    return (here >= mark - _ON) if mark > start else (here <= mark + _ON)


def _crossing(task: CommandTask, axis: AxisState, position: float) -> float:
    """Return when the encoder will be at a position if nothing else happens to it."""
    controller = task.board.controller
    encoder = controller.encoder(AUXILIARY + axis.number)
    start = encoder.starts[-1]
    found = encoder.profiles[-1].crossing(position, controller.clock.now - start)
    return INFINITY if found is None else start + found


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("motion").row
_reports_row = Group("reports").row


ROWS = (
    _row("AH", "command", "W", "axes", "uu", define_auxiliary,
         "Give the present position of the auxiliary encoder a new value.", "1AH100,1AT"),
    _row("AF", "command", "W", "axis", "uu", find_auxiliary_index,
         "Find the index of the auxiliary encoder: wait for its mark; there its position becomes this one. The machine "
         "file turns it and says where marks are ([[encoder]]).", "1AF0,1AT", waits="axis", topic="home"),
    _reports_row("AT", "reading", "R", "axes", "uu", tell_auxiliary,
                 "Tell the position of the auxiliary encoder, which the machine file turns.", "1AT"),
    _reports_row("AZ", "reading", "R", "axes", "uu", tell_auxiliary_index,
                 "Tell the position of the auxiliary encoder at its index, as AF found it.", "1AZ"),
)  # fmt: skip
