"""A run ends with its foreground if background tasks wait for impossible events."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.kernel import INFINITY
from motionlang.kernel.mccl import FileTask
from tests.mccl_runs import Runner

# 1 000 counts take 0.2 s, with ramps of 0.1 s; the foreground ends then.
FOREGROUND = "1SV40000,1SA100000,1DS100000,1MN,1MR1000,1WS\nGT15"
ENDED = "when the foreground ended; nothing could change that since"
WATCHES = {
    "MD15,IN3,CN34,NO,WA0.001,RP": "polled channel 3",
    "MD15,IN3,CN34,NO,WA1,RP": "polled channel 3",
    "MD15,IN3,CN34,NO,RP": "polled channel 3",
    'MD15,LU"STATUS",1RL@0,RP': "polled 1RL@0",
    "MD15,IF3,NO,NO,IN4,CN34,NO,WA0.01,RP": "polled channel 3 and channel 4",
    "MD15,IN3,CN34,NO,WA0.01,JR-4": "polled channel 3",
    "MD15,IN3,CN34,NO,WA0.01,MJ15": "polled channel 3",
    'MD15,LU"STATUS",1RL@0,IC11,JR-3,NO,CN34,RP': "polled 1RL@0",
    "MD14,IN3,CN34,NO\nMD15,MC14,WA0.01,RP": "polled channel 3",
    # Storing the present value is a no-op, in a register of the task and in a shared one.
    "MD15,IN3,CN34,NO,AL7,AR5,WA0.01,RP": "polled channel 3",
    "MD15,IN3,CN34,NO,AL7,AR25,WA0.01,RP": "polled channel 3",
    # A computation is not polled, a register is.
    'MD15,LU"POSITION",1RL@0,AN255,AM2,SR1,AV1,AR5,IE300,CN34,NO,RP': "polled 1RL@0",
    "MD15,RA20,AA@21,AS1,IE300,CN34,NO,RP": "polled RA20 and AA@21",
    "MD15,WN3,CN34,RP": "waited for channel 3 to be on",
    "MD15,WN3,CN34,WA1,RP": "waited for channel 3 to be on",
}


@pytest.mark.parametrize("watch", WATCHES)
def test_a_watch_does_not_keep_the_run_from_ending(watch: str, mccl: Runner) -> None:
    result = mccl(f"{watch}\n{FOREGROUND}")
    assert result.status == "ended"
    assert not result.diagnostics
    (note,) = result.notes
    line = watch.count("\n") + 1
    assert note.startswith(f"line {line}: background task 1 (macro 15) still {WATCHES[watch]} {ENDED}")
    assert 0.2 < result.time < 0.2 + (2.1 if "WA1" in watch and "WN" not in watch else 0.05)


def test_several_watches_are_each_named(mccl: Runner) -> None:
    watches = (
        "MD15,IN3,CN34,NO,WA0.01,RP\nMD16,IN4,CN34,NO,RP\nMD17,WF40,WN5,CN34,RP\nMD18,IN6,CN34,NO,WA0.3,RP"
    )
    result = mccl(f"{watches}\n1SV40000,1SA100000,1DS100000,1MN,1MR1000,1WS\nGT15\nGT16\nGT17\nGT18")
    assert result.status == "ended"
    assert [note.partition(" when ")[0] for note in result.notes] == [
        "line 1: background task 1 (macro 15) still polled channel 3",
        "line 2: background task 2 (macro 16) still polled channel 4",
        "line 3: background task 3 (macro 17) still waited for channel 5 to be on",
        "line 4: background task 4 (macro 18) still polled channel 6",
    ]
    assert 0.2 < result.time < 1.0


def test_the_run_goes_on_as_long_as_something_is_to_come(mccl: Runner) -> None:
    """The input turns on at 5 s; then the task moves the axis again, for 0.2 s."""
    watch = "MD15,IN3,MJ16,NO,WA0.01,RP\nMD16,1MR1000,1WS"
    result = mccl(f"{watch}\n{FOREGROUND}", machine={"input": [{"channel": 3, "at": 5.0}]})
    assert result.status == "ended"
    assert [move.line for move in result.machine.log.moves] == [3, 2]
    assert result.time == pytest.approx(5.2, abs=0.011)
    assert result.notes == []


@pytest.mark.parametrize(
    "acts",
    [
        "MD15,CN34,WA0.1,CF34,WA0.1,RP",
        "MD15,RA20,AA1,AR20,WA0.1,RP",
        "MD15,IF3,CN34,NO,WA0.1,RP",
    ],
    ids=["outputs", "a counter", "an output again and again"],
)
def test_a_background_task_that_acts_is_no_watch(acts: str, mccl: Runner) -> None:
    result = mccl(f"{acts}\n{FOREGROUND}", until=20.0)
    assert (result.status, result.time) == ("until", 20.0)


def test_a_background_task_that_switches_an_output_without_a_wait_is_no_watch(mccl: Runner) -> None:
    result = mccl(f"MD15,IF3,CN34,NO,RP\n{FOREGROUND}", until=20.0)
    assert result.status == "until"
    assert result.time == pytest.approx(20.0, abs=1e-4)


def test_a_background_task_that_waits_for_a_position_in_vain_is_a_mistake(mccl: Runner) -> None:
    result = mccl("MD15,1WP5000\n" + FOREGROUND)
    assert [each.code for each in result.diagnostics] == ["never"]


@pytest.mark.parametrize(
    ("fields", "expected"),
    [
        ({}, True),
        ({"hopeless": False}, False),
        ({"cause": "input"}, True),
        ({"cause": "input", "due": 5.0}, False),
        ({"cause": "task"}, False),
        ({"next": 5.0}, False),
        ({"outside": SimpleNamespace()}, False),  # a host may switch an input
        ({"scheduler": None}, False),
        ({"outside": SimpleNamespace(), "tasks": False}, True),
    ],
)
def test_the_foreground_ends_if_no_background_task_can_do_anything(
    fields: dict[str, Any], expected: bool
) -> None:
    wait = SimpleNamespace(cause=fields.get("cause"), due=lambda: fields.get("due", INFINITY))
    is_endless = fields.get("hopeless", "cause" not in fields)
    task = SimpleNamespace(is_endless=is_endless, wait=wait if "cause" in fields else None)
    scheduler = fields.get("scheduler", SimpleNamespace(outside=fields.get("outside")))
    board = SimpleNamespace(
        background={1: task} if fields.get("tasks", True) else {},
        machine=SimpleNamespace(scheduler=scheduler),
        controller=SimpleNamespace(clock=SimpleNamespace(next_time=lambda: fields.get("next", INFINITY))),
    )
    foreground: Any = SimpleNamespace(board=board)
    assert FileTask._nothing_left(foreground) is expected
