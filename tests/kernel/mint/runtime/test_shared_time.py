"""Functions that share statement time yield, wait for space and resume equally."""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.kernel import Source

HEAD = "Dim n As Integer\nSPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500 : MOVEBUFFERSIZE(0) = 2\n"
OTHERS = """
Task beside
  Loop
    Print "beside "; TIME
    WAIT = 40
  End Loop
End Task
Event IN0
  Print "input at "; POS(0)
End Event
"""
MACHINE: dict[str, object] = {
    "input": [{"channel": 0, "at": at, "value": value} for at, value in ((0.1, 1), (0.2, 0), (0.25, 1))]
}
BODIES = {
    "a full buffer": 'For n = 1 To 6 : MOVER(0) = 3 : GO(0) : Print n; " "; POS(0) : Next\nPause IDLE(0)',
    "a path in a full buffer": "For n = 1 To 4 : VECTORR(0, 1) = 3, 4 : GO(0) : Print n : Next\nPause IDLE(0)",
    "a loop that computes": 'For n = 1 To 14000 : POS(1) = n : Next\nPrint n; " "; POS(1)',
    "a loop that polls": "MOVER(0) = 20 : GO(0)\nRepeat\nUntil POS(0) > 10\nPrint POS(0)",
    "waits": "For n = 1 To 5 : WAIT = 50 : Print TIME : Next",
}


def ran(text: str) -> Run:
    return run(Source("t.mnt", HEAD + text), machine=MACHINE, until=2.0)


def told(result: Run) -> tuple[object, ...]:
    log = result.machine.log
    moves = [(each.start_time, each.command, each.profile and each.profile.duration) for each in log.moves]
    waits = [(wait.task, wait.since, wait.until) for wait in log.waits]
    return result.output, moves, waits, [(event.time, event.kind) for event in log.events]


@pytest.mark.parametrize("others", ["", OTHERS], ids=["alone", "beside others"])
@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
def test_program_runs_the_same_with_and_without_a_sub(body: str, others: str) -> None:
    begin = "Run beside\n" if others else ""
    unshared = ran(f"{begin}{body}\nEnd\n{others}")
    shared = ran(f"{begin}{body}\nEnd\nnothing\n{others}\nSub nothing\nEnd Sub\n")
    assert told(shared) == told(unshared)
    assert unshared.output


@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
def test_a_sub_takes_as_long_as_its_statements(body: str) -> None:
    """The call's own time passes at its end, so the sub's first statement is on time."""
    inside = ran(f"fill\nEnd\nSub fill\n{body}\nEnd Sub")
    outside = ran(f"{body}\nEnd")
    assert told(inside) == told(outside)


RELEASED = """
Dim a As Integer
Run Releasing
Run Held
WAIT(400)
End
Task Releasing
  Repeat
    WAIT(2)
    a = 0
  Until TIME > 900
End Task
Task Held
  WAIT(100)
  While TIME Mod 100 < 50
    a = 1
    While a = 1
    End While
  End While
  PRINT TIME
End Task
"""


def test_a_time_that_was_read_while_nothing_was_recorded_still_ends_a_loop() -> None:
    """`Held` reads TIME just after its inner loop has failed to repeat; the loop of `Releasing` then seems to."""
    assert run(Source("a.mnt", RELEASED)).output == ["150"]
