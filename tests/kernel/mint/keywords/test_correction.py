"""Corrections of a move, superposed motion, and the time unit of speeds."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
SLAVE = (
    RATES
    + "SPEED(1) = 20 : ACCEL(1) = 100 : DECEL(1) = 100\nMASTERCHANNEL(1) = 0\nFOLLOW(1) = 1\nJOG(0) = 50\nWAIT = 500\n"
)


def ran(text: str, until: float = 20.0) -> Run:
    result = run(Source("a.mnt", text), until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def offset_of(result: Run) -> Any:
    """Return the report's entry of the offset."""
    moves: Any = result.report["moves"]
    return next(row for row in moves if row["command"] == "OFFSET")


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
