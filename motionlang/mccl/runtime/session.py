"""MCCL for an interactive session, one line after another."""

from __future__ import annotations

from motionlang.errors import Diagnostic
from motionlang.lang.dialect import Interactive
from motionlang.lang.machine.machine import Machine
from motionlang.lang.task import Task
from motionlang.mccl.resolve.line import Line, lines_of
from motionlang.mccl.runtime.board import Board
from motionlang.mccl.runtime.program import TextTask, locate, override
from motionlang.mccl.runtime.task import CommandTask
from motionlang.source import Source


class Session(Interactive):
    """One board for the whole session: macros, registers and units outlive a line."""

    keeps_columns = True

    def __init__(self, machine: Machine) -> None:
        self.board = Board(machine, self._complain)
        self._machine = machine
        first = LineTask(self.board, Source("input", ""))
        override(first, machine.overrides)
        self._registers = first.registers

    def task(self, source: Source) -> Task:
        """Return the task for `source`.

        An error gives a `?` code and a diagnostic of the machine.
        """
        self.board.forget_complaints()
        task = LineTask(self.board, source)
        task.registers = self._registers
        return task

    def _complain(self, diagnostic: Diagnostic, task: CommandTask) -> None:
        line = task.line
        if line is not None:
            # The command may be in a macro from an earlier text: its offset is in that text.
            _, diagnostic.column, diagnostic.length = locate(Source("input", line.origin), task.offset)
            diagnostic.line = line.number
        elif isinstance(task, LineTask):
            diagnostic.line, diagnostic.column, diagnostic.length = locate(task.source, task.at)
        self._machine.complain(diagnostic)


class LineTask(TextTask):
    """Executes the lines of a text; background tasks run independently."""

    __slots__ = ("_entered", "source")

    def __init__(self, board: Board, source: Source) -> None:
        super().__init__("terminal", board, lines_of(source.text))
        self.source = source
        self._entered = 0

    @property
    def at(self) -> int:
        """The offset of the current command in the text.

        For a macro from an earlier text, this is the offset of the command that called it.
        """
        if self.line is None:
            return self._stray
        if self.line.origin is self.source.text:
            return self.offset
        for line, pc, _ in self.calls:
            if line.origin is self.source.text:
                return line.offsets[pc - 1]
        return self._entered

    def next_line(self) -> Line | None:
        line = super().next_line()
        if line is not None:
            self._entered = line.offsets[0]
        return line
