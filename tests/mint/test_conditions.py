"""Limits, stops and suspends act in every motion and order, by hand arithmetic.

Each axis runs at 50 with rates of 100 up and 200 down unless a program sets other values. A statement takes
10 us, so a position may be off the round figure by 50 x 10 us for every statement in between.
"""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.report import moves
from motionlang.source import Source

HEAD = "SPEED(0, 1) = 50; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 200;\n"
HANDLER = "\nEnd\nEvent ONERROR\nEnd Event"
TRAVEL: dict[str, object] = {"axis.0.travel": [-5.0, 50.0]}
# Beyond the switch at 50 while it has no function, then it causes a stop at ERRORDECEL.
BEYOND = "LIMITMODE(0) = 0\nMOVEA(0) = 54\nGO(0)\nPause IDLE(0)\nLIMITMODE(0) = 3\n"


def mint(text: str, machine: dict[str, object] | None = None, until: float = 20.0) -> Run:
    return run(Source("t.mnt", HEAD + text + HANDLER), machine=machine or {}, until=until, cache=False)


def rest(result: Run, axis: int = 0) -> tuple[object, int]:
    return result.controller.position(axis), result.controller.faults(axis)


@pytest.mark.parametrize(
    "motion",
    [
        "JOG(0) = -5\nWAIT = 200\nJOG(0) = 20",
        "SPEED(0) = 5\nMOVER(0) = -5\nGO(0)\nWAIT = 200\nINCR(0) = 33",
        "MASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = -5\nWAIT = 200\nJOG(1) = 20",
        "SPEEDREFENABLE(0) = 1\nSPEEDREF(0) = -5\nWAIT = 200\nSPEEDREF(0) = 20",
    ],
    ids=["jog", "incr", "slave", "speed reference"],
)
def test_motion_that_reverses_into_an_active_switch_stops_at_the_reversal(motion: str) -> None:
    """From 54: 0.125 to get to a speed of -5, 0.75 at it, and 0.0625 to the reversal."""
    result = mint(f"{BEYOND}{motion}\nWAIT = 2000", TRAVEL)
    assert rest(result) == (pytest.approx(54 - 0.125 - 0.75 - 0.0625, abs=1e-3), 4)


def test_active_input_still_blocks_after_motion_out_of_it() -> None:
    result = mint(
        "LIMITFORWARDINPUT(0) = 3\nJOG(0) = 40\nPause AXISERROR(0)\nCANCEL(0)\nJOG(0) = -5\nWAIT = 200\n"
        "JOG(0) = 20\nWAIT = 2000\nPRINT VEL(0)\nPRINT AXISERROR(0)",
        {"input": [{"channel": 3, "at": 1.0}]},
    )
    assert result.output == ["0.0000", "4"]


@pytest.mark.parametrize(
    ("before", "at_20", "where"),
    [
        ("", "SOFTLIMITFORWARD(0) = 10", 20.0),
        ("SOFTLIMITFORWARD(0) = 10\nSOFTLIMITMODE(0) = 0", "SOFTLIMITMODE(0) = 1", 20.0),
        ("SOFTLIMITFORWARD(0) = 50", "POS(0) = 60", 60.0),
    ],
    ids=["placed", "mode", "renamed"],
)
@pytest.mark.parametrize(
    "motion",
    ["MOVER(0) = 100\nGO(0)", "JOG(0) = 50", "MASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 50"],
    ids=["move", "jog", "slave"],
)
def test_a_limit_put_in_force_behind_a_moving_axis_acts_at_once(
    before: str, at_20: str, where: float, motion: str
) -> None:
    result = mint(f"{before}\n{motion}\nWhile POS(0) < 20\nEnd While\n{at_20}\nWAIT = 3000")
    assert rest(result) == (pytest.approx(where, abs=1e-2), 16)


def test_a_switch_put_in_force_behind_a_moving_axis_acts_at_once() -> None:
    result = mint("LIMITMODE(0) = 0\nJOG(0) = 50\nWAIT = 1500\nLIMITMODE(0) = 1\nWAIT = 100", TRAVEL)
    assert rest(result) == (pytest.approx(62.5, abs=1e-2), 4)


def test_a_limit_put_in_force_behind_a_path_stops_all_of_it() -> None:
    """After 1 s the path to 60, 80 has covered 50 - 12.5 = 37.5."""
    result = mint("VECTORA(0, 1) = 60, 80\nGO(0)\nWAIT = 1000\nSOFTLIMITFORWARD(1) = 10\nWAIT = 3000")
    assert rest(result, 1) == (pytest.approx(30.0, abs=1e-2), 16)
    assert rest(result, 0) == (pytest.approx(22.5, abs=1e-2), 0)


@pytest.mark.parametrize(
    "limit", ["SOFTLIMITFORWARD(0) = 50", "SOFTLIMITREVERSE(0) = 0 : SOFTLIMITFORWARD(0) = 9"]
)
def test_axis_at_rest_on_its_limit_has_reached_it(limit: str) -> None:
    result = mint(f"{limit}\nMOVER(0) = -10\nGO(0)\nWAIT = 1000")
    assert rest(result) == (0.0, 32)


def test_axis_on_its_switch_at_power_up_has_reached_it() -> None:
    result = mint("MOVER(0) = -10\nGO(0)\nWAIT = 1000", {"axis.0.travel": [0.0, 100.0]})
    assert rest(result) == (0.0, 8)


def test_an_error_input_acts_when_its_mode_is_put_in_force() -> None:
    """The axis has covered 14.5 at speed 10 by 1.5 s, and stops at 400 within 0.125."""
    result = mint(
        "ERRORINPUTMODE(0) = 0\nERRORINPUT(0) = 2\nERRORDECEL(0) = 400\nJOG(0) = 10\nWAIT = 1500\n"
        "ERRORINPUTMODE(0) = 3\nWAIT = 500",
        {"input": [{"channel": 2, "at": 1.0}]},
    )
    assert rest(result) == (pytest.approx(14.625, abs=1e-3), 2)


@pytest.mark.parametrize("stop", ["STOP(0)", "STOP(1)", "STOP(0, 1)", "STOP(1, 0)"])
def test_any_axis_of_a_path_stops_it(stop: str) -> None:
    """The path covers 37.5, and 50² / 800 more to rest; axis 0 has 0.6 of it."""
    result = mint(
        f"STOPMODE(0, 1) = 1;\nERRORDECEL(0, 1) = 400;\nVECTORA(0, 1) = 60, 80\nGO(0)\nWAIT = 1000\n{stop}\nWAIT = 2000"
    )
    assert rest(result) == (pytest.approx(24.375, abs=1e-3), 0)


@pytest.mark.parametrize("stop", ["STOP(0, 1)", "STOP(1, 0)"])
def test_of_two_stops_of_a_path_the_hard_one_holds(stop: str) -> None:
    result = mint(
        f"STOPMODE(1) = 1\nERRORDECEL(0, 1) = 400;\nVECTORA(0, 1) = 60, 80\nGO(0)\nWAIT = 1000\n{stop}\nWAIT = 2000"
    )
    assert rest(result) == (pytest.approx(24.375, abs=1e-2), 0)


@pytest.mark.parametrize("axis", [0, 1])
def test_stop_input_of_any_axis_stops_a_path(axis: int) -> None:
    result = mint(
        f"ERRORDECEL(0, 1) = 400;\nSTOPINPUT({axis}) = 1\nVECTORA(0, 1) = 60, 80\nGO(0)\nWAIT = 3000",
        {"input": [{"channel": 1, "at": 1.0}]},
    )
    assert rest(result) == (pytest.approx(24.375, abs=0.05), 0)


FOLLOWING = "MASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 10\nWAIT = 1000\n"


def test_a_suspended_slave_keeps_its_offset_until_it_goes_on() -> None:
    """The slave covers 9.5 by its master's ramp, and 0.25 to rest.

    Then it covers the offset of 10, and then 5 of the next offset.
    """
    result = mint(
        f"{FOLLOWING}SUSPEND(0) = 1\nWAIT = 500\nOFFSET(0) = 10\nGO(0)\nWAIT = 2000\nPRINT POS(0)\nSTOP(1)\n"
        "Pause IDLE(1)\nSUSPEND(0) = 0\nWAIT = 3000\nPRINT POS(0)\nOFFSET(0) = 5\nGO(0)\nWAIT = 3000\nPRINT POS(0)"
    )
    assert [float(each) for each in result.output] == pytest.approx([9.75, 19.75, 24.75], abs=1e-3)


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


SUSPENDING: dict[str, object] = {"input": [{"channel": 2, "at": 1.0, "for": 2.0}]}


def test_the_word_does_not_free_an_axis_that_its_input_suspends() -> None:
    result = mint(
        "SUSPENDINPUT(0) = 2\nJOG(0) = 10\nWAIT = 1500\nSUSPEND(0) = 0\nWAIT = 500\nPRINT VEL(0)\nPRINT SUSPEND(0)\n"
        "WAIT = 1500\nPRINT VEL(0)",
        SUSPENDING,
        5.0,
    )
    assert result.output == ["0.0000", "1", "10.0000"]


def test_the_input_does_not_free_an_axis_that_the_word_suspends() -> None:
    result = mint(
        "SUSPENDINPUT(0) = 2\nJOG(0) = 10\nWAIT = 500\nSUSPEND(0) = 1\nWAIT = 3000\nPRINT VEL(0)\nSUSPEND(0) = 0\n"
        "WAIT = 500\nPRINT VEL(0)",
        SUSPENDING,
        5.0,
    )
    assert result.output == ["0.0000", "10.0000"]


@pytest.mark.parametrize("axis", [0, 1])
def test_the_input_of_any_axis_suspends_a_path(axis: int) -> None:
    """At 1 s the path has covered 37.5, and comes to rest 6.25 further."""
    result = mint(
        f"SUSPENDINPUT({axis}) = 2\nVECTORA(0, 1) = 60, 80\nGO(0)\nWAIT = 2500\nPRINT POS(0)\nPause IDLE(0)\n"
        "PRINT POS(0)",
        SUSPENDING,
    )
    assert [float(each) for each in result.output] == pytest.approx([26.25, 60.0], abs=0.05)


def test_a_stop_does_not_lift_an_input_that_suspends() -> None:
    result = mint(
        "SUSPENDINPUT(0) = 2\nJOG(0) = 10\nWAIT = 1500\nSTOP(0)\nPause IDLE(0)\nMOVER(0) = 5\nGO(0)\nWAIT = 500\n"
        "PRINT VEL(0)\nPause IDLE(0)\nPRINT POS(0)",
        SUSPENDING,
    )
    assert result.output[0] == "0.0000"
    assert float(result.output[1]) == pytest.approx(9.5 + 0.25 + 5.0, abs=1e-2)


@pytest.mark.parametrize("load", ["FLY(0) = 50", "SPLINE(0) = 0"], ids=["fly", "spline"])
def test_what_begins_while_the_axis_is_suspended_waits(load: str) -> None:
    result = mint(
        "Dim c(5) As Float = 3, 10, 20, 5\nSPLINETABLE(0, c)\nMASTERCHANNEL(0) = 1\nMASTERDISTANCE(0) = 20\n"
        f"JOG(1) = 10\nSUSPEND(0) = 1\n{load}\nGO(0)\nWAIT = 500\nPRINT POS(0)\nSUSPEND(0) = 0\nWAIT = 5000\n"
        "PRINT POS(0) > 1"
    )
    assert result.output == ["0.0000", "1"], result.diagnostics


SUSPENDABLE = "MASTERCHANNEL(0) = 1\nSUSPENDINPUT(0) = 2\nMOVEBUFFERSIZE(0) = 9\nJOG(1) = 10\n"


@pytest.mark.parametrize(
    ("load", "before", "after"),
    [
        ("MASTERDISTANCE(0) = 100\nFLY(0) = 100", 29.0**2 / 100.0, 39.5**2 / 100.0),
        ("MASTERDISTANCE(0) = 40\nCAM(0) = 4", 29.0 / 4.0, 39.5 / 4.0),
    ],
    ids=["fly", "cam"],
)
def test_an_offset_on_a_held_cam_or_shear_begins_at_the_release(
    load: str, before: float, after: float
) -> None:
    """Its master is at 29 at 2.95 s and at 39.5 at 4 s.

    The offset of 10 takes 0.55 s from 3 s on, with rates of 100 and 200 and a peak speed of 36.5.
    """
    result = mint(
        f"Dim c(2) As Float = 1, 10\nCAMTABLE(0, c, NULL)\n{SUSPENDABLE}{load}\nGO(0)\nWAIT = 1500\n"
        "OFFSET(0) = 10\nGO(0)\nWAIT = 1450\nPRINT POS(0)\nWAIT = 1050\nPRINT POS(0)",
        SUSPENDING,
    )
    assert [float(each) for each in result.output] == pytest.approx([before, after + 10.0], abs=1e-2)


def test_an_input_holds_a_shear_after_its_last_segment() -> None:
    """Two segments of 10 end at 2.05 s; the input holds the move by 5 until 3 s."""
    fly = "MASTERDISTANCE(0) = 10\nFLY(0) = 5\nFLY(0) = 5\nMOVER(0) = 5\nGO(0)\n"
    result = mint(f"{SUSPENDABLE}{fly}WAIT = 2900\nPRINT POS(0)\nWAIT = 2000\nPRINT POS(0)", SUSPENDING)
    assert [float(each) for each in result.output] == pytest.approx([10.0, 15.0])


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


def test_what_waits_while_an_axis_follows_is_carried_out_when_it_does_no_longer() -> None:
    """The slave is at 9.5 after 1 s, brakes over 0.25, and then moves to 30."""
    result = mint(
        "MOVEA(0) = 30\nMASTERCHANNEL(0) = 1\nFOLLOW(0) = 1\nJOG(1) = 10\nGO(0)\nWAIT = 1000\nFOLLOW(0) = 0\n"
        "PAUSE IDLE(0)\nSTOP(1)"
    )
    assert rest(result) == (30.0, 0)
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
