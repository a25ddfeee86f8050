"""Time slices of tasks that wait, found without checking each task.

Replaces: the round of `Scheduler` in which every task is checked for the end of its wait. `idle_round`
resumes one task after the other while they wait for a time or for motion to end; each is found in one pass over the
ends of the waits. `passes_among_others` lets a wait pass without a task switch if its task is the next to continue
anyway. All other cases (two tasks at one time, an event in between, a wait for a condition) are left to the
scheduler.

Hook: `Accelerators.scheduler`. The run loop of `Scheduler` calls `idle_round` while all tasks may be waiting;
a WAIT or PAUSE of Mint calls `passes_among_others`. After each time slice `slice_over` calls `recurrence.py`.

Gain: four tasks 1.8 to 2.0 times (`shift_four_tasks` of benchmarks/shift.py).

Equality is tested by: tests/fast/test_time_slices.py, with random tasks.
"""

from __future__ import annotations

from operator import attrgetter

from motionlang.controller.clock import INFINITY
from motionlang.lang.scheduler import FULL_SLICE, Scheduler
from motionlang.lang.statement_time import NEVER
from motionlang.lang.waits import ROUNDING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.controller.controller import Controller
    from motionlang.fast.recurrence import Recurrence
    from motionlang.fast.timer_ticks import TimerTicks
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.scheduler import Outside
    from motionlang.lang.task import Task

_WAIT_OF: Callable[[Task], Any] = attrgetter("wait")


class TimeSlices(Scheduler):
    """A scheduler that knows when waits will end."""

    def __init__(
        self,
        machine: Controller | Machine,
        parent: Task,
        pace: Callable[[float], None] | None = None,
        outside: Outside | None = None,
    ) -> None:
        super().__init__(machine, parent, pace, outside)
        self.next_slice = -INFINITY
        # The ticks of the program's timer, if it has set one.
        self._ticks: TimerTicks | None = None
        # The number of successive time slices without an action, and the search for their period.
        self._idle_rounds = 0
        self._recurrence: Recurrence | None = None
        # The waits of all tasks, None for the running one; the latest and the expected end of each; the
        # source positions of those that wait for motion to end; and their names.
        self._known: list[Any] = []
        self._surely: list[float] = []
        self._ends: list[float] = []
        self._resting: set[int] = set()
        self._names: list[tuple[str]] = []
        # The index of the running task, the next event, and how many tasks have continued.
        self._index = 0
        self._event = INFINITY
        self._resumed = 0

    def idle_round(self, until: float) -> bool:
        """Resume tasks one after the other while all wait for a time or for motion to end.

        It stops at the time of a more complex case: two tasks can continue, an event comes first, a task does
        not wait, or the end of its wait is not predictable. False if no task continued.
        """
        if self._left or self.is_observed:
            return False
        tasks, clock, log, interrupts = self.tasks, self.clock, self.machine.log, self.interrupts
        waits: Callable[[Any], object] = log.waits.append
        append_slice: Callable[[Any], object] = log.slices.append
        known: list[Any] | None = None
        self._resumed = resumed = 0
        try:
            while not interrupts:
                if known is not self._known:
                    if not self._list_waits():
                        break
                    known, names = self._known, self._names
                    surely, ends, resting = self._surely, self._ends, self._resting
                for k in resting:
                    ends[k] = known[k].expected()
                first = min(ends)
                index = ends.index(first)
                ends[index] = INFINITY
                second = min(ends)
                if not clock.now + ROUNDING < first < until or second <= first + ROUNDING:
                    break
                found, wait = tasks[index], known[index]
                if index in resting:
                    self.current = self._last_checked(resting)
                    if not clock.ring(first):
                        break
                    resting.discard(index)
                elif clock.horizon <= first and clock.next_time() <= first:
                    break
                else:
                    surely[index] = INFINITY
                    clock.now = first
                self.began = first
                self.current, self._alone = found, True
                self._next_index, self._index, found.wait, known[index] = index + 1, index, None, None
                waits(found.waited(wait, first))
                # If a statement coincides with the time at which another task continues, rounding does not
                # decide the order.
                due = (min(surely) if resting else second) - 0.5 * ROUNDING
                self.next_slice = second
                resumed += 1
                time, after = found.resume(first, self._horizon(found, first, due))
                found.wait = after
                began = self.began
                if after is None or found.poll_check is not None or not began <= time < clock.horizon:
                    self._end_round(found, time, resumed)
                    return True
                if clock.now < time:
                    clock.now = time
                append_slice((began, time, names[index], (time - began,)))
                known[index] = after
                if after.ends is None:
                    resting.add(index)
                else:
                    ends[index] = surely[index] = after.ends
                if not resumed & 1023:
                    log.waits.trim()
                    log.slices.trim()
        finally:
            self.next_slice = -INFINITY
        if resumed:
            self._end, self._idle_rounds, self._stalls = 0.0, 0, 0
        return resumed > 0

    def _last_checked(self, indices: set[int]) -> Task:
        """Return the task whose wait the scheduler would check last.

        The next events are logged at the task's source position.
        """
        next_index, count = self._next_index, len(self.tasks)
        return self.tasks[
            max(indices, key=lambda k: (k - next_index) % count) if len(indices) > 1 else min(indices)
        ]

    def _list_waits(self) -> bool:
        """List the waits of all tasks, with their ends.

        False if a task does not wait, or if there is only one task.
        """
        known: list[Any] = list(map(_WAIT_OF, self.tasks))
        self._known = known
        if len(known) == 1:
            self.machine.log.slices.alone(self.clock.now)  # the last time slice has ended the others
        if None in known or len(known) == 1:
            return False
        self._names = [(task.name,) for task in self.tasks]
        self._surely = [INFINITY if wait.ends is None else wait.ends for wait in known]
        self._ends = self._surely[:]
        self._resting = {k for k, wait in enumerate(known) if wait.ends is None}
        return True

    def _end_round(self, task: Task, time: float, resumed: int) -> None:
        """Return a round to the scheduler, because a task did more than wait again."""
        if resumed + self._resumed > 1:
            self._idle_rounds = 0
        self._stalls = 0
        self._waiting[:] = [each for each in self.tasks if each is not task]
        self._leave(task, self._event, time, True)

    def slice_over(self, task: Task) -> None:
        """If all tasks only poll or wait and their state recurs, skip to the next event."""
        recurrence = self._recurrence
        if task.poll_check is None or task.busy or task.done or self.interrupts or self.outside is not None:
            self._idle_rounds = 0
            if recurrence is not None:
                recurrence.forget()
            return
        self._idle_rounds += 1
        count = len(self.tasks)
        if recurrence is not None:
            recurrence.has_run(task)
        if self._idle_rounds < count and (recurrence is None or not recurrence.is_eager(count)):
            return
        if recurrence is None:
            from motionlang.fast.recurrence import Recurrence

            recurrence = self._recurrence = Recurrence(self.machine, self.pace)
        elif self._idle_rounds == 1:
            recurrence.forget()  # tasks may have run since the last call
        recurrence.leap(self.tasks, self._next_index, self.until, self.is_observed)

    def timer_set(self, events: Any) -> None:
        """Prepare to run a timer's ticks while all tasks wait, after its period is set."""
        from motionlang.fast.timer_ticks import TimerTicks

        self._ticks, self.is_observed = TimerTicks(events), False
        # Programs without a timer do not pay for this.
        self._leave = self._leave_beside_timer  # type: ignore[method-assign]

    def _jump(self, until: float) -> None:
        """Jump to the next time at which something can change, or run ticks."""
        due, ticks = self.next_change(), self._ticks
        if ticks is None or not self.by_itself or self._left or not ticks.run(self, due, until):
            self._jump_to(due, until)

    @property
    def next_index(self) -> int:
        """The index of the task at which the search for the next one begins."""
        return self._next_index

    def _leave_beside_timer(self, task: Task, event: float, time: float, several: bool) -> None:
        """Leave a task, and skip ticks of TIMER if possible."""
        super()._leave(task, event, time, several)
        if self._ticks is not None:
            self._ticks.left(self, task)

    def ran_handler(self, task: Task, until: float) -> bool:
        """Let a handler interrupt the waiting tasks; True if it ends in one slice."""
        clock, statements, interrupts = self.clock, self._statements, self.interrupts
        several = len(self.tasks) > 1
        interrupts.append(task)
        statements.alone, statements.free = not several, NEVER
        self.next_slice, self._known = -INFINITY, []
        self.current, self._alone, self._next_index, self._stalls = task, True, 0, 0
        self.began = now = clock.now
        event = clock.next_time()
        event = horizon = event if event < until else until
        if several:
            self._end = now + min(FULL_SLICE, task.max_slice)
            horizon = min(horizon, self._end)
        time, task.wait = task.resume(now, horizon)
        if several or not task.done or not now <= time < clock.horizon:
            self._leave(task, event, time, several)
            return task.done and not interrupts
        clock.now = time
        interrupts.remove(task)
        return not interrupts

    def invalidate_waits(self) -> None:
        """Invalidate the known ends of the waits."""
        super().invalidate_waits()
        self.next_slice, self._known = -INFINITY, []

    def _horizon(self, task: Task, now: float, due: float) -> float:
        """Return the time up to which a task that wakes now may run.

        Another task continues at `due`.
        """
        max_slice, clock, until = task.max_slice, self.clock, self.until
        self._end = horizon = now + (max_slice if max_slice < FULL_SLICE else FULL_SLICE)
        event = clock.horizon
        if event <= horizon:
            event = clock.next_time()
        self._event = event = event if event < until else until
        if event < horizon:
            horizon = event
        return due if due < horizon else horizon

    def passes_among_others(self, since: float, end: float, by_arrival: bool) -> float:
        """Let a wait of one of several tasks pass, if its task is the next to continue.

        Returns the time up to which the task may then run, 0.0 if it must yield. With `by_arrival` the wait ends with
        an event that wakes no other task.
        """
        clock, known, ends, surely = self.clock, self._known, self._ends, self._surely
        if self.interrupts:
            return 0.0
        for k in self._resting:
            ends[k] = known[k].expected()
        self.next_slice = second = min(ends)
        began, until = self.began, self.until
        if (
            second <= end + ROUNDING
            or not since + ROUNDING < end < until
            or not began <= since < clock.horizon
        ):
            return 0.0
        if by_arrival:
            running = self.current
            self.current = self._last_checked({*self._resting, self._index})
            rang = clock.ring(end)
            self.current = running
            if not rang:
                return 0.0
        elif clock.horizon <= end and clock.next_time() <= end:
            return 0.0
        else:
            clock.now = end
        index, log = self._index, self.machine.log
        log.slices.append((began, since, self._names[index], (since - began,)))  # type: ignore[arg-type]
        self.began = end
        self._alone = True
        self._resumed = resumed = self._resumed + 1
        if not resumed & 1023:
            log.waits.trim()
            log.slices.trim()
        due = (min(surely) if self._resting else second) - 0.5 * ROUNDING
        return self._horizon(self.current, end, due)
