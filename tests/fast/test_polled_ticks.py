"""Ticks of TIMER are skipped while tasks poll, as if all handlers had run."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from motionlang import report, run
from motionlang.fast.polled_ticks import PolledTicks
from motionlang.mint.runtime.events import EventTask
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import cases
from tests.counted_calls import count_calls

_HEAD = "Dim n As Integer, m As Integer\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
_MOVE = "MOVEA(0) = 400 : GO(0)\nWhile Not IDLE(0)\n  {}\nEnd While\n"


@pytest.fixture
def skipped(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Return a function that gives the number of ticks skipped since its last call."""
    found = [0]
    passed = PolledTicks._pass

    def counted(self: PolledTicks, walk: Any, *given: Any) -> None:
        found[0] += sum(count for step, count in walk.times().items() if step.handler is not None)
        passed(self, walk, *given)

    def since() -> int:
        count, found[0] = found[0], 0
        return count

    monkeypatch.setattr(PolledTicks, "_pass", counted)
    return since


def ran(text: str, **machine: object) -> Run:
    """Run a program; check that report and records are equal without accelerators."""
    fast, plain = (
        run(Source("a.mnt", _HEAD + text), machine=machine, cache=False, fast=fast, until=20.0)
        for fast in (True, False)
    )
    for stream in ("outputs", "events", "prints", "settings"):
        assert list(getattr(fast.machine.log, stream)) == list(getattr(plain.machine.log, stream))
    assert report.text(fast) == report.text(plain)
    return fast


def handled(text: str, handler: str, period: int = 1) -> str:
    """Return a program with a TIMER handler; at its end it prints `n` and `m`."""
    start = f'TIMEREVENT = {period}\n{text}TIMEREVENT = 0\nPRINT n, " ", m\nEnd\n'
    return f"{start}Event TIMER\n{handler}\nEnd Event\n"


def executed(found: Run, skipped: Callable[[], int]) -> int:
    """Return how many ticks were executed, not skipped, since the last call."""
    return len(found.machine.log.events) - skipped()


def printed(found: Run) -> list[int]:
    return [int(each) for each in found.machine.terminal.lines[-1].split()]


def test_a_tick_at_the_end_of_a_handler_interrupts_no_loop() -> None:
    """A handler of four statements of 0.25 ms ends with the next tick."""
    move = "MOVEA(0) = 12 : GO(0)\nWhile Not IDLE(0)\n  If VEL(0) > 30 Then OUTX(2) = 1 Else OUTX(2) = 0\nEnd While\n"
    ran(
        handled(f"SPEED(0) = 50 : {move}", "If VEL(0) > 30 Then n = n + 1"),
        **{"controller.instruction_time": 2.5e-4},
    )


def test_a_round_counts_from_the_same_end_each_time() -> None:
    """A handler may end just as a WAIT is over, whose iteration counts from the tick."""
    ran(
        "Run T0\nTIMEREVENT = 2\nLoop\nOUTX(5) = Not OUTX(5)\nWAIT(1)\nIf TIME > 900 Then Exit Loop\nEnd Loop\nEnd\n"
        "Event TIMER\n  n = n + 1\nEnd Event\nTask T0\nLoop\n  PAUSE INX(1)\n  WAIT(5)\nEnd Loop\nEnd Task\n"
    )


def test_a_counter_has_counted_every_tick_of_a_move(skipped: Callable[[], int]) -> None:
    """The move takes 0.1 s for the 5 uu at each end, and 3.9 s for the other 390."""
    found = ran(handled(_MOVE.format(""), "n = n + 1"))
    assert printed(found) == [4100, 0]
    assert len(found.machine.log.events) == 4100
    assert executed(found, skipped) == 5


@cases(
    "body, cost, count",
    (
        ("", 1e-5, 5),
        ("", 0.7310585e-5, 4),
        ("If INX(5) Then STOP(0)", 0.7310585e-5, 5),
        ("If INX(5) Then STOP(0)", 4e-5, 6),
        ("If INX(5) Then STOP(0)\n  If INX(6) Then STOP(0)", 4e-5, 6),
        ("If INX(5) Then STOP(0)\n  If INX(6) Then STOP(0)", 3e-6, 7),
        ("m = POS(1)", 3e-6, 5),
        ("m = POS(1)", 1e-5, 7),
    ),
)
@pytest.mark.slow
def test_iterations_of_any_length_are_interrupted_at_the_same_statement(
    body: str, cost: float, count: int, skipped: Callable[[], int]
) -> None:
    """The log has the source position of the statement that each tick interrupts.

    `count` ticks are executed.
    """
    found = ran(handled(_MOVE.format(body), "n = n + 1"), **{"controller.instruction_time": cost})
    assert executed(found, skipped) == count


def test_a_toggled_output_has_a_record_for_each_change(skipped: Callable[[], int]) -> None:
    found = ran(handled(_MOVE.format(""), "OUTX(3) = Not OUTX(3)", 10))
    values = [each.value for each in found.machine.log.outputs]
    assert values == [(k + 1) % 2 for k in range(410)]
    assert executed(found, skipped) == 10


@cases(
    "handler, n, m, count",
    (
        ("n = n + 1\nIf n >= 100 Then n = 0 : m = m + 1", 0, 41, 211),
        ("n = n + 1\nIf n = 3777 Then m = 5", 4100, 5, 11),
        ("n = n + 1\nIf n > 2500 And n <= 3000 Then m = m + 1", 4100, 500, 17),
        ("n = n + 1\nIf n = 2000 Then OUTX(1) = 1 Else OUTX(1) = 0", 4100, 0, 13),
        ("n = n - 3", -12_300, 0, 7),
        ("n = 1 - n", 0, 0, 14),
        ("m = n\nn = n + 1", 4100, 4099, 4100),
        ("If INX(2) Then n = n + 1", 2000, 0, 10),
        ("If POS(0) > 205.05 Then n = n + 1", 2000, 0, 12),
    ),
)
@pytest.mark.slow
def test_a_handler_that_decides_does_so_at_the_right_tick(
    handler: str, n: int, m: int, count: int, skipped: Callable[[], int]
) -> None:
    """Input 2 is on for 2 s. The axis passes 205.05 at 2.1005 s: 5 uu take 0.1 s.

    Of the 4100 ticks `count` are executed: all if the effects of no two are equal.
    """
    found = ran(handled(_MOVE.format(""), handler), input=[{"channel": 2, "at": 1.0005, "for": 2.0}])
    assert printed(found) == [n, m]
    assert executed(found, skipped) == count


@cases(
    "handler, body, count",
    (
        ("If POS(0) > 50 Then m = m + 1", "", 61),
        ("If POS(0) > 50 Then OUTX(1) = 1 Else OUTX(1) = 0", "If POS(0) > 70 Then OUTX(2) = 1", 93),
        ("If INX(2) Then m = m + 1", "WAIT(5)", 114),
        ("OUTX(3) = Not OUTX(3)", "If INX(2) Then OUTX(4) = 1 Else OUTX(4) = 0", 118),
    ),
)
@pytest.mark.slow
def test_what_was_executed_before_an_event_is_known_after_it(
    handler: str, body: str, count: int, skipped: Callable[[], int]
) -> None:
    """Three moves of 100 there and three back, of 1.1 s each.

    An input is on for half of the time. Of some 6600 ticks `count` are executed.
    """
    moves = "".join(f"MOVEA(0) = {to} : GO(0)\nWhile Not IDLE(0)\n  {body}\nEnd While\n" for to in (100, 0))
    marks = [{"channel": 2, "at": 0.1, "every": 0.6, "for": 0.3}]
    found = ran(handled(moves * 3, handler), input=marks)
    handlers = sum(each.kind == "handler" for each in found.machine.log.events)
    assert handlers in range(6600, 6640)
    assert handlers - skipped() == count


@pytest.mark.parametrize(
    "body",
    [
        "If IDLE(0, 1) Then m = m + 1",
        "If IDLE And OUT = 0 Then m = m + 1",
        "If n > 90000 And IDLE(99) Then m = 5",
        "If n > 90000 And INX(9999) Then m = 5",
        "If n > 90000 And POS(99) > 5 Then m = 5",
        "If INX(m) Then m = 1",
        "If IN And 4 Then OUTX(1) = 1",
        "If POS(0) > m Then OUTX(1) = 1",
        "If TIME > 500 Then OUTX(1) = 1",
        "m = TIME",
    ],
)
def test_readings_without_outcomes_are_read_after_each_event(body: str) -> None:
    moves = "".join(f"MOVEA(0) = {to} : GO(0)\nWhile Not IDLE(0)\n  WAIT(5)\nEnd While\n" for to in (20, 0))
    marks = [{"channel": 2, "at": 0.1, "every": 0.6, "for": 0.3}]
    ran("AXES(0, 1)\n" + handled(moves * 3, f"n = n + 1\n{body}"), input=marks)


def test_a_loop_that_polls_the_counter_sees_each_value(skipped: Callable[[], int]) -> None:
    """The loop ends by the counter, so ticks that change it are not skipped."""
    found = ran(handled("While n < 700\nEnd While\nm = n\n", "n = n + 1"))
    assert printed(found)[1] == 700
    assert skipped() == 0


def test_a_handler_that_sets_what_the_loop_polls_ends_it() -> None:
    assert printed(ran(handled("While m = 0\nEnd While\n", "n = n + 1\nIf n = 1234 Then m = 7"))) == [1234, 7]


def test_a_tick_that_sets_the_counter_is_no_count() -> None:
    """The counter goes from 4 to 5 once, and each later tick sets it to 5."""
    text = "n = 4\n" + _MOVE.format("")
    assert printed(ran(handled(text, "If n >= 5 Then n = 4\nn = n + 1"))) == [5, 0]


def test_tasks_that_poll_beside_the_timer_are_skipped(skipped: Callable[[], int]) -> None:
    tasks = "Task Lamp\nLoop\n  OUTX(1) = VEL(0) > 0\nEnd Loop\nEnd Task\n"
    text = "Run Lamp\n" + handled("MOVEA(0) = 400 : GO(0)\nPAUSE IDLE(0)\n", "n = n + 1") + tasks
    found = ran(text)
    assert printed(found) == [4100, 0]
    assert executed(found, skipped) == 6


@cases(
    "body, period, count",
    (
        ("WAIT(5)", 10, 8),
        ("n = n + 1\n  WAIT(5)", 10, 12),
        ("WAIT(1)", 10, 10),
        ("WAIT(0.3)", 7, 17),
        ("If INX(5) Then STOP(0)\n  WAIT(5)", 1, 34),
        ("WAIT(1)", 1, 52),
    ),
)
def test_a_loop_with_a_wait_is_skipped(
    body: str, period: int, count: int, skipped: Callable[[], int]
) -> None:
    """WAITs end between ticks, in handlers and at interrupted statements.

    `count` ticks are executed.
    """
    found = ran(handled(_MOVE.format(body), "m = m + 1\nOUTX(3) = Not OUTX(3)", period))
    assert len(found.machine.log.events) in range(4100 // period, 4106 // period + 1)
    assert executed(found, skipped) == count


def test_a_loop_with_a_wait_has_counted_each_iteration() -> None:
    """The move takes 4.1 s, and an iteration 5.03 ms: a WAIT and three statements.

    The iteration with number 815 begins at 815 * 5.03 ms = 4.0995 s, the next one would begin at 4.1045 s. A tick
    during a WAIT delays nothing, and one that comes between the three statements 20 us at most, at 1 % of the ticks.
    """
    n, m = printed(ran(handled(_MOVE.format("n = n + 1\n  WAIT(5)"), "m = m + 1", 10)))
    assert n == 816
    assert m == 410


def test_a_loop_counts_up_to_a_constant(skipped: Callable[[], int]) -> None:
    """An iteration takes three statements, so 5000 of them take 0.15 s."""
    body = "k = k + 1\n  If k = 5000 Then n = TIME"
    found = ran(handled(_MOVE.format(body), "m = m + 1", 10))
    assert printed(found) == [150, 410]
    assert executed(found, skipped) == 7


def test_a_counter_that_another_loop_changes_is_no_counter() -> None:
    """The second loop doubles what the first one has counted."""
    text = "While TIME < 500\n  k = k + 1\nEnd While\nk = 3\n"
    text += "While k < 1000000 And TIME < 900\n  k = k * 2\n  WAIT(10)\nEnd While\nn = k\n"
    assert printed(ran(handled(text, "m = m + 1", 10)))[0] == 3 * 2**19


@cases(
    "main, tasks, count",
    (
        ("PAUSE IDLE(0)", ("OUTX(1) = VEL(0) > 0\n  WAIT(10)",), 6),
        ("While Not IDLE(0) : End While", ("OUTX(1) = VEL(0) > 0\n  WAIT(10)",), 5),
        ("PAUSE IDLE(0)", ("If INX(1) Then STOP(0)\n  WAIT(10)", "If INX(2) Then STOP(0)\n  WAIT(10)"), 6),
        ("While Not IDLE(0) : WAIT(5) : End While", ("OUTX(7) = 1 : WAIT(50) : OUTX(7) = 0 : WAIT(50)",), 11),
        ("While Not IDLE(0) : WAIT(5) : End While", ("OUTX(1) = VEL(0) > 0",), 9),
    ),
)
def test_tasks_with_waits_of_their_own_are_skipped(
    main: str, tasks: tuple[str, ...], count: int, skipped: Callable[[], int]
) -> None:
    """Of the 410 ticks `count` are executed."""
    text = "".join(f"Run T{k}\n" for k in range(len(tasks)))
    text += handled(f"MOVEA(0) = 400 : GO(0)\n{main}\n", "n = n + 1", 10)
    for k, body in enumerate(tasks):
        text += f"Task T{k}\nLoop\n  {body}\nEnd Loop\nEnd Task\n"
    found = ran(text)
    assert printed(found)[0] == 410
    assert executed(found, skipped) == count


@cases("wait, period", ((9, 1), (7, 1), (23, 10)))
def test_two_tasks_that_write_one_output_switch_it_in_time(wait: int, period: int) -> None:
    """The second task resets the output in its next iteration, not at the next tick."""
    text = "Run T0\nRun T1\n" + handled("MOVEA(0) = 200 : GO(0)\nPAUSE IDLE(0)\n", "", period)
    text += f"Task T0\nLoop\n  If INX(1) Then OUTX(7) = 1\n  WAIT({wait})\nEnd Loop\nEnd Task\n"
    text += "Task T1\nLoop\n  If VEL(1) > 0 Then OUTX(7) = 1 Else OUTX(7) = 0\nEnd Loop\nEnd Task\n"
    ran(text, input=[{"channel": 1, "at": 0.2}])


def test_an_input_between_two_ticks_ends_a_loop_with_a_wait() -> None:
    """The input comes at 1.0234 s, between two ticks.

    The loop sees it after its WAIT.
    """
    text = "While Not INX(2)\n  WAIT(3)\nEnd While\nn = TIME\n"
    found = ran(handled(text, "m = m + 1", 10), input=[{"channel": 2, "at": 1.0234}])
    n, m = printed(found)
    assert 1023 <= n <= 1027
    assert m == 102


_SHORT_MOVE = "MOVEA(0) = 100 : GO(0)\n"
_PAUSE, _POLL = f"{_SHORT_MOVE}PAUSE IDLE(0)\n", f"{_SHORT_MOVE}While Not IDLE(0)\n  {{}}\nEnd While\n"
_WATCH, _COUNT, _PULSE = "If INX(5) Then STOP(0)", "n = n + 1", "OUTX(3) = 1\nOUTX(3) = 0\n"
# The program, the loops of its other tasks, its handler, and how many ticks of 110 and more are executed.
WORK: dict[str, tuple[str, tuple[str, ...], str, int]] = {
    "a WAIT of 30 ms": (_POLL.format("WAIT(30)"), (), _COUNT, 5),
    "a WAIT of 59 ms": (_POLL.format("WAIT(59)"), (), _COUNT, 6),
    "a WAIT of 60 ms, which is long": (_POLL.format("WAIT(60)"), (), _COUNT, 38),
    "a WAIT of 61 ms": (_POLL.format("WAIT(61)"), (), _COUNT, 95),
    "a WAIT of 200 ms": (_POLL.format("WAIT(200)"), (), _COUNT, 34),
    "a WAIT of 60 ms in a loop that counts": (_POLL.format("m = m + 1\n  WAIT(60)"), (), _COUNT, 78),
    "a loop that counts": (_POLL.format("m = m + 1"), (), _COUNT, 5),
    "a loop that toggles": (_POLL.format("OUTX(2) = Not OUTX(2)\n  WAIT(7)"), (), _COUNT, 6),
    "a loop that sets an output": (_POLL.format("OUTX(2) = INX(4)"), (), _COUNT, 5),
    "no task that polls": (_PAUSE, (), _COUNT, 5),
    "one other task": (_PAUSE, (_WATCH,), _COUNT, 6),
    "one other task with a WAIT of 20 ms": (_PAUSE, (f"{_WATCH} : WAIT(20)",), _COUNT, 6),
    "one other task with a WAIT of 60 ms": (_PAUSE, (f"{_WATCH} : WAIT(60)",), _COUNT, 6),
    "two other tasks": (_PAUSE, (_WATCH, _WATCH), _COUNT, 4),
    "two other tasks, one with a WAIT": (_POLL.format(""), (_WATCH, f"{_WATCH} : WAIT(20)"), _COUNT, 3),
    "another task that counts": (_POLL.format(_WATCH), ("m = m + 1\n  WAIT(25)",), _COUNT, 109),
    "a handler that toggles": (_POLL.format(_WATCH), (), "OUTX(3) = Not OUTX(3)", 6),
    "a handler that counts and toggles": (_POLL.format(_WATCH), (), f"{_COUNT}\nOUTX(3) = Not OUTX(3)", 6),
    "a handler that prints": (_POLL.format(_WATCH), (), f"{_COUNT}\nPRINT n", 110),
    "a handler with a ring of 7": (_POLL.format(_WATCH), (), "n = (n + 1) Mod 7", 19),
    "a handler without two ticks that are alike": (_POLL.format(_WATCH), (), "m = n\nn = n + 1", 110),
    "a handler with 64 switches": (_POLL.format(_WATCH), (), 32 * _PULSE, 6),
    "a handler with 66 switches": (_POLL.format(_WATCH), (), 33 * _PULSE, 112),
    "a handler that sets its counter": (_POLL.format(_WATCH), (), "n = n + 1\nIf n > 40 Then n = 0", 12),
    "a handler that sets two outputs": (
        _POLL.format(_WATCH),
        (),
        "OUTX(3) = n > 50\nn = n + 1\nOUTX(4) = 1",
        12,
    ),
    "a handler with a WAIT": (_POLL.format(_WATCH), (), f"{_COUNT}\nWAIT(0.5)", 112),
    "a handler that reads the time": (_POLL.format(_WATCH), (), f"{_COUNT}\nIf TIME > 600 Then m = 1", 10),
    "a loop that reads the position": (_POLL.format("If POS(0) > 50 Then OUTX(1) = 1"), (), _COUNT, 6),
}


@pytest.mark.parametrize("name", WORK)
def test_the_ticks_that_are_executed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A move of 100 takes 1.1 s. The run without accelerators executes each tick."""
    main, loops, handler, count = WORK[name]
    text = "".join(f"Run T{k}\n" for k in range(len(loops))) + handled(main, handler, 10)
    text += "".join(f"Task T{k}\nLoop\n  {body}\nEnd Loop\nEnd Task\n" for k, body in enumerate(loops))
    handlers = count_calls(monkeypatch, (EventTask, "resume"))
    found = ran(text)
    assert handlers.calls - len(found.machine.log.events) == count
