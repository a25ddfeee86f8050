"""Reports of the controller: one line per axis, such as `01 1234`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl.axis.axis import AxisState, real
from motionlang.kernel.mccl.axis.motor import torque
from motionlang.kernel.mccl.axis.status import word
from motionlang.kernel.mccl.axis.variables import NAMES, read
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask

Reader = Callable[["CommandTask", AxisState], str]


def _each(reader: Reader) -> Action:
    """Return an action that reports one quantity for each axis of the command."""

    def tell(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            task.tell(axis.number, reader(task, axis))

    return tell


def _variable(name: str, unit: str = "position") -> Action:
    """Return an action that reports a variable for each axis of the command."""

    def reader(task: CommandTask, axis: AxisState) -> str:
        value, _ = read(task.board, axis, NAMES[name])
        return task.quantity(axis, value, unit)

    return _each(reader)


def _breakpoint(task: CommandTask, axis: AxisState) -> str:
    if axis.breakpoint is None:
        return (
            "NONE" if task.board.assumptions.get("mccl.no-breakpoint") == "NONE" else task.quantity(axis, 0.0)
        )
    return task.quantity(axis, axis.breakpoint)


def _stored_value(name: str) -> Reader:
    def reader(task: CommandTask, axis: AxisState) -> str:
        value = axis.stored.get(name, STORED_DEFAULTS.get(name, 0.0))
        return task.whole_text(int(value)) if axis.model.whole_gains else real(value)

    return reader


def _torque(task: CommandTask, axis: AxisState) -> str:
    return real(torque(axis))


# The power-up values of servo loop settings that are not 0.
STORED_DEFAULTS = {"kept_error_limit": 1024.0}


def tell_status(task: CommandTask, command: Command) -> None:
    """Report a status word of each axis, by its number (TS)."""
    which = task.whole(command)
    for axis in task.axes(command):
        value, _ = word(task.board, axis, which)
        task.tell(axis.number, task.whole_text(value))


def tell_error(task: CommandTask, command: Command) -> None:
    task.reply(task.whole_text(task.board.last_error))
    if task.board.assumptions.get("mccl.error-told") == "cleared":
        task.board.last_error = 0


def tell_segment(task: CommandTask, command: Command) -> None:
    axis = task.axis(command)
    task.tell(axis.number, task.whole_text(axis.segments))


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("reports").row
_contour_row = Group("contour").row


ROWS = (
    _row("TP", "reading", "R", "axes", "uu", Actions("tell_position", do=_variable("POSITION")),
         "Tell the actual position.", "1TP", effect="position", meant="POS PRINT"),
    _row("TT", "reading", "R", "axes", "uu", Actions("tell_target", do=_variable("TARGET")), "Tell the target.", "1TT"),
    _row("TO", "reading", "R", "axes", "uu", Actions("tell_optimal", do=_variable("OPTIMAL")),
         "Tell the optimal position, that of the trajectory.",
         "1TO"),
    _row("TF", "reading", "R", "axes", "uu", Actions("tell_following", do=_variable("ERROR", "uu")),
         "Tell the following error, optimal minus actual.",
         "1TF"),
    _row("TV", "reading", "R", "axes", "uu/s", Actions("tell_velocity", do=_variable("VELOCITY", "uu/s")),
         "Tell the actual velocity.", "1TV"),
    _row("TS", "reading", "R", "axes", "bits", tell_status,
         "Tell a status word: 0 status, 1 auxiliary, 2 profile, 3 mode.", "1TS", low=0, high=3, meant="STATUS"),
    _row("TE", "reading", "R", "none", "number", tell_error, "Tell the last error of the interpreter.", "TE"),
    _row("TG", "reading", "R", "axes", "number", Actions("tell_gain", do=_each(_stored_value("kept_gain"))),
         "Tell the proportional gain.", "1TG"),
    _row("TI", "reading", "R", "axes", "number", Actions("tell_integral", do=_each(_stored_value("kept_integral"))),
         "Tell the integral gain.", "1TI"),
    _row("TD", "reading", "R", "axes", "number", Actions("tell_derivative", do=_each(_stored_value("kept_derivative"))),
         "Tell the derivative gain.", "1TD"),
    _row("TL", "reading", "R", "axes", "number",
         Actions("tell_integral_limit", do=_each(_stored_value("kept_integral_limit"))),
         "Tell the limit of the integral term.",
         "1TL"),
    _row("TK", "reading", "R", "axes", "number",
         Actions("tell_velocity_gain", do=_each(_stored_value("kept_velocity_gain"))),
         "Tell the velocity gain.", "1TK"),
    _row("TQ", "reading", "R", "axes", "number", Actions("tell_torque", do=_each(_torque)),
         "Tell the torque limit.", "1TQ"),
    _row("TB", "reading", "R", "axes", "uu", Actions("tell_breakpoint", do=_each(_breakpoint)),
         "Tell the position of the breakpoint.", "1TB"),
    _row("TZ", "reading", "R", "axes", "uu", Actions("tell_index", do=_variable("INDEX")),
         "Tell the position at which the index was last seen.",
         "1TZ"),
    _contour_row("TX", "reading", "R", "axis", "number", tell_segment, "Tell the number of contour paths carried out.",
                 "1TX", family="contours"),
    _contour_row("CX", "reading", "R", "axis", "number", tell_segment,
                 "Same as TX; it is not known which of the two names is right.", "1CX", family="contours"),
)  # fmt: skip
