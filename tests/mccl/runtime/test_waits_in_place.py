"""A single task waits without yielding to the scheduler, with no other difference."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.lang.scheduler import Scheduler
from motionlang.source import Source
from tests.cases import cases, examples
from tests.fast.test_plain_moves import all_of, commands


@cases("seed", range(examples(30)))
def test_waits_within_a_time_slice_make_no_difference(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    source = Source("a.mcl", commands(seed))
    in_place = run(source, cache=False, until=9.0)
    monkeypatch.setattr(Scheduler, "passes", lambda *_: False)
    monkeypatch.setattr(Scheduler, "comes_to_rest", lambda *_: False)
    assert all_of(in_place) == all_of(run(source, cache=False, until=9.0))


def test_a_wait_yields_to_another_task() -> None:
    """Task 3 reports the position every second while the parent waits for a move.

    300 at 100 with 1000 takes 3.1 s. The ramp of 0.1 s puts the axis 5 behind 100 times the time.
    """
    text = "1MN,1SV100,1SA1000,1DS1000\nMD3,1TP,WA1,RP\nGT3\n1MR300,1WS,CN33,WA0.5\n"
    result = run(Source("a.mcl", text), cache=False, until=20.0)
    assert [float(line.split()[-1]) for line in result.output[:4]] == [0.0, 95.0, 195.0, 295.0]
    assert result.machine.log.outputs[0].time == pytest.approx(3.1, abs=1e-3)
