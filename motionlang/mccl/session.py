"""MCCL for a person who types one line after the other."""

from __future__ import annotations

from motionlang.errors import Diagnostic
from motionlang.lang.dialect import Interactive
from motionlang.mccl.board import Board
from motionlang.mccl.codes import Fault
from motionlang.mccl.line import Line, lines_of
from motionlang.mccl.program import locate
from motionlang.mccl.task import CommandTask

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.machine import Machine
    from motionlang.lang.task import Task
    from motionlang.source import Source


class Session(Interactive):
    """One board for the whole session: macros, registers and units stay between lines."""

    def __init__(self, machine: Machine) -> None:
        self.board = Board(machine, self._complain)
        self._machine = machine
        self._registers: list[float | int] | None = None
        self._source: Source | None = None

    def task(self, source: Source) -> Task:
        """The task that carries `source` out; what goes wrong is a `?` code and a diagnostic of the machine."""
        self._source = source
        self.board.forget_complaints()
        task = LineTask(self.board, list(lines_of(source.text)))
        if self._registers is not None:
            task.registers = self._registers
        self._registers = task.registers
        return task

    def _complain(self, diagnostic: Diagnostic, task: CommandTask) -> None:
        if self._source is not None and isinstance(task, LineTask):
            place = locate(self._source, task.at)
            diagnostic.line, diagnostic.column, diagnostic.length = place
        self._machine.diagnostics.append(diagnostic)


class LineTask(CommandTask):
    """Carries out the lines it was given; background tasks go on by themselves."""

    __slots__ = ("_lines",)

    def __init__(self, board: Board, lines: list[Line | tuple[Fault, int, int]]) -> None:
        super().__init__("terminal", board)
        board.foreground(self)
        self._lines = lines

    def next_line(self) -> Line | None:
        while self._lines:
            line = self._lines.pop(0)
            if isinstance(line, Line):
                return line
            self._refused(line[0])
        return None
