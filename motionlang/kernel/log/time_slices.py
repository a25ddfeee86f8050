"""Processor time of several tasks that share the processor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import fsum

from motionlang.kernel.log.records import TimeSlices, Waited
from motionlang.kernel.log.stream import Budget, Stream

# The number of records, and how long each task has computed since the last one.
Mark = tuple[int, dict[str, float]]


class Life:
    """The time of a task from its first `begin` to its last `end`, s.

    A task may be run again after it has ended: `lived` is for how long it was there, without the last time if it still
    runs, `since` when.
    """

    __slots__ = ("begin", "end", "lived", "since")

    def __init__(self, begin: float) -> None:
        self.begin = self.end = begin
        self.since: float | None = begin
        self.lived = 0.0


class TimeSliceStream(Stream[TimeSlices]):
    """`TimeSlices` in order of time.

    Tasks that alternate without a wait form one record. While a task is the only one, its time slices are not
    recorded: a record without tasks has the time from which to which one was alone, and a program of one
    task has no records. `lives` has all tasks except the parent and handlers of events.
    """

    def __init__(self, budget: Budget) -> None:
        super().__init__(budget)
        # How long each task has computed since one of them began or ended a wait, and the time of that.
        self.seconds: dict[str, float] = {}
        self._began = 0.0
        self._alone_since: float | None = 0.0
        # For how long the running task waits in iterations that are skipped in its time slice.
        self._rested = 0.0
        self.lives: dict[str, Life] = {}

    def started(self, task: str, now: float) -> None:
        """Record that a task begins."""
        self.lives.setdefault(task, Life(now)).since = now

    def ended(self, task: str, now: float) -> None:
        """Record that a task is over."""
        life = self.lives.get(task)
        if life is not None and life.since is not None:
            life.lived += now - life.since
            life.since, life.end = None, now

    def alone(self, now: float) -> None:
        """Record that there is only one task from now on."""
        self._alone_since = now

    def shared(self, now: float) -> None:
        """Record that there was only one task until now."""
        since, self._alone_since = self._alone_since, None
        if since is not None and since < now:
            self.add(TimeSlices(since, now, (), ()))

    def rested(self, count: int, waits: Iterable[Waited]) -> None:
        """Record that the running task waited as often again, in skipped iterations."""
        if self._alone_since is None:
            self._rested += count * fsum(wait.until - wait.since for wait in waits)

    def shared_by_all(self, seconds: float) -> None:
        """Record that all tasks have computed in a part of the present time slice, as in `repeat_since`."""
        self._rested += seconds

    def so_far(self, task: str, began: float, now: float) -> None:
        """Record the present time slice of a task up to now; `took` records the rest."""
        if not self.seconds:
            self._began = began
        self.seconds[task] = self.seconds.get(task, 0.0) + now - began - self._rested
        self._rested = now - began

    def took(self, task: str, began: float, now: float, stops: bool) -> None:
        """Record a time slice of a task; `stops` is true if the task then waits or ends."""
        seconds, rested, self._rested = self.seconds, self._rested, 0.0
        if not seconds:
            if stops:
                self.add(TimeSlices(began, now, (task,), (now - began - rested,)))
                return
            self._began = began
        seconds[task] = seconds.get(task, 0.0) + now - began - rested
        if stops:
            self.close(now)

    def mark(self) -> Mark:
        """Return how much has been recorded, for `repeat_since`."""
        return self.past, dict(self.seconds)

    def repeat_since(self, mark: Mark, now: float, until: float, times: int) -> None:
        """Record that what was recorded since `mark` repeats so many times.

        The repetitions take from now to `until`.
        """
        count, opened = mark
        seconds: dict[str, float] = {}
        for _, _, tasks, taken in self.rows[max(count - self.first, 0) :]:
            for task, each in zip(tasks, taken, strict=True):
                seconds[task] = seconds.get(task, 0.0) + each
        for task, each in self.seconds.items():
            seconds[task] = seconds.get(task, 0.0) + each
        for task, each in opened.items():
            seconds[task] -= each
        if self.seconds:
            self.close(now)
        repeated = {task: times * each for task, each in seconds.items() if each}
        if repeated:
            self.add(TimeSlices(now, until, tuple(repeated), tuple(repeated.values())))

    def up_to(self, now: float) -> Iterator[TimeSlices]:
        """Yield all records, with the current one as it would be written now."""
        yield from self
        if self.seconds:
            yield TimeSlices(self._began, now, tuple(self.seconds), tuple(self.seconds.values()))
        if self.rows and self._alone_since is not None:
            yield TimeSlices(self._alone_since, now, (), ())

    def close(self, now: float) -> None:
        """Write the current record, because a task begins or ends a wait."""
        seconds, self.seconds = self.seconds, {}
        self.add(TimeSlices(self._began, now, tuple(seconds), tuple(seconds.values())))
