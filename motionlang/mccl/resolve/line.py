"""A line of commands, ready to be carried out; the body of a macro is one too."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.resolve.decode import decode
from motionlang.mccl.syntax.split import LONGEST, pieces, without_comment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.mccl.resolve.command import Command


class Line:
    """`commands`, where each stands in the text (`places`), and the `number` of the source line.

    `origin` is that text: a macro outlives the one it came with.
    """

    __slots__ = ("commands", "number", "origin", "places")

    def __init__(
        self, commands: tuple[Command, ...], places: tuple[int, ...], number: int, origin: str
    ) -> None:
        self.commands, self.places, self.number, self.origin = commands, places, number, origin

    def rest(self, first: int) -> Line:
        """The line from command `first` on."""
        return Line(self.commands[first:], self.places[first:], self.number, self.origin)

    @property
    def text(self) -> str:
        """The commands as they were written, separated by commas."""
        return ",".join(command.text for command in self.commands)


def too_long(length: int) -> Fault:
    """The fault of a line that does not fit the controller's buffer."""
    return Fault(
        codes.TOO_LONG,
        f"the line has {length} characters; the controller takes {LONGEST}",
        "break the line, or put its parts into macros",
        "values",
    )


def line_of(text: str, start: int = 0, number: int = 1, origin: str | None = None) -> Line | None:
    """The commands of one line of text, None where it has none; Fault when it is too long."""
    whole = text if origin is None else origin
    text = without_comment(text)
    size = len(text)
    if size > LONGEST and len(text.strip()) > LONGEST:
        raise too_long(size)
    found = pieces(text)
    if not found:
        return None
    commands = tuple([decode(piece) for piece, _ in found])
    return Line(commands, tuple([start + at for _, at in found]), number, whole)


def lines_of(text: str) -> Iterator[Line | tuple[Fault, int, int]]:
    """The lines of a file, each with its commands; for a line too long its fault, offset and number."""
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
