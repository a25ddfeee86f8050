"""Processor time of several tasks that share the processor."""

from __future__ import annotations

from motionlang.log.stream import Stream

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.log.records import TimeSlices
    from motionlang.log.stream import Store

    TimeSlicesInOrder = Stream[TimeSlices]
else:
    TimeSlicesInOrder = Stream


class TimeSliceStream(TimeSlicesInOrder):
    """`TimeSlices` in order of time.

    Tasks that alternate without a wait form one record.
    """

    __slots__ = ("_began", "seconds")

    def __init__(self, store: Store) -> None:
        super().__init__(store, "TimeSlices")
        # How long each task has computed since one of them began or ended a wait, and the time of that.
        self.seconds: dict[str, float] = {}
        self._began = 0.0

    def took(self, task: str, began: float, now: float, stops: bool) -> None:
        """Record a time slice of a task; `stops` is true if the task then waits or ends."""
        seconds = self.seconds
        if not seconds:
            if stops:
                self.add((began, now, (task,), (now - began,)))
                return
            self._began = began
        seconds[task] = seconds.get(task, 0.0) + now - began
        if stops:
            self.close(now)

    def close(self, now: float) -> None:
        """Write the current record, because a task begins or ends a wait."""
        seconds, self.seconds = self.seconds, {}
        self.add((self._began, now, tuple(seconds), tuple(seconds.values())))
