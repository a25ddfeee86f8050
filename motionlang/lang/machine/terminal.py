"""What a program prints: whole lines, kept, and shown as they come."""

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
    """Keeps whole lines in `prints`; `show(text)`, if given, is called with every piece of text as it is written."""

    __slots__ = ("_clock", "_open", "_size", "prints", "show")

    def __init__(
        self, clock: Clock, prints: Stream[Printed], show: Callable[[str], object] | None = None
    ) -> None:
        self._clock, self.prints, self.show = clock, prints, show
        self._open = ""
        self._size = 0

    @property
    def lines(self) -> list[str]:
        """Every line that was printed."""
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
        """What stands on the line that is not ended yet."""
        return self._open

    def aside(self, text: str) -> None:
        """Show whole lines that are none of this terminal's own, such as another one's with its label."""
        if self.show is not None:
            self.show(f"\n{text}" if self._open else text)

    def forget(self) -> None:
        """Drop what was printed: a session has shown it, and each of its commands may print as much as a run."""
        self.prints.forget(0)
        self._size = len(self._open)

    def close(self) -> None:
        """End a line that was left open."""
        if self._open:
            self.write("\n")


def labelled(label: str, console: Terminal, clock: Clock, prints: Stream[Printed]) -> Terminal:
    """Another terminal, whose whole lines are shown among the console's, each after its label."""
    other = Terminal(clock, prints)
    begun = ""

    def show(text: str) -> None:
        nonlocal begun
        *whole, begun = (begun + text).split("\n")
        for line in whole:
            console.aside(f"[{label}] {line}\n")

    other.show = show
    return other
