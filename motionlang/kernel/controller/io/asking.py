"""The entries of a machine file by which the world answers when the program asks (`asked = 0.3`).

Problem. A person, a host or an unknown sensor acts because the program waits for it, not at a time. An entry with a
time therefore hides how fast a program is, and breaks as soon as the program becomes faster.

Idea. The program asks for a value while a task waits for it, or reads it again and again at one statement (`Query`),
always with the same result, and no axis that this task has started moves. `asked` seconds after the first of these
reads the entry acts, if the task still asks.

Data. A `Responder` belongs to one value, such as an input. It has the entries of that value, in the order of the file,
and a query for each task and statement that reads it. The first entry that is not used up and fits acts.

Which level. A digital input changes to its other level if that ends the wait, or changes the result of the condition
that polls it. Of several inputs in the condition, the smallest sets of changes that do so count (`_inputs_that_end`).
If there are none, or it cannot be known, it changes to its other level. If another task has asked for longer and needs
the present level, the change is made once that one no longer asks.

Invariants.
- Nothing polls: a query schedules one event of the clock, when its asking is known, and reads find out the rest.
- An event is scheduled before a loop can be skipped. Iterations that are skipped count as reads (`skipped`).
- A value without such an entry costs nothing but the test whether there is any.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any, Protocol

from motionlang.kernel.controller.clock import INFINITY, Clock, TimedCall
from motionlang.kernel.controller.io.stimuli import Entry, Stimulus
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.controller.io.channels import Channels
    from motionlang.kernel.controller.state import ControllerState

# A task that polls reads again within this time, s.
MAX_GAP = 1.2
# A statement that reads so often, with the same result, polls; the event is scheduled at the second read.
MIN_READS, MIN_SCHEDULED = 3, 2
# A condition of more inputs, or one that needs more changes at once, is not analysed.
MAX_INPUTS, MAX_CHANGES = 8, 3
# The device of each table with channels, and the key of its number.
DRIVEN = {
    "input": ("input", "channel"),
    "analogue": ("analogue input", "channel"),
    "coil": ("Modbus coil", "coil"),
}


class AskedReader(Protocol):
    """A task that reads, as far as asking needs it."""

    done: bool

    @property
    def stack(self) -> tuple[int, ...]:
        """The source offset of the statement after those of its callers."""

    def condition(self) -> Callable[[], object] | None:
        """Return the condition that its present statement tests, None if that is not known."""


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


@dataclass(slots=True, eq=False)
class Query:
    """A task that waits for a value, or reads it at a statement, since a time, with one result."""

    task: Any
    stack: tuple[int, ...]
    # What it waits for; None if it polls. `condition` is what it tests then.
    wait: Any
    value: object
    since: float
    last: float
    condition: Callable[[], object] | None = None
    count: int = 1
    # The longest time between two reads.
    period: float = 0.0
    rule: AskedRule | None = None
    event: TimedCall | None = None
    # Why it is not answered now: it was not needed with these levels, or another one has asked for longer.
    levels: object = None
    blocker: Query | None = None


class Responder:
    """The source of a value that is asked for.

    `current` returns the value, `other` the one to which a rule would change it, None if it would not.
    """

    def __init__(
        self,
        asking: Asking,
        name: Callable[[object], str],
        current: Callable[[], object],
        other: Callable[[AskedRule], object],
        put: Callable[[AskedRule, object], object],
        channel: int = -1,
    ) -> None:
        self._asking, self._name, self._current, self._other, self._put = asking, name, current, other, put
        # The number of a digital input, -1 for any other value.
        self.channel = channel
        self.rules: list[AskedRule] = []
        self.queries: dict[tuple[Any, tuple[int, ...]], Query] = {}

    def read(self) -> None:
        """Record that the running task, or the wait of a task, reads the value."""
        asking = self._asking
        tasks = asking.controller.tasks
        if tasks is None or tasks.current.done:
            return
        task, now = tasks.current, asking.clock.now
        key = task, task.stack
        query = self.queries.get(key)
        if asking.is_moving(task):
            self._drop(query)
            return
        wait, value = tasks.wait_of(task), self._current()
        if query is not None and query.wait is wait and query.value == value:
            gap = now - query.last
            if wait is not None or (gap <= MAX_GAP and query.last >= asking.last_start(task)):
                if gap > 0.0:
                    query.count += 1
                    query.last, query.period = now, max(query.period, gap)
                self.schedule(query)
                return
        self._drop(query)
        condition = wait.ready if wait is not None else task.condition()
        query = self.queries[key] = Query(*key, wait, value, now, now, condition)
        self.schedule(query)

    def _drop(self, query: Query | None) -> None:
        if query is None:
            return
        if query.event is not None:
            query.event.cancel()
        del self.queries[query.task, query.stack]

    def schedule(self, query: Query) -> None:
        """Schedule the answer to a query, once it is known to be one."""
        if query.event is not None or (query.wait is None and query.count < MIN_SCHEDULED):
            return
        asking = self._asking
        if query.blocker is not None and self._asks(query.blocker):
            return
        if query.levels is not None and query.levels == asking.levels():
            return
        rule = next((each for each in self.rules if self._fits(each)), None)
        if rule is None:
            return
        query.rule, query.blocker, query.levels = rule, None, None
        time = max(max(query.since, rule.begin) + rule.delay, asking.clock.now)
        query.event = asking.clock.at(time, lambda: self._answer(query))

    def _fits(self, rule: AskedRule) -> bool:
        """True if a rule may act on the present value."""
        if rule.stimulus.count >= rule.times or self._asking.clock.now < rule.until:
            return False
        value = self._other(rule)
        return value is not None and (rule.level is None or value == rule.level)

    def _asks(self, query: Query) -> bool:
        """True if the task of a query still asks."""
        asking = self._asking
        if self.queries.get((query.task, query.stack)) is not query or query.task.done:
            return False
        if query.value != self._current() or asking.is_moving(query.task):
            return False
        tasks = asking.controller.tasks
        assert tasks is not None
        if query.wait is not None:
            return tasks.wait_of(query.task) is query.wait
        return asking.clock.now - query.last <= 2.0 * query.period

    def _answer(self, query: Query) -> bool:
        """Act on a query if it still asks; True if nothing has changed."""
        query.event = None
        rule, asking = query.rule, self._asking
        if not self._asks(query):
            self._drop(query if self.queries.get((query.task, query.stack)) is query else None)
            return True
        if query.wait is None and query.count < MIN_READS:
            return True
        assert rule is not None
        if not self._fits(rule):
            return True
        if not self._needs_other(query):
            query.levels = asking.levels()
            return True
        older = (each for each in tuple(self.queries.values()) if each.since < query.since)
        query.blocker = next(
            (each for each in older if self._asks(each) and not self._needs_other(each)), None
        )
        if query.blocker is not None:
            return True
        value = self._other(rule)
        asking.answered(query, self._name(value))
        if rule.length < INFINITY:
            rule.until = asking.clock.now + rule.length
        rule.stimulus.count += 1
        self._put(rule, value)
        return False

    def _needs_other(self, query: Query) -> bool:
        """True unless a query is known to need the present level of an input."""
        if self.channel < 0 or query.condition is None:
            return True
        sets = self._asking.inputs_that_end(query)
        return not sets or any(self.channel in each for each in sets)


class Asking:
    """The answers of a machine when it is asked, and the tasks that have started its axes."""

    def __init__(self, controller: ControllerState) -> None:
        self.controller = controller
        self.clock: Clock = controller.clock
        self.responders: dict[object, Responder] = {}
        self._readers: dict[str, dict[int, Responder]] = {}
        self._starters: dict[int, Any] = {}
        self._starts: dict[Any, float] = {}
        # The inputs that a condition under test has read; None if none is tested.
        self._tested: set[int] | None = None

    def add_channel(self, table: str, channels: Channels, entry: Entry, since: float, on: float) -> None:
        """Add an entry by which a channel changes to `on`, or from there to 0, when asked."""
        channel: int = entry[DRIVEN[table][1]]  # type: ignore[assignment]
        key = table, channel

        def put(rule: AskedRule, value: object) -> None:
            channels[channel] = value  # type: ignore[assignment]
            if rule.length < INFINITY:
                back = 0.0 if value else on
                self.clock.at(rule.until, lambda: channels.__setitem__(channel, back))

        def other(rule: AskedRule) -> float:
            entry = rule.stimulus.entry
            value: float = 1 if table == "input" else entry.get("value", 1)  # type: ignore[assignment]
            return 0 if channels.present(channel) == value else value

        def name(value: object) -> str:
            level = ("on" if value else "off") if table == "input" else f"= {value:.10g}"
            return f"{DRIVEN[table][0]} {channel} {level}"

        is_input = table == "input"
        responder = self.add(
            table,
            entry,
            since,
            key,
            lambda: Responder(
                self, name, lambda: channels.present(channel), other, put, channel if is_input else -1
            ),
        )
        readers = self._readers.setdefault(table, {})
        readers[channel] = responder
        if is_input:
            channels.reader = self._reads_input
        else:
            channels.reader = lambda number: readers[number].read() if number in readers else None

    def add(
        self, table: str, entry: Entry, since: float, key: object, make: Callable[[], Responder]
    ) -> Responder:
        """Add an entry to what answers for a value, made on its first entry; return it."""
        responder = self.responders.get(key)
        if responder is None:
            responder = self.responders[key] = make()
        stimulus = Stimulus(self.clock, table, entry, lambda: None, since)
        self.controller.stimuli.all.append(stimulus)
        delay, length = float(entry["asked"]), float(entry.get("for", INFINITY))  # type: ignore[arg-type]
        begin, times = since + float(entry.get("at", 0.0)), float(entry.get("times", INFINITY))  # type: ignore[arg-type]
        responder.rules.append(AskedRule(stimulus, delay, begin, times, entry.get("level"), length))
        return responder

    def _reads_input(self, channel: int) -> None:
        responders = self._readers["input"]
        if self._tested is not None:
            self._tested.add(channel)
        elif channel in responders and not self.controller.inputs.is_supposed:
            responders[channel].read()

    # ------------------------------------------------------------------------------------------------ axes

    def starts(self, a: Axis, profile: Profile) -> None:
        """Record which task starts an axis, which is about to get a profile; it stays that of the moves behind it."""
        if not profile.distance and not profile.end_velocity:
            return
        tasks, now = self.controller.tasks, self.clock.now
        before, began = a.profiles[-1], a.starts[-1]
        is_going_on = now <= began + before.duration or before.end_velocity
        if tasks is not None and not (is_going_on and a.index in self._starters):
            self._starters[a.index] = tasks.current
        if a.index in self._starters:
            self._starts[self._starters[a.index]] = now

    def last_start(self, task: object) -> float:
        """Return when a task has last started an axis."""
        return self._starts.get(task, -INFINITY)

    def is_moving(self, task: object) -> bool:
        """True if an axis moves that a task has started."""
        axes = self.controller.axes
        return any(
            by is task and not axes[n].is_at_standstill for n, by in self._starters.items() if n in axes
        )

    # ---------------------------------------------------------------------------------------------- answers

    def repeats(self, began: float, here: float) -> None:
        """Schedule the answers to reads of a loop that repeats the iterations from `began` to `here`."""
        for responder in self.responders.values():
            for query in responder.queries.values():
                if query.wait is None and query.last >= began:
                    query.count = max(query.count, MIN_SCHEDULED)
                    query.period = max(query.period, here - began)
                    responder.schedule(query)

    def skipped(self, began: float, here: float, until: float, times: int) -> None:
        """Count the reads of iterations that repeat those from `began` to `here`, up to `until`."""
        for responder in self.responders.values():
            for query in responder.queries.values():
                if query.wait is None and query.last >= began:
                    query.last += until - here
                    query.count += times

    def levels(self) -> object:
        """Return the levels of all digital inputs."""
        return self.controller.inputs.values

    def answered(self, query: Query, text: str) -> None:
        """Log an answer, with the statement that has asked."""
        log = self.controller.log
        where = log.where
        log.where = lambda: query.stack[-1]
        try:
            log.note(self.clock.now, "asked", text=text)
        finally:
            log.where = where

    def inputs_that_end(self, query: Query) -> list[tuple[int, ...]]:
        """Return the smallest sets of inputs whose changes change the result of a condition; [] if not known."""
        assert query.condition is not None
        inputs, tasks = self.controller.inputs, self.controller.tasks
        assert tasks is not None
        current, tasks.current = tasks.current, query.task
        self._tested = read = set[int]()
        is_changed = False
        try:
            result = bool(query.condition())
            if len(read) == 1 or len(read) > MAX_INPUTS:
                return []
            is_changed = True
            for count in range(1, MAX_CHANGES + 1):
                found = []
                for changed in combinations(sorted(read), count):
                    with inputs.supposing(changed):
                        if bool(query.condition()) is not result:
                            found.append(changed)
                if found:
                    return found
            return []
        finally:
            if is_changed:
                query.condition()  # a wait stores what its last test has read
            self._tested, tasks.current = None, current
