"""The scheduler: run the tasks of a program in virtual time, from event to event.

Problem. Tasks share one processor on which statements take time (10 µs each by default), while axes move and
inputs change. A task that computes must not delay the others. Each run of a program must give the same
result, and eight hours of waiting must not take eight hours.

Idea. No clock ticks. A task is resumed with a horizon, the first time at which anything else may happen. It
runs on its own until it reaches the horizon, has to wait, or ends. Then the clock catches up, and each event
in between runs at its own time. If all tasks wait, the clock jumps to the earliest time at which an event
happens or a wait may end.

    time        0        1 ms     2 ms                    12.5 ms
    task A      ████████          ████ waits for 10 ms    ████
    task B               ████████     ███ waits for an input
                time slices of 1 ms     all wait: jump

The horizon is the earliest of four times: the next event of the clock, the end of the run, the end of the
time slice (`QUANTUM`, or the task's own if shorter), and the first time at which the wait of another task may
end.

Data. `tasks` has them in the order of their start, each with its `wait`, None while it can run. `interrupts`
is the stack of event handlers; while there is one, only the innermost runs. Among the tasks that can run,
those of the highest priority alternate, round robin. A wait whose end is a known time (`ends`) is compared
with the clock. For any other wait `ready` is true if it is over, and `due` is when it may be over next.

Invariants.
- A task reads the world or acts on it only after all events that are due by then. No slice outlasts the wait
  of another task.
- Times less than `ROUNDING` apart are one time: the order of the tasks decides, not the last bit.
- An event interrupts a time slice. The slice continues unless the event starts a handler or ends another
  task's wait.
- When the parent ends, the program has ended, and `settle` lets the motion in progress finish.
- `Stuck` is raised if every task waits and nothing can end any of the waits; if the run `gives_up`, so it is if they
  poll. A wait that is due and, by rounding, not ready is checked again slightly later, with doubling steps.

`pace` synchronises the run with real time. `outside` is a world that may act at any time, such as a host; the
clock then advances only as far as that allows.

Cost. A single task runs from event to event without the scheduler in between. With several tasks each slice
costs two passes over them. Other modules skip polls and waits that repeat; the result is the same without
them.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Protocol

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.lang.debugging import Hook
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.task import Task
from motionlang.kernel.lang.waits import ROUNDING, Wait
from motionlang.kernel.log.records import Waited


class Outside(Protocol):
    """A world that acts by itself."""

    def start(self, machine: Machine) -> None:
        """Called when the program starts on `machine`."""

    def may_act(self) -> bool:
        """True if the outside world may still end a wait that nothing else can end."""

    def advance(self, time: float) -> None:
        """Advance the machine's clock to `time`, or less if an outside event has arrived."""


# Virtual seconds that one task may run while another is runnable.
QUANTUM = 1e-3
# Slightly less, as a number of statements may fill it exactly.
FULL_SLICE = QUANTUM - ROUNDING
# Virtual seconds after which a task that computes lets `pace` wait for real time.
PACED = 10e-3
# How often a wait may be checked at one time before time advances without it.
STALLS = 4
_PRIORITY_OF: Callable[[Task], int] = attrgetter("priority")


class Stuck(Exception):
    """Every task waits or polls, and nothing can end any of the waits."""

    def __init__(self, task: Task, wait: Wait) -> None:
        self.task, self.wait = task, wait
        super().__init__(f"waits {wait.why}, which can no longer happen")


def _is_hopeless(task: Task) -> bool:
    wait = task.wait
    return (
        task.done or task.polls_in_vain or (wait is not None and wait.due() == INFINITY and not wait.ready())
    )


class Scheduler:
    """Runs tasks on a controller until the parent ends.

    The parent is the first task. `pace(now)` is called before time jumps, so that a run can be synchronised
    with real time. `outside` is a world that acts by itself, such as a host: it controls how far time
    advances, and may end any wait.
    """

    def __init__(
        self,
        controller: Controller,
        parent: Task,
        pace: Callable[[float], None] | None = None,
        outside: Outside | None = None,
        hook: Hook | None = None,
    ) -> None:
        self._controller = controller
        self.clock, self._log = controller.clock, controller.log
        # The parent is the first; it stays when it has ended.
        self.tasks: list[Task] = [parent]
        # Event handlers, the innermost last: while there is one, nothing else runs.
        self.interrupts: list[Task] = []
        self.current: Task = parent
        self.pace = pace
        self.outside = outside
        # True for a run that ends as soon as nothing can change any more. If the machine file limits its time
        # (`is_limited`), it goes on while the first task waits: that may be what a scenario shows.
        self.gives_up = self.is_limited = False
        # When the program had ended, while motion continues.
        self.ended: float | None = None
        # When the running task was resumed, true if no other could have been, and the end of its time slice,
        # 0 if there is none. An event cuts a slice in two, and does not end it.
        self.began = 0.0
        self._alone = False
        self._end = 0.0
        # The other tasks whose waits are not over.
        self._waiting: list[Task] = []
        # The wait of the running task that `passes` lets pass, for an observer.
        self.passing: Wait | None = None
        self.until = INFINITY
        # True once an event has ended the run.
        self.stopped = False
        # The index of the next task, and how often in a row time did not advance while all waited.
        self._next_index = 0
        self._stalls = 0
        controller.log.locate_by(self.where, self.calls)
        controller.run_by(self)
        self._hook = hook

    @property
    def parent(self) -> Task:
        """The task of the program itself."""
        return self.tasks[0]

    @property
    def by_itself(self) -> bool:
        """True if nothing but the tasks limits the clock."""
        return self.pace is None and self.outside is None

    def wait_of(self, task: Task) -> Wait | None:
        """Return the wait of a task, also one that passes without a round of the scheduler."""
        return self.passing if task.wait is None and task is self.current else task.wait

    def where(self) -> int:
        """Return the source position of the program for the log, -1 if it has ended.

        A handler that has ended, or another task, has none: it is that of the parent then.
        """
        task = self.parent if self.current.done else self.current
        return -1 if task.done else task.at

    def calls(self) -> tuple[int, ...]:
        """Return the source positions of the calls that led to `where`, outermost first."""
        task = self.current
        if task.done:
            task = self.parent
        return () if task.done else task.callers

    def start(self, task: Task) -> None:
        """Start a further task now."""
        self._alone = False
        self._log.slices.started(task.name, self.clock.now)
        self.tasks.append(task)

    def end(self, task: Task) -> None:
        """Stop a task at the request of the running one."""
        if task.wait is not None:
            self._log.waits.add(task.waited(task.wait, self.clock.now))
        self._forget(task)

    def interrupt(self, task: Task) -> None:
        """Run a task to its end before any other continues."""
        self._log.note(self.clock.now, "handler", text=task.name)
        self.interrupts.append(task)

    def run(self, until: float = INFINITY) -> str:
        """Run until the program has ended, or virtual time is up, then let motion finish.

        The result is "ended", "until", or "stopped" after a call of `stop`. Raises `Stuck` if the parent waits for
        something that can never happen, and any exception of a task.
        """
        done = self.run_program(until)
        if done:
            self.ended = self.clock.now
            done = self.settle(until)
        return "stopped" if self.stopped else "ended" if done else "until"

    def is_over(self) -> bool:
        """True if no event is due, and every task waits or polls for what only others could change."""
        return self.clock.next_time() == INFINITY and self.is_hopeless()

    def is_hopeless(self) -> bool:
        """True if no task can go on by itself, or end the wait of another one."""
        return all(map(_is_hopeless, self.interrupts[-1:] or self.tasks))

    def give_up(self) -> None:
        """Raise Stuck if nothing can change any more."""
        tasks = self.interrupts[-1:] or self.tasks
        acts = any(each.polls_in_vain and not each.is_endless for each in tasks)
        if self.is_limited and tasks[0].wait is not None:
            return
        if not acts and self.is_over() and (self.outside is None or not self.outside.may_act()):
            first = tasks[0]
            why = f"for a change of {first.polled}" if first.polled else "for its loop to end"
            leaves = first.conditions_out()
            before = leaves()
            wait = first.wait or Wait(self.clock.now, lambda: leaves() != before, lambda: INFINITY, why)
            raise Stuck(first, wait)

    def stop(self) -> None:
        """End the run now, at an event that it was to end at."""
        self.stopped, self.until = True, self.clock.now

    def run_program(self, until: float = INFINITY) -> bool:
        """Run tasks until the parent ends; False if `until` came first."""
        clock = self.clock
        outside = self.outside is not None
        parent = self.parent
        self.until, self._end = until, 0.0
        while not parent.done:
            now = clock.now
            is_over = now >= self.until
            if self._hook is not None and (is_over or not self._end):
                self._hook.between()
            if is_over:
                return False
            task = self.current if self._end else self._runnable()
            if task is None:
                self._jump(until)
                continue
            event = min(clock.next_time(), until, INFINITY if self.pace is None else now + PACED)
            several = outside or len(self.tasks) > 1
            self.began, self._alone = now, not several
            if several and not self._end:
                self._end = now + min(FULL_SLICE, task.max_slice)
            time, task.wait = task.resume(now, self.horizon(task))
            self._leave(task, event, time, several)
        return True

    def horizon(self, task: Task) -> float:
        """Return until when a task may run on: something else may happen then."""
        clock = self.clock
        horizon = min(clock.next_time(), self.until, INFINITY if self.pace is None else self.began + PACED)
        return min(horizon, self._end, self._next_due(task)) if self._end else horizon

    @property
    def turn(self) -> tuple[int, float]:
        """Which task is next, and when the present time slice ends; 0 if there is none."""
        return self._next_index, self._end

    def move_slice(self, by: float) -> None:
        """Move the end of the present time slice, since the running task has skipped whole periods of all tasks."""
        if self._end:
            self._end += by

    def passes(self, wait: Wait) -> bool:
        """Let a wait of the running task pass; False if the task must yield.

        The task must yield unless it is the only task, nothing outside controls the clock, nothing else
        begins during the wait, and the wait has an end.
        """
        clock = self.clock
        if not self.by_itself or self._end:
            return False
        self.passing = wait
        try:
            clock.advance(wait.since)
            while clock.now < self.until and len(self.tasks) == 1 and not self.interrupts:
                if wait.ready():
                    return True
                time = min(wait.due(), clock.next_time())
                if not clock.now < time < self.until:
                    return False
                clock.advance(time)
            return False
        finally:
            self.passing = None

    def comes_to_rest(self, since: float, end_of_moves: Callable[[], float]) -> bool:
        """Let a wait for standstill of axes pass; False if the task must yield.

        The wait began at `since`. `end_of_moves` returns its end without a check, negative once the axes are
        at rest. The conditions are the same as in `passes`.
        """
        clock, until = self.clock, self.until
        if not self.by_itself or self._end:
            return False
        if clock.horizon <= since or clock.now != since:
            clock.advance(since)
        while clock.now < until and len(self.tasks) == 1 and not self.interrupts:
            end = end_of_moves()
            if end < 0.0:
                return True
            if not clock.now < end < until:
                return False
            if clock.advance_to_news(end):
                return True
        return False

    def _leave(self, task: Task, event: float, time: float, several: bool) -> None:
        """Advance to the time at which a task stopped.

        `event` was the next event when the task was resumed.
        """
        clock = self.clock
        advance = clock.advance if self.by_itself else self._advance
        advance(time)
        while clock.now < time:
            advance(time)
        slices = self._log.slices
        if several:
            slices.took(task.name, self.began, clock.now, task.wait is not None or task.done)
        elif not self._alone and len(self.tasks) > 1:
            slices.shared(clock.now)
        if self._end and not (event <= time < self._end and self._goes_on(task)):
            self._end = 0.0
        if task.done and task is not self.parent:
            self._forget(task)
        if several and len(self.tasks) == 1 and self.outside is None:
            slices.alone(clock.now)

    def reach(self) -> float:
        """Return until when the running task may run alone without acting; 0 if not alone.

        A statement that coincides with the end of another task's wait comes after it, as in `_next_due`.
        """
        if not self._alone or self.outside is not None:
            return 0.0
        return min(self.clock.next_time(), self._first_end() - 0.5 * ROUNDING, self.until)

    def _first_end(self) -> float:
        """Return when the first wait may end if the running tasks do nothing."""
        first, running = INFINITY, self.current
        for task in self.interrupts[-1:] or self.tasks:
            wait = task.wait
            if wait is not None:
                self.current = task
                due = wait.due() if wait.ends is None else wait.ends
                if due < first:
                    first = due
        self.current = running
        return first

    def waited(self, wait: Waited) -> None:
        """Write the record of a completed wait to the log."""
        log = self._log
        log.waits.add(wait)
        if log.slices.seconds:
            log.slices.close(self.clock.now)

    def _goes_on(self, task: Task) -> bool:
        """True if the event woke no other task, so the time slice continues."""
        if task.wait is not None or task.done or self.interrupts:
            return False
        for other in self._waiting:
            self.current = other
            if other.wait is not None and other.wait.ready():
                return False
        self.current = task
        return True

    def settle(self, until: float = INFINITY) -> bool:
        """Let the motion in progress end; False if `until` comes first or an axis jogs."""
        while not self.stopped:
            busy = self._controller.moving()
            times = [self._controller.idle_time(axis) for axis in busy]
            if not busy:
                settling = self._controller.settling()
                if not settling:
                    return True
                times = [self._controller.rest_time(axis) for axis in settling]
            finite = [time for time in times if time < INFINITY]
            if not finite or min(finite) > until:
                if until < INFINITY:
                    self._advance(until)
                return False
            time = min(finite)
            if time <= self.clock.now:  # rounding: the end is over, and its event a last bit later
                time = self.clock.next_time()
                if time > until or time == INFINITY:
                    if until < INFINITY:
                        self._advance(until)
                    return False
            self._advance(time)
        return False

    def _next_due(self, task: Task) -> float:
        """Return when the first wait of another task may end; no time slice outlasts it.

        The task is alone until then if all others wait.
        """
        waiting, now = self._waiting, self.clock.now
        waiting.clear()
        first = INFINITY
        for other in self.interrupts[-1:] if self.interrupts else self.tasks:
            wait = other.wait
            if wait is None:
                continue
            due = wait.ends
            if due is None:
                self.current = other
                if wait.ready():
                    continue
                due = wait.due()
            elif now >= due - ROUNDING:
                continue
            waiting.append(other)
            if due < first:
                first = due
        self.current = task
        self._alone = len(waiting) == (0 if self.interrupts else len(self.tasks) - 1)
        # If a statement coincides with it, rounding does not decide which comes first.
        return first - 0.5 * ROUNDING

    def _advance(self, time: float) -> None:
        if self.outside is not None:
            self.outside.advance(time)
            return
        if self.pace is not None:
            self.pace(time)
        self.clock.advance(time)

    def _forget(self, task: Task) -> None:
        """Drop a task that has ended, unless another one has already dropped it."""
        if task in self.interrupts:
            self.interrupts.remove(task)
        elif task in self.tasks:
            self.tasks.remove(task)
            self._log.slices.ended(task.name, self.clock.now)

    def _runnable(self) -> Task | None:
        """Return the next task that can run: highest priority, round robin."""
        tasks = self.interrupts[-1:] if self.interrupts else self.tasks
        count, now = len(tasks), self.clock.now
        start = self._next_index % count
        highest: int | None = None
        found: Task | None = None
        for k in range(start, start + count):
            task = tasks[k if k < count else k - count]
            if found is not None and task.priority <= found.priority:
                continue
            wait = task.wait
            if wait is not None:
                ends = wait.ends
                if ends is None:
                    self.current = task
                    if not wait.ready():
                        continue
                elif now < ends - ROUNDING:
                    continue
            found, index_after = task, (k + 1) % count
            if highest is None:
                highest = max(map(_PRIORITY_OF, tasks)) if count > 1 else task.priority
            if task.priority == highest:
                break
        if found is None:
            return None
        wait = found.wait
        if wait is not None:
            self.waited(found.waited(wait, now))
            found.wait = None
        self._next_index = index_after
        self.current = found
        return found

    def _jump(self, until: float) -> None:
        """Jump to the next time at which something can change, since all tasks wait, but not beyond `until`."""
        clock = self.clock
        due = min(clock.next_time(), self._first_end())
        time = due if due < until else until
        if due == INFINITY and (self.outside is None or not self.outside.may_act()):
            waiting = (self.interrupts or self.tasks)[-1 if self.interrupts else 0]
            assert waiting.wait is not None
            raise Stuck(waiting, waiting.wait)
        # A wait that could end now and does not (rounding of its time) is checked again slightly later, never
        # for ever.
        self._stalls = self._stalls + 1 if time <= clock.now else 0
        late = 1e-9 * 2.0 ** min(self._stalls - STALLS, 30) if self._stalls > STALLS else 0.0
        if late or time <= clock.now or not self.by_itself:
            self._advance(min(max(time, clock.now + late), max(until, clock.now)))
        else:
            clock.advance(time)
