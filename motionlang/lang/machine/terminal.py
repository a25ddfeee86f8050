"""Terminal that stores what a program prints, by line, and shows it as it comes."""

from __future__ import annotations

from motionlang.controller.faults import Refusal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Clock
    from motionlang.log.records import Printed
    from motionlang.log.stream import Stream

MAX_CHARACTERS = 50_000_000


class Terminal:
    """The complete lines of a terminal in `prints`.

    `show(text)`, if given, is called with each fragment of text as it is written.
    """

    __slots__ = ("_clock", "_open", "_size", "prints", "show")

    def __init__(
        self, clock: Clock, prints: Stream[Printed], show: Callable[[str], object] | None = None
    ) -> None:
        self._clock, self.prints, self.show = clock, prints, show
        self._open = ""
        self._size = 0

    @property
    def lines(self) -> list[str]:
        """Return every line that was printed."""
        return [printed.text for printed in self.prints]

    def write(self, text: str) -> None:
        """Write text; `\\n` ends a line."""
        self._size += len(text)
        if self._size > MAX_CHARACTERS:
            raise Refusal(
                "limit", "the program printed more than 50 million characters", "shorten the run with --until"
            )
        if self.show is not None:
            self.show(text)
        *whole, self._open = (self._open + text).split("\n")
        for line in whole:
            self.prints.add((self._clock.now, line))

    @property
    def begun(self) -> str:
        """Return the text of the unfinished line."""
        return self._open

    def aside(self, text: str) -> None:
        """Show whole lines from elsewhere, such as another terminal's with its label."""
        if self.show is not None:
            self.show(f"\n{text}" if self._open else text)

    def forget(self) -> None:
        """Drop the printed lines, which a session has already shown.

        Each command of a session may then print as much as a run.
        """
        self.prints.forget(0)
        self._size = len(self._open)

    def close(self) -> None:
        """End an unfinished line."""
        if self._open:
            self.write("\n")


def labelled(label: str, console: Terminal, clock: Clock, prints: Stream[Printed]) -> Terminal:
    """Return another terminal whose complete lines appear on the console, labelled."""
    other = Terminal(clock, prints)
    begun = ""

    def show(text: str) -> None:
        nonlocal begun
        *whole, begun = (begun + text).split("\n")
        for line in whole:
            console.aside(f"[{label}] {line}\n")

    other.show = show
    return other
