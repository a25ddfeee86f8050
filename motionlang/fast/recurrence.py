"""Skipping of periods when the joint state of polling tasks repeats.

Replaces: running every iteration of tasks that do no more than poll and wait.

Hook: `Accelerators.scheduler`; `TimeSlices.slice_over` calls it after each time slice of a task that has only
polled.

Gain: 32 tasks that poll take no longer for hours than for seconds, 10² to 10⁵ times (`poll_32_tasks_reading`
of benchmarks/poll.py).

Equality is tested by: tests/fast/test_recurrence.py, tests/generated/test_tasks.py with generated tasks.

A joint state is everything that decides the next actions of the tasks:

* of each task its position in the code, its local variables and the rest of its wait (`Task.state`),
* the variables that tasks share, and the counters of their other actions (`Shared.state`),
* the task of the next time slice, the events so far, and those in the log.

Readings are included by their dependencies. `Dependencies.read` collects those of all tasks since the first
state was stored. The period repeats until the first time at which one of them may change, an event happens,
or a wait outside the period ends. So a state that recurs proves a period, whatever the tasks are doing.

The actions of tasks are compared first, so that nothing is stored while they act. States are small: contents
are replaced by numbers, and a task that has not run since keeps its number.

A search begins with the first time slice without an action. After `MAX_EAGER_FAILURES` failed searches per task
it begins only after as many such slices as there are tasks, and every second search is replaced by a back-off of
1, 2, 4, … time slices.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.lang.dependencies import CLOSE
from motionlang.lang.statement_time import UNITS, StatementTime, units
from motionlang.lang.waits import Delay

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.controller.controller import Controller
    from motionlang.lang.dependencies import Note
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Shared, Task
    from motionlang.lang.waits import Wait
    from motionlang.log.log import Mark

    # When a state was met: the time, the base and the count of the statement time, and what had been logged.
    Met = tuple[float, float, float, Mark]

# Waits that are this many times as long as the shortest one may also end a short period, and so may all waits
# if a task polls without one.
LONGER = 4.0
# Up to this many states, and contents of this many bytes, are stored; then all are dropped.
MAX_STATES = 20_000
MAX_BYTES = 10_000_000
# Failed searches per task before the back-off, and its longest, in time slices.
MAX_EAGER_FAILURES, MAX_BACK_OFF = 2, 2048


class Recurrence:
    """The joint states since the tasks began to only poll and wait."""

    def __init__(self, machine: Controller | Machine, pace: Callable[[float], None] | None) -> None:
        self._clock, self._pace, self._log = machine.clock, pace, machine.log
        self._statements: StatementTime = getattr(machine, "statements", None) or StatementTime(0.0)
        self._shared: Shared | None = None
        self._since: object = None
        self._read: set[Note] = set()
        self._met: dict[tuple[object, ...], Met] = {}
        self._numbers: dict[object, int] = {}
        self._bytes = 0
        self._states: dict[Task, int] = {}
        # Objects whose identity is part of a state.
        self._alive: dict[int, object] = {}
        # The index of the next task in the first state of a search. If no polling task waits, the tasks alternate,
        # and only states with this next task are compared.
        self._first_index, self._alternate = 0, False
        # The searches since one has skipped something, the time slices left of a back-off, and true if the last
        # change began a back-off.
        self._failures = self._back_off = 0
        self._backed_off = False

    def is_eager(self, count: int) -> bool:
        """True if the next search is likely to skip something, with so many tasks."""
        return self._excess(count) <= 0

    def forget(self) -> None:
        """Drop all states, because a task did more than poll and wait."""
        if self._shared is not None:
            self._shared.dependencies.end_all()
            self._since = self._shared = None

    def has_run(self, task: Task) -> None:
        """Invalidate the stored state of a task that has run."""
        self._states.pop(task, None)

    def leap(self, tasks: Sequence[Task], next_index: int, until: float, without_waits: bool = False) -> None:
        """Skip as many complete periods as fit before a change, if a period is known.

        This is called after a time slice. `without_waits`: no task of a period may wait.
        """
        shared = tasks[0].shared
        if without_waits and not any(task.wait is None for task in tasks):
            return
        if shared is None or self._statements.reached != self._clock.now:
            self.forget()
            return
        if self._back_off:
            self._back_off -= 1
            return
        since = self._clock.fired, shared.acted(), len(self._log.events)
        full = len(self._met) > MAX_STATES or self._bytes > MAX_BYTES
        if since != self._since or full or shared.dependencies.read is not self._read:
            if self._backs_off(len(tasks)):
                self.forget()
                return
            self._failures += 1
            self._begin(since, shared)
            self._first_index = next_index
        elif self._alternate and next_index != self._first_index:
            return
        if any(task.wait is None and task.poll_check is None for task in tasks):
            self.forget()
            return
        state = [next_index, self._number(shared.state(self._alive))]
        for task in tasks:
            number = self._states.get(task)
            if number is None:
                own = task.state(self._alive)
                if own is None:
                    return
                number = self._states[task] = self._number(own)
            state.append(number)
        lengths = [task.wait.length for task in tasks if task.poll_check and isinstance(task.wait, Delay)]
        self._alternate = not lengths
        longest, shortest = max(lengths, default=0.0), min(lengths, default=0.0)
        # The tasks of a period are those that poll and wait for at most this long, s.
        max_waits = {longest, min(longest, LONGER * shortest)}
        if any(task.wait is None for task in tasks):
            max_waits = {0.0} if without_waits else max_waits | {0.0}
        for max_wait in sorted(max_waits, reverse=True):
            inner = [task for task in tasks if task.poll_check and _duration(task.wait) <= max_wait]
            others = [task.wait for task in tasks if task.wait is not None and task not in inner]
            if self._skips(inner, others, (max_wait, *state), until):
                return

    def _excess(self, count: int) -> int:
        """Return the failed searches in excess of those that `count` tasks may have."""
        return self._failures - MAX_EAGER_FAILURES * count

    def _backs_off(self, count: int) -> bool:
        """True if a back-off of some time slices replaces the search that is due."""
        excess = self._excess(count)
        self._backed_off = excess > 0 and not self._backed_off
        if self._backed_off:
            self._back_off = min(2 ** min(excess, 30), MAX_BACK_OFF)
        return self._backed_off

    def _begin(self, since: object, shared: Shared) -> None:
        """Drop all states from before now."""
        self._since, self._shared, self._alternate = since, shared, False
        self._read = shared.dependencies.begin_all()
        self._met, self._numbers, self._bytes = {}, {}, 0
        self._states, self._alive = {}, {}

    def _number(self, contents: bytes) -> int:
        """Return the number of some contents."""
        number = self._numbers.get(contents)
        if number is None:
            number = self._numbers[contents] = len(self._numbers)
            self._bytes += len(contents)
        return number

    def _skips(self, tasks: list[Task], others: list[Wait], state: tuple[float, ...], until: float) -> bool:
        """Skip periods of `tasks` during which `others` wait.

        True if the search is over: there were any, or all states are dropped, and the numbers in `state` with them.
        """
        clock, statements = self._clock, self._statements
        now, base, count = clock.now, statements.base, statements.count
        waits = [task.wait for task in tasks if isinstance(task.wait, Delay)]
        elapsed = units(base) + int(count) * statements.cost_units
        remaining = [units(wait.ends) - elapsed for wait in waits]
        if waits and not statements.cost_units:
            remaining.append(count)  # type: ignore[arg-type]
        dues = [wait.due() for wait in others]
        key = (*state, *remaining, *dues)
        before, self._met[key] = self._met.get(key), (now, base, count, self._log.mark_period())
        if before is None:
            return False
        shift = self._shift(before, bool(waits))
        if shift is None:
            return False
        shared = self._shared
        assert shared is not None
        level = shared.dependencies.until(before[0] - CLOSE, self._read) - CLOSE
        if level <= now:  # a reading has changed, and the next period may differ
            self._begin(self._since, shared)
            return True
        if any(wait.ready() for wait in others):
            return False
        limit = min(level, clock.next_time(), *dues)
        if limit == until == INFINITY:
            raise Rejected("never", "the loops look for something that can no longer happen", "")
        times = int((min(limit, until) - CLOSE - now) / (now - before[0]))
        if times <= 0:
            return False
        statements.repeat(before[1], before[2], times)
        time = statements.reached
        if self._pace is not None:
            self._pace(time)
        for wait in waits:
            wait.move((units(wait.ends) + times * shift) / UNITS)
        clock.leaps += 1
        self._failures = 0
        clock.now = time
        self._log.repeat_period(before[3], before[0], now, time, times)
        self._met[key] = time, statements.base, statements.count, self._log.mark_period()
        return True

    def _shift(self, before: Met, wait: bool) -> int | None:
        """Return how much later, in units, waits end period by period.

        None if periods are not equal to the last bit. They are if statements continue their count from the
        same time, or equally far from another one, and each time is a whole unit.
        """
        statements = self._statements
        base, count, cost_units = statements.base, statements.count, statements.cost_units
        if base == before[1]:
            return None if wait and not cost_units else int(count - before[2]) * cost_units
        if count != before[2] or not _is_whole(base) or not _is_whole(before[1]):
            return None
        return units(base) - units(before[1])


def _is_whole(moment: float) -> bool:
    return units(moment) / UNITS == moment


def _duration(wait: Wait | None) -> float:
    """Return the duration of a wait; infinite if it is not known."""
    if wait is None:
        return 0.0
    return wait.length if isinstance(wait, Delay) else INFINITY
