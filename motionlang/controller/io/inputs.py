"""Digital and analogue channels, set by the world or the program, with listeners."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from motionlang.controller.clock import Clock
    from motionlang.log.records import Changed
    from motionlang.log.stream import Stream


class Channels:
    """Numbered values, 0 until they are set; `changes` is their log, as `Changed`.

    `listeners` are called with (channel, value) after a value has changed. `active_low` are the digital
    channels that are on while their level is low. An input's value is its level; an output's value is true if
    it is on.
    """

    __slots__ = ("_clock", "_values", "active_low", "changes", "listeners")

    def __init__(self, clock: Clock, changes: Stream[Changed] | None = None) -> None:
        self._clock, self.changes = clock, changes
        self._values: dict[int, float] = {}
        self.active_low: frozenset[int] = frozenset()
        self.listeners: list[Callable[[int, float], None]] = []

    def __getitem__(self, channel: int) -> float:
        return self._values.get(channel, 0)

    def __setitem__(self, channel: int, value: float) -> None:
        if self._values.get(channel, 0) == value:
            return
        self._values[channel] = value
        if self.changes is not None:
            self.changes.add((self._clock.now, channel, value))
        self._tell(channel)

    @property
    def values(self) -> tuple[tuple[int, float], ...]:
        """The channels that were ever set, with their values."""
        return tuple(self._values.items())

    @property
    def touched(self) -> list[int]:
        """The channels that ever had a value other than that at power-up, in order."""
        return sorted(self._values)

    def clear(self) -> None:
        """Reset all channels to 0 and notify of those that were not."""
        for channel in sorted(self._values):
            self[channel] = 0

    def _tell(self, channel: int) -> None:
        value = self[channel]
        for listener in tuple(self.listeners):
            listener(channel, value)

    def inverted(self, channel: int) -> bool:
        """Return a level as a logical state, or a logical state as a level."""
        return bool(self._values.get(channel, 0)) is not (channel in self.active_low)

    def set_active_low(self, channels: Iterable[int]) -> None:
        """Set the channels that are on while low; notify of those that this inverts."""
        before, self.active_low = self.active_low, frozenset(channels)
        for channel in sorted(before ^ self.active_low):
            self._tell(channel)

    def bank(self, first: int, count: int) -> int:
        """`count` channels from `first` on as a number, the first one the lowest bit."""
        return sum(1 << k for k in range(count) if self[first + k])

    def set_bank(self, first: int, count: int, bits: int) -> None:
        for k in range(count):
            self[first + k] = bits >> k & 1
