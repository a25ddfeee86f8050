"""One line on a terminal that says how far a long piece of work has come."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from motionlang.views.terminal import is_terminal, width_of

if TYPE_CHECKING:
    from typing import TextIO

# Seconds before it shows at all, and between two changes.
PATIENCE = 0.5
PERIOD = 0.1


class Progress:
    """Called with the part done, 0 to 1; writes to `stream` only where a person reads it."""

    __slots__ = ("_label", "_next", "_shown", "_stream")

    def __init__(self, stream: TextIO, label: str) -> None:
        self._stream, self._label = stream, label
        self._next = monotonic() + PATIENCE if is_terminal(stream) else float("inf")
        self._shown = False

    def __call__(self, part: float) -> None:
        if monotonic() < self._next:
            return
        self._next = monotonic() + PERIOD
        self._shown = True
        room = max(10, min(40, width_of(self._stream) - len(self._label) - 10))
        bar = ("█" * round(part * room)).ljust(room, "░")
        self._stream.write(f"\r{self._label} {bar} {part:4.0%}\x1b[K")
        self._stream.flush()

    def done(self) -> None:
        """Take the line away."""
        if self._shown:
            self._stream.write("\r\x1b[K")
            self._stream.flush()
