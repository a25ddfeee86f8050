"""The scheduler: from event to event until the program has ended and every axis is at rest.

Nothing here ticks. While a task is runnable it is resumed with a horizon, the time of the next event; while all wait,
the clock jumps to the earliest time at which something can change. When nothing can ever change again, the run says
so and ends.
"""

from __future__ import annotations

from motionlang.lang.task import ROUNDING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Protocol

    from motionlang.controller.controller import Controller
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.recurrence import Recurrence
    from motionlang.lang.task import Task, Wait

    class Outside(Protocol):
        """A world that acts by itself."""

        def start(self, machine: Machine) -> None:
            """The program is about to start on `machine`."""

        def may_act(self) -> bool:
            """Whether a wait that nothing else can end may yet be ended from outside."""

        def advance(self, time: float) -> None:
            """Advance the machine's clock to `time`, or less far where something has come from outside."""


INFINITY = float("inf")
# Virtual seconds that one task may run while another is runnable.
QUANTUM = 1e-3
# How often a wait may be asked at one moment before time goes on without it.
STALLS = 4


class Stuck(Exception):
    """Every task waits, and nothing can end any of the waits."""

    def __init__(self, task: Task, wait: Wait) -> None:
        self.task, self.wait = task, wait
        super().__init__(f"waits {wait.why}, which can no longer happen")


class Scheduler:
    """Runs tasks on a machine, or on a bare controller; when the first one, the parent, ends, the program has ended.

    `pace(now)` is called before time jumps, so that a run can be held to the wall clock. With `outside` there is a
    world that acts by itself, such as a host: it says how far time passes, and no wait is without hope.
    """

    def __init__(
        self,
        machine: Controller | Machine,
        parent: Task,
        pace: Callable[[float], None] | None = None,
        outside: Outside | None = None,
    ) -> None:
        self.machine = machine
        self.clock = machine.clock
        self.parent = parent
        self.tasks: list[Task] = [parent]
        # Event handlers, the innermost last: while there is one, nothing else runs.
        self.interrupts: list[Task] = []
        self.current: Task = parent
        self.pace = pace
        self.outside = outside
        # Whether the clock goes on with nobody but the tasks being asked.
        self.by_itself = pace is None and outside is None
        # When the program had ended, while motion goes on.
        self.ended: float | None = None
        # When the running task was resumed, when its turn began, whether no other could have had it, and when it ends;
        # an event cuts a turn in two, and does not end it.
        self.began = self.turn_began = 0.0
        self._alone = False
        self._end = 0.0
        # The others that wait, for what has not come about yet.
        self._waiting: list[Task] = []
        # How many turns in a row have brought nothing about.
        self._calm = 0
        self.until = INFINITY
        self._recurrence: Recurrence | None = None
        self._turn = 0
        self._stalls = 0
        self._log = machine.log
        self._log.where = self._where
        # How long each task has had the machine since the last of them began or ended a wait, and when that was.
        self._took: dict[str, float] = {}
        self._turns_began = 0.0
        # The length of the turns of a round, and how many of them are still to come.
        self._length, self._left = QUANTUM, 0

    def _where(self) -> int:
        """Where the program stands, for the log."""
        return self.current.at

    def start(self, task: Task) -> None:
        """Let a further task run from now on."""
        self.tasks.append(task)

    def interrupt(self, task: Task) -> None:
        """Let a task run to its end before any other goes on."""
        self._log.note(self.clock.now, "handler", text=task.name)
        self.interrupts.append(task)

    def run(self, until: float = INFINITY) -> str:
        """Run until the program has ended ("ended") or virtual time is up ("until"), then let motion finish.

        Raises `Stuck` when the parent waits for what can never happen, and whatever a task raises.
        """
        if not self.run_program(until):
            return "until"
        self.ended = self.clock.now
        return "ended" if self.settle(until) else "until"

    def run_program(self, until: float = INFINITY) -> bool:
        """Run tasks until the parent ends; False when `until` came first."""
        clock = self.clock
        self.until, self._end = until, 0.0
        while not self.parent.done:
            if clock.now >= until:
                return False
            task = self.current if self._end else self._runnable()
            if task is None:
                self._jump(until)
                continue
            horizon = min(clock.next_time(), until)
            several = len(self.tasks) > 1 or self.outside is not None
            event, self.began = horizon, clock.now
            if not self._end:
                self.turn_began = clock.now
            if several:
                if not self._end:
                    # Less than whole, as a number of statements may fill it exactly.
                    self._end = clock.now + min(self._turn_length(horizon) - ROUNDING, task.turn)
                horizon = min(horizon, self._end, self._next_due(task))
            time, task.wait = task.resume(self.began, horizon)
            self._advance(time)
            while clock.now < time:
                self._advance(time)
            if several:
                self._took_turn(task, self.began)
            if self._end and not (event <= time < self._end and self._goes_on(task)):
                self._end = 0.0
                self._compare(task)
            if task.done and task is not self.parent:
                self._forget(task)
        return True

    def passes(self, wait: Wait) -> bool:
        """Let the time of a wait pass under the task that runs, as it would pass while it gave way; false: it must.

        So it is where there is one task, nobody holds the clock, nothing else begins meanwhile, and an end is in sight.
        """
        clock = self.clock
        if not self.by_itself or self._end:
            return False
        clock.advance(wait.since)
        while clock.now < self.until and len(self.tasks) == 1 and not self.interrupts:
            if wait.ready():
                return True
            time = min(wait.due(), clock.next_time())
            if not clock.now < time < self.until:
                return False
            clock.advance(time)
        return False

    def reach(self) -> float:
        """Until when the running task has the machine for itself, if it does nothing; 0 where others can run, too."""
        return min(self.next_change(), self.until) if self._alone and self.outside is None else 0.0

    def next_change(self) -> float:
        """When something will happen, or a task that waits may go on, if those that run do nothing."""
        tasks = self.interrupts[-1:] or self.tasks
        due = min((task.wait.due() for task in tasks if task.wait is not None), default=INFINITY)
        return min(self.clock.next_time(), due)

    def _waited(self, task: Task, wait: Wait) -> None:
        """Write a wait that is over into the log."""
        why = "" if wait.cause == "time" else wait.why
        *callers, at = task.stack
        row = task.name, at, wait.since, self.clock.now, wait.cause, wait.what, why, tuple(callers)
        self._log.waits.add(row)
        if self._took:
            self._write_turns()

    def _took_turn(self, task: Task, began: float) -> None:
        """Note how long a task has had the machine; those that take turns without a wait are one record."""
        if not self._took:
            self._turns_began = began
        self._took[task.name] = self._took.get(task.name, 0.0) + self.clock.now - began
        if task.wait is not None or task.done:
            self._write_turns()

    def _write_turns(self) -> None:
        """Write what tasks have had the machine into the log."""
        took, self._took = self._took, {}
        self._log.turns.add((self._turns_began, self.clock.now, tuple(took), tuple(took.values())))

    def _goes_on(self, task: Task) -> bool:
        """Whether what has cut the turn of a task was nothing to anybody else: then it goes on with it."""
        if task.wait is not None or task.done or self.interrupts:
            return False
        for other in self._waiting:
            self.current = other
            if other.wait is not None and other.wait.ready():
                return False
        self.current = task
        return True

    def _compare(self, task: Task) -> None:
        """Where nobody does more than poll and wait, and all stand as they did before: go on to what may change it."""
        now, began = self.clock.now, self.turn_began
        task.into = now - task.looked if task.looked >= began else task.into + now - began
        if task.look is None or task.done or self.interrupts or self.outside is not None:
            self._calm = 0
            return
        self._calm += 1
        if self._calm < len(self.tasks):
            return  # not everybody has looked in vain yet
        if self._recurrence is None:
            from motionlang.lang.recurrence import Recurrence

            self._recurrence = Recurrence(self.machine)
        self._recurrence.leap(self.tasks, self._turn, self.until, self.pace)

    def settle(self, until: float = INFINITY) -> bool:
        """Let the motion that is under way end; False when `until` comes first or an axis jogs for ever."""
        while True:
            busy = self.machine.moving()
            times = [self.machine.idle_time(axis) for axis in busy]
            if not busy:
                settling = self.machine.settling()
                if not settling:
                    return True
                times = [self.machine.rest_time(axis) for axis in settling]
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

    def _turn_length(self, horizon: float) -> float:
        """How long a task runs while others can: many turns at once where nobody could tell the difference.

        That is so while every task that can run is busy with what is its own, and nothing is due before the round ends.
        """
        busy = self.current.busy
        if self._left and busy >= self._length:
            self._left -= 1
            return self._length
        self._left = 0
        if busy < 2 * QUANTUM:
            return QUANTUM
        tasks = self.interrupts[-1:] or self.tasks
        running = [task for task in tasks if task.wait is None]
        busy = min(task.busy for task in running)
        if busy < 2 * QUANTUM or self.outside is not None:
            return QUANTUM
        waits = [task.wait.due() for task in tasks if task.wait is not None]
        free = min(horizon, *waits) - self.clock.now if waits else horizon - self.clock.now
        turns = int(min(free / len(running), busy, 1e6) / QUANTUM)
        if turns < 2:
            return QUANTUM
        self._length, self._left = turns * QUANTUM, len(running) - 1
        return self._length

    def _next_due(self, task: Task) -> float:
        """When the first of the others that still wait may go on: a turn does not outlast it, so nobody oversleeps."""
        self._waiting.clear()
        first = INFINITY
        for other in self.interrupts[-1:] or self.tasks:
            self.current = other
            if other.wait is not None and not other.wait.ready():
                self._waiting.append(other)
                first = min(first, other.wait.due())
        self.current = task
        return (
            first - 0.5 * ROUNDING
        )  # where a statement meets it, rounding does not decide which comes first

    def _advance(self, time: float) -> None:
        if self.outside is not None:
            self.outside.advance(time)
            return
        if self.pace is not None:
            self.pace(time)
        self.clock.advance(time)

    def _forget(self, task: Task) -> None:
        """Drop a task that has ended; another one may have dropped it before."""
        for tasks in (self.interrupts, self.tasks):
            if task in tasks:
                tasks.remove(task)

    def _runnable(self) -> Task | None:
        """The next task that does not wait or whose wait is over: of the highest priority, in turn."""
        tasks = self.interrupts[-1:] or self.tasks
        count = len(tasks)
        highest = tasks[0].priority
        for task in tasks:
            if task.priority > highest:
                highest = task.priority
        found: Task | None = None
        self._alone = False
        for k in range(count):
            task = tasks[(self._turn + k) % count]
            if found is not None and task.priority <= found.priority:
                continue
            if task.wait is not None:
                self.current = task
                if not task.wait.ready():
                    continue
            self._alone = found is None and k == count - 1
            found, turn = task, (self._turn + k + 1) % count
            if task.priority == highest:
                break
        if found is not None:
            if found.wait is not None:
                self._waited(found, found.wait)
                found.wait = None
            self._turn = turn
            self.current = found
        return found

    def _jump(self, until: float) -> None:
        """All wait: go to the next moment at which something can change."""
        clock = self.clock
        tasks = self.interrupts[-1:] or self.tasks
        due = min((task.wait.due() for task in tasks if task.wait is not None), default=INFINITY)
        time = min(due, clock.next_time(), until)
        hopeless = self.outside is None or not self.outside.may_act()
        if hopeless and (time == INFINITY or (time == until and min(due, clock.next_time()) == INFINITY)):
            waiting = tasks[0]
            assert waiting.wait is not None
            raise Stuck(waiting, waiting.wait)
        # A wait that could end now and does not (rounding of its time) is asked again a little later, never for ever.
        self._stalls = self._stalls + 1 if time <= clock.now else 0
        late = 1e-9 * 2.0 ** min(self._stalls - STALLS, 30) if self._stalls > STALLS else 0.0
        self._advance(min(max(time, clock.now + late), max(until, clock.now)))
