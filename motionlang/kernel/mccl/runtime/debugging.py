"""The tasks and registers of a debug build at a stop."""

from __future__ import annotations

from motionlang.kernel.lang.debugging import Frame, Variable
from motionlang.kernel.lang.steps import Steps
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mccl.runtime.board import Board
from motionlang.kernel.mccl.runtime.register_uses import PRIVATE
from motionlang.kernel.mccl.runtime.task import CommandTask

# A register has 32 bits; a number with a fraction is a float of 64.
_LOW, _HIGH = -(2**31), 2**31 - 1


class Inspection:
    """The registers of a board, and the current lines and macros of its tasks."""

    def __init__(self, board: Board, foreground: CommandTask) -> None:
        self._board, self._foreground = board, foreground

    def module(self) -> list[Variable]:
        """Return the registers that all tasks share, except those that are 0."""
        return self.registers(PRIVATE)

    def registers(self, first: int = 0) -> list[Variable]:
        """Return the registers from a number on as the foreground sees them, except those that are 0."""
        task = self._foreground
        numbers = range(first, len(self._board.registers))
        return [_register(task, number) for number in numbers if task.register(number) != 0]

    def frames(self, task: Task, offset: int | None) -> list[Frame]:
        """Return the macro calls of a task, the innermost first.

        `offset` is the source offset of a task that is stopped in the hook; None for one that waits.
        """
        assert isinstance(task, CommandTask)
        private = [_register(task, number) for number in range(PRIVATE)]
        found = [Frame(self._title(task.steps), task.at if offset is None else offset, private)]
        for call in reversed(task.calls[1:]):
            found.append(Frame(self._title(call.steps), call.steps[call.pc - 1].at, private))
        return found

    def depth(self, task: Task) -> int:
        """Return the number of macro calls that the task is in."""
        assert isinstance(task, CommandTask)
        return max(len(task.calls) - 1, 0)

    def unlisted(self, task: Task | None, name: str) -> Variable | None:
        """Return a register by its name, such as R10, as seen by a task."""
        task = task or self._foreground
        assert isinstance(task, CommandTask)
        number = name[1:]
        if name[:1].upper() != "R" or not number.isdecimal() or int(number) >= len(self._board.registers):
            return None
        return _register(task, int(number))

    def _title(self, steps: Steps) -> str:
        for number, macro in self._board.macros.items():
            if macro is steps:
                return f"macro {number}"
        return "main"


def _register(task: CommandTask, number: int) -> Variable:
    def give(value: object) -> None:
        if not isinstance(value, (int, float)):
            raise ValueError(f"a register takes a number, not {value!r}")
        if value == int(value):
            if not _LOW <= value <= _HIGH:
                raise ValueError(f"{value:.10g} is outside the 32 bits of a register")
            value = int(value)
        task.set_register(number, value)

    name = f"R{number}"
    return Variable(name, "register" if number else "accumulator", task.register(number), give)
