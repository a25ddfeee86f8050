"""Polling loops are skipped up to the next event, with an equal result."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from motionlang.kernel.mccl import CommandTask
from tests.cases import blocks, cases
from tests.generated.compared import counting_skips, every_iteration
from tests.mccl_runs import Runner

POLL = 'LU"STATUS",1RL@0,IC3,JR-3,NO'
# Calculations with a moving position before the comparison, so that all passes differ.
RECKONED = 'LU"POSITION",AR20\n1MN,1SV1000,1MR500\n1RL@20,AA5,IB305,JR-3,NO,1TP,1WS,1TP'

PROGRAMS = blocks(Path(__file__).with_name("polls.txt"))


def outcome(runner: Runner, text: str) -> dict[str, Any]:
    machine: dict[str, object] = {
        "encoder": [{"aux": 1, "velocity": 700.0, "accel": 900.0, "at": 0.01}],
        "input": [{"channel": 5, "at": 0.0203, "for": 0.0113}],
    }
    result = runner(text, until=2.0, machine=machine)
    report: Any = result.report
    switched = [(each.time, each.channel, each.value) for each in result.machine.log.outputs]
    return {key: report[key] for key in ("status", "time", "output", "moves", "axes")} | {"outputs": switched}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(each, marks=pytest.mark.slow) if each == "an auxiliary encoder" else each
        for each in PROGRAMS
    ],
)
def test_skipping_changes_nothing(name: str, mccl: Runner) -> None:
    skipped = outcome(mccl, PROGRAMS[name])
    with every_iteration():
        assert outcome(mccl, PROGRAMS[name]) == skipped
    assert skipped["output"]


@pytest.mark.parametrize("read", ["RL", "RV", "RD"])
def test_an_iteration_that_reads_a_position_is_skipped_whatever_the_type(read: str, mccl: Runner) -> None:
    """45 s of polling are more than a million iterations of four commands."""
    skips: list[int] = []
    with counting_skips(skips):
        result = mccl(f'LU"POSITION",AR20\n1MN,1SV1000,1MR50000\n1{read}@20,IB45000.5,JR-2,NO,1TP,1WS')
    assert result.output == ["01 45001"]
    assert sum(skips) > 1_000_000


def test_eight_hours_of_polling(mccl: Runner) -> None:
    """At 0.0001 counts/s, three counts take over eight hours.

    The loop polls all the time.
    """
    text = f"1US10000,1MN,1SV0.0001,1SA1,1DS1,1MR3\n{POLL},1TP"
    begin = time.process_time()
    result = mccl(text, until=8 * 3600.0)
    assert time.process_time() - begin < 20.0  # some milliseconds; poll by poll it takes minutes
    assert result.time >= 8 * 3600.0
    finished = mccl(text, until=1e6)
    assert finished.output == ["01 3.000000"]
    assert finished.time == pytest.approx(30001, rel=1e-3)


@pytest.mark.parametrize(
    ("watch", "most"),
    [
        ("IN5,CN34,NO,IF5,CF34,NO,1RL@21,IC3,JR-9,NO", 6),
        ("1RL@20,IG2000,CN34,NO,IB2001,CF34,NO,1RL@21,IC3,JR-9,NO", 10),
        ("1RL@22,IG1,CN34,NO,1RL@21,IC3,JR-6,NO", 4),
        ("IN5,1ST,NO,1RL@21,IC3,JR-5,NO", 4),
        pytest.param("WA0.0005,1RL@20,IG2000,CN34,NO,1RL@21,IC3,JR-7,NO", 8, marks=pytest.mark.slow),
    ],
)
def test_an_hour_of_watching_is_over_at_once(watch: str, most: int, mccl: Runner) -> None:
    """At 1 count/s, 3600 counts take an hour, and a ramp takes 1 s more.

    At most so many times are iterations skipped.
    """
    variables = 'LU"POSITION",AR20,LU"STATUS",AR21,LU"VELOCITY",AR22'
    skips: list[int] = []
    with counting_skips(skips):
        result = mccl(f"{variables}\n1MN,1SV1,1SA1,1DS1,1MR3600\n{watch}", until=1e4)
    assert result.time == pytest.approx(3601.0, abs=0.001)
    assert len(skips) <= most


def test_a_poll_and_a_wait_beside_it_are_one_period(mccl: Runner, monkeypatch: pytest.MonkeyPatch) -> None:
    """The other task waits 1 s at a time; what both do in a second is skipped a hundred times."""
    slices, resume = 0, CommandTask.resume

    def counted(task: CommandTask, now: float, horizon: float) -> object:
        nonlocal slices
        slices += 2.5 < now < 99.5
        return resume(task, now, horizon)

    monkeypatch.setattr(CommandTask, "resume", counted)
    result = mccl(f"MD1,WA1,RP\nGT1\n{POLL.replace('IC3', 'IC25')}", until=101)
    assert slices < 10
    assert result.time == pytest.approx(101)


def test_a_loop_that_nothing_can_end_is_reported(mccl: Runner) -> None:
    result = mccl(POLL.replace("IC3", "IS3"))
    assert result.status == "fault"
    (diagnostic,) = result.diagnostics
    assert diagnostic.code == "never"
    assert diagnostic.message == "the program waits for a change of 1RL@0, which can never happen"
    assert diagnostic.line == 1


@cases(
    "program, end, most",
    [
        # A background task that only waits does not keep the run alive.
        ("MD1,WA0.001,RP\nGT1\nTR0", 0.00208, 2),
        ("WA0.003,IF5,JR-2,NO", 100.0, 3),
        ("RA31,AA1,AR31,JR-3", 100.0, 4),
        ("CN34,RP", 100.0, 2),
        ("MD1,CN34,RP\nGT1\nIF5,JR-1,NO", 100.0, 10),
        ("MD1,RA30,AA1,AR30,RP\nGT1\nIF5,JR-1,NO", 100.0, 20),
    ],
)
def test_a_loop_without_an_end_is_skipped_to_the_end_of_the_run(
    program: str, end: float, most: int, mccl: Runner
) -> None:
    """Iterations are skipped at most so many times."""
    skips: list[int] = []
    with counting_skips(skips):
        result = mccl(program, until=100.0)
    assert result.time == pytest.approx(end, abs=1e-4)
    assert len(skips) <= most


@pytest.mark.parametrize(
    "calls",
    ["MJ1\nMJ1\nAL7,TR0", "MC2,MC2,AL7,TR0", "MC3,MC3,AL7,TR0", "MC3\nMC3\nAL7,TR0", "MC4\nMC4\nAL7,TR0"],
)
def test_a_macro_that_is_called_again_is_no_loop(calls: str, mccl: Runner) -> None:
    """Each call jumps to the same command with the same registers, and then ends."""
    run = mccl(f"MD1,RA10\nMD2,MJ1\nMD3,JP3,BK,NO,JP1\nMD4,JP3,AD0,NO,JP1\n{calls}")
    assert [line for line in run.output if line != "?-1"] == ["7"]
