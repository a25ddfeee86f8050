"""Lines of commands as steps, for one board.

Each command begins with COMMAND: its time is paid before it runs, and other tasks that are ready go first. Then come
its own steps: usually one, its operation, which may return a wait. A command that jumps, calls a macro or goes on after
a wait writes its steps itself (`keywords.row.written`). The end of the line is a RETURN.

    1WS0.1,MC5      COMMAND  TRY paths  WAIT standstill  BRANCH  WAIT dwell
                    COMMAND  CALL macro 5
                    RETURN
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from motionlang.kernel.lang.steps import COMMAND, GO, RETURN, WAIT, Steps, Values
from motionlang.kernel.mccl.models import missing
from motionlang.kernel.mccl.motion.path import DESCRIBES
from motionlang.kernel.mccl.resolve.command import Command
from motionlang.kernel.mccl.resolve.decode import fault_of
from motionlang.kernel.mccl.runtime.register_uses import uses_of
from motionlang.kernel.tools import named

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.line import Line
    from motionlang.kernel.mccl.runtime.board import Board
    from motionlang.kernel.mccl.runtime.task import CommandTask


class LineSteps(Steps):
    """The steps of a line; `starts` has the first step of each command, and that of the line's end."""

    def __init__(self, line: Line) -> None:
        super().__init__()
        self.line, self.line_number = line, line.number
        self.starts: list[int] = []
        self.name = str(line.offsets[0]) if line.offsets else ""

    @property
    def text(self) -> str:
        """The commands in source form."""
        return self.line.text

    def index_of(self, pc: int) -> int:
        """Return the index in the line of the command to which a step belongs."""
        return bisect_right(self.starts, pc) - 1

    def command(self, pc: int) -> Command | None:
        """Return the command to which a step belongs, None for the line's end."""
        index = self.index_of(pc)
        return self.line.commands[index] if index < len(self.line.commands) else None

    def after(self, pc: int) -> int:
        """Return the first step after the command to which a step belongs."""
        return self.starts[min(self.index_of(pc) + 1, len(self.starts) - 1)]


class LineWriter:
    """Writes the steps of a line; `index` is that of the present command, `command`."""

    def __init__(self, line: Line, board: Board) -> None:
        self.board, self.line = board, line
        self.steps = LineSteps(line)
        self.index = 0
        self._jumps: list[tuple[int, int]] = []
        for self.index, (self.command, self._at) in enumerate(zip(line.commands, line.offsets, strict=True)):
            self.steps.starts.append(len(self.steps))
            self.steps.add(COMMAND, self._begin(), at=self._at)
            if hasattr(self.command.action, "written") and fault_of(self.command) is None:
                self.command.action(self, self.command)
            else:
                self.act(WAIT, self.command.action)
        self.steps.starts.append(len(self.steps))
        self.steps.add(RETURN, self._close_path, uses=None)
        for step, index in self._jumps:
            self.steps.set_target(step, self.steps.starts[min(index, self.end)])
        if board.machine.observer is not None:
            board.machine.observer.written(self.steps)

    @property
    def end(self) -> int:
        """The index of the line's end."""
        return len(self.line.commands)

    def act(self, kind: int, action: Callable[[Any, Command], Any] | None, to: int = -1) -> int:
        """Append a step of the present command, and return its index; a BACK without an action always goes back."""
        board, command = self.board, self.command
        if action is None:
            return self.steps.add(kind, None, to, self._at, uses_of(command))

        def do(values: Values) -> Any:
            return action(board.running, command)

        return self.steps.add(kind, named(command.name, do), to, self._at, uses_of(command))

    def jump(self, kind: int, index: int, action: Callable[[Any, Command], Any] | None = None) -> None:
        """Append a step that may jump to the command with an index, or to the line's end."""
        self._jumps.append((self.act(kind, action or _nothing), index))

    def go(self, action: Callable[[Any, Command], int], index: int | None) -> None:
        """Append a step that jumps to the command whose index an action returns, known before the run or None."""
        starts = self.steps.starts
        step = self.act(GO, lambda task, command: starts[action(task, command)])
        if index is not None and 0 <= index <= self.end:
            self._jumps.append((step, index))
        else:
            self.steps.uses[step] = None

    def _begin(self) -> Callable[[Values], None]:
        """Return what precedes the command: it may end a path, and the board may not know it."""
        board, command = self.board, self.command
        describes, is_pure = command.function in DESCRIBES, command.pure
        lacked = command.row if command.name in board.lacks else None

        def begin(values: Values) -> None:
            if not is_pure:
                board.effects += 1
            if not describes:
                self._close_path(values)
            if lacked is not None:
                raise missing(board.model, lacked)

        return begin

    def _close_path(self, values: Values) -> None:
        task = self.board.running
        if task.path_open is not None:
            task.close_path()


def _nothing(task: CommandTask, command: Command) -> None:
    pass
