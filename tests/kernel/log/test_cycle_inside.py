"""The cycle of a long log: twice the log is twice the work."""

from __future__ import annotations

import pytest

from motionlang.kernel import Run, Source, run
from motionlang.kernel.log import cycle_so_far
from tests.counted_calls import all_calls

SHUTTLE = """
Dim n As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
For n = 1 To {count}
  MOVEA(0) = 20 : GO(0) : PAUSE IDLE(0)
  OUTX(1) = 1 : WAIT(100) : OUTX(1) = 0
  If n Mod 7 = 0 Then MOVEA(0) = 30 : GO(0) : PAUSE IDLE(0) : Print "reject"
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  Print "part "; n
Next
"""


def shuttle(count: int) -> Run:
    return run(Source("shuttle.mnt", SHUTTLE.format(count=count)))


def test_the_newest_moves_of_a_run_in_progress_have_its_cycle() -> None:
    text = "Loop\n  MOVEA(0) = 20 : GO(0) : PAUSE IDLE(0)\n  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\nEnd Loop\n"
    made = run(Source("endless.mnt", text), until=30.0)
    assert made.cycle is not None
    homes = made.dialect.table().homes
    found = cycle_so_far(made.machine.log, made.time, lambda line: "program", homes)
    assert found is not None
    assert found.period == pytest.approx(made.cycle.period, rel=1e-3)
    assert cycle_so_far(shuttle(0).machine.log, 0.0, lambda line: "program", homes) is None


def test_twice_the_log_is_twice_the_work() -> None:
    runs = [shuttle(count) for count in (200, 400, 800)]
    lengths = [len(made.machine.log.moves) for made in runs]
    short, middle, long = (all_calls(lambda made=made: made.cycle) for made in runs)  # type: ignore[misc]
    assert lengths[2] > 1.9 * lengths[1] > 3.6 * lengths[0]
    assert long - middle < 2.1 * (middle - short)
