"""Digital and analogue channels: what the world sets, what the program sets, and who wants to know."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from motionlang.controller.clock import Clock
    from motionlang.log.records import Changed
    from motionlang.log.stream import Stream


class Channels:
    """Numbered values, 0 until something sets them; `changes` is where a log has them, as `Changed`.

    `listeners` are called with (channel, value) after a value has changed. `active_low` are the digital channels that
    are on while their level is low: an input's value is its level, an output's value is whether it is on.
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
    def touched(self) -> list[int]:
        """The channels that ever had another value than at power-up, in order."""
        return sorted(self._values)

    def clear(self) -> None:
        """All channels are 0, as nobody had ever set them; those that were not are told of."""
        for channel in sorted(self._values):
            self[channel] = 0

    def _tell(self, channel: int) -> None:
        value = self[channel]
        for listener in tuple(self.listeners):
            listener(channel, value)

    def inverted(self, channel: int) -> bool:
        """The channel as a logical state where its value is a level, and as a level where its value is a state."""
        return bool(self._values.get(channel, 0)) is not (channel in self.active_low)

    def set_active_low(self, channels: Iterable[int]) -> None:
        """Say which channels are on while low; those that this turns over are told of."""
        before, self.active_low = self.active_low, frozenset(channels)
        for channel in sorted(before ^ self.active_low):
            self._tell(channel)

    def bank(self, first: int, count: int) -> int:
        """`count` channels from `first` on as the bits of a number, the first one lowest."""
        return sum(1 << k for k in range(count) if self[first + k])

    def set_bank(self, first: int, count: int, bits: int) -> None:
        for k in range(count):
            self[first + k] = bits >> k & 1
