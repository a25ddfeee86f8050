"""The entries of a machine file by which the world answers when the program asks (`asked = 0.3`).

Problem. A person, a host or an unknown sensor acts because the program waits for it, not at a time. An entry with a
time therefore hides how fast a program is, and breaks as soon as the program becomes faster.

Idea. The program asks for a value while a task waits for it, or reads it again and again at one statement (`Query`),
always with the same result, and no axis that this task has started moves. `asked` seconds after the first of these
reads the entry acts, if the task still asks.

Data. A `Responder` belongs to one value, such as an input. It has the entries of that value, in the order of the file,
a query for each task that waits for it, and one for each task and statement that polls it. The first entry that is not
used up and fits acts.

Which level. A digital input changes to its other level if that ends the wait, or changes the result of the condition
that polls it. Of several inputs in the condition, the smallest sets of changes that do so count (`_inputs_that_end`).
If there are none, or it cannot be known, it changes to its other level. If another task has asked for longer and needs
the present level, the change is made once that one no longer asks.

Invariants.
- A query ends when its value changes, whatever changes it, and begins anew when another input has changed the result
  of its condition. So a rule never acts earlier than its time after the last change, and a statement that is passed
  once between two changes does not poll.
- Nothing polls: a query schedules one event of the clock, when its asking is known, and reads find out the rest. A
  further read of a wait costs no more than two lookups.
- An event is scheduled before a loop can be skipped. Iterations that are skipped count as reads (`skipped`).
- `Asking` is one of the observers of what the program reads (`reads.py`), and is made with the first such entry. A
  read of a value without one costs a lookup, and nothing on a machine without such entries.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from itertools import combinations
from typing import TYPE_CHECKING, Any, Protocol

from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.io.stimuli import Entry, Stimulus
from motionlang.kernel.log.records import Event
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.controller.io.channels import Channels
    from motionlang.kernel.controller.state import ControllerState

# A task that polls reads again within this time, s.
MAX_GAP = 1.2
# A statement that reads so often, with the same result, polls; the event is scheduled at the second read.
MIN_READS, MIN_SCHEDULED = 3, 2
# Of so many queries that poll for a value, those of tasks that have ended are dropped.
MANY = 8
# A condition of more inputs, or one that needs more changes at once, is not analysed.
MAX_INPUTS, MAX_CHANGES = 8, 3
# The device of each table with channels, and the key of its number.
DRIVEN = {
    "input": ("input", "channel"),
    "analogue": ("analogue input", "channel"),
}


class AskingTasks(Protocol):
    """The tasks of the program: the scheduler."""

    current: Any

    def wait_of(self, task: Any) -> Any:
        """Return the wait of a task, None if it runs."""


@dataclass(slots=True, eq=False)
class AskedRule:
    """An entry that acts when asked; `stimulus` counts how often it has."""

    stimulus: Stimulus
    delay: float
    begin: float
    times: float
    # The only value to which it changes; None for any.
    level: object
    # How long the change lasts, s, and until when the present one does.
    length: float
    until: float = -INFINITY

    def may_act(self, now: float) -> bool:
        """True if it is not used up, and its last change is over."""
        return self.stimulus.count < self.times and now >= self.until


class Query:
    """A task that waits for a value, or reads it at a statement, since a time, with one result.

    `wait` is what it waits for, None if it polls, and `condition` what it tests then. `stack` is the statement after
    those of its callers, of a task that polls.
    """

    # Of a task that polls: how many reads there were, and the longest time between two.
    count, period = 1, 0.0
    # The result of the condition when it was looked at last.
    result: bool | None = None
    event: TimedCall | None = None
    # Why it is not answered now: it was not needed with these levels and that result, or another one has asked for
    # longer.
    levels: object = None
    unneeded: bool | None = None
    blocker: Query | None = None

    def __init__(
        self,
        task: Any,
        wait: Any,
        value: object,
        now: float,
        condition: Callable[[], object] | None,
        stack: tuple[int, ...] = (),
    ) -> None:
        self.task, self.wait, self.value, self.condition, self.stack = task, wait, value, condition, stack
        self.since = self.last = now


@dataclass(slots=True, eq=False)
class Responder:
    """A value that changes when it is asked for.

    `current` returns the value, `other` the one to which a rule would change it, None if it would not, and `put`
    changes it. `name` returns the value of a rule in words.
    """

    name: Callable[[AskedRule, object], str]
    current: Callable[[], object]
    other: Callable[[AskedRule], object]
    put: Callable[[AskedRule, object], object]
    # The number of a digital input, -1 for any other value.
    channel: int = -1
    rules: list[AskedRule] = field(default_factory=list)
    waits: dict[Any, Query] = field(default_factory=dict)
    polls: dict[tuple[Any, tuple[int, ...]], Query] = field(default_factory=dict)
    # True while a hand has the value, in place of the rules.
    is_held: bool = False

    def queries(self) -> tuple[Query, ...]:
        """Return all queries, those of waits first."""
        return (*self.waits.values(), *self.polls.values())

    def answer(self, now: float) -> tuple[AskedRule, object] | None:
        """Return the rule that may act on the present value, and the value to which it changes."""
        for rule in () if self.is_held else self.rules:
            if rule.may_act(now):
                value = self.other(rule)
                if value is not None and (rule.level is None or value == rule.level):
                    return rule, value
        return None

    def is_listed(self, query: Query) -> bool:
        """True if a query is that of its task, or of its task and statement."""
        if query.wait is not None:
            return self.waits.get(query.task) is query
        return self.polls.get((query.task, query.stack)) is query

    def drop(self, query: Query) -> None:
        """Forget a query, if it is listed."""
        if query.event is not None:
            query.event.cancel()
            query.event = None
        if self.is_listed(query):
            if query.wait is not None:
                del self.waits[query.task]
            else:
                del self.polls[query.task, query.stack]

    def drop_outdated(self, value: object) -> None:
        """Forget the queries that began before the value changed to the present one."""
        for each in self.queries():
            if each.value != value:
                self.drop(each)


class Asking:
    """The answers of a machine when it is asked, and the tasks that have started its axes."""

    def __init__(self, controller: ControllerState) -> None:
        self._controller, self._clock = controller, controller.clock
        self._responders: dict[tuple[str, int], Responder] = {}
        self._starters: dict[Axis, Any] = {}
        self._starts: dict[Any, float] = {}
        controller.reads.add(self._reads)

    def add_channel(self, table: str, channels: Channels, entry: Entry, since: float, on: float) -> None:
        """Add an entry by which a channel changes to `on`, or from there to 0, when asked."""
        kind, key = DRIVEN[table]
        channel: int = entry[key]  # type: ignore[assignment]
        is_input = table == "input"

        def put(rule: AskedRule, value: object) -> None:
            channels[channel] = value  # type: ignore[assignment]
            if rule.length < INFINITY:
                back = 0.0 if value else on
                self._clock.at(rule.until, lambda: channels.__setitem__(channel, back))

        def other(rule: AskedRule) -> float:
            value: float = 1 if is_input else rule.stimulus.entry.get("value", 1)  # type: ignore[assignment]
            return 0 if channels.present(channel) == value else value

        def name(rule: AskedRule, value: object) -> str:
            level = ("on" if value else "off") if is_input else f"= {value:.10g}"
            return f"{kind} {channel} {level}"

        responder = Responder(
            name, lambda: channels.present(channel), other, put, channel if is_input else -1
        )
        self.add(table, channel, entry, since, responder)

    def add(self, table: str, number: int, entry: Entry, since: float, responder: Responder) -> None:
        """Add an entry to the responder of its value, which is `responder` if it is the first one."""
        stimulus = Stimulus(self._controller.stimuli, table, entry, lambda: None, since)
        delay, length = float(entry["asked"]), float(entry.get("for", INFINITY))  # type: ignore[arg-type]
        begin, times = since + float(entry.get("at", 0.0)), float(entry.get("times", INFINITY))  # type: ignore[arg-type]
        rule = AskedRule(stimulus, delay, begin, times, entry.get("level"), length)
        self._responders.setdefault((table, number), responder).rules.append(rule)

    def asked_since(self, table: str, number: int) -> float | None:
        """Return since when the program has asked for a value of an entry to change, None if it does not ask."""
        responder = self._responders.get((table, number))
        if responder is None:
            return None
        return min(
            (
                each.since
                for each in responder.queries()
                if self._asks(responder, each)
                and (each.wait is not None or each.count >= MIN_READS)
                and self._needs_other(responder, each)
            ),
            default=None,
        )

    def hold(self, table: str, number: int) -> None:
        """Let the entries of a value not act from now on, since a hand has it."""
        responder = self._responders.get((table, number))
        if responder is not None:
            responder.is_held = True
            for each in responder.queries():
                responder.drop(each)

    def let_go(self, table: str, number: int) -> None:
        """Let the entries of a value act again."""
        responder = self._responders.get((table, number))
        if responder is not None:
            responder.is_held = False

    # ------------------------------------------------------------------------------------------------ axes

    def starts(self, a: Axis, profile: Profile) -> None:
        """Record which task starts an axis, which is about to get a profile; it stays that of the moves behind it."""
        tasks = self._controller.tasks
        if tasks is None or not (profile.distance or profile.end_velocity):
            return
        starter, before, now = self._starters.get(a), a.profiles[-1], self._clock.now
        if starter is None or not (now <= a.starts[-1] + before.duration or before.end_velocity):
            starter = self._starters[a] = tasks.current
            if starter not in self._starts:
                self._starts = {task: time for task, time in self._starts.items() if not task.done}
        self._starts[starter] = now

    def _is_moving(self, task: object) -> bool:
        return any(by is task and not (a.is_at_standstill or a.suspended) for a, by in self._starters.items())

    # ----------------------------------------------------------------------------------------------- queries

    def _reads(self, table: str, number: int) -> None:
        """Record that the running task, or the wait of a task, reads a value."""
        responder, tasks = self._responders.get((table, number)), self._controller.tasks
        if responder is None or tasks is None or tasks.current.done:
            return
        task = tasks.current
        wait, value = tasks.wait_of(task), responder.current()
        stack = () if wait is not None else task.stack
        query = responder.polls.get((task, stack)) if wait is None else responder.waits.get(task)
        if query is not None:
            if query.wait is wait and query.value == value and (wait is not None or self._repeats(query)):
                if query.event is None:
                    self._schedule(responder, query)
                return
            responder.drop(query)
        responder.drop_outdated(value)
        if self._is_moving(task):
            return
        now = self._clock.now
        if wait is not None:
            polled = responder.polls.get((task, task.stack))
            if polled is not None:  # the statement waits from now on
                responder.drop(polled)
            query = responder.waits[task] = Query(task, wait, value, now, wait.ready)
            self._schedule(responder, query)
        else:
            if len(responder.polls) >= MANY:  # each call of a handler is another task
                for each in [each for each in responder.polls.values() if each.task.done]:
                    responder.drop(each)
            condition = task.condition()
            responder.polls[task, stack] = Query(task, None, value, now, condition, stack)

    def _repeats(self, query: Query) -> bool:
        """Count a further read of a task that polls; False if it has begun anew."""
        now = self._clock.now
        gap = now - query.last
        if gap > MAX_GAP or query.last < self._starts.get(query.task, -INFINITY):
            return False
        if gap > 0.0:
            query.count += 1
            query.last, query.period = now, max(query.period, gap)
        return True

    def repeats(self, began: float, here: float) -> None:
        """Schedule the answers to reads of a loop that repeats the iterations from `began` to `here`."""
        for responder in self._responders.values():
            for query in responder.polls.values():
                if query.last >= began:
                    query.count = max(query.count, MIN_SCHEDULED)
                    query.period = max(query.period, here - began)
                    self._schedule(responder, query)

    def skipped(self, began: float, here: float, until: float, times: int) -> None:
        """Count the reads of iterations that repeat those from `began` to `here`, up to `until`."""
        for responder in self._responders.values():
            for query in responder.polls.values():
                if query.last >= began:
                    query.last += until - here
                    query.count += times

    # ---------------------------------------------------------------------------------------------- answers

    def _schedule(self, responder: Responder, query: Query) -> None:
        """Schedule the answer to a query, once it is known to be one."""
        if query.event is not None or (query.wait is None and query.count < MIN_SCHEDULED):
            return
        if query.blocker is not None and self._asks(responder, query.blocker):
            return
        if query.levels is not None and query.levels == self._controller.inputs.values:
            return
        now = self._clock.now
        answer = responder.answer(now)
        if answer is None:
            return
        rule, value = answer
        query.blocker = query.levels = None
        time = max(max(query.since, rule.begin) + rule.delay, now)
        query.event = self._clock.at(time, partial(self._answer, responder, query, rule, value))

    def _asks(self, responder: Responder, query: Query) -> bool:
        task, tasks = query.task, self._controller.tasks
        if not responder.is_listed(query) or task.done or query.value != responder.current():
            return False
        if self._is_moving(task):
            return False
        if query.wait is None:
            return self._clock.now - query.last <= 2.0 * query.period
        assert tasks is not None
        return tasks.wait_of(task) is query.wait and self._starts.get(task, -INFINITY) <= query.since

    def _answer(self, responder: Responder, query: Query, rule: AskedRule, value: object) -> bool:
        """Act on a query if it still asks; True if nothing has changed."""
        query.event = None
        if not self._asks(responder, query):
            responder.drop(query)
            return query.wait is None  # a wait may have become another query
        now = self._clock.now
        if (query.wait is None and query.count < MIN_READS) or not rule.may_act(now):
            return True
        if not self._needs_other(responder, query):
            query.levels, query.unneeded = self._controller.inputs.values, query.result
            return True
        if query.unneeded not in (None, query.result):  # another input has changed the result: it asks anew
            query.since, query.unneeded = now, None
            return True
        for each in responder.queries():
            if (
                each.since < query.since
                and self._asks(responder, each)
                and not self._needs_other(responder, each)
            ):
                query.blocker = each
                return True
        self._controller.log.events.add(
            Event(now, "asked", None, None, None, query.task.stack[-1], 0, responder.name(rule, value))
        )
        if rule.length < INFINITY:
            rule.until = now + rule.length
        rule.stimulus.counts()
        responder.put(rule, value)
        responder.drop_outdated(responder.current())
        return False

    def _needs_other(self, responder: Responder, query: Query) -> bool:
        """True unless a query is known to need the present level of an input."""
        if responder.channel < 0 or query.condition is None:
            return True
        sets = self._inputs_that_end(query, query.condition)
        return not sets or any(responder.channel in each for each in sets)

    def _inputs_that_end(self, query: Query, condition: Callable[[], object]) -> list[tuple[int, ...]]:
        """Return the smallest sets of inputs whose changes change the result of a condition; [] if not known."""
        inputs, tasks, reads = self._controller.inputs, self._controller.tasks, self._controller.reads
        assert tasks is not None
        current, tasks.current = tasks.current, query.task
        read = set[int]()
        with reads.replaced(lambda table, number: read.add(number) if table == "input" else None):
            try:
                result = bool(condition())
                query.result = result
                if len(read) == 1 or len(read) > MAX_INPUTS:
                    return []
                for count in range(1, MAX_CHANGES + 1):
                    found = []
                    for changed in combinations(sorted(read), count):
                        with inputs.supposing({each: 1 - inputs.present(each) for each in changed}):
                            if bool(condition()) is not result:
                                found.append(changed)
                    if found:
                        break
                condition()  # a wait stores what its last test has read
                return found
            finally:
                tasks.current = current
