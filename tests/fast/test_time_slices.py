"""The task whose wait ends first continues without a task switch, equally."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import execution
from motionlang.controller.clock import Clock
from motionlang.controller.controller import Controller
from motionlang.fast.time_slices import TimeSlices
from motionlang.lang.task import Task
from motionlang.lang.waits import Delay, Wait
from motionlang.log.stream import Stream
from motionlang.report import text
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import cases
from tests.counted_calls import count_calls

SETTINGS = "SPEED(0, 1) = 100; : ACCEL(0, 1) = 500; : DECEL(0, 1) = 500;\n"
# Axis 0 moves for 0.4 s, 20 µs after its task has begun.
MOVE = "MOVER(0) = 20 : GO(0) : PAUSE IDLE(0)"
# Events during such a wait: the program, and the world around it.
MEETS: dict[str, tuple[str, dict[str, object]]] = {
    "nothing": (
        "Run Worker\nWAIT(5000)\nEnd\nTask Worker\n  While 1\n    {move}\n    WAIT(7)\n  Wend\nEnd Task",
        {},
    ),
    "another at the same instant": (
        "Run Worker\nRun Clock\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(10)\n    WAIT(10)\n  Wend\nEnd Task\n"
        "Task Clock\n  While 1\n    WAIT(10)\n    PRINT TIME; POS(0)\n  Wend\nEnd Task",
        {},
    ),
    "another at the end of the same move": (
        "Run Worker\nRun Other\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(25)\n  Wend\nEnd Task\n"
        "Task Other\n  While 1\n    PAUSE IDLE(0)\n    PRINT TIME; POS(0)\n    WAIT(33)\n  Wend\nEnd Task",
        {},
    ),
    "an input with a handler": (
        "Run Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    {move}\n    WAIT(50)\n  Wend\nEnd Task\n"
        "Event IN1\n  PRINT TIME; POS(0)\n  WAIT(3)\n  SPEED(0) = 60\nEnd Event",
        {"input": [{"channel": 1, "at": 0.2, "for": 0.1, "every": 0.43, "times": 5}]},
    ),
    "an input that nobody hears": (
        "Run Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    {move}\n    WAIT(50)\n  Wend\nEnd Task",
        {"input": [{"channel": 1, "at": 0.2, "for": 0.1, "every": 0.43, "times": 5}]},
    ),
    "a timer": (
        "TIMEREVENT = 35\nRun Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    {move}\n    WAIT(50)\n  Wend\n"
        "End Task\nEvent TIMER\n  Dim n As Integer\n  n = n + 1\n  WAIT(1)\nEnd Event",
        {},
    ),
    "a handler of axes at rest": (
        "Run Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    {move}\n    CANCEL(0)\n    WAIT(50)\n  Wend\n"
        "End Task\nEvent AXISIDLE\n  PRINT TIME; POS(0)\n  WAIT(2)\nEnd Event",
        {},
    ),
    "an error with a handler": (
        "SOFTLIMITFORWARD(0) = 50 : SOFTLIMITMODE(0) = 1\nRun Worker\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(5)\n  Wend\nEnd Task\n"
        "Event ONERROR\n  PRINT TIME; ERR\n  CANCEL(0)\n  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\nEnd Event",
        {},
    ),
    "an error without one": (
        "SOFTLIMITFORWARD(0) = 50 : SOFTLIMITMODE(0) = 1\nRun Worker\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(5)\n  Wend\nEnd Task",
        {},
    ),
    "the end of another": (
        "Run Worker\nRun Other\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(5)\n    End Other\n    WAIT(5)\n  Wend\nEnd Task\n"
        "Task Other\n  WAIT(200)\n  PRINT TIME\n  WAIT(700)\n  PRINT TIME\nEnd Task",
        {},
    ),
    "the start of another": (
        "Run Worker\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(5)\n    Run Other\n    WAIT(5)\n  Wend\nEnd Task\n"
        "Task Other\n  PRINT TIME; POS(0)\n  WAIT(200)\n  PRINT TIME; POS(0)\nEnd Task",
        {},
    ),
    "another that is held and let go": (
        "Run Worker\nRun Other\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    TASKSUSPEND(Other)\n    WAIT(45)\n    TASKRESUME(Other)\n    WAIT(5)\n"
        "  Wend\nEnd Task\nTask Other\n  While 1\n    WAIT(20)\n    PRINT TIME; POS(0)\n  Wend\nEnd Task",
        {},
    ),
    "one that stops what another waits for": (
        "Run Worker\nRun Other\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    WAIT(130)\n    STOP(1)\n    WAIT(3)\n    {move}\n  Wend\nEnd Task\n"
        "Task Other\n  While 1\n    MOVER(1) = 30 : GO(1)\n    PAUSE IDLE(1)\n    PRINT TIME; POS(1)\n  Wend\nEnd Task",
        {},
    ),
    "waits that are none, and very short ones": (
        "Run Worker\nWAIT(3000)\nEnd\n"
        "Task Worker\n  While 1\n    {move}\n    WAIT(0)\n    WAIT(0.0000005)\n    WAIT(0.02)\n  Wend\nEnd Task",
        {},
    ),
    "a sub with the wait": (
        "Run Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    Advance(4)\n    Advance(9)\n  Wend\nEnd Task\n"
        "Sub Advance(n As Integer)\n  {move}\n  WAIT(n)\nEnd Sub",
        {},
    ),
    "a loop that polls and waits": (
        "Run Worker\nWAIT(3000)\nEnd\nTask Worker\n  While 1\n    {move}\n    While TIME Mod 7 <> 0 And Not INX(1)\n"
        "      WAIT(1)\n    Wend\n    WAIT(10)\n  Wend\nEnd Task",
        {"input": [{"channel": 1, "at": 0.2, "for": 0.1, "every": 0.43, "times": 5}]},
    ),
}


def left(result: Run) -> tuple[object, ...]:
    """Return the complete result of a run."""
    log = result.machine.log
    return text(result), result.output, list(log.waits), list(log.slices), list(log.events), list(log.outputs)


def both(source: Source, machine: dict[str, object], until: float | None = None) -> tuple[Run, Run]:
    """Return a run, and one with an observed clock, in which every wait yields."""
    return (
        execution.run(source, machine=machine, cache=False, until=until),
        execution.run(source, machine=machine, cache=False, until=until, pace=lambda now: None),
    )


@pytest.fixture
def passed(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return a list that gets the end of each wait that passes without a switch."""
    ends: list[float] = []
    passes = TimeSlices.passes_among_others

    def counted(scheduler: TimeSlices, since: float, end: float, by_arrival: bool) -> float:
        reach = passes(scheduler, since, end, by_arrival)
        if reach:
            ends.append(end)
        return reach

    monkeypatch.setattr(TimeSlices, "passes_among_others", counted)
    return ends


@pytest.mark.parametrize("name", MEETS)
def test_what_meets_a_wait_changes_nothing(name: str) -> None:
    program, machine = MEETS[name]
    source = Source("waits.mnt", SETTINGS + program.replace("{move}", MOVE) + "\n")
    within_statement, yields = both(source, machine)
    assert left(within_statement) == left(yields)
    assert len(yields.machine.log.waits) > 4


@pytest.mark.parametrize(
    "name",
    [
        "nothing",
        "an input that nobody hears",
        "waits that are none, and very short ones",
        "a sub with the wait",
    ],
)
def test_task_among_others_continues_within_its_statement(name: str, passed: list[float]) -> None:
    program, machine = MEETS[name]
    result = execution.run(
        Source("waits.mnt", SETTINGS + program.replace("{move}", MOVE) + "\n"), machine=machine, cache=False
    )
    assert len(passed) > 4
    assert set(passed) <= {wait.until for wait in result.machine.log.waits}


@pytest.mark.parametrize("until", [0.2, 0.40002, 0.404, 0.41, 1.7777])
def test_a_run_ends_in_the_middle_of_a_wait(until: float) -> None:
    """The run ends at 0.4 s in the move, 0.007 s in the WAIT, or at the end of either."""
    program, machine = MEETS["nothing"]
    source = Source("waits.mnt", SETTINGS + program.replace("{move}", MOVE) + "\n")
    within_statement, yields = both(source, machine, until)
    assert left(within_statement) == left(yields)
    assert within_statement.time == until


def test_a_wait_ends_no_later_than_another_task_is_due(passed: list[float]) -> None:
    """A wait yields if it ends when another task's wait ends, or later."""
    program = (
        "Run Worker\nWAIT(100)\nPRINT TIME\nEnd\nTask Worker\n  While 1\n    WAIT(40)\n  Wend\nEnd Task\n"
    )
    result = execution.run(Source("waits.mnt", program), cache=False)
    assert result.output == ["100"]
    assert [round(end, 4) for end in passed] == [0.08]


def interrupting(after: int) -> Callable[[TimeSlices, float, float, bool], float]:
    """Return a replacement that interrupts the run at the wait number `after`."""
    passes, left = TimeSlices.passes_among_others, after

    def ends(scheduler: TimeSlices, since: float, end: float, by_arrival: bool) -> float:
        nonlocal left
        left -= 1
        if not left:
            raise KeyboardInterrupt
        return passes(scheduler, since, end, by_arrival)

    return ends


@pytest.mark.parametrize("after", [1, 2, 5])
def test_a_signal_in_such_a_wait_leaves_a_whole_log(after: int, monkeypatch: pytest.MonkeyPatch) -> None:
    program, machine = MEETS["nothing"]
    source = Source("waits.mnt", SETTINGS + program.replace("{move}", MOVE) + "\n")
    whole = execution.run(source, machine=machine, cache=False)
    monkeypatch.setattr(TimeSlices, "passes_among_others", interrupting(after))
    ended = execution.run(source, machine=machine, cache=False)
    assert ended.status == "interrupted"
    waits = list(ended.machine.log.waits)
    assert waits == list(whole.machine.log.waits)[: len(waits)]
    assert text(ended)


@pytest.mark.parametrize(
    ("next_index", "indices", "last"),
    [
        (0, {0, 2}, 2),
        (1, {0, 2}, 0),
        (2, {0, 2}, 0),
        (3, {0, 2}, 2),
        (3, {0, 1, 2, 3}, 2),
        (0, {3, 1}, 3),
        (2, {3, 1}, 1),
        (2, {2, 3}, 3),
        (3, {1}, 1),
        (1, {1}, 1),
    ],
)
def test_the_task_whose_wait_is_checked_last(next_index: int, indices: set[int], last: int) -> None:
    """Of four tasks, the search begins at the next one and goes around."""
    tasks: list[Any] = ["one", "two", "three", "four"]
    scheduler: Any = SimpleNamespace(_next_index=next_index, tasks=tasks)
    assert TimeSlices._last_checked(scheduler, indices) == tasks[last]


class Arrival(Wait):
    """A wait that ends with the event of a move, at `time`."""

    __slots__ = ("time",)

    def __init__(self, time: float) -> None:
        super().__init__(0.0, lambda: False, lambda: time, "for axis 0", "axis")
        self.time = time

    def expected(self) -> float:
        return self.time


class Scripted(Task):
    """A task whose time slices are given.

    Each has its duration and that of the WAIT after it, s. A slice without a WAIT ends at the horizon or earlier.
    It records when it is resumed, and its horizons.
    """

    def __init__(self, name: str, wait: Wait | None, *slices: tuple[float, float | None]) -> None:
        super().__init__(name)
        self.wait, self._slices, self.resumed = wait, list(slices), list[tuple[float, float]]()

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        self.resumed.append((now, horizon))
        lasts, waits = self._slices.pop(0)
        time = now + lasts
        return time, None if waits is None else until(time + waits, time)


def until(end: float, since: float = 0.0) -> Delay:
    return Delay(CLOCK, since, end)


CLOCK = Clock()
# A slice of 1 ms less a ns.
FULL = 0.001 - 1e-9


class Scripts:
    """A scheduler of scripted tasks."""

    def __init__(self, *tasks: Scripted) -> None:
        self.tasks = tasks
        self.made = TimeSlices(Controller(1), tasks[0])
        self.made.tasks[:] = tasks
        self.clock, self.log = self.made.clock, self.made.machine.log
        self.made._end, self.made._idle_rounds, self.made._stalls = 0.5, 7, 3
        self.made.until = 1.0

    def round(self, until: float = 1.0) -> bool:
        self.made.until = until
        return self.made.idle_round(until)

    def resumed(self) -> list[list[tuple[float, float]]]:
        return [task.resumed for task in self.tasks]

    def slices(self) -> list[tuple[object, ...]]:
        return [(each.tasks, each.time, each.until) for each in self.log.slices]

    def waits(self) -> list[tuple[object, ...]]:
        return [tuple(each)[:1] + tuple(each)[2:4] for each in self.log.waits]


def a_and_b(a: float = 0.005, b: float = 0.007) -> Scripts:
    """Return two tasks in WAITs up to 5 ms and 7 ms.

    A slice of A lasts 10 µs, and one of B 20 µs.
    """
    return Scripts(
        Scripted("A", until(a), (1e-5, 0.004), (1e-5, 0.004), (1e-5, 0.004)),
        Scripted("B", until(b), (2e-5, 0.01), (2e-5, 0.01)),
    )


def test_waiting_tasks_resume_one_after_the_other() -> None:
    """A waits for 4 ms and B for 10 ms after each slice.

    The third wait ends at 9.01 ms, which is too late.
    """
    scripts = a_and_b()
    assert scripts.round(0.00901)
    assert scripts.resumed() == [[(0.005, 0.005 + FULL)], [(0.007, 0.007 + FULL)]]
    assert scripts.made._alone
    assert scripts.slices() == [(("A",), 0.005, 0.00501), (("B",), 0.007, 0.00702)]
    assert scripts.waits() == [("A", 0.0, 0.005), ("B", 0.0, 0.007)]
    made, ends = scripts.made, [task.wait.ends for task in scripts.tasks if task.wait is not None]
    assert ends == [0.00501 + 0.004, 0.00702 + 0.01]
    assert (made.clock.now, made.current.name, made.next_index, made.next_slice) == (0.00702, "B", 2, -inf)
    assert (made._end, made._idle_rounds, made._stalls, made._resumed) == (0.0, 0, 0, 0)
    assert made._surely == ends
    assert scripts.round(0.00902)
    assert scripts.resumed()[0][1:] == [(0.00901, 0.00902)]


@cases(
    "a, b, now, end, event, resumes",
    (
        (0.005, 0.007, 0.0, 1.0, None, True),
        (0.005, 0.005 + 0.9e-9, 0.0, 1.0, None, False),
        (0.005, 0.005 + 1e-9, 0.0, 1.0, None, False),
        (0.005, 0.005 + 1.1e-9, 0.0, 1.0, None, True),
        (0.005, 0.007, 0.005 - 0.9e-9, 1.0, None, False),
        (0.005, 0.007, 0.005 - 1.1e-9, 1.0, None, True),
        (0.005, 0.007, 0.0, 0.005, None, False),
        (0.005, 0.007, 0.0, 0.0051, None, True),
        (0.005, 0.007, 0.0, 1.0, 0.005, False),
        (0.005, 0.007, 0.0, 1.0, 0.004, False),
        (0.005, 0.007, 0.0, 1.0, 0.0050001, True),
    ),
)
def test_a_wait_that_does_not_end_first_and_alone_is_left_to_the_scheduler(
    a: float, b: float, now: float, end: float, event: float | None, resumes: bool
) -> None:
    """Times within 1 ns are one time.

    An event comes before a wait that ends at its time.
    """
    scripts = a_and_b(a, b)
    scripts.clock.now = now
    if event is not None:
        scripts.clock.at(event, lambda: None)
    assert scripts.round(end) == resumes
    assert bool(scripts.resumed()[0]) == resumes
    if not resumes:
        assert (scripts.clock.now, scripts.made._end, scripts.made._idle_rounds) == (now, 0.5, 7)


@pytest.mark.parametrize(("field", "value"), [("_left", 1), ("is_observed", True)])
def test_no_round_begins_within_long_slices_or_while_waits_are_observed(field: str, value: object) -> None:
    scripts = a_and_b()
    setattr(scripts.made, field, value)
    assert not scripts.round()
    assert scripts.resumed() == [[], []]


def test_a_cancelled_event_is_none() -> None:
    scripts = a_and_b()
    scripts.clock.at(0.004, lambda: None).cancel()
    assert scripts.round(0.006)
    assert scripts.resumed() == [[(0.005, 0.005 + FULL)], []]


def left_by(scripts: Scripts) -> list[tuple[object, ...]]:
    """Run a round.

    Return what it leaves to the scheduler: the task, the next event, and its end.
    """
    left: list[tuple[object, ...]] = []

    def leave(task: Task, event: float, time: float, several: bool) -> None:
        left.append((task.name, event, time, several))

    scripts.made._leave = leave  # type: ignore[method-assign]
    assert scripts.round()
    return left


@cases(
    "a, event, polls, left",
    (
        # A runs to the end of its slice, or to an event that comes before that.
        (((FULL, None),), None, False, ("A", 1.0, 0.005 + FULL, True)),
        (((0.0003, None),), 0.0053, False, ("A", 0.0053, 0.0053, True)),
        # It waits again, but only polled, or an event came at the end of its slice.
        (((1e-5, 0.004),), None, True, ("A", 1.0, 0.00501, True)),
        (((1e-5, 0.004),), 0.00501, False, ("A", 0.00501, 0.00501, True)),
        (((1e-5, 0.004),), 0.005009, False, ("A", 0.005009, 0.00501, True)),
    ),
)
def test_a_task_that_does_more_than_wait_again_is_left_to_the_scheduler(
    a: tuple[tuple[float, float | None], ...], event: float | None, polls: bool, left: tuple[object, ...]
) -> None:
    scripts = Scripts(Scripted("A", until(0.005), *a), Scripted("B", until(0.2)))
    if event is not None:
        scripts.clock.at(event, lambda: None)
    if polls:
        scripts.tasks[0].poll_check = 0, True
    assert left_by(scripts) == [left]
    made = scripts.made
    assert (made._idle_rounds, made._stalls, made._waiting) == (7, 0, [scripts.tasks[1]])
    assert (made.next_slice, made.began, made._end) == (-inf, 0.005, 0.005 + FULL)
    assert scripts.slices() == []


def test_a_second_task_that_continues_ends_the_idle_rounds() -> None:
    scripts = Scripts(Scripted("A", until(0.005), (1e-5, 0.2)), Scripted("B", until(0.007), (FULL, None)))
    assert left_by(scripts) == [("B", 1.0, 0.007 + FULL, True)]
    assert scripts.made._idle_rounds == 0
    scripts = Scripts(Scripted("A", until(0.005), (FULL, None)), Scripted("B", until(0.007)))
    scripts.made._resumed = 5  # it is set again as a round begins
    assert left_by(scripts) == [("A", 1.0, 0.005 + FULL, True)]
    assert scripts.made._idle_rounds == 7


@cases("wakes, resumes", ((False, True), (True, False)))
def test_a_task_resumes_with_the_event_that_ends_its_move(wakes: bool, resumes: bool) -> None:
    """The event at 5 ms ends the move that A waits for.

    If it `wakes` another task, the scheduler decides. B is the last one whose wait would be checked.
    """
    scripts = Scripts(Scripted("A", Arrival(0.005), (1e-5, 0.004)), Scripted("B", Arrival(0.007)))
    located: list[str] = []

    def ends() -> bool:
        located.append(scripts.made.current.name)
        return not wakes

    scripts.clock.at(0.005, ends)
    assert scripts.round(0.006) == resumes
    assert located == ["B"]
    assert scripts.clock.now == (0.00501 if resumes else 0.005)
    assert scripts.resumed() == [[(0.005, 0.005 + FULL)] if resumes else [], []]


@cases(
    "others, event, longest, horizon",
    (
        # B waits for the end of a move, which may be later than it seems; C is in a WAIT.
        ((Arrival(0.0053), until(0.0054)), None, inf, 0.0054 - 0.5e-9),
        ((until(0.0053), until(0.0054)), None, inf, 0.0053 - 0.5e-9),
        ((Arrival(0.0053), until(0.0054)), 0.0052, inf, 0.0052),
        ((Arrival(0.0053), until(0.0054)), None, 0.0002, 0.0052),
        ((Arrival(0.0053), Arrival(0.0054)), None, inf, 0.005 + FULL),
    ),
)
def test_a_time_slice_ends_before_another_wait_may_end(
    others: tuple[Wait, ...], event: float | None, longest: float, horizon: float
) -> None:
    """Task A is resumed at 5 ms, and may run for 1 ms or for its longest slice."""
    first = Scripted("A", until(0.005), (1e-5, 0.004))
    first.poll_check, first.max_slice = (0, True), longest
    scripts = Scripts(first, *(Scripted(name, wait) for name, wait in zip("BC", others, strict=True)))
    if event is not None:
        scripts.clock.at(event, lambda: None)
    assert left_by(scripts) == [("A", event or 1.0, 0.00501, True)]
    assert first.resumed == [(0.005, horizon)]
    assert scripts.made._end == 0.005 + min(longest, FULL)


@cases(
    "waits, is_listed, ends, resting",
    (
        ((until(0.005), until(0.007)), True, [0.005, 0.007], set[int]()),
        ((until(0.005), Arrival(0.006), until(0.007)), True, [0.005, inf, 0.007], {1}),
        ((until(0.005), None), False, [], set[int]()),
        ((until(0.005),), False, [], set[int]()),
    ),
)
def test_the_waits_of_all_tasks_are_listed(
    waits: tuple[Wait | None, ...], is_listed: bool, ends: list[float], resting: set[int]
) -> None:
    """There must be two tasks or more, and all must wait.

    The end of a move is not certain.
    """
    tasks = [Scripted(f"T{k}", wait) for k, wait in enumerate(waits)]
    made = Scripts(*tasks).made
    assert made._list_waits() == is_listed
    assert (made._known, made._ends, made._surely, made._resting) == ([*waits], ends, ends, resting)
    assert made._names == ([(task.name,) for task in tasks] if is_listed else [])
    assert made._ends is not made._surely


@cases(
    "end, by_arrival, event, wakes, horizon",
    (
        (0.005, False, None, False, 0.005 + FULL),
        (0.005, False, 0.0055, False, 0.0055),
        (0.0068, False, None, False, 0.007 - 0.5e-9),
        (0.007 - 1.1e-9, False, None, False, 0.007 - 0.5e-9),
        (0.007 - 0.9e-9, False, None, False, 0.0),
        (0.007 - 1e-9, False, None, False, 0.0),
        (0.008, False, None, False, 0.0),
        (0.005, False, 0.005, False, 0.0),
        (0.005, False, 0.0049, False, 0.0),
        (0.0041, False, None, False, 0.0041 + FULL),
        (0.004 + 1.1e-9, False, None, False, 0.004 + 1.1e-9 + FULL),
        (0.004 + 0.9e-9, False, None, False, 0.0),
        (0.005, True, 0.005, False, 0.005 + FULL),
        (0.005, True, 0.005, True, 0.0),
        (0.005, True, None, False, 0.0),
        (0.005, True, 0.0049, False, 0.0),
    ),
)
def test_a_wait_of_the_next_task_passes_within_its_statement(
    end: float, by_arrival: bool, event: float | None, wakes: bool, horizon: float
) -> None:
    """Task A runs from 3 ms on, and waits from 4 ms on.

    B is in a WAIT up to 7 ms, C waits for a move up to 7.5 ms. The slice after the wait ends before the next
    wait, at an event or after 1 ms.
    """
    scripts = Scripts(Scripted("A", None), Scripted("B", until(0.007)), Scripted("C", Arrival(0.0075)))
    made, clock, located = scripts.made, scripts.clock, list[str]()
    for task in scripts.tasks[:1]:
        task.wait = until(0.003)
    assert made._list_waits()
    made._known[0], made._ends[0], made._surely[0] = None, inf, inf
    made.began, made.current, made._index, made._resumed, made._alone = 0.003, scripts.tasks[0], 0, 4, False
    clock.now = 0.003

    def rings() -> bool:
        located.append(made.current.name)
        return not wakes

    if event is not None:
        clock.at(event, rings)
    assert made.passes_among_others(0.004, end, by_arrival) == horizon
    assert made.next_slice == 0.007
    assert made.current.name == "A"
    assert located == ["C"] * (by_arrival and event == end)
    if horizon:
        assert (clock.now, made.began, made._resumed, made._alone, made._end) == (
            end,
            end,
            5,
            True,
            end + FULL,
        )
        assert scripts.slices() == [(("A",), 0.003, 0.004)]
    else:
        assert (made.began, made._resumed, made._alone, scripts.slices()) == (0.003, 4, False, [])


def test_a_move_may_end_later_than_it_seems() -> None:
    """Task A may run past 5.5 ms, where the move that C waits for seems to end.

    A cancelled event is none.
    """
    scripts = Scripts(
        Scripted("A", until(0.003)), Scripted("B", until(0.007)), Scripted("C", Arrival(0.0055))
    )
    made = scripts.made
    assert made._list_waits()
    made._known[0], made._ends[0], made._surely[0] = None, inf, inf
    made.began = 0.003
    scripts.clock.at(0.0049, lambda: None).cancel()
    assert made.passes_among_others(0.004, 0.005, False) == 0.005 + FULL
    assert made.next_slice == 0.0055


@cases("resumed, within, idle_rounds", ((1, 0, 7), (2, 0, 0), (1, 1, 0), (2, 3, 0)))
def test_a_round_in_which_several_waits_have_ended_is_not_idle(
    resumed: int, within: int, idle_rounds: int
) -> None:
    """Resumed tasks count, and so do waits that have passed within statements."""
    scripts, left = a_and_b(), list[object]()
    made, first = scripts.made, scripts.tasks[0]
    made._leave = lambda *given: left.append(given)  # type: ignore[method-assign]
    made._resumed, made._event = within, 0.8
    made._end_round(first, 0.25, resumed)
    assert (made._idle_rounds, made._stalls, left) == (idle_rounds, 0, [(first, 0.8, 0.25, True)])


@cases(
    "began, until_, interrupts, horizon",
    (
        (0.004, 1.0, 0, 0.005 + FULL),
        (0.0041, 1.0, 0, 0.0),
        (0.003, 0.005, 0, 0.0),
        (0.003, 0.0051, 0, 0.0051),
        (0.003, 1.0, 1, 0.0),
    ),
)
def test_a_wait_does_not_pass_beyond_the_run_or_in_a_handler(
    began: float, until_: float, interrupts: int, horizon: float
) -> None:
    """The wait of task A lasts from 4 ms to 5 ms."""
    scripts = Scripts(Scripted("A", until(0.003)), Scripted("B", until(0.007)))
    made = scripts.made
    assert made._list_waits()
    made._known[0], made._ends[0], made._surely[0] = None, inf, inf
    made.began, made.until, made.interrupts = began, until_, [*scripts.tasks[1:]] * interrupts
    assert made.passes_among_others(0.004, 0.005, False) == horizon


def handled(
    several: bool, lasts: float, event: float | None = None, longest: float = inf, ends: bool = True
) -> tuple[object, ...]:
    """Run a handler from 5 ms on, up to 20 ms.

    Return if it has ended, its horizon, and what is left. Another task may be in a WAIT. A handler that does not
    end stops in a wait.
    """
    tasks = [Scripted("A", until(0.5)), Scripted("B", until(0.7))][: 1 + several]
    scripts, handler = Scripts(*tasks), Scripted("timer", None, (lasts, None if ends else 0.1))
    made, left = scripts.made, list[tuple[object, ...]]()
    handler.max_slice = longest

    def resume(now: float, horizon: float) -> tuple[float, Wait | None]:
        handler.done = ends
        return Scripted.resume(handler, now, horizon)

    def leave(task: Task, event: float, time: float, several: bool) -> None:
        left.append((event, time, several))
        made.interrupts.remove(task)

    handler.resume, made._leave = resume, leave  # type: ignore[method-assign]
    made.clock.now = 0.005
    made._known, made.next_slice, made._next_index, made._end = [1], 3.0, 1, 0.0
    if event is not None:
        made.clock.at(event, lambda: None)
    over = made.ran_handler(handler, 0.02)
    assert (made._known, made.next_slice, made._next_index, made._stalls) == ([], -inf, 0, 0)
    assert (made.current, made._alone, made.began, made.interrupts) == (handler, True, 0.005, [])
    assert (made._statements.alone, made._statements.free) == (not several, -inf)
    ((now, horizon),) = handler.resumed
    assert now == 0.005
    return over, horizon, made._end, made.clock.now, left


@cases(
    "several, lasts, event, longest, ends, result",
    (
        (False, 1e-5, None, inf, True, (True, 0.02, 0.0, 0.00501, [])),
        (False, 1e-5, 0.006, inf, True, (True, 0.006, 0.0, 0.00501, [])),
        (False, 1e-5, 0.03, inf, True, (True, 0.02, 0.0, 0.00501, [])),
        (False, 0.001, 0.006, inf, True, (True, 0.006, 0.0, 0.005, [(0.006, 0.006, False)])),
        (False, 1e-5, None, inf, False, (False, 0.02, 0.0, 0.005, [(0.02, 0.00501, False)])),
        (True, 1e-5, None, inf, True, (True, 0.005 + FULL, 0.005 + FULL, 0.005, [(0.02, 0.00501, True)])),
        (True, 1e-5, None, 0.0002, True, (True, 0.0052, 0.0052, 0.005, [(0.02, 0.00501, True)])),
        (True, 1e-5, 0.0051, inf, True, (True, 0.0051, 0.005 + FULL, 0.005, [(0.0051, 0.00501, True)])),
        (True, 1e-5, None, inf, False, (False, 0.005 + FULL, 0.005 + FULL, 0.005, [(0.02, 0.00501, True)])),
    ),
)
def test_a_handler_interrupts_waiting_tasks(
    several: bool,
    lasts: float,
    event: float | None,
    longest: float,
    ends: bool,
    result: tuple[object, ...],
) -> None:
    """Next to several tasks its time slice lasts at most 1 ms."""
    assert handled(several, lasts, event, longest, ends) == result


class Counted:
    """A search for periods that records how it is used."""

    def __init__(self, is_eager: bool) -> None:
        self.calls, self._is_eager = list[object](), is_eager

    def forget(self) -> None:
        self.calls.append("forget")

    def has_run(self, task: Task) -> None:
        self.calls.append(task.name)

    def is_eager(self, count: int) -> bool:
        return self._is_eager and count == 2

    def leap(self, tasks: list[Task], *given: object) -> None:
        self.calls.append((len(tasks), *given))


LEAP = (2, 1, 1.0, False)


@cases(
    "rounds, is_eager, change, calls, after",
    (
        (0, False, None, ["A"], 1),
        (1, False, None, ["A", LEAP], 2),
        (5, False, None, ["A", LEAP], 6),
        (0, True, None, ["A", "forget", LEAP], 1),
        (1, True, None, ["A", LEAP], 2),
        (5, True, "acted", ["forget"], 0),
        (5, True, "busy", ["forget"], 0),
        (5, True, "done", ["forget"], 0),
        (5, True, "interrupted", ["forget"], 0),
        (5, True, "outside", ["forget"], 0),
    ),
)
def test_a_period_is_searched_for_after_a_slice_without_an_action(
    rounds: int, is_eager: bool, change: str | None, calls: list[object], after: int
) -> None:
    """Unless the search is eager, both tasks must have had such a slice."""
    first = Scripted("A", None)
    first.poll_check = 0, True
    scripts = Scripts(first, Scripted("B", None))
    made, search = scripts.made, Counted(is_eager)
    made._recurrence, made._idle_rounds, made._next_index = search, rounds, 1  # type: ignore[assignment]
    if change == "acted":
        first.poll_check = None
    elif change == "interrupted":
        made.interrupts.append(first)
    elif change == "outside":
        made.outside = SimpleNamespace()
    elif change is not None:
        setattr(first, change, 1)
    made.slice_over(first)
    assert (search.calls, made._idle_rounds) == (calls, after)


def test_the_first_search_begins_when_each_task_has_had_a_slice() -> None:
    first = Scripted("A", None)
    scripts = Scripts(first, Scripted("B", None))
    made = TimeSlices(Controller(1), first)
    assert (made._idle_rounds, made.next_slice) == (0, -inf)
    scripts.made.slice_over(first)
    assert scripts.made._idle_rounds == 0
    first.poll_check = 0, True
    scripts.made.slice_over(first)
    assert scripts.made._recurrence is None
    scripts.made.slice_over(first)
    assert scripts.made._recurrence is not None


@pytest.mark.parametrize(("rounds", "calls"), [(1023, 0), (1024, 2), (1500, 2), (2048, 4)])
def test_the_log_is_packed_after_1024_waits(rounds: int, calls: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the waits and of the time slices, the older ones are packed."""
    trimmed = count_calls(monkeypatch, (Stream, "trim"))
    first = Scripted("A", until(0.001), *[(1e-5, 0.001)] * rounds)
    scripts = Scripts(first, Scripted("B", until(5.0)))
    assert scripts.round(0.001 + 0.00101 * rounds - 1e-4)
    assert len(first.resumed) == rounds
    assert trimmed.calls == calls


@pytest.mark.parametrize(("resumed", "calls"), [(1022, 0), (1023, 2), (1024, 0)])
def test_the_log_is_packed_after_1024_waits_within_statements(
    resumed: int, calls: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    trimmed = count_calls(monkeypatch, (Stream, "trim"))
    made = a_and_b().made
    assert made._list_waits()
    made._known[0], made._ends[0], made._surely[0] = None, inf, inf
    made.began, made._resumed = 0.003, resumed
    assert made.passes_among_others(0.004, 0.005, False)
    assert trimmed.calls == calls
