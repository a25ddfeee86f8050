"""Reports of hosts that could not connect, at most one line per second."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from time import monotonic

# Seconds between two lines.
INTERVAL = 1.0


class Refusals:
    """Rate limiter for reports of rejected hosts; `complain` is called with a line.

    The first rejection is reported at once. After that, one line per second reports the latest and the number of other
    rejections. Call `report` after `left` seconds, and `flush` at the end.
    """

    def __init__(self, complain: Callable[[str], None], now: Callable[[], float] = monotonic) -> None:
        self._complain, self._now = complain, now
        self._latest = ""
        self._count = 0
        self._next_report = -inf

    @property
    def left(self) -> float | None:
        """Return the seconds until `report` has a line to write, or None if it has none."""
        return max(0.0, self._next_report - self._now()) if self._count else None

    def add(self, text: str) -> None:
        """Count a rejected host; `text` is the reason."""
        self._latest = text
        self._count += 1
        self.report()

    def report(self) -> None:
        """Write a pending line if a second has passed since the last one."""
        if self._count and self._now() >= self._next_report:
            self.flush()

    def flush(self) -> None:
        """Write the rejections that are still pending."""
        if self._count:
            others = self._count - 1
            self._complain(f"{self._latest} ({others} more since the last line)" if others else self._latest)
            self._count = 0
            self._next_report = self._now() + INTERVAL
