"""Digital and analogue channels with listeners, set from outside or by a program."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.controller.io.reads import ReadObserver
from motionlang.kernel.controller.io.samples import AnalogueChanges
from motionlang.kernel.controller.io.sensor import Sensor
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.records import Changed, Switched
from motionlang.kernel.log.stream import Stream
from motionlang.kernel.traced import reading


class Channels:
    """Numbered values, 0 until they are set; `changes` is their log.

    The log has `Changed` of inputs, and `Switched` of outputs, if `origin` returns where the program is.

    `listeners` are called with (channel, value) after a value has changed. `active_low` are the digital
    channels that are on while their level is low. `table` is that of the machine file that changes them. The value
    of an input is its level; the value of an output is true if it is on.
    """

    __slots__ = (
        "_clock",
        "_origin",
        "_values",
        "active_low",
        "changes",
        "is_supposed",
        "listeners",
        "observer",
        "table",
        "traces",
    )

    def __init__(
        self,
        clock: Clock,
        changes: Stream[Any] | None = None,
        origin: Callable[[], tuple[int, int]] | None = None,
        table: str = "",
    ) -> None:
        self._clock, self.changes, self._origin, self.table = clock, changes, origin, table
        self._values: dict[int, float] = {}
        self.active_low: frozenset[int] = frozenset()
        self.listeners: list[Callable[[int, float], None]] = []
        # True while its values are only supposed.
        self.is_supposed = False
        self.observer: ReadObserver | None = None
        self.traces = False

    def __getitem__(self, channel: int) -> float:
        if self.observer is not None:
            self.observer(self.table, channel)
        return self._values.get(channel, 0)

    def note_read(self, channel: int) -> None:
        """Call the observer of a channel of which the program reads something else, such as an edge."""
        if self.observer is not None:
            self.observer(self.table, channel)

    def present(self, channel: int) -> float:
        """Return the value of a channel for the world; the program reads nothing."""
        return self._values.get(channel, 0)

    def __setitem__(self, channel: int, value: float) -> None:
        self.set(channel, value)

    def set(self, channel: int, value: float, origin: tuple[int, int] | None = None) -> bool:
        """Set a channel by the present statement, or by another one; return True if that changed it."""
        if self._values.get(channel, 0) == value:
            return False
        self._values[channel] = value
        if self.changes is not None:
            now, present = self._clock.now, self._origin
            self.changes.add(
                Changed(now, channel, value)
                if present is None
                else Switched(now, channel, value, *(origin or present()))
            )
        self._notify(channel)
        return True

    @contextmanager
    def supposing(self, values: Mapping[int, float]) -> Iterator[None]:
        """Give some channels other values in the block; no listener is called, and nothing is logged."""
        before, self.is_supposed = self._values, True
        self._values = before | dict(values)
        try:
            yield
        finally:
            self._values, self.is_supposed = before, False

    @property
    def values(self) -> tuple[tuple[int, float], ...]:
        """The channels that have been set, with their values."""
        return tuple(self._values.items())

    @property
    def touched(self) -> list[int]:
        """Return the channels that have changed since power-up, in order."""
        return sorted(self._values)

    @property
    def is_untouched(self) -> bool:
        """True if no channel has changed since power-up."""
        return not self._values

    def clear(self) -> None:
        """Reset all channels to 0 and notify the listeners of those that change."""
        for channel in sorted(self._values):
            self[channel] = 0

    def _notify(self, channel: int) -> None:
        observer, self.observer = self.observer, None  # the program reads nothing here
        try:
            value = self[channel]
            for listener in tuple(self.listeners):
                listener(channel, value)
        finally:
            self.observer = observer

    def listen(self, call: Callable[[int, float], None]) -> None:
        """Call `call(channel, value)` after a value has changed."""
        self.listeners.append(call)

    def inverted(self, channel: int) -> bool:
        """Convert a channel's level to its logical state, or vice versa."""
        if self.observer is not None:
            self.observer(self.table, channel)
        return bool(self._values.get(channel, 0)) is not (channel in self.active_low)

    def set_active_low(self, channels: Iterable[int]) -> None:
        """Set the channels that are on while low; notify of the states that this changes."""
        before, self.active_low = self.active_low, frozenset(channels)
        for channel in sorted(before ^ self.active_low):
            self._notify(channel)

    def set_bank(self, first: int, count: int, bits: int) -> bool:
        """Set `count` channels from `first` on; return True if that changed one."""
        changes = [self.set(first + k, bits >> k & 1) for k in range(count)]
        return any(changes)


class AnalogueInputs(Channels):
    """Channels with the samples of sensors on axes, computed when they are read.

    `computed` are, by channel, the sensors on moving axes whose samples are not events.
    """

    __slots__ = ("_computes", "_sampled", "computed")

    def __init__(self, clock: Clock, log: Log) -> None:
        super().__init__(clock, log.changes_of_analogue_inputs, table="analogue")
        self._sampled = log.sampled
        self.computed: dict[int, Sensor] = {}
        self._computes = False
        log.analogue_inputs = AnalogueChanges(log, self.settle)

    def __getitem__(self, channel: int) -> float:
        if self.observer is not None:
            self.observer(self.table, channel)
        level = self.computed[channel].level() if channel in self.computed else None
        if level is None:
            level = self._values.get(channel, 0)
        return reading(level, self.table, channel) if self.traces else level

    def set(self, channel: int, value: float, origin: tuple[int, int] | None = None) -> bool:
        """Set a channel by the present statement, or by another one; return True if that changed it."""
        self.settle()
        return super().set(channel, value)

    @property
    def values(self) -> tuple[tuple[int, float], ...]:
        """The channels that have been set, with their values."""
        self.settle()
        return super().values

    def listen(self, call: Callable[[int, float], None]) -> None:
        """Notify a listener of each sample from now on."""
        super().listen(call)
        for sensor in tuple(self.computed.values()):
            sensor.tick()

    def compute(self) -> None:
        """Compute samples on demand, not by events; each reading records a dependency."""
        self._computes = True

    def may_compute(self, channel: int) -> bool:
        """True if the samples of a channel can be computed on demand, without events."""
        return self._computes and not self.listeners and channel not in self.computed

    def settle(self) -> None:
        """Log the samples up to now."""
        for channel, sensor in self.computed.items():
            value = sensor.log_samples(self._sampled)
            if value is not None:
                self._values[channel] = value
