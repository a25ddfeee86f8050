"""Offsets and dropped moves in the report.

Each axis runs at 50 with rates of 100 up and 200 down.
"""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.kernel import Source
from motionlang.kernel.report import moves

HEAD = "SPEED(0, 1) = 50; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 200;\n"
HANDLER = "\nEnd\nEvent ONERROR\nEnd Event"


def mint(text: str, machine: dict[str, object] | None = None) -> Run:
    return run(Source("t.mnt", HEAD + text + HANDLER), machine=machine or {}, until=20.0)


FOLLOWING = "MASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 10\nWAIT = 1000\n"


def test_a_suspended_offset_is_one_entry_of_the_report() -> None:
    result = mint(
        f"{FOLLOWING}OFFSET(0) = 10\nGO(0)\nWAIT = 100\nSUSPEND(0) = 1\nWAIT = 2000\n"
        "STOP(1)\nPause IDLE(1)\nSUSPEND(0) = 0\nWAIT = 3000\nOFFSET(0) = 5\nGO(0)\nWAIT = 3000"
    )
    offsets = [each for each in moves(result) if each["command"] == "OFFSET"]
    assert [each["distance"] for each in offsets] == pytest.approx([10.0, 5.0], abs=1e-6)


HOMING: dict[str, object] = {"axis.0.home_switch": [20.0, 30.0]}


@pytest.mark.parametrize(
    "text", ["HOME(0) = 2\nMOVEA(0) = 10\nGO(0)", "MOVEA(0) = 10\nHOME(0) = 2\nPause IDLE(0)\nGO(0)"]
)
def test_a_move_that_waits_for_homing_is_not_reported_as_dropped(text: str) -> None:
    assert "dropped" not in mint(f"HOMESPEED(0) = 20\n{text}\nPause IDLE(0)", HOMING).report


def test_a_move_that_waits_for_following_is_not_reported_as_dropped() -> None:
    result = mint(
        "MOVEA(0) = 30\nMASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 10\nGO(0)\nWAIT = 1000\nFOLLOW(0) = 0\n"
        "PAUSE IDLE(0)\nSTOP(1)"
    )
    assert "dropped" not in result.report


@pytest.mark.parametrize(
    ("end", "reason"), [("STOP(0)", "stop"), ("CANCEL(0)", "cancel"), ("RESET(0)", "cancel")]
)
def test_moves_that_a_stop_discards_are_reported(end: str, reason: str) -> None:
    result = mint(
        f"MOVEBUFFERSIZE(0, 1) = 5;\nMOVER(0) = 10\nVECTORR(0, 1) = 3, 4\nMOVER(1) = 5\nHOME(0) = 2\nWAIT = 10\n{end}",
        HOMING,
    )
    discarded = [
        (each["axis"], each["command"], each["line"], each["reason"]) for each in result.report["dropped"]
    ]
    assert discarded == [(0, "MOVER", 3, reason), (0, "VECTORR", 4, reason), (1, "VECTORR", 4, reason)]
