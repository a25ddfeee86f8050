"""A run without `until` ends by itself: after enough cycles if nothing in its text ends it, or after a shift."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
THERE_AND_BACK = (
    "MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\nWAIT = {wait}\nMOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
)
NOTE = "no path through the program ends it"


@pytest.mark.parametrize(
    ("text", "least", "most"),
    [
        # 2.2 s a cycle: 60 s are more than ten.
        ("Loop\n" + THERE_AND_BACK.format(wait=0) + "End Loop\n", 60.0, 60.0),
        ("#again\n" + THERE_AND_BACK.format(wait=0) + "GoTo again\n", 60.0, 60.0),
        ("Loop\nGoSub work\nEnd Loop\n#work\n" + THERE_AND_BACK.format(wait=0) + "Return\n", 60.0, 60.0),
        # 12.2 s a cycle.
        ("While 1\n" + THERE_AND_BACK.format(wait=10000) + "End While\n", 122.0, 160.0),
    ],
)
def test_a_program_that_never_ends_does_enough_cycles(text: str, least: float, most: float) -> None:
    result = run(Source("endless.mnt", RATES + text), machine={})
    assert result.status == "until"
    assert least <= result.time <= most
    assert result.cycle is not None
    assert result.cycle.count >= 10
    assert [each for each in result.notes if each.startswith(NOTE)]
    again = run(Source("endless.mnt", RATES + text), machine={}, until=result.time)
    assert again.report["moves"] == result.report["moves"]


@pytest.mark.parametrize(
    ("text", "time"),
    [
        # 1000 parts of 2.2 s, and 100 of them by an End inside an endless loop.
        ("For k = 1 To 1000\n" + THERE_AND_BACK.format(wait=0) + "Next\n", 2200.0),
        ("Loop\n" + THERE_AND_BACK.format(wait=0) + "n = n + 1\nIf n = 100 Then End\nEnd Loop\n", 220.0),
    ],
)
def test_a_program_that_can_end_does(text: str, time: float) -> None:
    result = run(Source("batch.mnt", RATES + text), machine={})
    assert result.status == "ended"
    assert result.time == pytest.approx(time, rel=1e-3)
    assert not [each for each in result.notes if each.startswith(NOTE)]


def test_an_axis_that_creeps_meets_its_limit() -> None:
    """Each cycle is 10 uu in 0.2 s and 1 s of waiting: 1000 uu are 100 cycles, 120 s."""
    limits = "SOFTLIMITFORWARD(0) = 1000 : SOFTLIMITREVERSE(0) = -10\n"
    text = RATES + limits + "Loop\nMOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nWAIT = 1000\nEnd Loop\n"
    result = run(Source("creeps.mnt", text), machine={})
    assert [each.kind for each in result.machine.log.events][-1:] == ["soft limit"]
    assert 119.0 < result.time < 122.0


def test_an_entry_of_the_machine_file_is_waited_for() -> None:
    text = RATES + "Loop\nPAUSE INX(1)\n" + THERE_AND_BACK.format(wait=0) + "End Loop\n"
    result = run(Source("waits.mnt", text), machine={"input": [{"channel": 1, "at": 100.0, "value": 1}]})
    assert result.time == 160.0
    assert result.cycle is not None
