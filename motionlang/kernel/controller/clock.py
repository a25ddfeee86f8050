"""Virtual time: a heap of events, and `now`.

Time passes when the program spends it (a statement has a duration), or when all tasks wait and the clock
jumps to the next event. Both end in `advance`, so an event always runs at its exact time.
"""

from __future__ import annotations

from collections.abc import Callable
from heapq import heappop, heappush

# No time, or no end.
INFINITY = float("inf")


class TimedCall:
    """A callback at `time`; `cancel()` prevents it."""

    __slots__ = ("call", "time")

    def __init__(self, time: float, call: Callable[[], object]) -> None:
        self.time = time
        self.call: Callable[[], object] | None = call

    def cancel(self) -> None:
        self.call = None


class Clock:
    """Virtual time: `now` since power-up, and `horizon`, the time of the next event.

    Both are in s; `horizon` is infinite if there is no event. `made` and `fired` count the events that were
    scheduled and those that have run.
    """

    __slots__ = ("_heap", "fired", "horizon", "made", "now")

    def __init__(self) -> None:
        self.now = 0.0
        self.horizon = INFINITY
        self.made = self.fired = 0
        self._heap: list[tuple[float, int, TimedCall]] = []

    def at(self, time: float, call: Callable[[], object], number: int | None = None) -> TimedCall:
        """Call `call` at `time`; events at the same time run in order of creation, or of a reserved `number`.

        If the call returns true, it woke no other task.
        """
        event = TimedCall(time, call)
        if number is None:
            self.made = number = self.made + 1
        heappush(self._heap, (time, number, event))
        if time < self.horizon:
            self.horizon = time
        return event

    def again(self, event: TimedCall, time: float) -> None:
        """Schedule an event that has already run for another time."""
        event.time = time
        self.made = made = self.made + 1
        heappush(self._heap, (time, made, event))
        if time < self.horizon:
            self.horizon = time

    def reserve(self, count: int) -> int:
        """Reserve the numbers of events that are created later; return the one before the first."""
        first, self.made = self.made, self.made + count
        return first

    def next_time(self) -> float:
        """Return the time of the next pending event, infinite if there is none."""
        heap = self._heap
        while heap and heap[0][2].call is None:
            heappop(heap)
        self.horizon = heap[0][0] if heap else INFINITY
        return self.horizon

    def advance(self, time: float) -> None:
        """Advance to `time`, running each event due before it at its own time."""
        while not self.advance_to_news(time):
            pass

    def advance_to_news(self, end: float) -> bool:
        """Advance to `end`, but no further than the first event that wakes a task; run each event at its own time.

        True if no event woke a task.
        """
        heap, time, quiet = self._heap, end, True
        while heap and heap[0][0] <= time:
            due, _, event = heappop(heap)
            call = event.call
            if call is not None:
                if due > self.now:
                    self.now = due
                self.fired += 1
                if not call():
                    time, quiet = self.now, False
        while heap and heap[0][2].call is None:
            heappop(heap)
        self.horizon = heap[0][0] if heap else INFINITY
        if time > self.now:
            self.now = time
        return quiet


class WatchedClock(Clock):
    """A clock that calls `watch` with each time to which it is about to advance.

    The result is that of an ordinary clock, unless `watch` raises an exception.
    """

    __slots__ = ("_watch",)

    def __init__(self, watch: Callable[[float], None]) -> None:
        super().__init__()
        self._watch = watch

    def advance_to_news(self, end: float) -> bool:
        """Advance like `Clock.advance_to_news`, one time after the other."""
        while (due := self.horizon) < end:
            self._watch(due)
            if not Clock.advance_to_news(self, due):
                return False
        if end > self.now or due == end:
            self._watch(end)
        return Clock.advance_to_news(self, end)
