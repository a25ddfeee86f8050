"""Skipping of TIMER ticks while tasks poll, along transitions executed before.

Replaces: polling up to each tick, the handler, and the switch back, where all of them do what they did before.

Hook: `TimerTicks.handled`, which `TimeSlices` calls as a handler has ended.

Gain: 10² times (`field_timer_while_polling` of benchmarks/cliffs.py).

Equality is tested by: tests/fast/test_polled_ticks.py, tests/generated/test_polls.py with generated programs.

Problem. A task that polls is interrupted by each tick, so neither its own iterations nor those of several tasks
can be skipped further than that. Executed, a tick with some polling takes 30 to 60 µs.

Idea. The joint state after a handler is the position and the local variables of each task, the variables that
they share, the outputs, the waits and the task that comes next. While no reading changes and no other event
happens, this state and the number of statements up to the next tick decide everything up to the end of the next
handler. So each tick executed is a transition, from a state and a number of statements to another state.

    state 0 ──98 statements──> state 1 ──98──> state 0 ──99──> state 2 ──97──> state 0

Times of statements and of ticks are products that round differently. If a tick coincides with a statement, the
last bit decides if that statement comes first, in no simple pattern. So the number of statements up to each tick is
computed by the same expression as in the run, and the walk along known transitions is exact. It ends before a
transition that is not known, a change of a reading, another event or the end of a wait, and where a counter
reaches a level. The tasks can only continue in the state that they are in, so ticks are skipped up to the last one
that leads to that state.

Data. `_numbers` has the states by their contents, `_known` the transitions. They are valid since `_begun`, and
`_read` has the dependencies of all tasks since then (`Dependencies.longest`).

Invariants.
- A transition is recorded only if nothing has happened but the tick, polling, and switches of outputs. `_marks` has
  what must not change meanwhile, and only `_streams` may have new records.
- Counters of the handler (`handler_counters.py`) are no part of a state, unless a loop that may poll uses them.
  All transitions advance them equally, and while they do, each stays on one side of its constants. If the handler
  also sets one that has advanced, a transition must have been executed twice.
- Records of skipped ticks are those of the run to the last bit, except that the time slices of several tasks
  become one record.

Cost. A state takes some 10 µs a task, and a tick of the walk 0.3 µs. Exponential back-off: if `PATIENCE` ticks
have not led to a skip, 1, 2, 4, … ticks are executed without a search.
"""

from __future__ import annotations

from collections import Counter
from itertools import groupby
from operator import attrgetter

from motionlang.fast.handler_counters import HandlerCounters
from motionlang.lang.dependencies import CLOSE
from motionlang.log.repeated import rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.lang.waits import Wait
    from motionlang.log.stream import Stream
    from motionlang.mint.runtime.events import Events

# Ticks that are observed without a skip before the search is left out, and the most that are executed then.
PATIENCE, MAX_BACK_OFF = 16, 512
# The most ticks of a walk, the fewest with equal records that become a template, and the most switches of a tick.
MAX_WALK, MIN_TEMPLATE, MAX_ROWS = 4096, 16, 64
# A walk ends this long, s, before anything else happens.
MARGIN = 2 * CLOSE
# The transitions of a state from which none is known.
_NONE_KNOWN: dict[float, Transition] = {}
_HANDLER_OF: Callable[[Transition], Any] = attrgetter("handler")


class Transition:
    """The effects from the end of one handler to the end of the next one.

    `after` are the statements from the tick to the end of its handler, `state` the state there. `handler` is
    the rest of the record of the handler, and `switches` are those of outputs, each with the statements since the
    tick. `seconds` is how long each task has computed. `is_proved` is false until it may be repeated.
    """

    __slots__ = ("after", "handler", "is_proved", "seconds", "state", "switches")

    def __init__(
        self,
        state: int,
        after: float,
        handler: tuple[object, ...],
        switches: tuple[tuple[float, tuple[object, ...]], ...],
        seconds: dict[str, float],
    ) -> None:
        self.state, self.after, self.handler, self.switches = state, after, handler, switches
        self.seconds = seconds
        self.is_proved = False

    def equals(self, other: Transition) -> bool:
        """True if it has the same effects, in whatever time slices."""
        own = self.state, self.after, self.handler, self.switches
        return own == (other.state, other.after, other.handler, other.switches)


class PolledTicks:
    """The states of a program after its TIMER handler, and their transitions."""

    def __init__(self, events: Events, kind: str) -> None:
        self._events, self._environment = events, events.environment
        self._counters = HandlerCounters(events, kind, beside_loops=True)
        self._log = log = events.environment.machine.log
        self._streams: tuple[Stream[Any], ...] = log.events, log.outputs, log.slices
        self._others = [stream for stream in log.streams() if stream not in self._streams]
        # What no tick may change, the time since which it has not changed, and the readings since then.
        self._since: tuple[object, ...] = ()
        self._begun = 0.0
        self._read: set[Note] | None = None
        self._alive: dict[int, object] = {}
        self._numbers: dict[object, int] = {}
        self._known: dict[int, dict[float, Transition]] = {}
        # How far each transition advances the counters, None before the first one.
        self._advance: list[float] | None = None
        # After the last handler: the state, None without one, the statement, the counters and the lengths of the
        # streams.
        self._state: int | None = None
        self._count = 0.0
        self._values: tuple[float, ...] = ()
        self._lengths: list[int] = []
        # The ticks observed since the last skip, those left to execute without a search, and their next number.
        self._observed = self._left = 0
        self._back_off = 1

    def handled(self, scheduler: Any) -> None:
        """Skip ticks after a handler of the timer, if the following ones are known."""
        if self._left:
            self._left -= 1
            return
        waits = [task.wait for task in scheduler.tasks if task.wait is not None]
        if len(waits) == len(scheduler.tasks) or not self._is_regular(scheduler):
            self._forget()
            return
        self._observed += 1
        if self._observed > PATIENCE:
            self._give_up()
            return
        since = self._marks(scheduler)
        if since != self._since or self._environment.dependencies.read is not self._read:
            self._begin(since)
        self._observe(scheduler)
        if self._state is not None:
            self._skip(scheduler, waits)

    def _is_regular(self, scheduler: Any) -> bool:
        """True if no handler is active or due, and nothing outside may act."""
        events, environment = self._events, self._environment
        return (
            not events.active
            and not events.pending
            and not scheduler.interrupts
            and scheduler.by_itself
            and not any(task.busy for task in scheduler.tasks)
            and environment.machine.hook is None
            and not environment.machine.assumptions
            and environment.statements.reached == environment.clock.now
            and not environment.controller.outputs.listeners
        )

    def _marks(self, scheduler: Any) -> tuple[object, ...]:
        """Return what must not change, except by the ticks themselves."""
        events, environment = self._events, self._environment
        ticks = events.ticks
        return (
            environment.clock.fired - 2 * ticks,
            environment.acts - environment.switches - ticks,
            environment.copies,
            environment.midways,
            environment.statements.base,
            events.started,
            events.timer,
            len(scheduler.tasks),
            *self._counters.sides(),
            *map(len, self._others),
        )

    def _forget(self) -> None:
        """Drop all states."""
        if self._read is not None:
            self._environment.dependencies.end_longest(self._read)
            self._read = None
        self._since, self._state = (), None

    def _give_up(self) -> None:
        """Execute some ticks without a search."""
        self._forget()
        self._observed = 0
        self._left, self._back_off = self._back_off, min(2 * self._back_off, MAX_BACK_OFF)

    def _begin(self, since: tuple[object, ...]) -> None:
        """Drop all states from before now."""
        environment = self._environment
        self._since, self._begun, self._state = since, environment.clock.now, None
        self._read = environment.dependencies.begin_longest()
        self._alive, self._numbers, self._known, self._advance = {}, {}, {}, None

    def _observe(self, scheduler: Any) -> None:
        """Record the state after a handler, and the transition to it."""
        statements, events = self._environment.statements, self._events
        before, self._state = self._state, self._joint_state(scheduler)
        count, values, lengths = self._count, self._values, self._lengths
        self._mark()
        if before is None or self._state is None:
            return
        first = statements.first(events.tick_time(events.ticks - 1))
        advance = [n - m for n, m in zip(self._values, values, strict=True)]
        made = self._transition(first, lengths)
        known = self._known.get(before, {}).get(first - count)
        if made is None or self._advance not in (None, advance) or (known and not known.equals(made)):
            self._known, self._advance = {}, None
        elif known is None:
            self._known.setdefault(before, {})[first - count], self._advance = made, advance
            made.is_proved = self._counters.is_proved(advance)
        else:
            known.is_proved = True

    def _mark(self) -> None:
        """Remember the statement, the counters and the lengths of the streams."""
        self._count, self._values = self._environment.statements.count, self._counters.values()
        self._lengths = list(map(len, self._streams))

    def _joint_state(self, scheduler: Any) -> int | None:
        """Return the number of the joint state; None if it cannot be compared."""
        environment, alive = self._environment, self._alive
        state: list[object] = [
            scheduler.next_index,
            environment.controller.outputs.values,
            self._counters.other_variables(alive),
        ]
        for task in scheduler.tasks:
            own, wait = task.state(alive), task.wait
            if own is None:
                return None
            state += [own, task.priority, task.max_slice]
            if wait is not None:
                alive[id(wait)] = wait
                state += [id(wait), wait.ends]
        return self._numbers.setdefault(tuple(state), len(self._numbers))

    def _transition(self, first: float, lengths: list[int]) -> Transition | None:
        """Return the transition since the last handler.

        None if its records cannot be repeated. `first` is the first statement that is not before the tick, `lengths`
        are those of the streams by then.
        """
        statements, state = self._environment.statements, self._state
        handlers, outputs, slices = (
            stream[length:] for stream, length in zip(self._streams, lengths, strict=True)
        )
        rows = rows_of(outputs, 0, statements.base, statements.cost)
        if len(handlers) != 1 or rows is None or len(rows) > MAX_ROWS or state is None:
            return None
        seconds: dict[str, float] = {}
        for *_, tasks, taken in slices:
            for task, each in zip(tasks, taken, strict=True):
                seconds[task] = seconds.get(task, 0.0) + each
        switches = tuple([(count - first, rest) for _, (count,), rest in rows])
        return Transition(state, statements.count - first, tuple(handlers[0][1:]), switches, seconds)

    def _skip(self, scheduler: Any, waits: list[Wait]) -> None:
        """Skip ticks from the present state on, as far as they are known."""
        environment = self._environment
        first = environment.statements.first(self._events.tick_time(self._events.ticks))
        if first - self._count not in self._known.get(self._state, ()):  # type: ignore[arg-type]
            return
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
        end = min(level, clock.second_time(), scheduler.until, *dues) - MARGIN
        steps, firsts = self._walk(end, MAX_WALK)
        while steps and self._pass(steps, firsts, scheduler):
            steps, firsts = self._walk(end, MAX_WALK)

    def _walk(self, end: float, most: int) -> tuple[list[Transition], list[float]]:
        """Return the transitions of the next ticks whose handlers are over before `end`.

        The second list has the first statement that is not before each tick. Both end with the last tick that
        leads to the present state.
        """
        events, known, statements = self._events, self._known, self._environment.statements
        base, cost, started, period = statements.base, statements.cost, events.started, events.timer / 1000.0
        own, count, last = self._state, self._count, statements.first(end)
        if any(self._advance or ()):
            most = int(min(most, self._counters.most(self._advance or ())))
        assert own is not None
        gaps = known[own]
        steps: list[Transition] = []
        firsts: list[float] = []
        good, ratio = 0, float(round(period / cost))
        first = statements.first(events.tick_time(events.ticks)) - ratio
        for number in range(events.ticks, events.ticks + most):
            # The same statement as that of `StatementTime.first`, mostly found without a division.
            moment = started + number * period
            first += ratio
            if base + first * cost < moment:
                first += 1.0
            elif base + (first - 1.0) * cost >= moment:
                first -= 1.0
            if not base + (first - 1.0) * cost < moment <= base + first * cost:
                first = statements.first(moment)
            step = gaps.get(first - count)
            if step is None or not step.is_proved:
                break
            count = first + step.after
            if count >= last:
                break
            steps.append(step)
            firsts.append(first)
            if step.state == own:
                good = len(steps)
            gaps = known.get(step.state, _NONE_KNOWN)
        return steps[:good], firsts[:good]

    def _pass(self, steps: list[Transition], firsts: list[float], scheduler: Any) -> bool:
        """Let the ticks of a walk pass; False if that is impossible."""
        events, environment, log = self._events, self._environment, self._log
        clock, statements = environment.clock, environment.statements
        assert events.tick_event is not None
        since = clock.now
        if not clock.reach(events.tick_event):
            return False
        base, cost, number = statements.base, statements.cost, events.ticks
        for handler, group in groupby(steps, _HANDLER_OF):
            past = number + len(list(group))
            self._log_handlers(range(number, past), handler)
            number = past
        log.outputs.extend(
            [
                (base + (first + offset) * cost, *rest)
                for first, step in zip(firsts, steps, strict=True)
                for offset, rest in step.switches
            ]
        )
        events.schedule_tick(number)
        clock.now = statements.leave(firsts[-1] + steps[-1].after)
        clock.leaps += 1
        environment.fired = clock.fired
        self._counters.advance(self._advance or (), len(steps))
        if len(scheduler.tasks) > 1:
            self._log_slices(steps, since, clock.now)
        self._since = self._marks(scheduler)
        self._mark()
        self._observed, self._back_off = 0, 1
        return True

    def _log_handlers(self, numbers: range, handler: tuple[object, ...]) -> None:
        """Log the same record at several ticks in a row."""
        events, stream = self._events, self._log.events
        if len(numbers) < MIN_TEMPLATE:
            stream.extend([(events.tick_time(number), *handler) for number in numbers])
            return
        pace = events.started, numbers[0], events.timer / 1000.0, self._environment.statements.cost
        stream.repeat(([(0, (0.0,), handler)], len(numbers), 1, 0.0), pace)

    def _log_slices(self, steps: list[Transition], since: float, until: float) -> None:
        """Log the time slices of several tasks as one record."""
        seconds: dict[str, float] = {}
        for step, times in Counter(steps).items():
            for task, each in step.seconds.items():
                seconds[task] = seconds.get(task, 0.0) + times * each
        self._log.slices.add((since, until, tuple(seconds), tuple(seconds.values())))
