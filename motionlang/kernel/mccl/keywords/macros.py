"""Macros and background tasks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.steps import CALL, DO, ENTER, JUMP, Values
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault, LineAbandoned
from motionlang.kernel.mccl.keywords.row import Group, pure, written
from motionlang.kernel.mccl.models import no_macro_number

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineSteps, LineWriter


@written
def define_macro(line: LineWriter, command: Command) -> None:
    """Define a macro from the rest of the line, replacing any with the same number."""
    is_first, macro = line.index == 0, line.line.rest(1)

    def define(task: CommandTask, command: Command) -> None:
        if not is_first:
            raise codes.define_not_first()
        task.board.macros[_number(task, command)] = task.board.written(macro)

    line.act(DO, define)
    line.jump(JUMP, line.end)


@written
@pure
def call_macro(line: LineWriter, command: Command) -> None:
    line.act(CALL, _entered)


@written
@pure
def jump_macro(line: LineWriter, command: Command) -> None:
    """Jump to a macro without return; a macro that jumps to itself is a loop."""
    line.act(ENTER, _entered)


def reset_macros(task: CommandTask, command: Command) -> None:
    task.board.macros.clear()


@written
@pure
def leave(line: LineWriter, command: Command) -> None:
    line.jump(JUMP, line.end)


def start_task(task: CommandTask, command: Command) -> None:
    """Start a background task with its own registers 0 to 9.

    Its number is stored in the accumulator.
    """
    task.registers[0] = task.board.start_task(_macro(task, command), task)


def end_task(task: CommandTask, command: Command) -> None:
    """End a background task; an unknown number is a parameter error."""
    number = task.whole(command)
    if not task.board.end_task(number):
        raise Fault(
            codes.PARAMETER,
            f"there is no background task {number}",
            "GT leaves its number in the accumulator",
            "range",
        )
    if task.done:
        raise LineAbandoned


def tell_macro(task: CommandTask, command: Command) -> None:
    """List one macro, or all of them, in the form of the lines that define them."""
    board, number = task.board, task.whole(command)
    if number != -1:
        task.reply(f"MD{number},{_macro(task, command).text}")
        return
    for each in sorted(board.macros):
        task.reply(f"MD{each},{board.macros[each].text}")


def _number(task: CommandTask, command: Command) -> int:
    number, model = task.whole(command), task.board.model
    if not 0 <= number <= model.macros:
        raise no_macro_number(model, number)
    return number


def _entered(task: CommandTask, command: Command) -> tuple[LineSteps, Values]:
    return _macro(task, command), task.new_values()


def _macro(task: CommandTask, command: Command) -> LineSteps:
    number = _number(task, command)
    macro = task.board.macros.get(number)
    if macro is None:
        raise Fault(
            codes.NO_MACRO, f"macro {number} does not exist", f"MD{number},... defines it", "unknown-word"
        )
    return macro


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("macros and tasks").row
_reports_row = Group("reports").row


ROWS = (
    _row("MD", "statement", "W", "none", "number", define_macro,
         "Define macro n as the rest of the line; must come first in its line.", "MD1,1MN,1MR1000"),
    _row("MC", "statement", "W", "none", "number", call_macro, "Call macro n and come back.",
         "MD1,AL5\nMC1,TR0", meant="CALL"),
    _row("MJ", "statement", "W", "none", "number", jump_macro, "Jump to macro n and do not come back.",
         "MD1,AL5,TR0\nMJ1", meant="GOTO JUMP"),
    _row("RM", "command", "C", "none", "", reset_macros, "Forget all macros.", "RM"),
    _row("GT", "statement", "W", "none", "number", start_task,
         "Run macro n as a background task; its number is then in the accumulator.", "MD1,WA0.1\nGT1,TR0",
         family="tasks"),
    _row("ET", "statement", "W", "none", "number", end_task, "End a background task.", "MD1,WA9\nGT1,ET@0", low=0,
         family="tasks"),
    _row("BK", "statement", "C", "none", "", leave, "Leave the macro, or the line.", "AL5,BK,AL6"),
    _reports_row("TM", "reading", "R", "none", "number", tell_macro, "List a macro; -1 lists all.", "TM-1", low=-1),
)  # fmt: skip
