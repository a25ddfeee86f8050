"""A line of commands, ready to run; the body of a macro is also a line."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.resolve.command import Command
from motionlang.mccl.resolve.decode import COMMANDS
from motionlang.mccl.syntax.parser import MAX_LINE, pieces, spans, without_comment

# Enough for any host and most programs; see `decode` for the commands.
_MEMO_SIZE = 5_000


class Line:
    """The commands of one source line, with its `number`.

    `origin` is the text that contained it, beginning at `start`; a macro outlives that text. `offsets` are the
    offsets of the commands in it. The commands of a macro are those of its line from index `first` on.
    """

    __slots__ = ("_offsets", "commands", "first", "number", "origin", "start")

    def __init__(
        self, commands: tuple[Command, ...], number: int, origin: str, start: int, first: int = 0
    ) -> None:
        self.commands, self.number, self.first = commands, number, first
        self.origin, self.start = origin, start
        self._offsets: tuple[int, ...] | None = None

    @property
    def offsets(self) -> tuple[int, ...]:
        """The offsets of the commands in `origin`, computed on demand."""
        if self._offsets is None:
            end = self.origin.find("\n", self.start)
            text = self.origin[self.start : end if end >= 0 else None]
            self._offsets = tuple([self.start + at for at, _ in spans(text)][self.first :])
        return self._offsets

    def rest(self, first: int) -> Line:
        """Return the line from command `first` on."""
        return Line(self.commands[first:], self.number, self.origin, self.start, self.first + first)

    @property
    def text(self) -> str:
        """The commands in source form, separated by commas."""
        return ",".join(command.text for command in self.commands)


def too_long(length: int) -> Fault:
    """Return the fault of a line that does not fit the controller's buffer."""
    return Fault(
        codes.TOO_LONG,
        f"the line has {length} characters; the controller accepts {MAX_LINE}",
        "break the line, or move commands into macros",
        "values",
    )


class Lines(dict[str, "tuple[Command, ...]"]):
    """Cache from the text of a line to its commands, because hosts repeat lines.

    Raises Fault if the line is too long.
    """

    def __missing__(self, text: str) -> tuple[Command, ...]:
        if len(text) > MAX_LINE:
            sent = without_comment(text)
            if len(sent.strip()) > MAX_LINE:
                raise too_long(len(sent))
        if len(self) >= _MEMO_SIZE:
            self.clear()
        found = self[text] = tuple(map(COMMANDS.__getitem__, pieces(text)))
        return found


_LINES = Lines()


def line_of(text: str, start: int = 0, number: int = 1, origin: str | None = None) -> Line | None:
    """Return the commands of one line of text, or None if it has none.

    Raises Fault if the line is too long.
    """
    found = _LINES[text]
    return Line(found, number, text if origin is None else origin, start) if found else None


def lines_of(text: str) -> Iterator[Line | tuple[Fault, int, int]]:
    """Yield the lines of a file.

    A line that is too long yields its fault, offset and number instead.
    """
    start = 0
    for number, raw in enumerate(text.split("\n"), 1):
        try:
            line = line_of(raw, start, number, text)
        except Fault as fault:
            yield fault, start, number
        else:
            if line is not None:
                yield line
        start += len(raw) + 1
