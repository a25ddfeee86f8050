"""Offsets and moves that a suspend, a homing or a stop keeps, drops or reports.

Each axis runs at 50 with rates of 100 up and 200 down.
"""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.report import moves
from motionlang.source import Source

HEAD = "SPEED(0, 1) = 50; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 200;\n"
HANDLER = "\nEnd\nEvent ONERROR\nEnd Event"


def mint(text: str, machine: dict[str, object] | None = None) -> Run:
    return run(Source("t.mnt", HEAD + text + HANDLER), machine=machine or {}, until=20.0, cache=False)


def rest(result: Run) -> tuple[object, int]:
    return result.controller.position(0), result.controller.faults(0)


FOLLOWING = "MASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 10\nWAIT = 1000\n"


def test_an_offset_that_is_suspended_goes_on_where_it_was() -> None:
    """After 0.1 s the offset has covered 0.5, and its speed is 10, like the master's.

    Each of the two stops in 0.1 s, over 0.5.
    """
    result = mint(
        f"{FOLLOWING}OFFSET(0) = 10\nGO(0)\nWAIT = 100\nSUSPEND(0) = 1\nWAIT = 2000\nPRINT POS(0)\nPRINT OFFSET(0)\n"
        "STOP(1)\nPause IDLE(1)\nSUSPEND(0) = 0\nWAIT = 3000\nPRINT POS(0)\nOFFSET(0) = 5\nGO(0)\nWAIT = 3000\n"
        "PRINT POS(0)"
    )
    rest = 9.5 + 1.0 + 0.5 + 1.0
    assert [float(each) for each in result.output] == pytest.approx(
        [rest, 9.0, rest + 9.0, rest + 14.0], abs=2e-3
    )
    offsets = [each for each in moves(result) if each["command"] == "OFFSET"]
    assert [each["distance"] for each in offsets] == pytest.approx([10.0, 5.0], abs=1e-6)


HOMING: dict[str, object] = {"axis.0.home_switch": [20.0, 30.0]}


@pytest.mark.parametrize(
    "text",
    [
        "HOME(0) = 2\nMOVEA(0) = 10\nGO(0)\nPause IDLE(0)",
        "MOVEA(0) = 10\nHOME(0) = 2\nPause IDLE(0)\nPRINT MOVEBUFFERFREE(0)\nGO(0)\nPause IDLE(0)",
    ],
    ids=["during", "before"],
)
def test_what_waits_while_an_axis_homes_is_carried_out_when_it_is_home(text: str) -> None:
    result = mint(f"HOMESPEED(0) = 20\n{text}\nPRINT HOMESTATUS(0)", HOMING)
    assert rest(result) == (10.0, 0)
    assert result.output[-1] == "1"
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
