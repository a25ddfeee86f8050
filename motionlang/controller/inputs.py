"""Digital and analogue channels: what the world sets, what the program sets, and who wants to know."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Clock


class Channels:
    """Numbered values, 0 until something sets them; `changes` is the log of (time, channel, value).

    `listeners` are called with (channel, value) after a value has changed.
    """

    __slots__ = ("_clock", "_values", "changes", "listeners")

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._values: dict[int, float] = {}
        self.changes: list[tuple[float, int, float]] = []
        self.listeners: list[Callable[[int, float], None]] = []

    def __getitem__(self, channel: int) -> float:
        return self._values.get(channel, 0)

    def __setitem__(self, channel: int, value: float) -> None:
        if self._values.get(channel, 0) == value:
            return
        self._values[channel] = value
        self.changes.append((self._clock.now, channel, value))
        for listener in self.listeners:
            listener(channel, value)

    def bank(self, first: int, count: int) -> int:
        """`count` channels from `first` on as the bits of a number, the first one lowest."""
        return sum(1 << k for k in range(count) if self[first + k])

    def set_bank(self, first: int, count: int, bits: int) -> None:
        for k in range(count):
            self[first + k] = bits >> k & 1
