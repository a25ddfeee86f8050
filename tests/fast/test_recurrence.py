"""Periods of several tasks are skipped only if their joint state recurs."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.mint.runtime.task import MintTask
from motionlang.result import Run
from motionlang.source import Source
from tests.counted_calls import count_calls
from tests.generated.tasks import every_iteration

SETTER = """\
Task Other
  Loop
    WAIT(100)
    a = 1
  End Loop
End Task
"""
COUNTED = f"""\
Dim a As Integer, n As Integer
Run Other
While n < 20
  While a = 0
  End While
  a = 0
  n = n + 1
  WAIT(50)
End While
PRINT n, " ", TIME
End
{SETTER}"""
# The reading is outside the polling loop.
TIMED = f"""\
Dim a As Integer
Run Other
Loop
  While a = 0
  End While
  a = 0
  If TIME > 1050 Then Exit Loop
End Loop
PRINT TIME
End
{SETTER}"""
# `n` is 0 whenever a time slice ends while Late waits; only the partly computed sum has counted.
HALF_WORKED_OUT = """\
Dim n As Integer, m As Integer, ready As Integer
Run Other
Repeat
  n = m
  m = 0
  m = n + Late()
Until m = 20
PRINT m, " ", TIME
End
Function Late() As Integer
  While ready = 0
  End While
  ready = 0
  Late = 1
End Function
Task Other
  Loop
    WAIT(10)
    n = 0
    WAIT(10)
    ready = 1
  End Loop
End Task
"""
# Both arrays are equal whenever a time slice ends while Count polls; the one that it counts in is decided
# before.
BY_REFERENCE = """\
Type Pair
  n As Integer
  m As Integer
End Type
Dim p(2) As Pair, i As Integer, k As Integer, ready As Integer
Run Other
Loop
  i = 2 - k
  Count(p(i).n)
  If p(1).n = 1 And p(2).n = 1 Then Exit Loop
  p(1).n = 0
End Loop
PRINT TIME
End
Sub Count(ByRef n As Integer)
  i = 0
  While ready = 0
  End While
  ready = 0
  n = n + 1
End Sub
Task Other
  Loop
    WAIT(20)
    ready = 1
  End Loop
End Task
"""
# A flag that is reset within the iteration of a loop, and a task that waits for it.
GIVEN_BACK = """\
Dim a As Integer
Run Other
Loop
  a = 1
  OUTX(1) = INX(1)
  a = 0
  OUTX(2) = INX(2)
  If TIME > 900 Then Exit Loop
End Loop
PRINT TIME
End
Task Other
  PAUSE a = 1
  PRINT "seen ", TIME
End Task
"""


def ran(text: str, until: float | None = None, cost: float = 1e-5) -> Run:
    machine: dict[str, object] = {"controller.instruction_time": cost}
    return run(Source("a.mnt", text), machine=machine, cache=False, until=until)


def test_a_counter_that_the_polling_loop_does_not_name_counts() -> None:
    """Other begins at 1.03 ms and sets `a` every 100.03 ms, lastly at 2 001.6 ms.

    That is the 20th time. Another 50 ms pass after it.
    """
    assert ran(COUNTED).output == ["20 2051"]


def test_a_time_that_is_read_outside_the_polling_loop_passes() -> None:
    """`a` is set 1.03 ms after each multiple of 100.03 ms.

    The first of these times after 1050 ms is 1 101.36 ms.
    """
    assert ran(TIMED).output == ["1101"]


@pytest.mark.parametrize("beside", ["If INX(1) Then OUTX(1) = 1", "WAIT(7)", "While INX(1) = 0 : End While"])
def test_loop_until_a_time_ends_on_time_next_to_a_polling_task(beside: str) -> None:
    text = f"Run Other\nWhile TIME < 400\nEnd While\nPRINT TIME\nEnd\nTask Other\nLoop\n  {beside}\nEnd Loop\nEnd Task"
    (printed,) = ran(text).output
    assert 400 <= int(printed) <= 401  # the other task may have had the time slice


def test_values_of_an_expression_before_its_wait_belong_to_the_state() -> None:
    """Task Other begins at 1.05 ms and makes twenty iterations of 20.05 ms."""
    assert ran(HALF_WORKED_OUT, until=3.0).output == ["20 402"]


@pytest.mark.parametrize("text", [BY_REFERENCE, GIVEN_BACK, COUNTED, TIMED, HALF_WORKED_OUT])
@pytest.mark.parametrize("cost", [1e-5, 0.7310585e-5, 3e-5])
def test_it_is_as_every_iteration_has_it(text: str, cost: float) -> None:
    skipped = ran(text, until=3.0, cost=cost)
    with every_iteration():
        carried_out = ran(text, until=3.0, cost=cost)
    assert (skipped.output, skipped.time) == (carried_out.output, carried_out.time)


def test_tasks_that_hand_a_variable_to_and_fro_for_ever_are_skipped() -> None:
    """Each task changes the variable that the other one polls, in a joint period."""
    text = COUNTED.replace("  n = n + 1\n", "")
    result = ran(text)
    assert result.time == pytest.approx(28_800.0)
    assert len(result.machine.log.waits) == 6


def test_an_hour_is_skipped_after_many_searches_have_failed(monkeypatch: pytest.MonkeyPatch) -> None:
    """An output changes every 3 ms for 0.6 s, so no search for a period succeeds.

    After that nothing happens until 3600 s.
    """
    text = (
        "Dim k As Integer\nRun Lamp\nRun Guard\nFor k = 1 To 200\n  OUTX(2) = k Mod 2\n  WAIT(3)\nNext\n"
        "PAUSE INX(3)\nPRINT TIME\nEnd\nTask Lamp\nLoop\n  If INX(1) Then OUTX(1) = 1 Else OUTX(1) = 0\n"
        "End Loop\nEnd Task\nTask Guard\nLoop\n  If INX(5) Then STOP(0)\nEnd Loop\nEnd Task\n"
    )
    resumed = count_calls(monkeypatch, (MintTask, "resume"))
    machine: dict[str, object] = {"input": [{"channel": 3, "at": 3600.0}]}
    found = run(Source("a.mnt", text), machine=machine, cache=False, until=4000.0)
    (passed,) = map(int, found.output)
    assert 3_600_000 <= passed <= 3_600_002  # the others may each have a time slice of 1 ms before
    assert resumed.calls == 1154


def test_a_stop_on_an_axis_that_is_stopping_is_no_event() -> None:
    """From 40 at 500/s² the axis stops in 0.08 s; only the first STOP is logged."""
    text = (
        "SPEED(0) = 50 : DECEL(0) = 500\nRun T1\nJOG(0) = 40\nWAIT(200)\nWhile Not IDLE(0)\n  STOP(0)\n"
        "End While\nEnd\nTask T1\n  Loop\n    WAIT(1)\n  End Loop\nEnd Task\n"
    )
    fast, plain = (run(Source("a.mnt", text), cache=False, fast=fast) for fast in (True, False))
    stops = [
        [each.time for each in found.machine.log.events if each.kind == "stop"] for found in (fast, plain)
    ]
    assert stops[0] == stops[1]
    assert len(stops[0]) == 1
