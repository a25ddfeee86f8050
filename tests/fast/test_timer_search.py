"""Periods of a timer's ticks, and ticks that run without the scheduler."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.controller.clock import Clock
from motionlang.fast.timer_ticks import TimerTicks, _is_short, _quiet_until, _Search
from motionlang.lang.statement_time import StatementTime
from motionlang.lang.waits import Condition, Delay, Wait
from motionlang.mint.keywords.event_kinds import KINDS
from motionlang.mint.runtime.events import EventTask
from motionlang.mint.runtime.waits import Rest
from tests.cases import cases

# The number of the timer among the kinds of events.
TIMER = KINDS.index("timer")
CLOCK: Any = SimpleNamespace(now=0.0, fired=0)


def waiting(wait: Any, is_delay: bool = True) -> Any:
    return SimpleNamespace(wait=wait, delay=wait if is_delay else None)


@cases(
    "lengths, are_delays, is_short",
    (
        ((), True, False),
        ((0.0599,), True, True),
        ((0.0601,), True, False),
        ((0.0625,), True, False),
        ((0.5, 0.03), True, True),
        ((0.03,), False, False),
        ((None,), True, False),
    ),
)
def test_a_wait_of_less_than_60_ms_is_short(
    lengths: tuple[float | None, ...], are_delays: bool, is_short: bool
) -> None:
    """Waits other than WAITs do not count."""
    tasks = [
        waiting(each and SimpleNamespace(since=0.0, ends=each), are_delays) if each else waiting(None)
        for each in lengths
    ]
    assert _is_short(SimpleNamespace(tasks=tasks)) == is_short


def condition(solved: float, ignores_data: bool) -> Condition:
    dependencies: Any = SimpleNamespace(clock=CLOCK)
    made = Condition(dependencies, lambda: False, 0.0, "for a condition", ignores_data)
    made.solved = solved
    return made


def rest(settled: object) -> Rest:
    """Return a wait until axes are at rest; with `settled` it is also due at times."""
    environment: Any = SimpleNamespace(settled=settled)
    made = Rest(environment, 0.0, lambda: 5.0, lambda: False, "for axes to be idle", (0, ()))
    made._built = Wait(0.0, lambda: False, lambda: 0.25, "for a condition")
    return made


@cases(
    "wait, until",
    (
        (Delay(CLOCK, 0.0, 0.5), 0.5 - 1e-9),
        (condition(inf, True), inf),
        (condition(inf, False), -inf),
        (condition(0.5, True), -inf),
        (rest(None), inf),
        (rest(1), -inf),
        (Wait(0.0, lambda: False, lambda: inf, "for an axis"), -inf),
    ),
)
def test_the_time_up_to_which_only_an_event_ends_a_wait(wait: Wait, until: float) -> None:
    assert _quiet_until(wait) == until


class Left:
    """A timer whose handler or whose tasks have just stopped."""

    def __init__(self) -> None:
        event, self.reached = object(), list[tuple[object, ...]]()
        environment = SimpleNamespace(machine=SimpleNamespace(log=None))
        events: Any = SimpleNamespace(tick_event=event, environment=environment)
        self.events = events
        made: Any = TimerTicks(events)
        self.made = made
        made._polled = SimpleNamespace(reached=lambda scheduler, *given: self.reached.append(given))
        self.scheduler: Any = SimpleNamespace(is_observed=True, tasks=[waiting(None)])

    @staticmethod
    def handler(name: str = "timer", done: bool = True, kind: type[EventTask] = EventTask) -> Any:
        task: Any = kind.__new__(kind)
        task.name, task.done, task.wait = name, done, None
        return task


class Task(EventTask):
    """A task that is no handler itself."""

    __slots__ = ()


@cases(
    "task, reached",
    (
        (Left.handler(), [(True, True)]),
        (Left.handler("in1"), []),
        (Left.handler(done=False), []),
        (Left.handler(kind=Task), []),
    ),
)
def test_the_end_of_a_tick_is_a_checkpoint(task: Any, reached: list[object]) -> None:
    left = Left()
    left.made.left(left.scheduler, task)
    assert left.reached == reached


@cases(
    "cause, is_observed, reached", (("time", True, [(False, True)]), ("time", False, []), ("axis", True, []))
)
def test_the_beginning_of_a_wait_is_a_checkpoint(
    cause: str, is_observed: bool, reached: list[object]
) -> None:
    left = Left()
    left.scheduler.is_observed = is_observed
    task = Left.handler("main", False)
    task.wait = SimpleNamespace(cause=cause)
    left.made.left(left.scheduler, task)
    assert left.reached == reached


@cases(
    "tasks, polls",
    (
        ([waiting(None)], True),
        ([waiting(SimpleNamespace(since=0.0, ends=0.5))], False),
        ([waiting(SimpleNamespace(since=0.0, ends=0.05))], True),
        ([waiting(SimpleNamespace(since=0.0, ends=0.5)), waiting(None)], True),
    ),
)
def test_a_short_wait_counts_as_polling(tasks: list[Any], polls: bool) -> None:
    left = Left()
    left.scheduler.tasks = tasks
    left.made.left(left.scheduler, Left.handler())
    assert left.reached == [(True, polls)]


def test_a_timer_with_another_period_is_left_alone() -> None:
    left = Left()
    left.events.tick_event = object()
    left.made.left(left.scheduler, Left.handler())
    assert (left.reached, left.scheduler.is_observed) == ([], False)


def test_a_search_that_fails_pauses_for_twice_as_many_ticks() -> None:
    made, pauses = Left().made, []
    for _ in range(15):
        made._search = object()
        made._fail()
        assert made._search is None
        pauses.append(made._left)
    assert pauses == [0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 4096]


# The state of a program in which a tick may run at 0.5 s: each field that decides it, and another value.
RUNS: dict[str, Any] = {
    "events.active": [], "events.pending": [], "events.disabled": 0, "events.handles": lambda kind: kind == "timer",
    "machine.hook": None, "machine.assumptions": {}, "event.time": 0.5,
}  # fmt: skip
RUNS_NOT: dict[str, Any] = {
    "events.active": [1], "events.pending": [1], "events.disabled": 1 << TIMER, "events.handles": lambda kind: False,
    "machine.hook": print, "machine.assumptions": {"a": 1}, "event.time": 0.4,
}  # fmt: skip


class Ticking:
    """A program whose tasks wait while the timer ticks every 10 ms; it is 0.495 s.

    Each tick takes 30 µs. `ends` is what each tick returns: false if it has acted, or has not ended.
    """

    def __init__(self, *waits: Any, ends: tuple[bool, ...] = (), **given: Any) -> None:
        self.clock, self.calls, self._ends = Clock(), list[tuple[float, float, int]](), list(ends)
        self.clock.now = 0.495
        parts: dict[str, Any] = {"event": self.clock.at(0.5, lambda: None)}
        for key, value in {**RUNS, **given}.items():
            owner, _, field = key.partition(".")
            setattr(parts.setdefault(owner, SimpleNamespace()), field, value)
        self.event, self.events = parts["event"], parts["events"]
        machine = parts["machine"]
        machine.log = None
        self.events.environment = SimpleNamespace(clock=self.clock, machine=machine)
        self.events.tick_event = self.event
        self.tasks = [SimpleNamespace(wait=each, delay=None, at=k) for k, each in enumerate(waits)]
        self.scheduler: Any = SimpleNamespace(tasks=self.tasks, current=SimpleNamespace(at=77))
        self.scheduler.where = lambda: self.scheduler.current.at
        made: Any = TimerTicks(self.events)
        self.made = made
        made._left, made._tick = 10**6, self.tick

    def tick(self, scheduler: Any, now: float, until: float, at: int) -> bool:
        self.calls.append((round(now, 9), until, at))
        self.clock.now = now + 3e-5
        self.clock.again(self.event, now + 0.01)
        return self._ends.pop(0) if self._ends else True

    def run(self, due: float = 0.5, until: float = 1.0) -> bool:
        return bool(self.made.run(self.scheduler, due, until))

    def ticks(self) -> int:
        return len(self.calls)


def pause(ends: float | None = None) -> Any:
    """Return a WAIT up to `ends`, or a wait for axes at rest."""
    return rest(None) if ends is None else Delay(CLOCK, 0.0, ends)


@pytest.mark.parametrize("name", ["nothing", *RUNS_NOT])
def test_a_tick_runs_without_the_scheduler_unless_something_else_may_act(name: str) -> None:
    program = Ticking(pause(2.0), **({name: RUNS_NOT[name]} if name in RUNS_NOT else {}))
    assert program.run(until=0.505) == (name == "nothing")
    assert program.ticks() == (name == "nothing")


def test_another_event_of_the_timer_runs_by_the_scheduler() -> None:
    program = Ticking(pause(2.0))
    program.events.tick_event = None
    assert not program.run()
    program.events.tick_event, program.made._event = program.event, None
    assert not program.run()


@cases(
    "waits, due, until, ticks",
    (
        ((pause(2.0),), 0.5, 0.6, 10),
        ((pause(2.0),), 0.5, 0.5, 0),
        ((pause(2.0),), 0.5, 0.51, 1),
        ((pause(2.0),), 0.5, 0.5 + 1e-6, 1),
        ((pause(2.0),), 0.51, 0.6, 0),
        ((pause(0.5),), 0.5, 0.6, 0),
        ((pause(0.50001),), 0.5, 0.6, 1),
        ((pause(0.55),), 0.5, 0.6, 5),
        ((pause(2.0), pause(0.525)), 0.5, 0.6, 3),
        ((pause(0.57 + 2e-9),), 0.5, 0.6, 8),
        ((pause(0.57 + 0.5e-9),), 0.5, 0.6, 7),
        ((pause(0.51 + 1e-9),), 0.5, 0.6, 1),
        ((pause(),), 0.5, 0.6, 10),
        # Another kind of wait may be over after each tick, or may end at a solved time.
        ((Wait(0.0, lambda: False, lambda: inf, "for an axis"),), 0.5, 0.6, 1),
        ((condition(0.7, True),), 0.5, 0.6, 1),
        ((condition(0.4, True),), 0.5, 0.6, 0),
        ((condition(inf, True),), 0.5, 0.6, 10),
    ),
)
def test_ticks_run_up_to_the_end_of_a_wait(
    waits: tuple[Any, ...], due: float, until: float, ticks: int
) -> None:
    """They are at 0.50 s, 0.51 s and so on; a wait ends 1 ns early."""
    program = Ticking(*waits)
    assert program.run(due, until) == (ticks > 0)
    assert program.ticks() == ticks


def test_ticks_run_up_to_another_event_at_their_time() -> None:
    program = Ticking(pause(2.0))
    program.clock.at(0.52, lambda: None)
    assert program.run(until=0.6)
    assert program.ticks() == 2
    program = Ticking(pause(2.0))
    program.clock.at(0.5, lambda: None)
    assert not program.run(until=0.6)


def test_a_tick_that_acts_is_the_last_one() -> None:
    program = Ticking(pause(2.0), ends=(True, True, False))
    assert program.run(until=0.6)
    assert program.ticks() == 3


@cases(
    "waits, at, current",
    (
        ((pause(2.0), pause(3.0)), [77, 77, 77], 77),
        ((pause(2.0), pause(), pause(), pause(3.0)), [77, 2, 2], 2),
    ),
)
def test_a_tick_is_located_at_the_task_that_was_checked_last(
    waits: tuple[Any, ...], at: list[int], current: int
) -> None:
    """That is the last one whose end is not known.

    For the first tick, the one that the scheduler has checked.
    """
    program = Ticking(*waits)
    assert program.run(until=0.525)
    assert [each[2] for each in program.calls] == at
    assert program.scheduler.current.at == current


@cases("polled, is_searching, runs", ((False, False, False), (True, True, False), (True, False, True)))
def test_ticks_within_short_waits_are_left_to_the_search_of_polling_tasks(
    polled: bool, is_searching: bool, runs: bool
) -> None:
    program = Ticking(pause(0.54))
    program.tasks[0].delay = program.tasks[0].wait
    program.tasks[0].wait.since = 0.49
    if polled:
        program.made._polled = SimpleNamespace(is_searching=is_searching)
    assert program.run(until=0.525) == runs


def test_a_search_begins_after_the_pause() -> None:
    """Two ticks are left without one.

    The third one begins it, and each of the others asks for a period. The third question fails, which begins a
    pause.
    """
    program, asked = Ticking(pause(2.0)), list[float]()
    program.made._left = 2

    def skipped(end: float) -> bool:
        asked.append(round(end, 9))
        return len(asked) < 3

    program.made._skipped = skipped
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("motionlang.fast.timer_ticks._Search", lambda events: "search")
        assert program.run(until=0.555)
    assert (program.ticks(), asked) == (6, [0.555] * 3)
    assert (program.made._search, program.made._left, program.made._back_off) == (None, 0, 1)


def search(*values: tuple[float, ...], period: float = 10.0, ticks: int = 5, started: float = 0.0) -> Any:
    """Return a search with the values of counters after each tick.

    The last one was tick `ticks` - 1.
    """
    made: Any = _Search.__new__(_Search)
    clock: Any = SimpleNamespace(now=0.0, second_time=lambda: inf)
    made._events = SimpleNamespace(
        started=started, timer=period, ticks=ticks, tick_time=lambda number: number * period / 1000.0
    )
    made._environment = SimpleNamespace(clock=clock, statements=StatementTime(1e-5))
    made.marks = [((), each) for each in values]
    made.times = [k * 0.01 for k in range(len(values))]
    made.ends = [each + 3e-5 for each in made.times]
    made.notes, made._met = [], {}
    return made


@cases(
    "values, period, steps",
    (
        (((1.0, 5.0), (1.0, 5.0)), 1, [0.0, 0.0]),
        (((1.0, 5.0), (2.0, 5.0)), 1, None),
        (((1.0, 5.0), (2.0, 5.0), (3.0, 5.0)), 1, [1.0, 0.0]),
        (((1.0, 5.0), (2.0, 5.0), (4.0, 5.0)), 1, None),
        (((1.0,), (1.5,), (3.0,), (3.5,), (5.0,)), 2, [2.0]),
        (((9.0,), (1.5,), (3.0,), (3.5,), (5.0,)), 2, None),
        (((1.0,), (3.0,), (4.0,), (3.0,)), 2, [0.0]),
    ),
)
def test_a_counter_must_advance_equally_in_two_periods(
    values: tuple[tuple[float, ...], ...], period: int, steps: list[float] | None
) -> None:
    assert search(*values)._advanced(len(values) - 1, period) == steps


@cases(
    "period, end, second, ticks, timer, most, fitting",
    (
        # Tick 4 was the last one; a handler takes 30 µs. Up to 1 s ticks 5 to 99 fit, and up to 1.00004 s tick 100.
        (1, 1.0, inf, 5, 10.0, inf, 94),
        (1, 1.00004, inf, 5, 10.0, inf, 95),
        (1, 1.00003, inf, 5, 10.0, inf, 94),
        (1, 1.000031 + 1e-9, inf, 5, 10.0, inf, 95),
        (2, 1.0, inf, 5, 10.0, inf, 47),
        (1, 1.0, 0.5, 5, 10.0, inf, 44),
        (1, 1.0, inf, 5, 20.0, inf, 44),
        (1, 1.0, inf, 5, 10.0, 7.0, 7),
        (1, 0.03, inf, 5, 10.0, inf, -3),
    ),
)
def test_the_periods_that_fit_before_a_change(
    period: int, end: float, second: float, ticks: int, timer: float, most: float, fitting: int
) -> None:
    """The handler of the last tick ends 30 µs after it, and a µs before the change."""
    made = search((1.0,), (1.0,), (1.0,), period=timer, ticks=ticks)
    made._environment.clock.second_time = lambda: second
    made._counters = SimpleNamespace(most=lambda steps: most)
    assert made.fitting(period, end) == fitting


def test_counters_advance_by_the_steps_of_the_last_period() -> None:
    asked = list[object]()
    made = search((5.0,), (6.0,), (6.0,))

    def most(steps: object) -> float:
        asked.append(steps)
        return 3.0

    made._counters = SimpleNamespace(most=most)
    assert made.fitting(1, 1.0) == 3
    assert asked == [[0.0]]


def test_ticks_count_from_the_start_of_the_timer() -> None:
    """Since 0.5 s ticks 5 to 49 fit before 1 s."""
    made = search((1.0,), (1.0,), (1.0,), started=0.5)
    made._counters = SimpleNamespace(most=lambda steps: inf)
    assert made.fitting(1, 1.0) == 45 - 1


def test_the_longest_handler_of_a_period_must_fit() -> None:
    """The last but one takes 2 ms, and the one before it, of another period, 9 ms."""
    made = search((1.0,), (1.0,), (1.0,), (1.0,), (1.0,))
    made.ends[-2], made.ends[-3] = made.times[-2] + 0.002, made.times[-3] + 0.009
    made._counters = SimpleNamespace(most=lambda steps: inf)
    assert [made.fitting(2, end) for end in (0.1019, 0.1021, 0.1119, 0.1121)] == [2, 2, 2, 3]
    assert [made.fitting(1, end) for end in (0.10002, 0.10004)] == [4, 5]


@cases(
    "levels, is_solvable",
    (((), True), ((5.0,), True), ((inf,), False), ((-inf,), False), ((0, inf), False), ((inf, 0), True)),
)
def test_readings_of_loops_end_the_search(levels: tuple[float, ...], is_solvable: bool) -> None:
    """A value that a loop only stores, or its maximum, is no dependency.

    The loop executes its last iteration.
    """
    made = search()
    made.notes = [(lambda *about: 0.0, ()), (lambda *about: 0.0, levels)]
    assert made.is_solvable == is_solvable


class Stream(list[Any]):
    """A stream of a log; a template is stored as it is given."""

    def repeat(self, shape: object, pace: object) -> None:
        self.append((shape, pace))


def recorded(period: int = 2) -> tuple[Any, list[Stream]]:
    """Return a search and its streams.

    The handler toggles an output at ticks 2 and 3, which are at 20 ms and 30 ms.
    """
    made = search(period=10.0, ticks=4)
    streams = [Stream([(k * 0.01, "handler") for k in range(4)]), Stream(), Stream()]
    streams[1] += [(0.0, 9, 9), (0.01, 9, 9), (0.02 + 1e-5, 3, 1), (0.03 + 1e-5, 3, 0)]
    made._log = SimpleNamespace(events=streams[0], outputs=streams[1], slices=streams[2])
    made._others, made._lengths = [[1]], [1]
    made.marks = [((k + 1, k + 1, 0), (float(k * k), 2.0)) for k in range(4)]
    made.times = [k * 0.01 for k in range(4)]
    return made, streams


ROWS = [
    [(0, (0.0,), ("handler",)), (1, (0.0,), ("handler",))],
    [(0, (1.0,), (3, 1)), (1, (1.0,), (3, 0))],
    [],
]


def test_the_records_of_a_period() -> None:
    made, _ = recorded()
    assert made.rows(2) == ROWS
    made._lengths = [0]  # another stream has a new record
    assert made.rows(2) is None
    made, streams = recorded()
    streams[1][-1] = (0.030005, 3, 0)  # between two statements
    assert made.rows(2) is None


@cases("count, is_found", ((257, True), (258, False)))
def test_a_period_has_at_most_256_records_before_its_last_tick(count: int, is_found: bool) -> None:
    """The records of tick 2 are `count` less one, and tick 3 adds one."""
    made, streams = recorded()
    streams[1][:] = [(0.02, 3, 1)] * (count - 1) + [(0.03, 3, 1)]
    past = [0, 0, count - 1, count]
    made.marks = [((k + 1, past[k], 0), ()) for k in range(4)]
    found = made.rows(2)
    assert (found is not None) == is_found
    if found is not None:
        assert len(found[1]) == count


def test_skipped_periods_have_all_their_effects() -> None:
    """Ticks 4 to 9 pass: three periods of two.

    Tick 9 is at 90 ms, and its handler ends 3 statements later.
    """
    made, streams = recorded()
    scheduled, reached, advanced = list[int](), list[object](), list[object]()
    events, environment = made._events, made._environment
    events.tick_event, events.schedule_tick = "tick", scheduled.append
    environment.clock.reach, environment.clock.fired = reached.append, 42
    environment.statements.base, environment.statements.count = 0.03, 3.0
    made._counters = SimpleNamespace(advance=lambda *given: advanced.append(given))
    made.skip(2, 3, ROWS)
    pace = 0.0, 4, 0.01, 1e-5
    assert [each[-1] for each in streams[:2]] == [((rows, 3, 2, 0.0), pace) for rows in ROWS[:2]]
    assert streams[2] == [(([], 3, 2, 0.0), pace)]
    assert (scheduled, reached, advanced) == ([10], ["tick"], [([9.0 - 1.0, 0.0], 3)])
    assert (environment.clock.now, environment.statements.base) == (0.09 + 3 * 1e-5, 0.09)
    assert environment.fired == 42


def test_a_state_that_recurs_is_a_period() -> None:
    """The outputs alternate, and a counter advances by 1.

    So a period is found when it has been met twice.
    """
    made = search(ticks=1)
    values, hidden = [0.0], list[object]()
    made._counters = SimpleNamespace(hide=lambda: "hidden", set=hidden.append, values=lambda: (values[0],))
    made._log = SimpleNamespace(events=[1], outputs=[1, 2], slices=[])
    outputs = SimpleNamespace(values=0)
    made._environment.controller = SimpleNamespace(outputs=outputs)
    made._environment.state = lambda alive: b"shared"
    made.marks, made.times, made.ends = [], [], []
    found = []
    for number in range(1, 6):
        made._events.ticks, made._environment.clock.now = number, number * 0.01 + 0.002
        outputs.values, values[0] = number % 2, float(number)
        found.append(made.period())
    assert found == [None, None, None, None, 2]
    assert hidden == ["hidden"] * 5
    assert made.marks == [((1, 2, 0), (float(number),)) for number in range(1, 6)]
    assert made.times == [number * 10.0 / 1000.0 for number in range(5)]
    assert made.ends == [number * 0.01 + 0.002 for number in range(1, 6)]


class Handler:
    """A handler of a timer with given effects, and the state after its tick.

    It switches `switches` outputs, has `acts` effects in all, and `change` is called in it.
    """

    def __init__(self, acts: int = 0, switches: int = 0, ends: bool = True, change: str = "") -> None:
        self.recorded, self.scheduled, self.ran = list[object](), list[int](), list[Any]()
        self._effects, self._ends, self._change = (acts, switches), ends, change
        self.clock = SimpleNamespace(fired=6)
        self.outputs = SimpleNamespace(listeners=list[object]())
        log = SimpleNamespace(events=SimpleNamespace(add=self.recorded.append))
        self.environment: Any = SimpleNamespace(
            clock=self.clock,
            acts=50,
            switches=20,
            machine=SimpleNamespace(log=log),
            controller=SimpleNamespace(outputs=self.outputs),
        )
        events: Any = SimpleNamespace(
            environment=self.environment,
            ticks=4,
            tick_event="tick",
            schedule_tick=self.scheduled.append,
            handler=lambda kind: f"code of {kind}",
            active=[],
            pending=[],
        )
        self.events = events
        made: Any = TimerTicks(events)
        self.made = made

    def ran_handler(self, task: Any, until: float) -> bool:
        self.ran.append((task, task.notes, until))
        self.environment.acts += 1 + self._effects[0]  # its delivery, too
        self.environment.switches += self._effects[1]
        if self._change == "pending":
            self.events.pending.append(1)
        elif self._change == "fired":
            self.clock.fired += 1
        elif self._change == "timer":
            self.events.tick_event = "another"
        elif self._change == "notes":
            task.notes = []
        elif self._change == "listened":
            self.outputs.listeners.append(1)
        return self._ends

    def tick(self) -> bool:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("motionlang.fast.timer_ticks.EventTask", Made)
            return bool(self.made._tick(self, 0.5, 0.9, 33))


class Made:
    """A task that a tick has made."""

    def __init__(self, *given: object) -> None:
        self.given, self.done, self.notes = given, False, None
        self._generator: object = "running"
        self.axes, self.poll_check = (1, 2), (1, True)


@cases(
    "given, goes_on",
    (
        ({}, True),
        ({"acts": 1}, False),
        ({"acts": 1, "switches": 1}, True),
        ({"acts": 3, "switches": 3}, True),
        ({"acts": 3, "switches": 2}, False),
        ({"acts": 1, "switches": 1, "change": "listened"}, False),
        ({"change": "listened"}, True),
        ({"change": "pending"}, False),
        ({"change": "fired"}, False),
        ({"change": "timer"}, False),
        ({"ends": False}, False),
    ),
)
def test_a_tick_that_has_only_switched_outputs_goes_on(given: dict[str, Any], goes_on: bool) -> None:
    """The record of tick 4 is at 0.5 s, at source position 33; tick 5 is scheduled."""
    handler = Handler(**given)
    assert handler.tick() == goes_on
    assert (handler.scheduled, handler.events.active) == ([5], [(TIMER, 0)])
    assert handler.recorded == [(0.5, "handler", None, None, None, 33, 0, "timer")]
    assert handler.clock.fired == 7 + (given.get("change") == "fired")
    ((task, notes, until),) = handler.ran
    assert (task.given, notes, until) == (("timer", "code of timer", handler.environment), None, 0.9)
    assert handler.made._task is (task if given.get("ends", True) else None)


def test_the_task_of_a_handler_is_started_again() -> None:
    handler = Handler()
    handler.tick()
    handler.ran[0][0].done = True
    handler.tick()
    (first, *_), (again, *_) = handler.ran
    assert again is first
    assert (first._generator, first.done, first.axes, first.poll_check) == (None, False, (0,), None)


@cases("change, left", (("", 10), ("notes", 4)))
def test_a_tick_that_records_no_readings_ends_the_search(change: str, left: int) -> None:
    """The readings of a tick go to the list of the search, unless they are too many."""
    handler = Handler(change=change)
    search: Any = SimpleNamespace(notes=[1])
    handler.made._search, handler.made._left, handler.made._back_off = search, 10, 4
    assert handler.tick()
    assert handler.ran[0][1] is search.notes
    assert (handler.made._search is search, handler.made._left) == (change == "", left)


class Skipping:
    """A search at its period, whose answers are given."""

    def __init__(
        self,
        period: int | None = 2,
        marks: int = 5,
        level: float = 0.7,
        fitting: int = 9,
        rows: object = "rows",
    ) -> None:
        self.calls, self.marks, self.times, self.notes = list[object](), [1] * marks, [0.3, 0.4], [1]
        self._answers, self.is_solvable, self._rows = (period, level, fitting), True, rows
        dependencies = SimpleNamespace(stable_until=self.stable_until)
        environment = SimpleNamespace(
            clock=SimpleNamespace(now=0.5), dependencies=dependencies, machine=SimpleNamespace(log=None)
        )
        events: Any = SimpleNamespace(environment=environment, tick_event="tick")
        made: Any = TimerTicks(events)
        self.made = made
        made._left = made._back_off = 8

    def stable_until(self, *given: object) -> float:
        self.calls.append(given)
        return self._answers[1]

    def period(self) -> int | None:
        return self._answers[0]

    def fitting(self, *given: object) -> int:
        self.calls.append(given)
        return self._answers[2]

    def rows(self, period: int) -> object:
        return self._rows

    def skip(self, *given: object) -> None:
        self.calls.append(given)

    def skipped(self) -> bool:
        self.made._search = self
        return bool(self.made._skipped(0.9))


LEVEL = ([1], 0, 0.3)


@cases(
    "given, goes_on, calls, left",
    (
        ({}, True, [LEVEL, (2, 0.7), (2, 9, "rows")], 0),
        ({"level": 2.0}, True, [LEVEL, (2, 0.9), (2, 9, "rows")], 0),
        ({"level": 0.5}, False, [LEVEL], 8),
        ({"level": 0.4}, False, [LEVEL], 8),
        ({"level": 0.51}, True, [LEVEL, (2, 0.51), (2, 9, "rows")], 0),
        ({"fitting": 1}, True, [LEVEL, (2, 0.7), (2, 1, "rows")], 0),
        ({"fitting": 0}, True, [LEVEL, (2, 0.7)], 8),
        ({"rows": None}, False, [LEVEL, (2, 0.7)], 8),
    ),
)
def test_a_period_is_skipped_as_often_as_it_fits(
    given: dict[str, Any], goes_on: bool, calls: list[object], left: int
) -> None:
    """It is 0.5 s.

    The readings since 0.3 s are the same up to a level, and the ticks end at 0.9 s.
    """
    search = Skipping(**given)
    assert search.skipped() == goes_on
    assert search.calls == calls
    assert (search.made._search, search.made._left, search.made._back_off) == (None, left, left)


@cases("marks, goes_on", ((63, True), (64, True), (65, False)))
def test_a_period_is_searched_for_in_64_ticks(marks: int, goes_on: bool) -> None:
    search = Skipping(period=None, marks=marks)
    assert search.skipped() == goes_on
    assert search.made._search is search
    assert search.calls == []


def test_a_period_with_a_reading_of_a_loop_is_not_skipped() -> None:
    search = Skipping()
    search.is_solvable = False
    assert not search.skipped()
    assert search.calls == []


def test_a_search_begins_with_the_state_of_its_first_tick() -> None:
    """Only handlers, outputs and time slices may have new records."""
    events, outputs, slices, prints, moves = ([0] * k for k in range(5))
    log: Any = SimpleNamespace(events=events, outputs=outputs, slices=slices)
    log.streams = lambda: [events, prints, outputs, slices, moves]
    environment = SimpleNamespace(
        machine=SimpleNamespace(log=log),
        clock=SimpleNamespace(now=0.031),
        controller=SimpleNamespace(outputs=SimpleNamespace(values=())),
        state=lambda alive: b"shared",
        handler_counters={},
    )
    given: Any = SimpleNamespace(
        environment=environment, handler=lambda kind: None, ticks=4, tick_time=lambda number: number * 0.01
    )
    made: Any = _Search(given)
    assert (made._others, made._lengths) == ([prints, moves], [3, 4])
    assert (made.marks, made.times, made.ends) == ([((0, 1, 2), ())], [0.03], [0.031])
