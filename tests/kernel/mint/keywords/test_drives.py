"""References, jogs and presets in the log."""

from __future__ import annotations

from math import radians, sin

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

DRIVE = "DRIVESPEEDMAX(0) = 1000 : SPEEDREFACCELTIME(0) = 500 : SPEEDREFDECELTIME(0) = 1000\n"


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text), until=60.0)
    assert [each.message for each in result.diagnostics] == []
    return result


def test_the_log_names_the_keyword_of_a_jog_or_preset() -> None:
    jog = ran("JOGSPEED(0) = 100 : JOGMODE(0) = 1 : JOGDURATION(0) = 400\nJOGCOMMAND(0) = 1\nPAUSE IDLE(0)")
    assert [move.command for move in jog.controller.log.moves] == ["JOGCOMMAND", "JOGCOMMAND"]
    preset = ran(
        "PRESETMOVETYPE(0, 0) = 4 : PRESETMOVEPOSITION(0) = 10\nPRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)"
    )
    assert [move.command for move in preset.controller.log.moves] == ["PRESETMOVE"]


def test_many_references_are_one_entry_of_the_log() -> None:
    result = ran(
        DRIVE
        + "For i = 1 To 50\nSPEEDREF(0) = i\nWAIT = 10\nNext\nSPEEDREF(0) = -50\nWAIT = 500\nPRINT VEL(0)\nSTOP(0)"
    )
    assert result.output == ["-50.0000"]
    assert len(result.controller.log.moves) == 1


def test_a_position_reference_goes_in_straight_lines() -> None:
    """A sine in steps of 1 ms: the axis follows one step, 1 ms, behind the reference."""
    result = ran(
        "For i = 1 To 200\nPOSREF(0) = 10 * Sin(i)\nWAIT = 1\nNext\nPAUSE IDLE(0)\nPRINT POS(0), POSREF(0)"
    )
    assert result.output == ["-3.4202-3.4202"]
    (move,) = result.controller.log.moves
    assert move.profile is not None
    a, last = result.controller.axes[0], move.start_time + move.profile.duration
    assert a.position(last) == pytest.approx(10 * sin(radians(200)))
    moving = [profile for profile in a.profiles if profile.shape == "reference"]
    assert [each.end for each in moving] == pytest.approx([10 * sin(radians(i)) for i in range(1, 201)])
    assert all(each.peak_speed == pytest.approx(abs(each.distance) / 0.001) for each in moving)
