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

Data. `_numbers` has the states by their contents, `_known` the transitions. They are valid since `_begun`, and
`_read` has the dependencies of all tasks since then (`Dependencies.longest`). `_last` is the last checkpoint.

Invariants.
- A transition is recorded only if nothing has happened but the tick, polling, WAITs, and switches of outputs.
  `_marks` has what must not change meanwhile, and only `_streams` and the waits may have new records.
- Counters (`handler_counters.py`) are no part of a state: those of the handler unless a loop that may poll uses
  them, and those of loops. While they advance, each stays on one side of its constants. If the handler also sets
  one, all ticks must advance it equally, and a transition must have been executed twice.
- Times that differ by no more than `ROUNDING` may be one time for the scheduler. A walk ends where they are
  close to that.
- Records of skipped ticks are those of the run to the last bit, except that the time slices of several tasks
  become one record, and that WAITs leave none.

Cost. A state takes some 10 µs a task, and a step of the walk 1 µs. Exponential back-off: if `PATIENCE`
checkpoints have not led to as many skipped ones, 1, 2, 4, … ticks are executed without a search.
"""

from __future__ import annotations

from bisect import insort
from collections import Counter
from itertools import groupby
from math import ceil

from motionlang.controller.clock import INFINITY
from motionlang.fast.handler_counters import HandlerCounters
from motionlang.lang.dependencies import CLOSE
from motionlang.lang.statement_time import UNITS, units
from motionlang.lang.waits import ROUNDING
from motionlang.log.repeated import rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.lang.waits import Wait
    from motionlang.log.stream import Stream
    from motionlang.mint.runtime.events import Events

    # A tick or the end of a WAIT: its time, the index of the task or `TICK`, and the beginning of the WAIT.
    Due = tuple[float, int, float]

# Checkpoints without a skip before the search is left out, and the most ticks that are executed then.
PATIENCE, MAX_BACK_OFF = 48, 512
# The most steps of a walk, the fewest ticks with equal records that become a template, and the most switches of a
# transition.
MAX_WALK, MIN_TEMPLATE, MAX_ROWS = 4096, 16, 64
# More states are not stored.
MAX_STATES = 1000
# A walk ends this long, s, before anything else happens.
MARGIN = 2 * CLOSE
# In place of the index of a task: the tick.
TICK = -1
# Two times further apart than this, s, are two times for the scheduler.
APART = 2 * ROUNDING
_NO_DUE: Due = (INFINITY, TICK, 0.0)
# The transitions of a state from which none is known.
_NO_GAPS: dict[float, Transition] = {}


class Transition:
    """The effects from one checkpoint to the next one.

    Statements are counted from the origin: the checkpoint, the first tick or end if all tasks waited for it, or the
    beginning of the last iterations of a task that polls. `length` is the number of them, and `state` the state then.
    `handler` is the rest of the record of the handler, None without a tick. `switches` are those of outputs, each with
    its statement. `waits` are the WAITs that tasks have begun: the index of the task, the statement, and the units
    from the origin to the end. `open` are the indices of the WAITs in its path that are not over. `steps` is how far
    it advances the counters, () if it does not. `seconds` is how long each task has computed since the origin.
    `is_proved` is false until it may be repeated.
    """

    __slots__ = ("handler", "is_proved", "length", "open", "seconds", "state", "steps", "switches", "waits")

    def __init__(
        self,
        state: int,
        length: float,
        handler: tuple[object, ...] | None,
        switches: tuple[tuple[float, tuple[object, ...]], ...],
        waits: tuple[tuple[int, float, int], ...],
        open: frozenset[int],
        steps: tuple[float, ...],
        seconds: dict[str, float],
    ) -> None:
        self.state, self.length, self.handler, self.switches = state, length, handler, switches
        self.waits, self.open, self.steps, self.seconds = waits, open, steps, seconds
        self.is_proved = False

    def equals(self, other: Transition) -> bool:
        """True if it has the same effects, in whatever time slices."""
        own = self.state, self.length, self.handler, self.switches, self.waits, self.steps
        return own == (
            other.state,
            other.length,
            other.handler,
            other.switches,
            other.waits,
            other.steps,
        )


class _Node:
    """The transition after some ticks and ends.

    `next` has the nodes after one more of them, by its index and statement.
    """

    __slots__ = ("next", "transition")

    def __init__(self) -> None:
        self.transition: Transition | None = None
        self.next: dict[tuple[int, float], _Node] = {}


class _Checkpoint:
    """A state with its times.

    These are the base and count of the statements, and the next tick and ends in order. `number` is that of the
    next tick, `values` are those of the counters and `lengths` those of the streams.
    """

    __slots__ = ("base", "count", "dues", "lengths", "number", "state", "values")

    def __init__(
        self,
        state: int,
        base: float,
        count: float,
        dues: list[Due],
        number: int,
        values: tuple[float, ...],
        lengths: list[int] | None = None,
    ) -> None:
        self.state, self.base, self.count, self.dues = state, base, count, dues
        self.number, self.values, self.lengths = number, values, lengths or []


class _Walk:
    """Transitions in a row; the first `good` ones lead to the present state.

    `switching` has the number of each that switches outputs, its base and its origin. `polling` has the number of each
    before whose origin a task polls, the task and the statements of that. `reached` are base, count, ticks and ends,
    and the number of the next tick after the good ones.
    """

    __slots__ = ("good", "polling", "reached", "steps", "switching")

    def __init__(self) -> None:
        self.steps: list[Transition] = []
        self.switching: list[tuple[int, float, float]] = []
        self.polling: list[tuple[int, str, float]] = []
        self.good = 0
        self.reached: tuple[float, float, list[Due], int] = 0.0, 0.0, [], 0


class PolledTicks:
    """The states of a program at its checkpoints, and their transitions."""

    def __init__(self, events: Events, kind: str) -> None:
        self._events, self._environment = events, events.environment
        self._counters = HandlerCounters(events, kind, beside_loops=True)
        self._log = log = events.environment.machine.log
        self._streams: tuple[Stream[Any], ...] = log.events, log.outputs, log.slices
        self._others = [each for each in log.streams() if each not in (*self._streams, log.waits)]
        cost_units = events.environment.statements.cost * UNITS
        # The duration of a statement in units, 0 if that is no integer.
        self._cost_units = round(cost_units) if abs(cost_units - round(cost_units)) < 1e-6 else 0
        # What no transition may change, the time since which it has not changed, and the readings since then.
        self._since: tuple[object, ...] = ()
        self._begun = 0.0
        self._read: set[Note] | None = None
        self._alive: dict[int, object] = {}
        self._numbers: dict[object, int] = {}
        # By state: its transitions, true if all tasks wait in it, the name of the task that polls in it if there is
        # just one, and the period of that task: its start after the checkpoint and its length, in statements.
        self._known: dict[int, _Node] = {}
        # Of these, transitions from states in which all tasks wait for just one tick or end, by its index, and those
        # of states in which no task is in a WAIT, by the number of statements up to the tick.
        self._alone: dict[tuple[int, int], Transition] = {}
        self._gaps: dict[int, dict[float, Transition]] = {}
        self._are_idle: list[bool] = []
        self._polling: list[str] = []
        self._periods: dict[int, tuple[float, float] | None] = {}
        # How far each tick advances the counters that the handler also sets, None before the first one.
        self._advance: list[float] | None = None
        self._last: _Checkpoint | None = None
        # True if a task has been in a WAIT.
        self._has_waits = False
        # The checkpoints without a skip, the ticks left to execute without a search, and their next number.
        self._observed = self._left = 0
        self._back_off = 1

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
        if not polls or not self._is_regular(scheduler):
            self._forget(scheduler)
            return
        self._observed += 1
        if self._observed > PATIENCE:
            self._give_up(scheduler)
            return
        since = self._marks(scheduler)
        is_full = len(self._numbers) > MAX_STATES
        if since != self._since or self._environment.dependencies.read is not self._read or is_full:
            self._begin(since)
        self._observe(scheduler)
        if self._last is not None:
            self._has_waits = self._has_waits or len(self._last.dues) > 1
            scheduler.is_observed = self._has_waits
            self._skip(scheduler)

    def _is_regular(self, scheduler: Any) -> bool:
        """True if no handler is active or due, and nothing outside may act."""
        events, environment = self._events, self._environment
        return (
            not events.active
            and not events.pending
            and events.tick_event is not None
            and not scheduler.interrupts
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
        """Drop all states."""
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
        """Drop all states from before now."""
        environment = self._environment
        self._since, self._begun, self._last = since, environment.clock.now, None
        self._read = environment.dependencies.begin_longest()
        self._alive, self._numbers, self._known, self._periods = {}, {}, {}, {}
        self._alone, self._gaps, self._are_idle, self._polling, self._advance = {}, {}, [], [], None
        self._has_waits = False
        self._counters.forget()

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
            origin = self._origin(before.state, before.base, before.count, due, len(before.dues) == 1)
        path = None if origin is None else self._path(before, self._last, *origin)
        if origin is None or path is None or (origin[1] > before.count and self._counters.loops_count(steps)):
            return
        made = self._transition(before, self._last, origin[1], path, steps)
        if made is None:
            return
        node = self._known.setdefault(before.state, _Node())
        for due, statement in path:
            node = node.next.setdefault((due[1], statement - origin[1]), _Node())
        known = node.transition
        if known is not None and known.equals(made):
            known.is_proved = True
            return
        node.transition = made
        if len(path) == 1 and self._are_idle[before.state]:
            if origin[0] != before.base:
                self._alone[before.state, path[0][0][1]] = made
        elif len(path) == len(before.dues) == len(self._last.dues) == 1:
            due, statement = path[0]
            self._gaps.setdefault(before.state, {})[statement - origin[1]] = made
        is_tick = made.handler is not None
        advance = self._counters.steps_of_set(made.steps) if is_tick else []
        if known is not None or (is_tick and self._advance not in (None, advance)):
            self._known, self._alone, self._gaps, self._advance = {}, {}, {}, None
        elif is_tick:
            self._advance = advance
        made.is_proved = not any(advance)
        self._counters.record(steps)

    def _learn_period(
        self, before: _Checkpoint, steps: tuple[float, ...], base: float, first: float, last: float
    ) -> None:
        """Store the period of the only task that polls in a state, from `first` to `last`.

        It is not used if loops count, or if no other task is in a WAIT, since the task may then switch outputs.
        """
        statements, state, count = self._environment.statements, before.state, before.count
        is_used = self._polling[state] and len(before.dues) > 1 and base == before.base
        if not is_used or first < count or statements.at(last) > before.dues[0][0]:
            return
        known = self._periods.get(state, (INFINITY, 0.0))
        if self._counters.loops_count(steps):
            self._periods[state] = None
        elif known is not None and first - count < known[0]:
            self._periods[state] = first - count, last - first

    def _checkpoint(self, scheduler: Any) -> _Checkpoint | None:
        """Return the present state and its times; None if it cannot be compared."""
        environment, alive, events = self._environment, self._alive, self._events
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
            own, wait = task.state(alive), task.wait
            state += [own, task.priority, task.max_slice]
            if wait is None:
                polling.append(task.name)
            elif wait is task.delay:
                dues.append((wait.ends, index, wait.since))
                state.append(True)
            else:
                alive[id(wait)] = wait
                state += [id(wait), wait.ends or 0.0]
        self._counters.set(values)
        if None in state:
            return None
        key = tuple(state)
        number = self._numbers.get(key)
        if number is None:
            number = self._numbers[key] = len(self._numbers)
            self._are_idle.append(not polling)
            self._polling.append(polling[0] if len(polling) == 1 else "")
        statements = environment.statements
        dues.sort()
        lengths = list(map(len, self._streams))
        return _Checkpoint(number, statements.base, statements.count, dues, events.ticks, values, lengths)

    def _path(
        self, before: _Checkpoint, after: _Checkpoint, base: float, origin: float
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
            statement = _first(due, base, cost)
            if statement is None:
                return None
            path.append((due, statement))
        return path

    def _transition(
        self,
        before: _Checkpoint,
        after: _Checkpoint,
        origin: float,
        path: list[tuple[Due, float]],
        steps: tuple[float, ...],
    ) -> Transition | None:
        """Return the transition between two checkpoints; None if it cannot be repeated."""
        statements, cost_units, base = self._environment.statements, self._cost_units, after.base
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
        polls = self._polling[before.state]
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

    def _skip(self, scheduler: Any) -> None:
        """Skip transitions from the last checkpoint on, as far as they are known."""
        environment, last = self._environment, self._last
        assert last is not None
        if self._next(last.state, last.base, last.count, [*last.dues, _NO_DUE]) is None:
            return
        tasks = scheduler.tasks
        waits: list[Wait] = [
            task.wait for task in tasks if task.wait is not None and task.wait is not task.delay
        ]
        if any(wait.ends is None and (not wait.ignores_data or wait.ready()) for wait in waits):
            return
        dependencies, clock = environment.dependencies, environment.clock
        assert self._read is not None
        level = dependencies.until(self._begun - CLOSE, self._read) - CLOSE
        if level <= clock.now:
            self._observed += PATIENCE // 4
            self._begin(self._since)
            return
        dues = [wait.due() if wait.ends is None else wait.ends for wait in waits]
        event = self._events.tick_event
        assert event is not None
        other = clock.second_time() if clock.next_time() == event.time else clock.horizon
        end = min(level, other, scheduler.until, *dues) - MARGIN
        by_tick = len(last.dues) == 1 and not self._are_idle[last.state]
        walk = self._walk_ticks if by_tick else self._walk
        while self._last is not None and (walked := walk(self._last, end)) is not None:
            self._pass(walked, scheduler)

    def _origin(
        self, state: int, base: float, count: float, due: Due, by_tick: bool
    ) -> tuple[float, float] | None:
        """Return the base and statement from which a transition counts to `due`.

        None if rounding might decide. `by_tick`: no task is in a WAIT, so the distances to the tick are few.
        """
        cost = self._environment.statements.cost
        if self._are_idle[state]:
            now = base + count * cost
            if due[0] > now + APART:
                return due[0], 0.0
            return None if due[0] > now else (base, count)
        period = self._periods.get(state)
        if period is None or by_tick:
            return base, count
        begin, length = period
        statement = _first(due, base, cost)
        if statement is None:
            return None
        return base, count + max(0.0, (statement - count - begin) // length * length)

    def _next(
        self, state: int, base: float, count: float, dues: list[Due]
    ) -> tuple[Transition, float, float, int] | None:
        """Return the transition that comes next, None if it is not known.

        The result has its base and its origin, and how many of the ticks and ends are in its path.
        """
        node, cost = self._known.get(state), self._environment.statements.cost
        if node is None:
            return None
        origin, step, depth, first = count, node.transition, 0, 0.0
        if step is None or dues[0][0] <= base + (count + step.length) * cost + APART:
            found = self._origin(state, base, count, dues[0], len(dues) == 2)
            if found is None:
                return None
            (base, origin), step = found, None
        while step is None or dues[depth][0] <= base + (origin + step.length) * cost + APART:
            due = dues[depth]
            statement = _first(due, base, cost)
            node = None if statement is None else node.next.get((due[1], statement - origin))
            if statement is None or node is None:
                return None
            first = first or statement - origin
            step, depth = node.transition, depth + 1
        offsets = [offset for offset, _ in step.switches[:1]] + [offset for _, offset, _ in step.waits]
        if origin > count and offsets and min(offsets) < first:
            return None  # that happens before the iterations that are left out
        return step, base, origin, depth

    def _walk(self, own: _Checkpoint, end: float) -> _Walk | None:
        """Return the next transitions before `end`, and the checkpoint after them.

        The transitions end with the last one that leads to the present state; None if there is none.
        """
        alone, cost, cost_units = self._alone, self._environment.statements.cost, self._cost_units
        started, period = self._events.started, self._events.timer / 1000.0
        state, base, count, number = own.state, own.base, own.count, own.number
        dues, most = [*own.dues, _NO_DUE], min(MAX_WALK, self._counters.most_recorded(own.values))
        walk = _Walk()
        steps = walk.steps
        while len(steps) < most:
            moment, index, _ = dues[0]
            step = alone.get((state, index))
            if (
                step is not None
                and moment > base + count * cost + APART
                and dues[1][0] > moment + step.length * cost + APART
            ):
                base, origin = moment, 0.0
                del dues[0]
                if step.state == state and step.is_proved and not step.switches:
                    # It repeats up to another tick or end. The last repetitions are left to single steps.
                    length = step.waits[0][2] / UNITS if step.waits else period
                    left = min(dues[0][0], end) - step.length * cost - APART - moment
                    times = min(int(left / length) - 1, most - len(steps) - 1)
                    if times > 0:
                        steps += [step] * times
                        if index == TICK:
                            number += times
                            base = started + number * period
                        else:
                            base = (units(moment) + times * step.waits[0][2]) / UNITS
            else:
                known = self._next(state, base, count, dues)
                if known is None:
                    break
                step, since, origin, depth = known
                if origin > count and since == base:
                    walk.polling.append((len(steps), self._polling[state], origin - count))
                base = since
                passed = dues[:depth]
                del dues[:depth]
                for due in passed:
                    if due[1] in step.open:
                        insort(dues, due)
            count = origin + step.length
            if not step.is_proved or base + count * cost >= end:
                break
            if step.switches:
                walk.switching.append((len(steps), base, origin))
            steps.append(step)
            for task, offset, wait_units in step.waits:
                time = (units(base) + int(origin) * cost_units + wait_units) / UNITS
                insort(dues, (time, task, base + (origin + offset) * cost))
            if step.handler is not None:
                number += 1
                insort(dues, (started + number * period, TICK, 0.0))
            state = step.state
            if state == own.state:
                walk.good, walk.reached = len(steps), (base, count, dues[:-1], number)
        return walk if walk.good else None

    def _walk_ticks(self, own: _Checkpoint, end: float) -> _Walk | None:
        """Return the same as `_walk` while no task is in a WAIT.

        It takes less time for each tick.
        """
        known, statements = self._gaps, self._environment.statements
        base, cost, started, period = (
            statements.base,
            statements.cost,
            self._events.started,
            self._events.timer / 1000.0,
        )
        count, number, last = own.count, own.number, statements.first(end)
        present = own.state
        gaps = known.get(present)
        most = min(MAX_WALK, self._counters.most_recorded(own.values))
        if gaps is None:
            return None
        walk = _Walk()
        steps, switching = walk.steps, walk.switching
        good, ratio = count, float(round(period / cost))
        first = statements.first(own.dues[0][0]) - ratio
        for each in range(number, number + most):
            # The same statement as that of `StatementTime.first`, without a division: a tick is at most one statement
            # off the whole number of them in a period.
            moment = started + each * period
            first += ratio
            if base + first * cost < moment:
                first += 1.0
            elif base + (first - 1.0) * cost >= moment:
                first -= 1.0
            step = gaps.get(first - count)
            if step is None or not step.is_proved:
                break
            if step.switches:
                switching.append((len(steps), base, count))
            count += step.length
            if count >= last:
                break
            steps.append(step)
            state = step.state
            if state == present:
                walk.good, good = len(steps), count
            gaps = known.get(state, _NO_GAPS)
        if not walk.good:
            return None
        number += walk.good
        walk.reached = base, good, [(started + number * period, TICK, 0.0)], number
        return walk

    def _pass(self, walk: _Walk, scheduler: Any) -> None:
        """Let the transitions of a walk pass."""
        events, environment, log = self._events, self._environment, self._log
        clock, statements, tasks = environment.clock, environment.statements, scheduler.tasks
        last, steps = self._last, walk.steps[: walk.good]
        assert events.tick_event is not None
        assert last is not None
        since, cost = clock.now, statements.cost
        handlers = [step.handler for step in steps if step.handler is not None]
        self._log_handlers(handlers)
        log.outputs.extend(
            [
                (base + (origin + offset) * cost, *rest)
                for each, base, origin in walk.switching
                if each < walk.good
                for offset, rest in steps[each].switches
            ]
        )
        if handlers:
            clock.reach(events.tick_event)
            events.schedule_tick(events.ticks + len(handlers))
        values = last.values
        for step, times in Counter(steps).items():
            if step.steps:
                values = tuple([n + times * m for n, m in zip(values, step.steps, strict=True)])
        self._counters.set(values)
        after = _Checkpoint(last.state, *walk.reached, values)
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
            self._log_slices(walk, since, clock.now)
        self._since = self._marks(scheduler)
        after.lengths, self._last = list(map(len, self._streams)), after
        self._observed = max(self._observed - len(steps), 0)
        if not self._observed:
            self._back_off = 1

    def _log_handlers(self, handlers: list[tuple[object, ...]]) -> None:
        """Log a record for each of the next ticks.

        Many equal ones in a row become a template.
        """
        events, stream = self._events, self._log.events
        started, period, number = events.started, events.timer / 1000.0, events.ticks
        rows: list[tuple[object, ...]] = []
        for handler, group in groupby(handlers):
            past = number + len(list(group))
            if past - number < MIN_TEMPLATE:
                rows += [(started + each * period, *handler) for each in range(number, past)]
            else:
                stream.extend(rows)
                rows = []
                pace = started, number, period, self._environment.statements.cost
                stream.repeat(([(0, (0.0,), handler)], past - number, 1, 0.0), pace)
            number = past
        stream.extend(rows)

    def _log_slices(self, walk: _Walk, since: float, until: float) -> None:
        """Log the time slices of several tasks as one record."""
        seconds: dict[str, float] = {}
        for step, times in Counter(walk.steps[: walk.good]).items():
            for task, each in step.seconds.items():
                seconds[task] = seconds.get(task, 0.0) + times * each
        for number, task, count in walk.polling:
            if number < walk.good:
                seconds[task] = seconds.get(task, 0.0) + count * self._environment.statements.cost
        if seconds:
            self._log.slices.add((since, until, tuple(seconds), tuple(seconds.values())))


def _first(due: Due, base: float, cost: float) -> float | None:
    """Return the first statement that comes after a tick or the end of a WAIT.

    None if rounding might decide. The scheduler regards a WAIT as over slightly early.
    """
    moment = due[0]
    if due[1] == TICK:
        count = float(ceil((moment - base) / cost))
        if base + count * cost < moment:
            return count + 1.0
        return count - 1.0 if base + (count - 1.0) * cost >= moment else count
    # A statement this much before the end comes after it.
    nearest = float(round((moment - base) / cost))
    distance = base + nearest * cost - moment
    if -0.1 * ROUNDING < distance < 0.1 * ROUNDING:
        return nearest
    if -APART < distance < APART:
        return None
    return nearest if distance > 0.0 else nearest + 1.0
