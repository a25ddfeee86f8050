"""What asking remembers of tasks, from inside: no result shows it but the memory of a long run."""

from __future__ import annotations

from motionlang.kernel import Source, run
from motionlang.kernel.controller.io.asking import MANY

HANDLERS = """\
SPEED(0) = 1000 : ACCEL(0) = 100000 : DECEL(0) = 100000
INPUTPOSTRIGGER(0) = 32 : IMASK(0) = 32
WAIT = 2000
Event IN5
  IF INX(1) THEN PRINT 1
  MOVER(0) = 1 : GO(0)
End Event
"""


def test_tasks_that_have_ended_are_forgotten() -> None:
    world = {"input": [{"channel": 1, "asked": 0.3}, {"channel": 5, "every": 0.02, "for": 0.01}]}
    result = run(Source("handlers.mnt", HANDLERS), machine=world, until=9.0)
    assert len(result.machine.log.moves) == 100
    asking = result.machine.controller.asking
    assert asking is not None
    (responder,) = asking._responders.values()
    assert len(responder.queries()) <= MANY
    assert len(asking._starts) <= 2
