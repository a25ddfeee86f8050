"""Source positions: line, sub, and the lines of the calls that led there."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from motionlang.kernel import Run


@dataclass(eq=False, slots=True)
class SourcePosition:
    """A line, its sub ("" if none), and the lines of the calls that led there.

    The outermost call is first.
    """

    line: int
    sub: str
    callers: tuple[int, ...]


class SourcePositions:
    """The source positions of a run; each is looked up once."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._blocks = run.program.blocks if run.program is not None else ()
        self._lines: dict[int, int] = {}
        self._called: dict[tuple[int, tuple[int, ...]], SourcePosition] = {}
        self._at_lines: dict[int, SourcePosition] = {}
        self._known: dict[tuple[int, tuple[int, ...]], SourcePosition] = {}

    def __getstate__(self) -> dict[str, object]:
        return {**vars(self), "_run": None}

    def line(self, at: int) -> int:
        """Return the line of a source offset."""
        if at not in self._lines:
            self._lines[at] = self._run.dialect.locate(self._run.source, at)[0]
        return self._lines[at]

    def begin(self, task: str) -> SourcePosition | None:
        """Return the first line of a task, an event handler or the program, or None."""
        names = f"task {task}".lower(), f"event {task}".lower()
        block = next((block for block in self._blocks if block[0].lower() in names), None)
        if block is not None:
            lines: Iterable[int] = range(block[1] + 1, block[2] + 1)
        else:
            last = self._run.source.text.count("\n") + 1
            lines = (line for line in range(1, last + 1) if not self.sub(line))
        dialect, source = self._run.dialect, self._run.source
        first = next((line for line in lines if dialect.has_code(source.line(line))), None)
        return None if first is None else self.at_line(first)

    def sub(self, line: int) -> str:
        """Return the name of the innermost block that contains a line."""
        inside = [block for block in self._blocks if block[1] <= line <= block[2]]
        return min(inside, key=lambda block: block[2] - block[1])[0] if inside else ""

    def of(self, at: int, callers: tuple[int, ...]) -> SourcePosition:
        """Return the source position of an offset, reached through the calls at `callers`."""
        key = at, callers
        if key not in self._known:
            line = self.line(at)
            self._known[key] = SourcePosition(line, self.sub(line), tuple(map(self.line, callers)))
        return self._known[key]

    def called(self, line: int, callers: tuple[int, ...]) -> SourcePosition:
        """Return the source position of a line, reached through calls on `callers` lines."""
        key = line, callers
        if key not in self._called:
            self._called[key] = SourcePosition(line, self.sub(line), callers)
        return self._called[key]

    def at_line(self, line: int) -> SourcePosition:
        """Return the source position of a line with unknown callers."""
        if line not in self._at_lines:
            self._at_lines[line] = SourcePosition(line, self.sub(line), ())
        return self._at_lines[line]
