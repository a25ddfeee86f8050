"""Waits of a program's only task pass where they stand; the run is the same to the last bit as where it gives way."""

from __future__ import annotations

import pytest

from motionlang import execution
from motionlang.report import text
from motionlang.source import Source

WAITS = "WAIT(1) : WAIT(0) : WAIT(0.3) : WAIT(7.77)"
PROGRAMS = {
    "events in between": f"""
Dim i As Integer
SCALEFACTOR(0) = 7 : SPEED(0) = 30
MOVER(0) = 3 : MOVER(0) = -3 : GO(0)
For i = 1 To 60
  {WAITS}
  PRINT TIME; POS(0); VEL(0)
Next
""",
    "a loop that polls": f"""
Dim i As Integer
PULSEOUTX(3) = 35
JOG(0) = 1.5
Repeat
  {WAITS}
  i = i + 1
Until POS(0) > 0.25
PRINT i; TIME; POS(0); OUTX(3)
Repeat
  WAIT(10)
Until POS(0) > 1
PRINT TIME; POS(0)
STOP(0)
""",
    "pauses": """
SCALEFACTOR(0, 1) = 7, 3 : SPEED(0, 1) = 30, 20
MOVER(0) = 3 : MOVER(1) = 9 : GO(0, 1)
PAUSE POS(0) > 1.3
PRINT TIME; POS(0); POS(1)
PAUSE VEL(0) = 0
PRINT TIME
PAUSE IDLE(0) And IDLE(1)
PRINT TIME; POS(1)
Dim began As Time
began = 0
PAUSE began >= 25
PRINT TIME
""",
    "a pause with a handler": """
Dim n As Integer
TIMEREVENT = 7
JOG(0) = 2
PAUSE POS(0) > 0.25
PRINT TIME; POS(0); n
STOP(0)
PAUSE n > 40
PRINT TIME; n
End
Event TIMER
  n = n + 1
  WAIT(1)
End Event
""",
    "a pause that an error ends": """
SOFTLIMITFORWARD(0) = 2 : SOFTLIMITMODE(0) = 1
MOVER(0) = 5 : GO(0)
PAUSE IDLE(0)
PRINT TIME; POS(0)
MOVER(0) = 5 : GO(0)
""",
    "two tasks": f"""
Dim k As Integer
Run Beside
{WAITS}
PRINT TIME; k
WAIT(20)
PRINT TIME; k
End
Task Beside
  While 1
    k = k + 1
    WAIT(0.5)
  Wend
End Task
""",
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_wait_is_over_at_once_or_waited_out(name: str) -> None:
    source = Source("waits.mnt", PROGRAMS[name])
    at_once = execution.run(source, cache=False)
    waited_out = execution.run(source, cache=False, pace=lambda now: None)  # somebody follows the clock
    assert at_once.output
    assert text(at_once) == text(waited_out)
    assert list(at_once.machine.log.waits) == list(waited_out.machine.log.waits)
