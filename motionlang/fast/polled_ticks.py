"""Skipping of TIMER ticks while tasks poll, along transitions executed before.

Replaces: polling up to each tick, the handler, the switch back, and the iterations of loops that poll with a WAIT
of their own, where all of them do what they did before.

Hook: `TimerTicks.left`, which `TimeSlices` calls as a handler has ended, and as a task begins a WAIT while
`Scheduler.is_observed`.

Gain: 10 to 10² times (`field_timer_while_polling` and the family `timers` of benchmarks/cliffs.py).

Equality is tested by: tests/fast/test_polled_ticks.py, tests/generated/test_polls.py with generated programs.

Problem. A task that polls is interrupted by each tick, so neither its own iterations nor those of several tasks
can be skipped further than that. Executed, a tick with some polling takes 30 to 60 µs.

Idea. Observe the program at checkpoints: when a handler has ended, and when a task has begun a WAIT. The joint
state there is the position and the local variables of each task, the variables that they share, the outputs,
the waits other than WAITs and the task that comes next. While no reading changes and no other event happens,
this state and the number of statements up to the next tick or end of a WAIT decide everything up to the next
checkpoint. So whatever is executed between two checkpoints is a transition, from a state and a number of
statements to another state. A task that polls:

    state 0 ──98 statements──> state 1 ──98──> state 0 ──99──> state 2 ──97──> state 0

If all tasks wait, the clock jumps to the next tick or end, and there are no statements up to it. A loop with
WAIT(5) and a tick every 10 ms:

    state 0 ──tick──> state 1 ──end of the WAIT──> state 2 ──end of the WAIT──> state 2 ──tick──> state 1

If another tick or end comes before the checkpoint, the transition depends on the number of statements up to that
one, too: transitions are the nodes of a tree, with a level for each tick or end that falls into them.

If a task polls while another one is in a WAIT, the number of statements up to the next tick or end is another one
each time. If the loop of the only task that polls has been skipped (`StatementTime.repeated`), its iterations are
alike, and whole iterations before the tick or end are left out of that number.

Times of statements and of ticks are products that round differently. If a tick coincides with a statement, the
last bit decides if that statement comes first, in no simple pattern. So all times are computed by the same
expressions as in the run, and the walk along known transitions is exact. It ends before a transition that is not
known, a change of a reading, another event or the end of another wait, and where a counter reaches a level. The
tasks can only continue in the state that they are in, so transitions are skipped up to the last one that leads
to that state.

An event that nothing of this depends on changes nothing. So the transitions are stored as an event happens, under the
outcomes of all readings of the program (`mint/compile/outcomes.py`), and used again when the outcomes are the same. A
loop that waits for the end of a move has few new transitions in the next move.

Data. `_known` has the states and the transitions (`transitions.py`). They are valid since `_begun`, and `_read` has
the dependencies of all tasks since then (`Dependencies.longest`). `_last` is the last checkpoint. Walks are computed
in `walker.py`, and `rounds.py` repeats what is in them.

Invariants.
- A transition is recorded only if nothing has happened but the tick, polling, WAITs, and switches of outputs.
  `_marks` has what must not change meanwhile, and only `_streams` and the waits may have new records.
- Counters (`handler_counters.py`) are no part of a state: those of the handler unless a loop that may poll uses
  them, and those of loops. While they advance, each stays on one side of its constants. If the handler also sets
  one, all ticks must advance it equally, and a transition must have been executed twice.
- Transitions are used after an event only if each reading of the program has an outcome, and if no write has changed
  nothing, because what it would change is no outcome. They keep their dependencies.
- Times that differ by no more than `ROUNDING` may be one time for the scheduler. A walk ends where they are
  close to that.
- Records of skipped ticks are those of the run to the last bit, except that the time slices of several tasks
  become one record, and that a WAIT that is over while a handler runs ends then and not after it.

Cost. A state takes some 10 µs a task, and a step of the walk 1 µs. Exponential back-off: if `PATIENCE`
checkpoints have not led to as many skipped ones, 1, 2, 4, … ticks are executed without a search.
"""

from __future__ import annotations

from collections import Counter
from functools import partial
from itertools import groupby

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.fast.handler_counters import HandlerCounters
from motionlang.fast.transitions import (
    APART,
    NO_DUE,
    TICK,
    Checkpoint,
    Known,
    Transition,
    first_statement,
)
from motionlang.fast.walk import Pace
from motionlang.fast.walker import MAX_WALK, Walker
from motionlang.lang.dependencies import CLOSE
from motionlang.lang.statement_time import UNITS, units
from motionlang.log.repeated import rows_of
from motionlang.mint.runtime.binding import bind, row_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from motionlang.fast.transitions import Due
    from motionlang.fast.walk import Ended, Switching, Walk
    from motionlang.lang.dependencies import Note
    from motionlang.lang.waits import Wait
    from motionlang.log.repeated import Row
    from motionlang.log.stream import Stream
    from motionlang.mint.runtime.events import Events

# Checkpoints without a skip before the search is left out, and the most ticks that are executed then.
PATIENCE, MAX_BACK_OFF = 48, 512
# The fewest ticks with equal records that become a template, and the most switches of a transition.
MIN_TEMPLATE, MAX_ROWS = 16, 64
# More states are not stored.
MAX_STATES = 1000
# The transitions of so many searches are stored.
MAX_STORED = 16
# A walk ends this long, s, before anything else happens.
MARGIN = 2 * CLOSE


class PolledTicks:
    """The states of a program at its checkpoints, and their transitions."""

    def __init__(self, events: Events, kind: str) -> None:
        self._events, self._environment = events, events.environment
        self._counters = HandlerCounters(events, kind, beside_loops=True)
        self._log = log = events.environment.machine.log
        self._streams: tuple[Stream[Any], ...] = log.events, log.outputs, log.slices
        self._others = [each for each in log.streams() if each not in (*self._streams, log.waits)]
        # What no transition may change, the time since which it has not changed, and the readings since then.
        self._since: tuple[object, ...] = ()
        self._begun = 0.0
        self._read: set[Note] | None = None
        self._known = Known(self._counters.count)
        # The transitions of earlier searches, by all outside the states that decides them, and that of the present
        # search; the readings that are part of it; and how many writes had changed nothing as the search began.
        self._stored: dict[tuple[object, ...], Known] = {}
        self._outcomes: tuple[object, ...] | None = None
        self._readings = self._bound_readings()
        self._repeats = 0
        self._last: Checkpoint | None = None
        # True if a task has been in a WAIT.
        self._has_waits = False
        # The checkpoints without a skip, the ticks left to execute without a search, and their next number.
        self._observed = self._left = 0
        self._back_off = 1

    def _bound_readings(self) -> list[Callable[[], object]] | None:
        """Return functions for the outcomes of the program's readings.

        None if other readings may decide.
        """
        if self._environment.outcomes is None:
            return None
        return [self._bound(*each) for each in self._environment.outcomes]

    def _bound(self, name: str, index: int, level: float | None) -> Callable[[], object]:
        """Return a function for the outcome of a reading, or for its side of a level."""
        row = row_of(name)
        if row.actions.outcome is not None:
            return partial(row.actions.outcome(self._environment, row), index)
        assert level is not None
        read: Any = partial(bind(self._environment, "read", row), index)
        return lambda: (read() > level) - (read() < level)

    @property
    def is_searching(self) -> bool:
        """True unless ticks are executed without a search."""
        return not self._left

    def reached(self, scheduler: Any, by_tick: bool, polls: bool) -> None:
        """Skip transitions from a checkpoint on, if they are known.

        It is the end of a handler if it is reached `by_tick`, or else the beginning of a WAIT. `polls` is false if
        all tasks wait for long.
        """
        if self._left:
            self._left -= by_tick
            scheduler.is_observed = False
            return
        if self._events.active or self._events.pending or scheduler.interrupts:
            return  # the next checkpoint is the end of a handler
        if not polls or not self._is_regular(scheduler):
            self._forget(scheduler)
            return
        self._observed += 1
        if self._observed > PATIENCE:
            self._give_up(scheduler)
            return
        since = self._marks(scheduler)
        is_full = len(self._known) > MAX_STATES
        if since != self._since or self._environment.dependencies.read is not self._read or is_full:
            self._begin(since)
        level = self._level()
        if level <= self._environment.clock.now:  # a reading has changed
            self._observed += PATIENCE // 4
            self._begin(since)
            level = self._level()
        self._observe(scheduler)
        assert self._read is not None
        self._known.read |= self._read
        if self._last is not None:
            self._has_waits = self._has_waits or len(self._last.dues) > 1
            scheduler.is_observed = self._has_waits
            self._skip(scheduler, level)

    def _level(self) -> float:
        """Return the time up to which readings may change by an event only."""
        assert self._read is not None
        return self._environment.dependencies.until(self._begun - CLOSE, self._read) - CLOSE

    def _is_regular(self, scheduler: Any) -> bool:
        """True if nothing outside may act."""
        events, environment = self._events, self._environment
        return (
            events.tick_event is not None
            and scheduler.pace is None
            and scheduler.outside is None
            and not any(task.busy or task.suspended for task in scheduler.tasks)
            and environment.machine.hook is None
            and not environment.machine.assumptions
            and environment.statements.reached == environment.clock.now
            and not environment.controller.outputs.listeners
        )

    def _marks(self, scheduler: Any) -> tuple[object, ...]:
        """Return what must not change, except by ticks, switches and WAITs."""
        events, environment = self._events, self._environment
        ticks = events.ticks
        return (
            environment.clock.fired - 2 * ticks,
            environment.acts - environment.switches - ticks,
            environment.copies,
            environment.midways,
            events.started,
            events.timer,
            len(scheduler.tasks),
            *self._counters.sides(),
            *map(len, self._others),
        )

    def _forget(self, scheduler: Any) -> None:
        """End the search."""
        self._store()
        if self._read is not None:
            self._environment.dependencies.end_longest(self._read)
            self._read = None
        self._since, self._last = (), None
        scheduler.is_observed = False

    def _give_up(self, scheduler: Any) -> None:
        """Execute some ticks without a search."""
        self._forget(scheduler)
        self._observed = 0
        self._left, self._back_off = self._back_off, min(2 * self._back_off, MAX_BACK_OFF)

    def _begin(self, since: tuple[object, ...]) -> None:
        """Begin a search, with the states that are stored for the present outcomes."""
        self._store()
        environment = self._environment
        self._since, self._begun, self._last = since, environment.clock.now, None
        self._has_waits = False
        self._outcomes = self._outcomes_now()
        self._repeats = environment.repeats
        known = None if self._outcomes is None else self._stored.pop(self._outcomes, None)
        self._known = known or Known(self._counters.count)
        self._read = environment.dependencies.begin_longest()
        self._read |= self._known.read

    def _store(self) -> None:
        """Store the states for a later search, if the outcomes alone decide."""
        outcomes, self._outcomes = self._outcomes, None
        is_decided = self._repeats == self._environment.repeats and len(self._known) <= MAX_STATES
        if outcomes is not None and is_decided:
            self._stored[outcomes] = self._known
            if len(self._stored) > MAX_STORED:
                del self._stored[next(iter(self._stored))]

    def _outcomes_now(self) -> tuple[object, ...] | None:
        """Return all else that decides; None if there may be more."""
        environment, events = self._environment, self._events
        if self._readings is None or environment.outcomes is None:
            return None
        environment.dependencies.notes = None  # these readings are no dependencies
        try:
            outcomes = [read() for read in self._readings]
        except Rejected:  # of an axis or a channel that does not exist
            self._readings = None
            return None
        return (
            events.timer,
            events.disabled,
            tuple(self._counters.sides()),
            tuple(sorted(environment.controller.outputs.active_low)),
            *outcomes,
        )

    def _observe(self, scheduler: Any) -> None:
        """Record a checkpoint, and the transition to it."""
        before, self._last = self._last, self._checkpoint(scheduler)
        statements = self._environment.statements
        repeated, statements.repeated = statements.repeated, None
        if before is None or self._last is None:
            return
        steps = tuple([n - m for n, m in zip(self._last.values, before.values, strict=True)])
        if repeated is not None:
            self._learn_period(before, steps, *repeated)
        due = before.dues[0]
        origin: tuple[float, float] | None = before.base, before.count
        if due[0] <= self._environment.clock.now + APART:
            by_tick = len(before.dues) == 1
            found = self._walker().origin(before.state, before.base, before.count, due, by_tick)
            origin = None if found is None else found[:2]
        path = None if origin is None else self._path(before, self._last, *origin)
        if origin is None or path is None or (origin[1] > before.count and self._counters.loops_count(steps)):
            return
        made = self._transition(before, self._last, origin[1], path, steps)
        if made is None:
            return
        node = self._known.node(before.state, [(due[1], statement - origin[1]) for due, statement in path])
        known = node.transition
        if known is not None and known.equals(made):
            known.is_proved = True
            return
        node.transition = made
        if len(path) == 1 and self._known.are_idle[before.state]:
            if origin[0] != before.base:
                self._known.alone[before.state, path[0][0][1]] = made
        elif len(path) == len(before.dues) == len(self._last.dues) == 1:
            due, statement = path[0]
            self._known.gaps.setdefault(before.state, {})[statement - origin[1]] = made
        is_tick = made.handler is not None
        advance = self._counters.steps_of_set(made.steps) if is_tick else []
        if known is not None or (is_tick and self._known.advance not in (None, advance)):
            self._known.forget_transitions()
            return
        if is_tick:
            self._known.advance = advance
        made.is_proved = not any(advance)
        self._known.widen(steps)

    def _learn_period(
        self, before: Checkpoint, steps: tuple[float, ...], base: float, first: float, last: float
    ) -> None:
        """Store the period of the only task that polls in a state, from `first` to `last`.

        It is not used if loops count, or if no other task is in a WAIT, since the task may then switch outputs.
        """
        statements, state, count = self._environment.statements, before.state, before.count
        is_used = self._known.polling[state] and len(before.dues) > 1 and base == before.base
        if not is_used or first < count or statements.at(last) > before.dues[0][0]:
            return
        known = self._known.periods.get(state, (INFINITY, 0.0))
        if self._counters.loops_count(steps):
            self._known.periods[state] = None
        elif known is not None and first - count < known[0]:
            self._known.periods[state] = first - count, last - first

    def _checkpoint(self, scheduler: Any) -> Checkpoint | None:
        """Return the present state and its times; None if it cannot be compared."""
        environment, alive, events = self._environment, self._known.alive, self._events
        tasks, current = scheduler.tasks, scheduler.current
        state: list[object] = [
            tasks.index(current) if current in tasks else TICK,
            scheduler.next_index,
            environment.controller.outputs.values,
        ]
        dues: list[Due] = [(events.tick_time(events.ticks), TICK, 0.0)]
        polling: list[str] = []
        values = self._counters.hide()
        state.append(environment.state(alive))
        for index, task in enumerate(tasks):
            own, wait = task.state(alive, self._begun), task.wait
            state += [own, task.priority, task.max_slice]
            if wait is None:
                polling.append(task.name)
            elif wait is task.delay:
                dues.append((wait.ends, index, wait.since))
                state.append(True)
            elif wait.ends is None and wait.ignores_data:
                state.append(False)  # `_skip` checks whether it ends, and no transition ends it
            else:
                alive[id(wait)] = wait
                state += [id(wait), wait.ends or 0.0]
        self._counters.set(values)
        if None in state:
            return None
        number = self._known.number(tuple(state), polling)
        if number not in self._known.waits:
            self._known.waits[number] = {
                index: tasks[index].waited(tasks[index].wait, 0.0) for _, index, _ in dues if index != TICK
            }
        statements = environment.statements
        dues.sort()
        lengths = list(map(len, self._streams))
        return Checkpoint(number, statements.base, statements.count, dues, events.ticks, values, lengths)

    def _path(
        self, before: Checkpoint, after: Checkpoint, base: float, origin: float
    ) -> list[tuple[Due, float]] | None:
        """Return the ticks and ends between two checkpoints.

        Each has the first statement after it. None if they cannot be compared.
        """
        if base != after.base or origin > after.count:
            return None
        cost, path = self._environment.statements.cost, []
        end = base + after.count * cost + APART
        for due in before.dues:
            if due[0] > end:
                break
            statement = first_statement(due, base, cost)
            if statement is None:
                return None
            path.append((due, statement))
        return path

    def _transition(
        self,
        before: Checkpoint,
        after: Checkpoint,
        origin: float,
        path: list[tuple[Due, float]],
        steps: tuple[float, ...],
    ) -> Transition | None:
        """Return the transition between two checkpoints; None if it cannot be repeated."""
        statements, base = self._environment.statements, after.base
        cost_units = statements.cost_units
        handlers, outputs, slices = (
            stream[length:] for stream, length in zip(self._streams, before.lengths, strict=True)
        )
        rows = rows_of(outputs, 0, base, statements.cost)
        ticks = after.number - before.number
        if rows is None or len(rows) > MAX_ROWS or len(handlers) != ticks or ticks > 1:
            return None
        if ticks and handlers[0][0] != self._events.tick_time(before.number):
            return None
        waits: list[tuple[int, float, int]] = []
        ended = {due[1] for due in before.dues} - {due[1] for due in after.dues}
        if ticks:
            ended.add(TICK)
        for due in after.dues:
            end, index, since = due
            if index == TICK or due in before.dues:
                continue
            ended.add(index)
            count = float(round((since - base) / statements.cost))
            begun = units(base) + int(origin) * cost_units
            wait_units = units(end) - begun
            is_exact = (begun + wait_units) / UNITS == end and statements.at(count) == since
            if not cost_units or not is_exact or count < origin:
                return None
            waits.append((index, count - origin, wait_units))
        reached = {due[1] for due, _ in path}
        if not ended.intersection(due[1] for due in before.dues) <= reached:
            return None
        switches = tuple([(count - origin, rest) for _, (count,), rest in rows])
        if switches and switches[0][0] < 0.0:
            return None
        seconds: dict[str, float] = {}
        for *_, tasks, taken in slices:
            for task, each in zip(tasks, taken, strict=True):
                seconds[task] = seconds.get(task, 0.0) + each
        polls = self._known.polling[before.state]
        if polls in seconds:
            seconds[polls] -= (origin - before.count) * statements.cost
        return Transition(
            after.state,
            after.count - origin,
            tuple(handlers[0][1:]) if ticks else None,
            switches,
            tuple(waits),
            frozenset(reached - ended),
            steps if any(steps) else (),
            seconds,
        )

    def _skip(self, scheduler: Any, level: float) -> None:
        """Skip known transitions from the last checkpoint on, up to `level`."""
        environment, last = self._environment, self._last
        assert last is not None
        walker = self._walker()
        if walker.next(last.state, last.base, last.count, [*last.dues, NO_DUE]) is None:
            return
        tasks = scheduler.tasks
        waits: list[Wait] = [
            task.wait for task in tasks if task.wait is not None and task.wait is not task.delay
        ]
        if any(wait.ends is None and (not wait.ignores_data or wait.ready()) for wait in waits):
            return
        clock = environment.clock
        dues = [wait.due() if wait.ends is None else wait.ends for wait in waits]
        event = self._events.tick_event
        assert event is not None
        other = clock.second_time() if clock.next_time() == event.time else clock.horizon
        end = min(level, other, scheduler.until, *dues) - MARGIN
        while (last := self._last) is not None:
            walk = walker.walk(last, end, self._counters.most_in(self._known.range, last.values))
            if walk is None:
                return
            self._pass(walk, scheduler)
            if len(walk.steps) < MAX_WALK:
                return  # there is none after it

    def _walker(self) -> Walker:
        """Return a walker along the transitions."""
        return Walker(self._known, self._pace())

    def _pace(self) -> Pace:
        """Return the times of ticks and statements."""
        return Pace(self._events.started, self._events.timer / 1000.0, self._environment.statements)

    def _pass(self, walk: Walk, scheduler: Any) -> None:
        """Let the transitions of a walk pass."""
        events, environment = self._events, self._environment
        clock, statements, tasks = environment.clock, environment.statements, scheduler.tasks
        last, times = self._last, walk.times()
        assert last is not None
        assert events.tick_event is not None
        since = clock.now
        self._log_switches(walk)
        self._log_waits(walk)
        if walk.reached[3] > last.number:
            self._log_handlers(walk)
            clock.reach(events.tick_event)
            events.schedule_tick(walk.reached[3])
        values = last.values
        for step, count in times.items():
            if step.steps:
                values = tuple([n + count * m for n, m in zip(values, step.steps, strict=True)])
        self._counters.set(values)
        after = Checkpoint(last.state, *walk.reached, values)
        if after.base != statements.base:
            statements.base = after.base
        clock.now = statements.leave(after.count)
        clock.leaps += 1
        environment.fired = clock.fired
        for end, index, begun in after.dues:
            if index != TICK:
                wait = tasks[index].wait
                wait.since, wait.ends = begun, end
        if len(tasks) > 1:
            self._log_slices(walk, times, since, clock.now)
        self._since = self._marks(scheduler)
        after.lengths, self._last = list(map(len, self._streams)), after
        self._observed = max(self._observed - times.total(), 0)
        if not self._observed:
            self._back_off = 1

    def _log_switches(self, walk: Walk) -> None:
        """Log the switches of a walk; those of rounds become a template if ticks switch."""
        first, stream, pace = 0, self._log.outputs, self._pace()
        for each in walk.rounds:
            stream.extend(self._switches(walk, walk.switching_between(first, each.past)))
            first = each.past
            if all(source is not None and source[0] == TICK for *_, source in each.switching):
                ticks = each.shift.ticks
                rows: list[Row] = [
                    (source[1] + ticks, (origin + offset,), rest)
                    for number, _, origin, source in each.switching
                    if source is not None
                    for offset, rest in walk.steps[number].switches
                ]
                stream.repeat((rows, each.times, ticks, 0.0), (pace.started, 0, pace.period, pace.cost))
            else:
                stream.extend(self._switches(walk, each.repeated(pace)))
        stream.extend(self._switches(walk, walk.switching_between(first, walk.good)))

    def _switches(self, walk: Walk, switching: list[Switching]) -> list[tuple[object, ...]]:
        """Return the records of the switches of some transitions."""
        cost = self._environment.statements.cost
        return [
            (base + (origin + offset) * cost, *rest)
            for number, base, origin, _ in switching
            for offset, rest in walk.steps[number].switches
        ]

    def _log_waits(self, walk: Walk) -> None:
        """Log the WAITs that end in a walk."""
        first, log = 0, self._log
        for each in walk.rounds:
            self._log_ended(walk.ended_between(first, each.past))
            waits: dict[int, list[tuple[object, ...]]] = {}
            for ended in walk.ended_between(each.first, each.past):
                waits.setdefault(ended[2][1], []).extend([self._waited(ended, k) for k in range(ended[3])])
            for index, mine in waits.items():
                log.repeated_waits.add((tuple(mine), each.times, each.shift.ends[index] / UNITS))
            first = each.past
        self._log_ended(walk.ended_between(first, walk.good))

    def _log_ended(self, waits: list[Ended]) -> None:
        """Log some WAITs that end in a walk."""
        self._log.waits.extend([self._waited(ended, 0) for ended in waits])
        for ended in waits:
            times, length = ended[3:]
            if times > 1:
                self._log.repeated_waits.add(((self._waited(ended, 0),), times - 1, length / UNITS))

    def _waited(self, ended: Ended, k: int) -> tuple[object, ...]:
        """Return the record of the WAIT that ends `k` WAITs after the first one."""
        _, state, (end, index, begun), _, length = ended
        name, at, _, _, *about = self._known.waits[state][index]
        later = k * length / UNITS
        return name, at, begun + later, end + later, *about

    def _log_handlers(self, walk: Walk) -> None:
        """Log a record for each tick of a walk.

        Many equal ones in a row become a template, and so do rounds that repeat.
        """
        steps, first = walk.steps, 0
        number = self._events.ticks
        for each in walk.rounds:
            number = self._log_ticks(_handlers(steps[first : each.past]), number)
            number = self._log_repeated(_handlers(steps[each.first : each.past]), each.times, number)
            first = each.past
        self._log_ticks(_handlers(steps[first : walk.good]), number)

    def _log_ticks(self, handlers: list[tuple[object, ...]], number: int) -> int:
        """Log the ticks from `number` on; return the number of the next one."""
        for handler, group in groupby(handlers):
            number = self._log_repeated([handler], len(list(group)), number)
        return number

    def _log_repeated(self, handlers: list[tuple[object, ...]], times: int, number: int) -> int:
        """Log the records of some ticks so many times, as a template if there are many."""
        events, stream = self._events, self._log.events
        past = number + len(handlers) * times
        if past - number < MIN_TEMPLATE:
            stream.extend([(events.tick_time(number + k), *rest) for k, rest in enumerate(handlers * times)])
        else:
            pace = events.started, number, events.timer / 1000.0, self._environment.statements.cost
            rows: list[Row] = [(k, (0.0,), rest) for k, rest in enumerate(handlers)]
            stream.repeat((rows, times, len(handlers), 0.0), pace)
        return past

    def _log_slices(self, walk: Walk, times: Counter[Transition], since: float, until: float) -> None:
        """Log the time slices of several tasks as one record."""
        seconds: dict[str, float] = {}
        for step, count in times.items():
            for task, each in step.seconds.items():
                seconds[task] = seconds.get(task, 0.0) + count * each
        for number, task, statements in walk.polling:
            if number < walk.good:
                seconds[task] = seconds.get(task, 0.0) + statements * self._environment.statements.cost
        if seconds:
            self._log.slices.add((since, until, tuple(seconds), tuple(seconds.values())))


def _handlers(steps: Sequence[Transition]) -> list[tuple[object, ...]]:
    """Return the rest of the record of each handler in some transitions."""
    return [step.handler for step in steps if step.handler is not None]
