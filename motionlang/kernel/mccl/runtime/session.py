"""MCCL for an interactive session, one line after another."""

from __future__ import annotations

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.debugging import Variable
from motionlang.kernel.lang.dialect import Interactive
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.steps import Steps, Values
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mccl.resolve.line import lines_of, locate
from motionlang.kernel.mccl.runtime.board import Board
from motionlang.kernel.mccl.runtime.debugging import Inspection
from motionlang.kernel.mccl.runtime.program import override
from motionlang.kernel.mccl.runtime.register_uses import PRIVATE
from motionlang.kernel.mccl.runtime.task import CommandTask
from motionlang.kernel.mccl.runtime.writer import LineSteps
from motionlang.kernel.source import Source


class BoardSession(Interactive):
    """One board for the whole session: macros, registers and units outlive a line."""

    keeps_columns = True

    def __init__(self, machine: Machine) -> None:
        self.board = Board(machine, self._complain)
        self._machine = machine
        first = LineTask(self.board, Source("input", ""), [0] * PRIVATE)
        override(first, machine.overrides)
        self._registers, self._last = first.registers, first

    def task(self, source: Source) -> Task:
        """Return the task for `source`.

        An error gives a `?` code and a diagnostic of the machine.
        """
        self.board.forget_complaints()
        self._last = LineTask(self.board, source, self._registers)
        return self._last

    def variables(self) -> list[Variable]:
        return Inspection(self.board, self._last).registers()

    def _complain(self, diagnostic: Diagnostic, task: CommandTask) -> None:
        line = task.line
        if line is not None:
            # The command may be in a macro from an earlier text: its offset is in that text.
            _, diagnostic.column, diagnostic.length = locate(Source("input", line.origin), task.at_statement)
            diagnostic.line = line.number
        elif isinstance(task, LineTask):
            diagnostic.line, diagnostic.column, diagnostic.length = locate(task.source, task.at)
        self._machine.complain(diagnostic)


class LineTask(CommandTask):
    """Executes the lines of a text; background tasks run independently."""

    def __init__(self, board: Board, source: Source, registers: list[float | int]) -> None:
        super().__init__("terminal", board, registers)
        board.foreground(self)
        self.source = source
        self._begin = 0
        self.carry_out(lines_of(source))

    @property
    def at(self) -> int:
        """The offset of the current command in the text.

        For a macro from an earlier text, this is the offset of the command that called it.
        """
        if self.line is None or self.line.origin is self.source.text:
            return super().at
        for call in self.calls:
            steps = call.steps
            if isinstance(steps, LineSteps) and steps.line.origin is self.source.text:
                return steps[call.pc - 1].at
        return self._begin

    def enter(self, steps: LineSteps) -> tuple[Steps, Values]:
        self._begin = steps.line.offsets[0]
        return super().enter(steps)
