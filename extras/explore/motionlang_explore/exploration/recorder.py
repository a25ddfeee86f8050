"""A record of what the tasks of a run do: statements, readings, comparisons, what the program remembers."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from math import inf
from typing import Any, NamedTuple

from motionlang.kernel import Hook, Machine, Scheduler, Steps, Task
from motionlang.kernel.lang import Snapshot, Values, conditions
from motionlang.kernel.traced import form_of
from motionlang_explore.exploration.changes import Channel

# A trial ends after so many statements, or if none of so many is the first at its place and none starts a move. A run
# that is not recorded ends if this holds for the larger number.
MAX_STATEMENTS, MAX_REPEATED = 60_000, 20_000
# Every run ends earlier if it prints lines, or starts moves, again and again: so many of them in a time, s.
MAX_PRINTED, MAX_STARTED, FLOOD = 500, 200, 0.5
# The work of a round of the tasks and of a reading, in statements.
ROUND, READING = 6, 2
# So often the user's time is looked at, in statements.
CHECKED = 500
# Readings of a statement that are no further apart are one span, s.
SAME_SPAN = 1.0
# Where the name of a task would be, in a record of what handlers do.
HANDLERS = "!"


class Begun(NamedTuple):
    """A statement that began: its time, its source offset, and the offsets of the calls that led there."""

    time: float
    at: int
    callers: tuple[int, ...]


class ReadSpan(NamedTuple):
    """When a statement read a channel again and again: the times of the first and of the last reading, s.

    No move began meanwhile; `moves` were made before.
    """

    first: float
    last: float
    moves: int


# A comparison: the source offset of its statement, and its number among those of the statement, from 1 on.
Comparison = tuple[int, int]
# The source offset of a statement that began, or a comparison with 1 if the left side was the larger one, 0 or -1.
Seen = int | tuple[int, int, int]
# How a condition came out: the source offset of its statement, its number there, and whether it was true.
Outcome = tuple[int, int, bool]
# The channels that statements have read, as table and number, with the spans in which they did so.
Readings = Mapping[int, Mapping[Channel, Sequence[ReadSpan]]]


class TrialRecorder(Hook):
    """A record of the tasks of a run from a time on: their statements, what they read and compare, the memory.

    `remembered` are the numbers of the variables whose values are recorded. What is no reading of the program is
    left out: `written` are the channels that a statement only writes, by its source offset, since a write reads the old
    value, too.
    """

    def __init__(
        self,
        remembered: Sequence[int],
        written: Mapping[int, Collection[Channel]],
        since: float,
        snapshot_at: float = inf,
        is_cut: Callable[[], bool] = lambda: False,
    ) -> None:
        super().__init__(lambda task, time, offset: None, between=self._between)
        self._remembered, self._written = remembered, written
        self._machine: Machine | None = None
        # True once the user's time is up, which also ends a run.
        self._is_cut = is_cut
        self.restart(since, snapshot_at)

    def restart(self, since: float, snapshot_at: float) -> None:
        """Begin an empty record of a run that is at its first statement."""
        # The statements that began before the snapshot, and how conditions came out in all that was played.
        self.before: set[int] = set()
        self.outcomes: set[Outcome] = set()
        # The statement that has begun last in each task.
        self._at: dict[str, int] = {}
        self.begin(since, snapshot_at)

    def begin(self, since: float, snapshot_at: float) -> None:
        """Begin an empty record from a time on, s, and take a snapshot at another one."""
        self.since, self._snapshot_at = since, snapshot_at
        # Until the last change of the world nothing that repeats is idle, s.
        self.last_change = since
        # The state of the run at `snapshot_at`, and the statements that had begun last.
        self.snapshot: tuple[Snapshot, dict[str, int]] | None = None
        self._clear()
        self._remember_now()

    def _clear(self) -> None:
        self.count = self._rounds = self._read = 0
        # True if so many statements were nothing new.
        self.is_idle = False
        self.statements: dict[str, list[Begun]] = defaultdict(list)
        # Left and right side of each comparison, in order.
        self.comparisons: dict[Comparison, list[tuple[object, object]]] = defaultdict(list)
        # The channels on which the comparisons and truths of statements depend.
        self.decided: dict[int, set[Channel]] = defaultdict(set)
        self.readings: dict[int, dict[Channel, list[ReadSpan]]] = defaultdict(lambda: defaultdict(list))
        # The values of the remembered variables, each time that one of them has changed.
        self.memory: list[tuple[float, tuple[object, ...]]] = []
        self.seen: set[Seen] = set()
        # The tasks in which each statement has begun.
        self.tasks: dict[int, set[str]] = defaultdict(set)
        # The number of comparisons of the present statement at a time: a wait compares again and again.
        self._comparisons, self._compared = 0, (-1, -inf)
        self._is_recorded = False
        # The places since `since`, the moves so far, and the number of the last statement with something new.
        self._places: set[int] = set()
        self._moves = self._news = 0
        # The numbers of moves and of lines at which the time is looked at next, and when it was last, s.
        self._started, self._started_at = 0, -inf
        self._printed, self._printed_at = 0, -inf
        # The calls of the last statement of each task: how many, the innermost one, and their offsets.
        self._callers: dict[str, tuple[int, object, tuple[int, ...]]] = {}

    def written(self, steps: Steps) -> None:
        """Let the conditions among some steps record how they come out; for a run that it observes."""
        for pc, number in conditions(steps):
            step = steps[pc]
            assert step.do is not None
            steps[pc] = step._replace(do=self._recorded(step.do, step.at, number))

    def _recorded(self, test: Callable[[Values], Any], at: int, number: int) -> Callable[[Values], Any]:
        def decide(values: Values) -> Any:
            holds = test(values)
            self.outcomes.add((at, number, bool(holds)))
            return holds

        return decide

    def skipped(self, first: object, end: object, times: int) -> None:
        """Iterations that are skipped bring nothing new."""

    def failed(self, task: object) -> None:
        """A statement that fails has begun."""

    def attach(self, machine: Machine) -> None:
        """Watch a run that is about to begin on a machine."""
        self._machine = machine
        machine.controller.reads.add(self._reads)
        if self.since < inf:  # comparisons are recorded
            machine.controller.reads.trace()
        self.expect_changes()

    def expect_changes(self) -> None:
        """Let no wait before the changes be hopeless."""
        if self._snapshot_at < inf and self._machine is not None:
            self._machine.clock.at(self.since, _nothing)

    @property
    def work(self) -> int:
        """The statements, and what rounds of the tasks and readings cost more."""
        return self.count + ROUND * self._rounds + READING * self._read

    def _between(self) -> None:
        self._rounds += 1
        assert self._machine is not None
        if self.snapshot is None and self._machine.clock.now >= self._snapshot_at:
            self.snapshot = Snapshot(self._machine.scheduler), dict(self._at)
            self.before.update(each for each in self.seen if isinstance(each, int))

    def go_back(self) -> bool:
        """Put the snapshot back and begin another record; False if the program ended before."""
        if self.snapshot is None:
            return False
        snapshot, self._at = self.snapshot[0], dict(self.snapshot[1])
        snapshot.restore()
        self._clear()
        self._remember_now()
        return True

    def _reads(self, table: str, number: int) -> None:
        """Record a reading, as part of a span in which the same statement reads the channel again and again."""
        assert self._machine is not None
        if self._machine.controller.inputs.is_supposed:
            return  # a hint asks what would end a wait
        self._read += 1
        number = 0 if table == "key" else number  # of any terminal
        at, now = self._place(), self._machine.clock.now
        if at < 0 or (table, number) in self._written.get(at, ()):
            return
        spans, moves = self.readings[at][table, number], self._machine.moves_made
        if spans and now - spans[-1].last <= SAME_SPAN and spans[-1].moves == moves:
            spans[-1] = ReadSpan(spans[-1].first, now, moves)
        else:
            spans.append(ReadSpan(now, now, moves))

    def _place(self) -> int:
        """Return the statement that runs, or that of the wait whose condition is checked."""
        assert self._machine is not None
        scheduler = self._machine.scheduler
        if scheduler is None:
            return -1
        if scheduler.current.wait is not None:
            return scheduler.current.at
        return self._at.get(_name(scheduler, scheduler.current), -1)

    def begins(self, task: Task, time: float, offset: int) -> bool:
        """Record a statement, and end the run if it only repeats."""
        self.count += 1
        assert self._machine is not None
        scheduler, log = self._machine.scheduler, self._machine.log
        assert scheduler is not None
        name = _name(scheduler, task)
        self._at[name], self._is_recorded, self._comparisons = offset, time >= self.since, 0
        moves, prints = log.moves.past, log.prints.past
        is_checked = moves >= self._started or prints >= self._printed
        if (not self.count % CHECKED and self._is_cut()) or (
            is_checked and self._floods(time, moves, prints)
        ):
            scheduler.until = time
            return True
        if not self._is_recorded:
            is_new = offset not in self.seen or moves != self._moves
            self.seen.add(offset)
            self.tasks[offset].add(name)
            self._moves = moves
            if is_new or self.since < inf:
                self._news = self.count
            if self.count - self._news < MAX_STATEMENTS:
                return False
            scheduler.until = time
            return True
        self.statements[name].append(Begun(time, offset, self._callers_of(task)))
        self._remember(scheduler.parent, time)
        is_new = offset not in self._places or moves != self._moves
        if is_new or time < self.last_change:
            self._places.add(offset)
            self.seen.add(offset)
            self._moves, self._news = moves, self.count
        self.is_idle = self.count - self._news >= MAX_REPEATED
        if self.count < MAX_STATEMENTS and not self.is_idle:
            return False
        scheduler.until = time
        return True

    def _floods(self, time: float, moves: int, prints: int) -> bool:
        """True if the program prints line after line, or starts moves without time to carry them out."""
        is_soon = False
        if moves >= self._started:
            is_soon = time - self._started_at < FLOOD
            self._started, self._started_at = moves + MAX_STARTED, time
        if prints >= self._printed:
            is_soon = self.is_idle = is_soon or time - self._printed_at < FLOOD
            self._printed, self._printed_at = prints + MAX_PRINTED, time
        return is_soon

    def _remember_now(self) -> None:
        scheduler = None if self._machine is None else self._machine.scheduler
        if scheduler is not None:
            self._remember(scheduler.parent, self.since)

    def _remember(self, parent: Any, time: float) -> None:
        shared, own = parent.loops_of_all.world.shared, parent.own  # tasks of a program run on steps
        values = tuple([shared[n] if n >= 0 else own[-1 - n] for n in self._remembered])
        if not self.memory or self.memory[-1][1] != values:
            self.memory.append((time, values))

    def _callers_of(self, task: Task) -> tuple[int, ...]:
        """Return the calls that lead to the present statement, worked out once for each call."""
        calls = task.calls  # type: ignore[attr-defined]  # tasks of a program run on steps
        if not calls:
            return ()
        depth, innermost, callers = self._callers.get(task.name, (0, None, ()))
        if depth != len(calls) or innermost is not calls[-1]:
            callers = task.stack[:-1]
            self._callers[task.name] = len(calls), calls[-1], callers
        return callers

    def compared(self, left: object, right: object) -> None:
        assert self._machine is not None
        if self._machine.controller.inputs.is_supposed:
            return  # a hint asks what would end a wait
        self._read += 1
        at, now = self._place(), self._machine.clock.now
        if (at, now) != self._compared:
            self._comparisons, self._compared = 0, (at, now)
        if self._is_recorded or now >= self.since:  # a wait compares after it has begun
            self._comparisons += 1
            self.comparisons[at, self._comparisons].append((left, right))
            self._decides(at, left)
            self._decides(at, right)
            if isinstance(left, (int, float)) and isinstance(right, (int, float)):
                self.seen.add((at, self._comparisons, (left > right) - (left < right)))

    def tested(self, number: object) -> None:
        assert self._machine is not None
        if not self._machine.controller.inputs.is_supposed:  # no hint asks what would end a wait
            self._decides(self._place(), number)

    def _decides(self, at: int, number: object) -> None:
        for table, channel, _ in form_of(number):
            self.decided[at].add((table, channel))


def _name(scheduler: Scheduler, task: Task) -> str:
    """Return the name of a task; handlers have one for all."""
    return HANDLERS if scheduler.interrupts and task in scheduler.interrupts else task.name


def _nothing() -> None:
    """Do nothing; an event at which something may change."""
