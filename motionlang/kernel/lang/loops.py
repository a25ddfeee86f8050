"""One rule for loops, for both languages, and for one task or many.

An iteration that changes nothing, or changes each number by the same amount as the one before, repeats: until the next
event, until a reading passes the value it is compared with, or until a comparison of numbers turns. All whole
iterations up to that moment are counted at once.

    While POS(0) < 50 : End While                nothing changes until POS(0) is 50
    While n < 1000000 : n = n + 1 : End While    n grows by 1, and n - 1000000 turns its sign once

Every jump back comes here with the state of all tasks, which is plain data, so the rule compares states:

    place     for each task: its next step, the calls that it is in, and what is left of its wait; and the number of
              actions whose effects cannot be compared
    numbers   the contents of all variables
    margins   left side minus right side of each comparison of numbers since the state before

Two states with the same place and numbers are equal but for the time, whatever happens in between. With the same place
and a constant difference of numbers and margins they are equal as far as the differences matter, provided that the
numbers that change are only added, subtracted and compared, and that sums are exact, so that n additions are one
multiplication. A state is compared with the last one at its place and with the one before that, so a loop may toggle.
If several tasks run, the iterations of one are a period of all when the places of the others are the same again.

Which variables matter is a static fact, worked out for a loop from the `Uses` of its steps (`variable_uses.py`). A
variable that every iteration sets before it reads it is not compared. Its value after the loop is that of the last
iteration, so one iteration less is skipped, and that one is carried out. A fact about a loop holds only while its task
stays in it.

A reading that changes by itself is in `Dependencies`, which solves when it passes the level it is compared with.

Back-off: after a failed check the next 1, 2, 4, … jumps back of the task are not checked.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import ceil
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.change_times import CLOSE, MAX_NOTES, Dependencies, Note
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.statement_time import UNITS, StatementTime, units
from motionlang.kernel.lang.steps import Steps, own
from motionlang.kernel.lang.variable_uses import NONE, UNKNOWN, Copy, IterationUses, Span, body_of
from motionlang.kernel.lang.waits import ROUNDING, Delay, Wait

if TYPE_CHECKING:
    from motionlang.kernel.lang.step_task import StepTask


class SharedState(Protocol):
    """The state that the tasks of a program share."""

    dependencies: Dependencies
    # True if tasks take turns by the end of time slices.
    has_slices: bool

    @property
    def tasks(self) -> Sequence[StepTask]:
        """All tasks, those that wait included."""

    @property
    def shared(self) -> list[Any]:
        """The variables of all tasks."""

    @property
    def switched(self) -> int:
        """How often outputs have been switched that nothing on the machine hears."""

    def levels(self) -> Sequence[object]:
        """Return the levels of these outputs, which are part of the state."""

    def changes(self) -> tuple[int, int]:
        """Return counters of the actions whose effects cannot be compared, and of events."""

    def acted(self) -> object:
        """Return counters of all that a loop could wait for."""

    def stands_still(self) -> Wait | None:
        """Return the wait of a loop that repeats until something else acts; None if it runs on."""

    def period(self, delays: list[tuple[float, float]]) -> int:
        """Return how long some waits take together, in units of time; 0 if their sums round."""

    def end_of_wait(self, base: float, count: float, seconds: float) -> float:
        """Return when a wait ends that began at statement `count` from `base`."""


MAX_BACK_OFF = 4096
# So many states in a row may be equal and nothing skipped: a value changes in one iteration, and the next one acts.
FREE_FAILURES = 2
# More states of a task without an action are dropped.
MAX_STATES = 2000
# Numbers that are whole multiples of this, and smaller than `LARGEST`, add up without rounding.
GRAIN = 2.0**-20
LARGEST = 2.0**31
# A period with more switches of outputs is not skipped, nor one of more iterations in which they differ.
MAX_ROWS, MAX_TOGGLED = 64, 8
# An iteration with more waits for a time is not skipped.
MAX_DELAYS = 100
# Variables that move with a clock are relied upon for so long, s, and no clock reaches so many milliseconds.
MAX_SPAN, FAR = 3600.0, 2.0**62


class Mark(NamedTuple):
    """A list of records, and its length at some moment."""

    records: list[Any]
    length: int

    def since(self, records: list[Any]) -> list[Any] | None:
        """Return the records since then; None if another list has been begun."""
        return records[self.length :] if records is self.records else None


NO_RECORDS = Mark([], 0)


@dataclass(slots=True, eq=False)
class LoopState:
    """All tasks at a jump back of one of them, at statement `t` from `base`."""

    t: float
    base: float
    numbers: list[Any]
    # The wait of each other task, and what is left of it, in units of time, if its end is known.
    waits: list[Wait | None]
    left: list[int]
    # What the loop of the running task does, and how often that task has changed its loop, and tasks have taken turns.
    body: IterationUses
    strayed: int
    turns: int
    # Counters of all that has been done so far, and of the outputs that have been switched.
    acted: object
    switched: int
    # What had been recorded: readings of each task, margins, waits for a time, and the log of several tasks.
    read: list[tuple[StepTask, Mark]] = field(default_factory=list)
    margins: Mark = NO_RECORDS
    delays: Mark = NO_RECORDS
    logged: Any = None
    lengths: list[int] = field(default_factory=list)
    # How much the observer of the run had counted, and how often what ends the run had occurred.
    seen: Any = None
    occurred: int = 0
    # The last state at the same place, and by how much numbers and margins differ from it; None if not known.
    before: LoopState | None = None
    change: list[float] | None = None
    # The variables that are set before they are read since the state that it was compared with last.
    overwritten: frozenset[int] = NONE


class Loops:
    """Watches the jumps back of the tasks of a program, and skips iterations that repeat."""

    def __init__(self, machine: Machine, time: StatementTime, world: SharedState) -> None:
        self.machine, self.time, self.world = machine, time, world
        # The tasks as of the last check, the running one, and how often another one than the last has run.
        self._tasks: Sequence[StepTask] = ()
        self.task: StepTask | None = None
        self.turns = 0
        # The switches of outputs before the last state.
        self._switched = 0
        # True until the first jump back of the running task since it went on.
        self._is_first = True
        self._margins: list[float] = []
        # The waits for a time: at which statement each began, and its length.
        self._delays: list[tuple[float, float]] = []

    # ------------------------------------------------------------------------------------------ for the tasks

    def run(self, task: StepTask) -> None:
        """Record that a task goes on."""
        self.world.dependencies.notes = task.notes
        self._is_first = True
        if task is not self.task:
            self.task = task
            self.turns += 1

    def give_way(self, task: StepTask) -> None:
        """Record that a task has stopped."""
        task.notes = self.world.dependencies.notes

    def compared(self, margin: float) -> None:
        """Record a comparison of numbers."""
        if len(self._margins) > MAX_NOTES:
            self._margins = []
        self._margins.append(margin)

    def waits(self, seconds: float) -> None:
        """Record that the running task begins to wait for a time."""
        if len(self._delays) > MAX_DELAYS:
            self._delays = []
        self._delays.append((self.time.count, seconds))

    def back(self, task: StepTask, here: int, t: float, is_inside: bool = True) -> tuple[float, Wait | None]:
        """Return the statement after all iterations that repeat, for a jump back from step `here`.

        There is a wait, too, if the loop repeats until another task or the world acts. The jump is not inside one list
        of steps if it enters another one without return.
        """
        self._follow(task, here, is_inside)
        if task.unchecked:
            task.unchecked -= 1
            return t, None
        self._tasks = self.world.tasks
        if self._depends_on_turns(task):
            if not self._is_first:
                return t, None  # one state for each time slice is enough
            self._is_first = False
        self._find_futile(task, here, t)
        scheduler = self.machine.scheduler
        if scheduler is not None and scheduler.gives_up and task.is_endless:
            scheduler.give_up()
        return self._check(task, here, t)

    def _follow(self, task: StepTask, here: int, is_inside: bool) -> None:
        """Log the jump, and note if it is that of another loop than the last one."""
        log = task.loop_log
        if is_inside and (here != log.end or task.pc != log.target):
            log.back(here, task.pc)
        steps, first, last = task.last_loop
        if not is_inside or steps is not task.steps or first != task.pc or last != here:
            task.strayed += 1
            task.last_loop = task.steps, task.pc, here if is_inside else -1

    def _check(self, task: StepTask, here: int, t: float) -> tuple[float, Wait | None]:
        """Compare the present state with the last one at its place, and skip what repeats."""
        changes = self.world.changes()
        if changes != task.met_after:
            has_acted = bool(task.met) and changes[0] != task.met_after[0]
            task.met, task.met_after = {}, changes
            if has_acted:
                return self._failed(task, t)
        place, now = self._place(task, here), self._state(task, here, t)
        if not task.met:
            self._begin()
        last = task.met.get(place)
        wait = None
        if last is not None:
            t, wait, repeats = self._repeated(task, now, last)
            if t != now.t or self.time.base != now.base or wait is not None:
                task.failures = task.back_off = 0
            elif not repeats or task.failures >= FREE_FAILURES:
                return self._failed(task, t)
            elif last.before is not None:
                task.failures += 1
        elif len(task.met) > self._most_places(task, now):
            return self._failed(task, t)
        now.t, now.base, now.before = t, self.time.base, last
        if last is not None:
            last.before = None
        if wait is None:
            self._mark(now)
            task.met[place] = now
        else:
            task.met = {}
        return t, wait

    def _most_places(self, task: StepTask, now: LoopState) -> int:
        """Return at how many places a task may have been; one that runs alone may toggle outputs."""
        others = [each.wait for each in self._tasks if each is not task]
        if None in others or self._depends_on_turns(task):
            return MAX_STATES
        return MAX_TOGGLED if now.switched else 0

    def _depends_on_turns(self, task: StepTask) -> bool:
        """True if it matters when the time slice ends: another task can run then, or may by what this one sets."""
        others = [each.wait for each in self._tasks if each is not task]
        return self.world.has_slices and any(wait is None or not wait.ignores_data for wait in others)

    def _find_futile(self, task: StepTask, here: int, t: float) -> None:
        """Find out if an iteration of a task was like the one before, and only others can change that."""
        dependencies, acted = self.world.dependencies, self.world.acted()
        now = acted, here, id(task.steps), task.pc, task.context(), list(task.own)
        notes, first, began = task.since
        shared = list(self.world.shared)
        stays = shared == task.seen_shared
        if (
            now == task.last_own
            and notes is not None
            and notes is dependencies.notes
            and (task.futile_after != acted or (stays and task.endless_with != shared))
            and dependencies.until(began - CLOSE, notes[first:]) == INFINITY
        ):
            asking = self.machine.controller.asking
            if asking is not None:
                asking.repeats(began, self.time.at(t))
            self._is_futile(task, stays)
        task.last_own, task.seen_shared = now, shared
        task.since = dependencies.notes, len(dependencies.notes or ()), self.time.at(t)

    def _is_futile(self, task: StepTask, stays: bool) -> None:
        """Record that only others can change the loop of a task; `stays` is True if it changes no variable of them."""
        acted = self.world.acted()
        if task.futile_after != acted:
            task.futile_since, task.futile_after = self.machine.clock.now, acted
        if stays:
            task.endless_with = list(self.world.shared)

    # ------------------------------------------------------------------------------------------------ states

    def _place(self, task: StepTask, here: int) -> tuple[object, ...]:
        tasks = self._tasks
        turn = self._turn_of_tasks() if self._depends_on_turns(task) else ()
        return (
            here,
            turn,
            self.world.levels(),
            *[(id(each.steps), each.pc, each.is_paid, each.context(), _kind(each.wait)) for each in tasks],
        )

    def _turn_of_tasks(self) -> tuple[int, ...]:
        """Return whose turn it is next, and what is left of the time slice, in units of time."""
        scheduler = self.machine.scheduler
        assert scheduler is not None
        following, end = scheduler.turn
        return following, round((end - self.time.at(self.time.count)) * UNITS)

    def _state(self, task: StepTask, here: int, t: float) -> LoopState:
        tasks = self._tasks
        numbers = [number for each in tasks for number in each.own] + self.world.shared
        elapsed = units(self.time.base) + int(t) * self.time.cost_units
        waits = [None if each is task else each.wait for each in tasks]
        left = [units(wait.ends) - elapsed if isinstance(wait, Delay) else 0 for wait in waits]
        body = _body(task.last_loop)
        acted = self.world.acted()
        switched = self.world.switched
        now = LoopState(
            t, self.time.base, numbers, waits, left, body, task.strayed, self.turns, acted, switched
        )
        if self.machine.observer is not None:
            now.seen = self.machine.observer.seen
        if self.machine.stop is not None:
            now.occurred = self.machine.stop.counts.total()
        return now

    def _begin(self) -> None:
        """Begin to record what tasks read; a list that has a gap is never continued."""
        dependencies = self.world.dependencies
        if self.task is not None:
            self.task.notes = dependencies.notes
        for each in self._tasks:
            if each.notes is None:
                each.notes = []
        if self.task is not None:
            dependencies.notes = self.task.notes

    def _mark(self, now: LoopState) -> None:
        dependencies = self.world.dependencies
        if self.task is not None:
            if dependencies.notes is None:
                dependencies.notes = []
            self.task.notes = dependencies.notes
            self.task.since = dependencies.notes, len(dependencies.notes), self.time.at(now.t)
        for each in self._tasks:
            if each.notes is None:
                each.notes = []
            now.read.append((each, Mark(each.notes, len(each.notes))))
        now.margins = Mark(self._margins, len(self._margins))
        now.delays = Mark(self._delays, len(self._delays))
        if now.switched != self._switched:
            self._switched, now.lengths = now.switched, [each.past for each in self.machine.log.streams()]
        scheduler = self.machine.scheduler
        if self.task is not None and scheduler is not None and len(scheduler.tasks) > 1:
            self.machine.log.slices.so_far(self.task.name, scheduler.began, self.time.at(now.t))
            now.logged = self.machine.log.mark_period()

    def _failed(self, task: StepTask, t: float) -> tuple[float, Wait | None]:
        task.met, task.failures = {}, 0
        task.back_off = min(2 * task.back_off + 1, MAX_BACK_OFF)
        task.unchecked = task.back_off
        self.world.dependencies.rest()
        return t, None

    # ---------------------------------------------------------------------------------------------- skipping

    def _repeated(self, task: StepTask, now: LoopState, last: LoopState) -> tuple[float, Wait | None, bool]:
        """Skip the iterations that repeat that from `last` to `now`; False if it does not repeat."""
        t = now.t
        if now.occurred != last.occurred:  # each of these iterations counts
            return t, None, False
        if not _same_waits(last, now):
            return t, None, True
        change = self._change(last, now)
        if change is not None and not any(change):
            return (*self._skip(task, now, last, INFINITY), True)
        toggle = last.before
        if toggle is not None and _same_waits(toggle, now):
            change_of_two = self._change(toggle, now)
            if change_of_two is not None and not any(change_of_two):
                return (*self._skip(task, now, toggle, INFINITY), True)
        if change is None:
            return t, None, last.before is None
        now.change = self._with_margins(change, now, last)
        if now.change is None:
            return t, None, last.before is None
        if now.change == last.change and self._only_counts(task, now, last):
            most = self._turn(now)
            if most > 0:
                return (*self._skip(task, now, last, most), True)
        return t, None, last.before is None

    def _variables(self) -> list[tuple[StepTask | None, int]]:
        """Return the task of each number, None for those that are shared, and its number in `Uses`."""
        return [
            *[(each, own(k)) for each in self._tasks for k in range(len(each.own))],
            *[(None, k) for k in range(len(self.world.shared))],
        ]

    def _with_margins(self, change: list[float], now: LoopState, last: LoopState) -> list[float] | None:
        """Return the changes of numbers and of margins; None if other comparisons were made."""
        since, first = last.margins.since(self._margins), last.margins.length
        if since is None or len(since) > first:
            return None
        before = self._margins[first - len(since) : first]
        now.margins = Mark(
            self._margins, len(self._margins)
        )  # conditions of waits may be compared before a skip
        return change + [b - a for a, b in zip(before, since, strict=True)]

    def _change(self, last: LoopState, now: LoopState) -> list[float] | None:
        """Return by how much each number that matters has changed; None if anything else is different."""
        overwritten = now.overwritten = self._overwritten(last, now)
        if last.numbers == now.numbers and list(map(type, last.numbers)) == list(map(type, now.numbers)):
            return [0] * len(now.numbers)
        change: list[float] = []
        for (_, variable), one, other in zip(self._variables(), last.numbers, now.numbers, strict=True):
            if (one == other and type(one) is type(other)) or variable in overwritten:
                change.append(0)
            elif is_number(one) and type(one) is type(other):
                change.append(other - one)
            else:
                return None
        return change

    def _overwritten(self, last: LoopState, now: LoopState) -> frozenset[int]:
        """Return the variables that the iterations since a state have set before they read them."""
        task, body = self.task, now.body
        if task is None or last.turns != now.turns or last.strayed != now.strayed:
            return NONE
        if list(task.met.values()) != [last] or self._depends_on_turns(task):
            return body.overwritten  # there may be several
        (notes,) = [
            read.since(self.world.dependencies.notes or []) for each, read in last.read if each is task
        ]
        return body.overwritten | body.set_first(notes or ())

    def _only_counts(self, task: StepTask, now: LoopState, last: LoopState) -> bool:
        """True if the changing numbers are only added and compared, and add up exactly."""
        bodies = {task: now.body if now.strayed == last.strayed else UNKNOWN}
        for each, wait, then in zip(self._tasks, now.waits, last.waits, strict=True):
            if each is not task and (wait is None or wait is not then):
                bodies[each] = _body(each.last_loop)
        for (owner, variable), number, by in zip(
            self._variables(), now.numbers, now.change or (), strict=False
        ):
            if by:
                linear = [bodies.get(owner, UNKNOWN)] if owner is not None else bodies.values()
                if not (
                    is_exact(number) and is_exact(by) and all(each.is_linear(variable) for each in linear)
                ):
                    return False
        return True

    def _turn(self, now: LoopState) -> float:
        """Return how many further iterations take the same branches, and overflow no number."""
        count, change = len(now.numbers), now.change or []
        most = INFINITY
        records, length = now.margins
        margins = records[length - (len(change) - count) : length] if len(change) > count else []
        for margin, by in zip(margins, change[count:], strict=True):
            if by and not (is_exact(margin) and is_exact(by)):
                return 0
            if by and margin * by <= 0:
                most = min(most, ceil(-margin / by) - 1)
        for number, by in zip(now.numbers, change, strict=False):
            if by:
                most = min(most, (LARGEST - 1 - abs(number)) // abs(by) - 1)
        return most

    def _skip(
        self, task: StepTask, now: LoopState, last: LoopState, most: float
    ) -> tuple[float, Wait | None]:
        """Count the iterations that repeat the last one, at most `most` of them."""
        time, clock, scheduler, t = self.time, self.machine.clock, self.machine.scheduler, now.t
        assert scheduler is not None
        here = time.leave(t)
        began = last.base + last.t * time.cost
        asking = self.machine.controller.asking
        if asking is not None:
            asking.repeats(began, here)
        is_alone = now.turns == last.turns
        stable = self._stable_until(task, now, last, began, here, is_alone)
        kept = [
            wait
            for wait, then in zip(now.waits, last.waits, strict=True)
            if wait is not None and wait is then
        ]
        # A statement that coincides with the end of another task's wait comes after it.
        until = min([stable, clock.next_time(), *[each.due() - 0.5 * ROUNDING for each in kept]])
        if until == INFINITY and most == INFINITY and now.acted == last.acted:
            if last.delays.since(self._delays) == []:
                self._is_futile(task, stays=True)
                wait = self.world.stands_still()
                if wait is not None:
                    return t, wait
            elif kept:
                return t, None  # the run may end before, if all tasks are futile
        if is_alone:
            if any(each.wait is None for each in self._tasks if each is not task):
                return t, None
            until = min(until, max(time.until, scheduler.reach() if scheduler.by_itself else 0.0))
        elif scheduler.by_itself and not any(each.ready() for each in kept):
            until = min(until, scheduler.until)
        else:
            return t, None
        if now.overwritten or (now.body.overwritten and now.strayed == last.strayed):
            # The last iteration sets what the others would have set, so it is carried out.
            until, most = until - (here - began) - CLOSE, most - 1
        if not here < until < INFINITY:
            return t, None
        moved = self._moved(now, last)
        first = self._first_switch(now, last) if now.switched != last.switched else 0
        if moved is None or first < 0:
            return t, None
        times, time.base = self._fitting(now, last, until, most)
        if times > 0:
            more = times * (now.t - last.t) if now.base == last.base else 0.0
            t = now.t + more
            time.leave(t)
            for wait, count, seconds in moved:
                wait.since = time.at(count + more)
                wait.ends = self.world.end_of_wait(time.base, count + more, seconds)
            self._carry(task, now, last, began, here, times)
            if now.switched != last.switched:
                period = (now.t - last.t) * time.cost
                self.machine.log.outputs.repeat(first, times, period, last.base, time.cost)
        return t, None

    def _first_switch(self, now: LoopState, last: LoopState) -> int:
        """Return the number of the first switch of an output since a state; -1 if these cannot be repeated."""
        scheduler, log = self.machine.scheduler, self.machine.log
        assert scheduler is not None
        if len(scheduler.tasks) > 1 or scheduler.interrupts or now.base != last.base or not self.time.cost:
            return -1
        first = -1
        for stream, length in zip(log.streams(), last.lengths, strict=False):
            if stream is log.outputs and stream.past - length <= MAX_ROWS:
                first = length
            elif stream.past != length:
                return -1
        return first

    def _moved(self, now: LoopState, last: LoopState) -> list[tuple[Delay, float, float]] | None:
        """Return the waits of other tasks that have begun since a state: statement and length.

        None if one of them is not known.
        """
        begun = {self.time.at(count): (count, seconds) for count, seconds in self._delays}
        waits = [wait for wait, then in zip(now.waits, last.waits, strict=True) if wait is not then]
        found = [(wait, *begun.get(wait.since, (0.0, -1.0))) for wait in waits if isinstance(wait, Delay)]
        return found if all(seconds >= 0.0 for _, _, seconds in found) else None

    def _fitting(self, now: LoopState, last: LoopState, until: float, most: float) -> tuple[int, float]:
        """Return how many more iterations fit before a time, at most `most`, and the base after them."""
        time = self.time
        if now.base == last.base:
            return int(min(time.periods(last.base, last.t + 1.0, now.t + 1.0, until), most)), now.base
        # Sums of waits for a time are multiples of the unit of time, or round and are added up one by one.
        delays, base, times = last.delays.since(self._delays), now.base, 0
        if delays is None or self._after(last.base, delays) != base:
            return 0, base
        if now.turns != last.turns or now.t != last.t:
            return 0, base
        rest = (now.t + 1.0) * time.cost
        period = self.world.period(delays)
        if period:
            begun = units(base)
            times = int(max(0.0, min(most, (until - rest - base) * UNITS // period + 1)))
            while times and (begun + times * period) / UNITS + rest >= until:
                times -= 1
            return times, (begun + times * period) / UNITS
        while times < most and (following := self._after(base, delays)) + rest < until:
            base = following
            times += 1
        return times, base

    def _carry(
        self, task: StepTask, now: LoopState, last: LoopState, began: float, here: float, times: int
    ) -> None:
        """Log `times` more iterations like that from `began` to `here`, and let the numbers change with them."""
        time, log, scheduler = self.time, self.machine.log, self.machine.scheduler
        assert scheduler is not None
        if self.machine.observer is not None:
            self.machine.observer.skipped(last.seen, now.seen, times)
            now.seen = self.machine.observer.seen
        asking = self.machine.controller.asking
        if asking is not None:
            asking.skipped(began, here, time.reached, times)
        if now.turns != last.turns:
            log.slices.so_far(task.name, scheduler.began, here)
            log.repeat_period(last.logged, began, here, time.reached, times)
            log.slices.shared_by_all(time.reached - here)
        elif last.base != now.base:
            log.repeat_waits(task.name, began, here - began, times)
        if self._depends_on_turns(task):
            scheduler.move_slice(time.reached - here)
        if now.change is not None:
            count = len(now.numbers)
            k = 0
            for values in [*[each.own for each in self._tasks], self.world.shared]:
                for index in range(len(values)):
                    if by := now.change[k]:
                        values[index] = now.numbers[k] = now.numbers[k] + times * by
                    k += 1
            margins = now.change[count:]
            records, length = now.margins
            for index, by in enumerate(margins, length - len(margins)):
                records[index] += times * by

    def _stable_until(
        self, task: StepTask, now: LoopState, last: LoopState, began: float, here: float, is_alone: bool
    ) -> float:
        """Return the time until which all readings since `last` that matter stay unchanged."""
        dependencies = self.world.dependencies
        task.notes = dependencies.notes
        body = now.body if is_alone and now.strayed == last.strayed else UNKNOWN
        found: list[Note] = []
        for each, read in last.read:
            if each is not task and is_alone:
                continue
            notes = read.since(each.notes) if each.notes is not None else None
            if notes is None:
                return -INFINITY
            found += notes
        clocks = body.clocks(found, now.overwritten, dependencies.ticks, (here - began) * 1000.0)
        latest = began + MAX_SPAN if clocks else INFINITY
        matter: list[Note] = []
        for note in found:
            mark, about = note
            if isinstance(mark, Span) and mark.variable in clocks:
                matter.append((about[0], (about[1], FAR)))
            elif body is UNKNOWN or not (
                isinstance(mark, Copy) and (mark.variable in clocks or body.is_only_copied(mark))
            ):
                matter.append(note)
        return min(dependencies.until(began - CLOSE, matter) - CLOSE, latest)

    def _after(self, base: float, delays: list[tuple[float, float]]) -> float:
        for count, seconds in delays:
            base = self.world.end_of_wait(base, count, seconds)
        return base


def _body(loop: tuple[Steps, int, int]) -> IterationUses:
    steps, first, last = loop
    found = steps.bodies.get((first, last))
    if found is None:
        found = steps.bodies[first, last] = body_of(steps, first, last) if first <= last else UNKNOWN
    return found


def _kind(wait: Wait | None) -> object:
    """Return the wait itself, or what all waits for a time have in common."""
    return Delay if isinstance(wait, Delay) else wait


def _same_waits(last: LoopState, now: LoopState) -> bool:
    """True if as much is left of each wait, unless it is the same one."""
    waits = zip(last.waits, now.waits, last.left, now.left, strict=True)
    return all(then is wait or before == left for then, wait, before, left in waits)


def is_number(value: object) -> bool:
    """True for a number that may count."""
    return value.__class__ is int or value.__class__ is float


def is_exact(number: float) -> bool:
    """True if multiples of a number add up without rounding."""
    return -LARGEST < number < LARGEST and (number / GRAIN).is_integer()
