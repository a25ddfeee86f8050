"""Virtual time: a heap of events, and `now`.

Time passes in two ways: the program spends it (a statement costs something), or everybody waits and the clock
jumps to the next event. Both end in `advance`, so an event always runs at its own exact time.
"""

from __future__ import annotations

from heapq import heappop, heappush

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

INFINITY = float("inf")


class Event:
    """Something that happens at `time`; `cancel()` makes it not happen."""

    __slots__ = ("call", "time")

    def __init__(self, time: float, call: Callable[[], object]) -> None:
        self.time = time
        self.call: Callable[[], object] | None = call

    def cancel(self) -> None:
        self.call = None


class Clock:
    """`now` in seconds since power-up, and `horizon`, the time of the next event (infinite when there is none).

    `made` and `fired` count the events that were entered and those whose time has come, `leaps` the times at which it
    went on over what was known to repeat itself.
    """

    __slots__ = ("_heap", "_kept", "fired", "horizon", "leaps", "made", "now")

    def __init__(self) -> None:
        self.now = 0.0
        self.horizon = INFINITY
        self.made = self.fired = self.leaps = 0
        self._kept = 0  # places in the order that are kept for events entered later
        self._heap: list[tuple[float, int, Event]] = []

    def at(self, time: float, call: Callable[[], object]) -> Event:
        """Call `call` at `time`; events of one time run in the order in which they were made.

        A call that answers true was no news: nobody has heard of it but those who knew when it would be.
        """
        event = Event(time, call)
        self.made += 1
        heappush(self._heap, (time, self.made + self._kept, event))
        if time < self.horizon:
            self.horizon = time
        return event

    def again(self, event: Event, time: float) -> None:
        """Let an event that has happened happen once more."""
        event.time = time
        self.made = made = self.made + 1
        heappush(self._heap, (time, made + self._kept, event))
        if time < self.horizon:
            self.horizon = time

    def keep(self, count: int) -> int:
        """Keep `count` places in the order of events, as if they were made now; the last of those before them."""
        first = self.made + self._kept
        self._kept += count
        return first

    def at_kept(self, time: float, order: int, call: Callable[[], object]) -> Event:
        """The same as `at`, in a place that was kept for it."""
        event = Event(time, call)
        heappush(self._heap, (time, order, event))
        if time < self.horizon:
            self.horizon = time
        return event

    def next_time(self) -> float:
        """The time of the next event that will happen, infinite when there is none."""
        heap = self._heap
        while heap and heap[0][2].call is None:
            heappop(heap)
        self.horizon = heap[0][0] if heap else INFINITY
        return self.horizon

    def advance(self, time: float) -> None:
        """Let time pass until `time`, running what falls due on the way at its own moment."""
        heap = self._heap
        while heap and heap[0][0] <= time:
            due, _, event = heappop(heap)
            call = event.call
            if call is not None:
                if due > self.now:
                    self.now = due
                self.fired += 1
                call()
        if time > self.now:
            self.now = time
        while heap and heap[0][2].call is None:
            heappop(heap)
        self.horizon = heap[0][0] if heap else INFINITY

    def advance_to_news(self, end: float) -> bool:
        """The same, no further than the first moment at which there is news; true where there is none."""
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

    def ring(self, moment: float) -> bool:
        """Let time pass to the next event, where that is at a moment; false where it is not, or was news."""
        if self.horizon != moment and self.next_time() != moment:
            return False
        heap = self._heap
        call = heap[0][2].call
        if call is None:
            return self.next_time() == moment and self.advance_to_news(moment)
        heappop(heap)
        self.now = moment
        self.fired += 1
        quiet = call()
        while heap:
            due, _, event = heap[0]
            if due <= moment:
                return self.advance_to_news(moment) and bool(quiet)
            if event.call is not None:
                self.horizon = due
                return bool(quiet)
            heappop(heap)
        self.horizon = INFINITY
        return bool(quiet)
