"""A terminal, which stores a program's output by line and shows it immediately."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO

from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import no_origin
from motionlang.kernel.log.records import Printed
from motionlang.kernel.log.stream import Stream

MAX_CHARACTERS = 50_000_000
# The smallest screen; a text beyond it may scroll, or continue on the next row.
ROWS, COLUMNS = 24, 80


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

    `show(text)`, if given, is called with each fragment of text as it is written. `origin` returns where the program
    is, as `Log.origin` does. With `repeats`, a text for
    a row of the screen is written even if the row already shows it, because hosts see every character.
    """

    __slots__ = (
        "_clock",
        "_expected_row",
        "_open",
        "_origin",
        "_row",
        "_rows",
        "_size",
        "prints",
        "repeats",
        "show",
    )

    def __init__(
        self,
        clock: Clock,
        prints: Stream[Printed],
        show: Callable[[str], object] | None = None,
        origin: Callable[[], tuple[int, int]] = no_origin,
    ) -> None:
        self._clock, self.prints, self.show, self._origin = clock, prints, show, origin
        self._open = LineBuffer()
        self._size = 0
        self.repeats = False
        # The texts that `write_on_row` wrote, by row, the row of the cursor, and the row on which the program
        # expects it, which differs after a text that was not written.
        self._rows: dict[int, str] = {}
        self._row = self._expected_row = 0

    @property
    def lines(self) -> list[str]:
        """Return every line that was printed."""
        return [printed.text for printed in self.prints]

    def write(self, text: str) -> None:
        """Write text; `\\n` ends a line."""
        if self._rows:
            if self._expected_row != self._row:
                text = _on_row(self._expected_row, self._rows[self._expected_row]) + text
            self._rows.clear()  # the text may be on any row
        self._write(text)

    def write_on_row(self, row: int, text: str) -> bool:
        """Write text at the beginning of a row unless the row shows it; True if written."""
        row, rows = max(row, 1), self._rows
        if rows.get(row) == text and not self.repeats:
            self._expected_row = row
            return False
        if row > ROWS or len(text) > COLUMNS or not text.isprintable():
            rows.clear()
        else:
            rows[row] = text
            self._row = self._expected_row = row
        self._write(_on_row(row, text))
        return True

    def _write(self, text: str) -> None:
        self._size += len(text)
        if self._size > MAX_CHARACTERS:
            raise Rejected(
                "limit", "the program printed more than 50 million characters", "shorten the run with --until"
            )
        if self.show is not None:
            self.show(text)
        for line in self._open.completed(text):
            self.prints.add(Printed(self._clock.now, line, *self._origin()))

    @property
    def begun(self) -> str:
        """Return the text of the unfinished line."""
        return self._open.unfinished

    def aside(self, text: str) -> None:
        """Show whole lines from elsewhere, such as another terminal's with its label."""
        self._rows.clear()
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
        self._rows.clear()
        if self._open:
            self.write("\n")


def _on_row(row: int, text: str) -> str:
    """Return a text preceded by the ANSI code for the beginning of a row."""
    return f"\x1b[{row};1H{text}"


def labelled(label: str, console: Terminal, clock: Clock, prints: Stream[Printed]) -> Terminal:
    """Return a terminal whose complete lines appear on the console with a label."""
    other = Terminal(clock, prints)
    buffer = LineBuffer()

    def show(text: str) -> None:
        for line in buffer.completed(text):
            console.aside(f"[{label}] {line}\n")

    other.show = show
    return other
