"""A file sent to a board with connected hosts.

Its lines run one after another, and the replies go to the sender.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from motionlang.kernel import Diagnostic, Source, Wait
from motionlang.kernel.mccl import Board, CommandTask, FileTask, MacroFile, locate

Write: TypeAlias = Callable[[str], None]
Complain: TypeAlias = Callable[[Diagnostic], None]


class Download(FileTask):
    """The task of a download, which ends with the last line.

    `complain` is called for every rejected command, with its position in the file.
    """

    def __init__(self, source: Source, board: Board, write: Write, complain: Complain) -> None:
        others = list(board.tasks)
        super().__init__(MacroFile(source), board)
        board.tasks = [*others, self]
        self._source, self._complain = source, complain
        self.write = write
        board.complain = self._record_complaint

    def _record_complaint(self, diagnostic: Diagnostic, task: CommandTask) -> None:
        if task is self:
            diagnostic.line, diagnostic.column, diagnostic.length = locate(self._source, self.at)
            self._complain(diagnostic)

    def rest(self) -> Wait | None:
        """End the download; background tasks that the file has started continue."""
        self.board.complain = None
        self.board.ended(self)
        return None
