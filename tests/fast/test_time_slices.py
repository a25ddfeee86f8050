"""The task whose wait ends first continues without a task switch, equally."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang import execution
from motionlang.fast.time_slices import TimeSlices
from motionlang.report import text
from motionlang.result import Run
from motionlang.source import Source

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
