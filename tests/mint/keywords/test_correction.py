"""Corrections of a move, superposed motion, and the time unit of speeds."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
SLAVE = (
    RATES
    + "SPEED(1) = 20 : ACCEL(1) = 100 : DECEL(1) = 100\nMASTERCHANNEL(1) = 0\nFOLLOW(1) = 1\nJOG(0) = 50\nWAIT = 500\n"
)


def ran(text: str, until: float = 20.0) -> Run:
    result = run(Source("a.mnt", text), cache=False, until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def offset_of(result: Run) -> Any:
    """Return the report's entry of the offset."""
    moves: Any = result.report["moves"]
    return next(row for row in moves if row["command"] == "OFFSET")


def test_a_correction_moves_the_end_of_the_move() -> None:
    """100 at speed 100 and rate 1000 take 1.1 s; 2 more take another 20 ms."""
    result = ran(
        RATES + "MOVER(0) = 100\nGO(0)\nWAIT = 500\nMOVECORRECTION(0) = 2\nPAUSE IDLE(0)\nPRINT POS(0)"
    )
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert move.profile.duration == pytest.approx(1.12)
    assert result.output == ["102.0000"]


def test_a_correction_backwards_when_it_comes_late() -> None:
    text = (
        RATES
        + "MOVER(0) = 100\nGO(0)\nPAUSE POSREMAINING(0) < 1\nMOVECORRECTION(0) = -5\nPAUSE IDLE(0)\nPRINT POS(0)"
    )
    assert ran(text).output == ["95.0000"]


def test_at_rest_there_is_nothing_to_correct() -> None:
    result = run(Source("a.mnt", "MOVECORRECTION(0) = 2"), cache=False)
    assert [each.message for each in result.diagnostics] == ["axis 0 is on no move that could be corrected"]


def test_speeds_may_be_a_minute() -> None:
    """600 per minute are 10 per second, and 36000 per minute² are 10 per second².

    So the move takes 1 s up, 1 s at speed, and 1 s down.
    """
    result = ran(
        "TIMESCALE(0) = 60\nSPEED(0) = 600 : ACCEL(0) = 36000 : DECEL(0) = 36000\n"
        "MOVER(0) = 20\nGO(0)\nWAIT = 1500\nPRINT VEL(0)"
    )
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert (move.profile.duration, move.profile.peak_speed) == pytest.approx((3.0, 10.0))
    assert result.output == ["600.0000"]


def test_jogs_and_references_too_and_through_a_new_scale() -> None:
    text = (
        "TIMESCALE(0) = 60\nSCALEFACTOR(0) = 4\nPRINT TIMESCALE(0)\nJOG(0) = 120\nWAIT = 1000\nPRINT VEL(0)\n"
    )
    result = ran(
        text
        + (
            "STOP(0)\nPAUSE IDLE(0)\nSPEEDREF(0) = 60\nWAIT = 100\nPRINT VEL(0)\nCANCEL(0)\n"
            "DEFAULT(0)\nPRINT TIMESCALE(0)"
        )
    )
    assert result.output == ["60.0000", "120.0000", "60.0000", "1.0000"]
    assert result.controller.log.moves[0].profile is not None
    assert result.controller.log.moves[0].profile.peak_speed == pytest.approx(8.0)


def test_an_offset_on_a_follower_is_an_entry_of_its_own() -> None:
    """10 at 20 with 100 takes 0.2 + 0.3 + 0.2 s.

    Its start and end count from the slave's base position.
    """
    result = ran(SLAVE + "OFFSET(1) = 10\nGO(1)\nWAIT = 1000\nSTOP(0)\nPAUSE IDLE(0)")
    row = offset_of(result)
    assert (row["axis"], row["line"], row["start"], row["end"]) == (1, 7, 0.0, 10.0)
    assert row["duration"] == pytest.approx(0.7)
    assert [phase["name"] for phase in row["phases"]] == ["accel", "slew", "decel"]
    assert "ended" not in row


@pytest.mark.parametrize(
    ("end", "message"),
    [("STOP(1)\nPAUSE IDLE(1)\nSTOP(0)", "stop"), ("CANCEL(1)\nSTOP(0)", "cancel"), ("", "end-of-run")],
)
def test_report_names_what_cut_an_offset_short(end: str, message: str) -> None:
    result = ran(SLAVE + f"OFFSET(1) = 10\nGO(1)\nWAIT = 400\n{end}", 20.0 if end else 0.9)
    row = offset_of(result)
    assert row["ended"] == message
    assert row["duration"] == pytest.approx(0.4, abs=1e-3)
    assert row["end"] == pytest.approx(2.0 + 0.2 * 20.0, abs=0.01)


def test_a_lag_that_is_to_be_corrected_is_no_figure_of_the_run() -> None:
    assert any("GEARINGMODE" in each for each in ran("GEARINGMODE(1) = 1 : GEARING(1) = 100").notes)
    assert not any("GEARING" in each for each in ran("GEARINGMODE(1) = 0 : GEARING(1) = 100").notes)
