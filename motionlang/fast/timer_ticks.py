"""Ticks of TIMER while all tasks wait: run without the scheduler, then skipped.

Replaces: the path of a tick through `Clock.advance`, `Events.raise_`, `Events.deliver` and the scheduler, and
running the handler where it does what it did before.

Hook: `Scheduler.timer_set`, by which `TimeSlices` creates it; it calls `run` before it jumps.

Gain: a handler that computes 2.5 times (`filter_timer_1` of benchmarks/cliffs.py), one that counts or toggles
10² to 10⁴ times (`handlers_timer_1_toggles`).

Held equal by: tests/fast/test_timer_ticks.py, tests/generated/test_handlers.py with generated programs.

Running. A tick is taken here if it is the next event, nothing else is at its time, and no handler is active
or pending. The handler is one task object, started again. If it does more than run to its end within a time
slice, or ends a wait, the scheduler continues from there.

Skipping. The state before a tick is the variables that functions share and the outputs. While everything
that the handler has read stays the same (`Dependencies`), no other event is due and no wait ends, a state that
recurs after some ticks proves that these repeat. Two kinds of change are allowed for:

* Output switches. They are in the log, and its new records become a template (`log/repeated.py`).
* Counters. The compiler names the variables that a handler only counts, sets to constants and compares with
  constants. One that has advanced equally in two periods has been counted, and advances by that amount each time,
  up to the next of these constants (`loop_counters.py`).

Any other action (`Environment.acts`), and any record other than a switch and those of the handler itself, ends the
search. Exponential back-off: after it has failed, 1, 2, 4, … ticks run without one.
"""

from __future__ import annotations

from math import floor

from motionlang.controller.clock import INFINITY
from motionlang.fast.handler_counters import HandlerCounters
from motionlang.lang.waits import ROUNDING, Condition
from motionlang.log.repeated import rows_of
from motionlang.mint.keywords.event_kinds import KINDS
from motionlang.mint.runtime.events import EventTask
from motionlang.mint.runtime.waits import Rest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.fast.polled_ticks import PolledTicks
    from motionlang.lang.dependencies import Note
    from motionlang.lang.task import Task
    from motionlang.log.repeated import Row
    from motionlang.log.stream import Stream
    from motionlang.mint.runtime.events import Events

TIMER = "timer"
ENTRY = KINDS.index(TIMER), 0
# A period of more ticks is not found, nor one with more records.
MAX_PERIOD, MAX_ROWS = 64, 256
MAX_BACK_OFF = 4096
# During a shorter WAIT, s, ticks are left to `polled_ticks.py`.
SHORT_WAIT = 0.06
# Ticks closer to the end of a skip than this, s, are executed.
MARGIN = 1e-6
# The levels of readings that only a loop may use.
_OF_LOOPS = (-INFINITY, INFINITY)


class TimerTicks:
    """The ticks of one program's timer, run and skipped."""

    def __init__(self, events: Events) -> None:
        self._events, self._environment = events, events.environment
        self._event = events.tick_event
        self._log = events.environment.machine.log
        self._task: EventTask | None = None
        self._search: _Search | None = None
        # The ticks until the next search, and the number of them after the next failure.
        self._left = self._back_off = 0
        self._polled: PolledTicks | None = None

    def left(self, scheduler: Any, task: Task) -> None:
        """Skip ticks after a handler has ended, or a task has begun a WAIT, if tasks poll."""
        if self._event is not self._events.tick_event:
            scheduler.is_observed = False
            return
        by_tick = task.done and task.__class__ is EventTask and task.name == TIMER
        if not by_tick and (not scheduler.is_observed or task.wait is None or task.wait.cause != "time"):
            return
        polls = any(each.wait is None for each in scheduler.tasks) or _is_short(scheduler)
        if self._polled is not None:
            self._polled.reached(scheduler, by_tick, polls)
        elif polls:
            from motionlang.fast.polled_ticks import PolledTicks

            self._polled = PolledTicks(self._events, TIMER)

    def run(self, scheduler: Any, due: float, until: float) -> bool:
        """Run ticks from `due` on while all tasks wait; False if that is impossible."""
        events, environment = self._events, self._environment
        event, clock = self._event, environment.clock
        if (
            event is None
            or event.time != due
            or event is not events.tick_event
            or not due < until
            or events.active
            or events.pending
            or events.disabled >> ENTRY[0] & 1
            or not events.handles(TIMER)
            or environment.machine.hook is not None
            or environment.machine.assumptions
        ):
            return False
        if (self._polled is None or self._polled.is_searching) and _is_short(scheduler):
            return False
        waits = [task.wait for task in scheduler.tasks]
        ends = (wait.solved if wait.__class__ is Condition else wait.ends or INFINITY for wait in waits)
        if min(ends) <= due:
            return False
        # Up to then only an event other than a tick can end a wait, unless the handler acts.
        quiet = min(map(_quiet_until, waits))
        resting = [task for task in scheduler.tasks if task.wait.ends is None]
        self._search = None
        at = scheduler.where()
        ran = False
        while clock.reach(event):
            if not self._tick(scheduler, clock.now, until, at) or quiet <= clock.now:
                return True
            if not ran:
                ran = True
                if resting:  # the last one that the scheduler would have checked
                    scheduler.current = resting[-1]
                at = scheduler.where()
            elif resting:
                scheduler.current = resting[-1]
            if self._left:
                self._left -= 1
            elif self._search is None:
                self._search = _Search(self._events)
            elif not self._skipped(min(quiet, until)):
                self._fail()
            if not event.time < quiet or not event.time < until:
                break
        return ran

    def _tick(self, scheduler: Any, now: float, until: float, at: int) -> bool:
        """Run the handler; True if it has ended, and has not acted except on outputs."""
        events, environment, clock = self._events, self._environment, self._environment.clock
        task, search = self._task, self._search
        events.schedule_tick(events.ticks + 1)
        clock.fired = fired = clock.fired + 1  # the delivery, which is an event without this
        self._log.events.add((now, "handler", None, None, None, at, 0, TIMER))
        if task is None:
            task = self._task = EventTask(TIMER, events.handler(TIMER), environment)
        else:
            task._generator, task.done, task.axes = None, False, (0,)
            task.poll_check = None
        task.notes = None if search is None else search.notes
        events.active.append(ENTRY)
        acts, switches = environment.acts, environment.switches
        if not scheduler.ran_handler(task, until):
            self._task = None  # it may be in use
            return False
        if events.pending or clock.fired != fired or events.tick_event is not self._event:
            return False
        if search is not None and task.notes is not search.notes:
            self._fail()
        acted = environment.acts - acts - 1
        return acted == 0 or (
            acted == environment.switches - switches and not environment.controller.outputs.listeners
        )

    def _fail(self) -> None:
        """Give up a search; the next one is after twice as many ticks."""
        self._search = None
        self._left, self._back_off = self._back_off, min(2 * self._back_off or 1, MAX_BACK_OFF)

    def _skipped(self, end: float) -> bool:
        """Skip periods that fit before `end`; False if the search has failed."""
        search, environment = self._search, self._environment
        assert search is not None
        period = search.period()
        if period is None:
            return len(search.marks) <= MAX_PERIOD
        since = search.times[0]
        level = (
            environment.dependencies.stable_until(search.notes, 0, since) if search.is_solvable else -INFINITY
        )
        self._search = None
        if level <= environment.clock.now:
            return False
        count = search.fitting(period, min(end, level))
        if count > 0:
            rows = search.rows(period)
            if rows is None:
                return False
            search.skip(period, count, rows)
            self._left = self._back_off = 0
        return True


class _Search:
    """The states after ticks of a handler since a search began.

    `marks` are, after each tick, the lengths of the streams and the values of the counters; `times` are the
    times of the ticks and `ends` those at which the handler ended.
    """

    def __init__(self, events: Events) -> None:
        self._events, self._environment = events, events.environment
        environment = events.environment
        self._log = environment.machine.log
        self.notes: list[Note] = []
        self._counters = HandlerCounters(events, TIMER)
        self._others = [stream for stream in self._log.streams() if stream not in self._streams]
        self._lengths = list(map(len, self._others))
        self.marks: list[tuple[Any, ...]] = []
        self.times: list[float] = []
        self.ends: list[float] = []
        self._met: dict[object, int] = {}
        self.period()

    @property
    def _streams(self) -> tuple[Stream[Any], ...]:
        """The streams in which a handler that is skipped may write."""
        return self._log.events, self._log.outputs, self._log.slices

    @property
    def is_solvable(self) -> bool:
        """False if a reading was recorded for a loop, which executes its last iteration."""
        return not any(about[-1:] and about[-1] in _OF_LOOPS for _, about in self.notes)

    def period(self) -> int | None:
        """Record the state after a tick; return the number of ticks since it was the same."""
        environment, events = self._environment, self._events
        values = self._counters.hide()
        state = environment.state({}), environment.controller.outputs.values
        self._counters.set(values)
        number = len(self.marks)
        self.marks.append((tuple(map(len, self._streams)), self._counters.values()))
        self.times.append(events.tick_time(events.ticks - 1))
        self.ends.append(environment.clock.now)
        before = self._met.get(state)
        self._met[state] = number
        if before is None or self._advanced(number, number - before) is None:
            return None
        return number - before

    def _advanced(self, number: int, period: int) -> list[float] | None:
        """Return how far counters advance in a period; None if not twice in a row."""
        after, between = self.marks[number][1], self.marks[number - period][1]
        steps = [n - m for n, m in zip(after, between, strict=True)]
        if any(steps):
            first = number - 2 * period
            if first < 0 or [m - n for m, n in zip(between, self.marks[first][1], strict=True)] != steps:
                return None
        return steps

    def fitting(self, period: int, end: float) -> int:
        """Return how many periods fit before `end` and the next other event."""
        events, clock = self._events, self._environment.clock
        lasts = max(now - time for now, time in zip(self.ends[-period:], self.times[-period:], strict=True))
        end = min(end, clock.second_time()) - lasts - MARGIN
        ticks = floor((end - events.started) / (events.timer / 1000.0)) - events.ticks
        steps = self._advanced(len(self.marks) - 1, period)
        assert steps is not None
        return int(min(ticks // period, self._counters.most(steps)))

    def rows(self, period: int) -> list[list[Row]] | None:
        """Return the rows of a period for each stream; None if they cannot be repeated."""
        if list(map(len, self._others)) != self._lengths:
            return None
        cost = self._environment.statements.cost
        made: list[list[Row]] = []
        for index, stream in enumerate(self._streams):
            rows: list[Row] = []
            for tick in range(period):
                number = len(self.marks) - period + tick
                first, past = (self.marks[each][0][index] for each in (number - 1, number))
                found = rows_of(stream[first:past], tick, self.times[number], cost)
                if found is None or len(rows) > MAX_ROWS:
                    return None
                rows += found
            made.append(rows)
        return made

    def skip(self, period: int, count: int, rows: list[list[Row]]) -> None:
        """Let `count` periods pass after the last tick."""
        events, environment = self._events, self._environment
        clock, statements = environment.clock, environment.statements
        pace = events.started, events.ticks, events.timer / 1000.0, statements.cost
        for stream, each in zip(self._streams, rows, strict=True):
            stream.repeat((each, count, period, 0.0), pace)
        before, after = self.marks[-period - 1][1], self.marks[-1][1]
        self._counters.advance([n - m for m, n in zip(before, after, strict=True)], count)
        assert events.tick_event is not None
        clock.reach(events.tick_event)
        last = events.ticks + count * period - 1
        events.schedule_tick(last + 1)
        statements.base = events.tick_time(last)
        clock.now = statements.leave(statements.count)
        environment.fired = clock.fired


def _is_short(scheduler: Any) -> bool:
    """True if a task is in a WAIT too short for a search of its own."""
    waits = [task.wait for task in scheduler.tasks if task.wait is not None and task.wait is task.delay]
    return any(wait.ends - wait.since < SHORT_WAIT for wait in waits)


def _quiet_until(wait: Any) -> float:
    """Return the time up to which only an event or an action can end a wait."""
    if wait.ends is not None:
        return float(wait.ends) - ROUNDING
    if wait.__class__ is Condition:
        return INFINITY if wait.ignores_data and wait.solved == INFINITY else -INFINITY
    return INFINITY if wait.__class__ is Rest and wait.due() == INFINITY else -INFINITY
