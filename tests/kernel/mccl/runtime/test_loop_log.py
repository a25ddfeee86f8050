"""The loops in the log: from when to when each took, and who called it."""

from __future__ import annotations

import pytest

from tests.cases import cases
from tests.mccl_runs import Runner

# Program, and for each loop the command that jumps back, its start and end, and the calls around it, s. A command takes
# 10 us. A loop from the beginning of a line begins with it, any other with its first jump back.
LOOPS: list[tuple[str, list[tuple[str, float, float, tuple[str, ...]]]]] = [
    ("AL0\nAA1,WA0.1,IB5,JR-3,NO,TR0", [("JR-3", 0.0, 0.5, ())]),
    ("AL0,AR20\nNO,RA20,AA1,AR20,WA0.1,IB3,JR-5,NO,TR20", [("JR-5", 0.1, 0.3, ())]),
    ("WA0.1,RP2,WA0.1,RP1", [("RP2", 0.0, 0.3, ()), ("RP1", 0.0, 0.8, ())]),
    ("WA0.5\nWA0.1,RP1,WA0.5", [("RP1", 0.5, 0.7, ())]),
    ("MD1,WA0.1,RP1\nMC1,RP1;", [("RP1\n", 0.0, 0.2, ("MC1",)), ("RP1\n", 0.2, 0.4, ("MC1",)), ("RP1;", 0.0, 0.4, ())]),
    ("MD1,WA0.1,RP1\nMD2,MC1,WA0.1\nMC2,WA0.5", [("RP1", 0.0, 0.2, ("MC2", "MC1"))]),
    ("MD1,RA20,AA1,AR20,WA0.1,IB3,MJ1,NO\nMJ1\nWA0.5", [("MJ1,", 0.0, 0.3, ())]),
    ("MD1,RA20,AA1,AR20,WA0.1,IB3,MJ1,NO\nMC1\nWA0.5", [("MJ1", 0.0, 0.3, ("MC1",))]),
    ("AL0,WA0.1,AA1,IB2,JP1,NO,WA0.1,AA1,IB4,JP1,NO,WA1", [("JP1,NO,WA0", 0.1, 0.2, ()), ("JP1,NO,WA1", 0.3, 0.5, ())]),
    # A jump by a register, to 2, to 1 and to 0, is the end of three loops.
    ("AL3,AR20\nNO,WA0.1,WA0.1,RA20,AS1,AR20,IG-1,JP@20,NO",
     [("JP@20", 0.2, 0.3, ()), ("JP@20", 0.3, 0.5, ()), ("JP@20", 0.0, 0.7, ())]),
    # RP2 follows the last command of the inner loop: that loop ends there, and the one of RP2 continues.
    ("NO,WA0.1,RA20,AA1,AR20,IS0,JP1,NO,RP2",
     [("JP1", 0.1, 0.2, ()), ("JP1", 0.3, 0.4, ()), ("JP1", 0.5, 0.6, ()), ("RP2", 0.0, 0.6, ())]),
    # A macro that calls itself within its loop has a loop for each call.
    ("MD1,RA20,AA1,AR20,WA0.1,IE2,MC1,NO,RP1\nMC1\nWA0.5",
     [("RP1", 0.2, 0.4, ("MC1\n", "MC1,")), ("RP1", 0.0, 0.4, ("MC1\n",))]),
    # Less than a hundred commands leave no record.
    ("NO,RP49", []),
    ("WA0.5\nNO,RP48", []),
    ("NO,RP60", [("RP60", 0.0, 0.00122, ())]),
    # An error leaves the line, BK the line or the macro.
    ("WA0.1,AA1,IB3,RP,NO,TR999,WA9", [("RP", 0.0, 0.3, ())]),
    ("MD1,WA0.1,AA1,IE3,BK,NO,RP\nMC1,WA9", [("RP", 0.0, 0.3, ("MC1",))]),
]  # fmt: skip


@cases("text, expected", LOOPS)
def test_the_loops_of_a_program(
    text: str, expected: list[tuple[str, float, float, tuple[str, ...]]], mccl: Runner
) -> None:
    found = sorted(mccl(text).machine.log.loops, key=lambda each: each.until)
    assert [each.at for each in found] == [text.index(jump) for jump, *_ in expected]
    for each, (_, since, until, callers) in zip(found, expected, strict=True):
        assert (each.since, each.until) == pytest.approx((since, until), abs=0.0004)
        assert each.callers == tuple(text.rindex(call) for call in callers)
        assert each.task == "test.mcl"


def test_a_background_task_has_loops_of_its_own_from_its_start_on(mccl: Runner) -> None:
    """Two tasks are started 0.05 s apart, and each waits three times 0.1 s."""
    result = mccl("MD1,WA0.1,RP2\nGT1,WA0.05,RP1")
    found = [(each.task, each.at, each.since, each.until) for each in result.machine.log.loops]
    for name, at, since, until in (
        ("test.mcl", 25, 0.0, 0.1),
        ("task 1", 10, 0.0, 0.3),
        ("task 2", 10, 0.05, 0.35),
    ):
        (loop,) = [each for each in found if each[0] == name]
        assert loop[1] == at
        assert loop[2:] == pytest.approx((since, until), abs=4e-4)


def test_the_waits_of_skipped_iterations_are_one_record(mccl: Runner) -> None:
    """An iteration takes 0.1 s and four commands of 1 ns.

    Two iterations are carried out. Those from 0.2 s on repeat the second one 47 times, and the wait that begins at
    4.9 s is not over when the run ends at 5 s.
    """
    machine = {"controller.instruction_time": 1e-9, "input": [{"channel": 1, "at": 301.0}]}
    log = mccl("WA0.1,IS1,1MR10,NO,NO,RP", machine=machine, until=5.0).machine.log
    assert [round(wait.since, 6) for wait in log.waits.written()] == [0.0, 0.1]
    assert [wait.since for wait in log.waits] == pytest.approx([0.1 * k for k in range(49)], abs=1e-6)
    assert {(wait.task, wait.at, round(wait.until - wait.since, 6)) for wait in log.waits} == {
        ("test.mcl", 0, 0.1)
    }
