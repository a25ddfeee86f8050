"""The entries of a machine file that take effect by time or after an output.

By time: at `at`, and then every `every` seconds, `times` in total. After an output: `delay` seconds after each change
of `output` to `level`. The owner of a table gives the function that an entry calls then.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from motionlang.kernel.controller.clock import INFINITY, Clock
from motionlang.kernel.controller.io.channels import Channels

Entry = Mapping[str, object]


class Stimulus:
    """An entry of a table; `count` is how often it has taken effect."""

    __slots__ = ("_act", "_all", "_begin", "_clock", "_every", "_times", "count", "entry", "table")

    def __init__(
        self, stimuli: Stimuli, table: str, entry: Entry, act: Callable[[], object], since: float
    ) -> None:
        self.table, self.entry, self.count = table, entry, 0
        self._all, self._clock, self._act = stimuli, stimuli.clock, act
        self._begin = since + entry.get("at", 0.0)  # type: ignore[operator]
        self._every: float | None = entry.get("every")  # type: ignore[assignment]
        self._times: float = entry.get("times", INFINITY)  # type: ignore[assignment]

    def begin(self, *, at_once: bool) -> None:
        """Start an entry that takes effect by time; those of its times that are past count as one.

        If its time has come, it takes effect `at_once`, or at the next event.
        """
        now = self._clock.now
        if self._every is not None and self._begin < now:
            self.counts(int(min((now - self._begin) // self._every, self._times - 1)))
        time = self._time()
        if at_once and time <= now:
            self.act()
        else:
            self._clock.at(max(time, now), self.act)

    def act(self) -> None:
        """Take effect, and schedule the next time if there is one."""
        self.counts()
        self._act()
        if self._every is not None and self.count < self._times:
            self._clock.at(self._time(), self.act)

    def counts(self, times: int = 1) -> None:
        """Count that it takes effect so often."""
        if times and not self.count:
            self._all.taken.append((self.table, self.entry))
        self.count += times

    def after(self, delay: float) -> None:
        """Take effect `delay` seconds from now; at once without a delay."""
        if delay > 0.0:
            self._clock.at(self._clock.now + delay, self.act)
        else:
            self.act()

    def _time(self) -> float:
        return self._begin if self._every is None else self._begin + self.count * self._every


class _Pulse:
    """A value for a duration, s, which a further pulse prolongs."""

    __slots__ = ("_clock", "_end", "_length", "_off", "_on", "_put")

    def __init__(
        self, clock: Clock, put: Callable[[float], None], on: float, off: float, length: float
    ) -> None:
        self._clock, self._put, self._on, self._off, self._length = clock, put, on, off, length
        self._end = 0.0

    def begin(self) -> None:
        self._put(self._on)
        self._end = self._clock.now + self._length
        self._clock.at(self._end, self._finish)

    def _finish(self) -> None:
        if self._clock.now >= self._end:
            self._put(self._off)


class Stimuli:
    """The entries of a run that take effect by time or after an output.

    `taken` are those that have, with their tables.
    """

    # The attributes that `cut` restores.
    GROWING = ("taken",)

    def __init__(self, clock: Clock, outputs: Channels) -> None:
        self.clock, self._outputs = clock, outputs
        self.taken: list[tuple[str, Entry]] = []

    def add(
        self,
        table: str,
        entry: Entry,
        act: Callable[[], object],
        since: float = 0.0,
        *,
        at_once: bool = False,
    ) -> None:
        """Call `act` whenever an entry takes effect; its times count from `since`."""
        stimulus = Stimulus(self, table, entry, act, since)
        if "output" not in entry:
            stimulus.begin(at_once=at_once)
            return
        outputs, level = self._outputs, bool(entry.get("level", 1))
        output: int = entry["output"]  # type: ignore[assignment]
        delay: float = entry.get("delay", 0.0)  # type: ignore[assignment]

        def changed(number: int, _: float) -> None:
            if number == output and outputs.inverted(output) is level:
                stimulus.after(delay)

        outputs.listeners.append(changed)

    def add_pulse(
        self,
        table: str,
        entry: Entry,
        put: Callable[[float], None],
        on: float,
        off: float = 0,
        *,
        since: float = 0.0,
        at_once: bool = False,
    ) -> None:
        """Put `on` whenever an entry takes effect, and `off` when its `for` has passed since the last time."""
        length: float | None = entry.get("for")  # type: ignore[assignment]
        if length is None or entry.keys() & {"output", "every"}:
            act = partial(put, on) if length is None else _Pulse(self.clock, put, on, off, length).begin
            self.add(table, entry, act, since, at_once=at_once)
            return
        self.add(table, entry, partial(put, on), since, at_once=at_once)
        at: float = entry.get("at", 0.0)  # type: ignore[assignment]
        # Scheduled now, so that it is over before another entry takes effect at the same time.
        self.clock.at(max(since + at + length, self.clock.now), partial(put, off))

    def used(self, table: str) -> list[Entry]:
        """Return the entries of a table that have taken effect."""
        return [entry for each, entry in self.taken if each == table]

    def extent(self) -> int:
        """Return the number of entries that have taken effect, for `cut`."""
        return len(self.taken)

    def cut(self, extent: int) -> None:
        """Drop the entries that have taken effect since `extent` was taken."""
        del self.taken[extent:]
