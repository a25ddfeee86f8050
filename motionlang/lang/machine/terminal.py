"""A terminal, which stores a program's output by line and shows it immediately."""

from __future__ import annotations

from io import StringIO

from motionlang.controller.faults import Rejected

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Clock
    from motionlang.log.records import Printed
    from motionlang.log.stream import Stream

MAX_CHARACTERS = 50_000_000


class LineBuffer:
    """Split text that arrives in fragments into lines, at a cost linear in its length."""

    __slots__ = ("_open",)

    def __init__(self) -> None:
        self._open = StringIO()

    def completed(self, text: str) -> list[str]:
        """Add a fragment and return the lines that it completes, without line feeds."""
        *lines, rest = text.split("\n")
        if lines and self._open.tell():
            lines[0] = self._open.getvalue() + lines[0]
            self._open = StringIO()
        self._open.write(rest)
        return lines

    def __len__(self) -> int:
        """Return the length of the unfinished line."""
        return self._open.tell()

    @property
    def unfinished(self) -> str:
        """Return the text of the unfinished line."""
        return self._open.getvalue()


class Terminal:
    """The complete lines of a terminal in `prints`.

    `show(text)`, if given, is called with each fragment of text as it is written. With `repeats`, a text for
    a row of the screen is written even if the row already shows it, because hosts see every character.
    """

    __slots__ = ("_clock", "_open", "_size", "prints", "show")

    def __init__(
        self, clock: Clock, prints: Stream[Printed], show: Callable[[str], object] | None = None
    ) -> None:
        self._clock, self.prints, self.show = clock, prints, show
        self._open = LineBuffer()
        self._size = 0

    @property
    def lines(self) -> list[str]:
        """Return every line that was printed."""
        return [printed.text for printed in self.prints]

    def write(self, text: str) -> None:
        """Write text; `\\n` ends a line."""
        self._size += len(text)
        if self._size > MAX_CHARACTERS:
            raise Rejected(
                "limit", "the program printed more than 50 million characters", "shorten the run with --until"
            )
        if self.show is not None:
            self.show(text)
        for line in self._open.completed(text):
            self.prints.add((self._clock.now, line))

    @property
    def begun(self) -> str:
        """Return the text of the unfinished line."""
        return self._open.unfinished

    def aside(self, text: str) -> None:
        """Show whole lines from elsewhere, such as another terminal's with its label."""
        if self.show is not None:
            self.show(f"\n{text}" if self._open else text)

    def forget(self) -> None:
        """Discard the printed lines, which a session has already shown.

        Each command of a session may therefore print as much as a whole run.
        """
        self.prints.forget(0)
        self._size = len(self._open)

    def close(self) -> None:
        """End an unfinished line."""
        if self._open:
            self.write("\n")


def labelled(label: str, console: Terminal, clock: Clock, prints: Stream[Printed]) -> Terminal:
    """Return a terminal whose complete lines appear on the console with a label."""
    other = Terminal(clock, prints)
    buffer = LineBuffer()

    def show(text: str) -> None:
        for line in buffer.completed(text):
            console.aside(f"[{label}] {line}\n")

    other.show = show
    return other
