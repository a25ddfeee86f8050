"""Preset moves: selection, start, and each type."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
# 1: 10 further at 20; 2: to 50; 3: home position 0 in reverse.
TABLE = RATES + (
    "PRESETMOVETYPE(1, 0) = 4 : PRESETMOVEPOSITION(1) = 10 : PRESETMOVESPEED(1) = 20\n"
    "PRESETMOVETYPE(2, 0) = 3 : PRESETMOVEPOSITION(2) = 50 : PRESETACCEL(2, 0) = 500 : PRESETDECEL(2, 1) = 200\n"
    "PRESETMOVETYPE(3, 0) = 3 : PRESETMOVEPOSITION(3) = 0\n"
)
TRIGGER = [{"channel": 8, "at": at, "for": 0.01} for at in (0.5, 2.0, 4.0)]


def ran(text: str, until: float = 20.0, **machine: object) -> Run:
    result = run(Source("a.mnt", text), machine=machine, cache=False, until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def test_enabling_starts_the_selected_one_and_another_index_the_next() -> None:
    text = (
        "PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)\nPRINT POS(0)\n"
        "PRESETINDEX(0) = 2\nPAUSE IDLE(0)\n"
    )
    result = ran(
        TABLE + text + "PRINT POS(0)\nPRESETMOVEENABLE(0) = 0\nPRESETINDEX(0) = 3\nWAIT = 100\nPRINT POS(0)"
    )
    assert result.output == ["10.0000", "50.0000", "50.0000"]


def test_a_preset_moves_at_its_own_speed_and_rates() -> None:
    """The first, 10 at speed 20 and rate 1000, takes 0.02 + 9.6/20 + 0.02 s.

    The second, 40 at speed 100 and rate 500, takes 0.2 + 0.2 + 0.2 s.
    """
    text = "PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)\nPRESETINDEX(0) = 2\nPAUSE IDLE(0)"
    first, last = (move.profile for move in ran(TABLE + text).controller.log.moves)
    assert first is not None
    assert last is not None
    assert (first.peak_speed, first.duration) == pytest.approx((20.0, 0.52))
    assert (last.peak_speed, last.duration) == pytest.approx((100.0, 0.6))


def test_own_rates_of_the_axis_are_left_alone() -> None:
    text = "PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)\nMOVER(0) = 40\nGO(0)\nPAUSE IDLE(0)"
    last = ran(TABLE + text).controller.log.moves[-1].profile
    assert last is not None
    assert (last.peak_speed, last.duration) == pytest.approx((100.0, 0.5))


def test_a_trigger_input_starts_it_at_its_edge() -> None:
    result = ran(
        TABLE + "PRESETTRIGGERINPUT(0) = 8 : PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1\nWAIT = 6000",
        input=TRIGGER,
    )
    assert [move.start_time for move in result.controller.log.moves] == pytest.approx([0.5, 2.0, 4.0])
    assert result.controller.position(0) == pytest.approx(30.0)
    assert [move.command for move in result.controller.log.moves] == ["PRESETMOVE"] * 3


def test_each_trigger_steps_on_through_the_table() -> None:
    text = (
        "PRESETTRIGGERINPUT(0) = 8 : PRESETINDEX(0) = 1 : PRESETINDEXMODE(0) = 1\nPRESETMOVEENABLE(0) = 1\n"
    )
    waits = (
        "WAIT = 1500\nPRINT POS(0), PRESETINDEX(0)\nWAIT = 2000\nPRINT POS(0)\n"
        "WAIT = 2000\nPRINT POS(0), PRESETINDEX(0)"
    )
    assert ran(TABLE + text + waits, input=TRIGGER).output == ["10.00002", "50.0000", "0.00001"]


def test_inputs_select_it() -> None:
    """Inputs 4 and 5 are the bits of the preset's number: 1, then 3, then 2."""
    bits = [{"channel": 4, "at": 0.1, "for": 2.0}, {"channel": 5, "at": 1.0}]
    text = "PRESETTRIGGERINPUT(0) = 8 : PRESETINDEXSOURCE(0) = 1 : PRESETSELECTORINPUT(0) = 4\nPRESETINPUTSMAX(0) = 2\n"
    waits = (
        "PRESETMOVEENABLE(0) = 1\nWAIT = 1500\nPRINT POS(0), PRESETINPUTSTATE(0)\n"
        "WAIT = 4000\nPRINT POS(0), PRESETINDEX(0)"
    )
    result = ran(TABLE + text + waits, input=[*TRIGGER, *bits])
    assert result.output == ["10.00003", "50.00002"]
    assert [move.profile.end for move in result.controller.log.moves if move.profile] == pytest.approx(
        [10.0, 0.0, 50.0]
    )


def test_the_table_goes_round_by_itself() -> None:
    """Moves of 0.52, 0.6 and 0.6 s with dwells of 0.3 s between them.

    The third is 50 back at 100 with 1000.
    """
    text = (
        "PRESETINDEX(0) = 1 : PRESETINDEXMODE(0) = 2 : PRESETDWELLTIME(0) = 300\n"
        "PRESETMOVEENABLE(0) = 1\nWAIT = 2800\n"
    )
    result = ran(TABLE + text + "PRESETMOVEENABLE(0) = 0\nPAUSE IDLE(0)")
    first, *others = [move.start_time for move in result.controller.log.moves]
    assert [start - first for start in others] == pytest.approx([0.82, 1.72, 2.62])
    assert result.controller.position(0) == pytest.approx(10.0)


def test_a_rest_ends_with_what_it_belonged_to() -> None:
    """Disabling and enabling after 200 ms of a dwell begins a new one of 300 ms.

    So the next preset starts at 500 ms and not at 300 ms.
    """
    text = (
        "PRESETINDEX(0) = 3 : PRESETINDEXMODE(0) = 2 : PRESETDWELLTIME(0) = 300\nPRESETMOVEENABLE(0) = 1\n"
        "WAIT = 200\nPRESETMOVEENABLE(0) = 0\nPRESETINDEX(0) = 3\nPRESETMOVEENABLE(0) = 1\nWAIT = 200\n"
    )
    result = ran(TABLE + text + "PRINT IDLE(0)\nWAIT = 150\nPRINT IDLE(0)\nPRESETMOVEENABLE(0) = 0")
    assert result.output == ["1", "0"]


@pytest.mark.parametrize(
    ("preset", "then", "shown"),
    [
        (
            "PRESETMOVETYPE(5, 0) = 2 : PRESETJOGSPEED(5) = 30 : PRESETJOGDIRECTION(5) = 1",
            "VEL(0)",
            "-30.0000",
        ),
        ("PRESETMOVETYPE(5, 0) = 5 : PRESETMOVEPOSITION(5) = 77", "POS(0)", "77.0000"),
        ("PRESETMOVETYPE(5, 0) = 6 : PRESETMOVESPEED(5) = -40", "VEL(0)", "-40.0000"),
        ("JOG(0) = 20 : WAIT = 300\nPRESETMOVETYPE(5, 0) = 8", "IDLE(0)", "1"),
        ("MOVER(0) = 90 : GO(0) : WAIT = 300\nPRESETMOVETYPE(5, 0) = 9", "VEL(0), SUSPEND(0)", "0.00001"),
        ("JOG(0) = 20 : WAIT = 300\nPRESETMOVETYPE(5, 0) = 10", "IDLE(0)", "1"),
    ],
)
def test_the_other_types(preset: str, then: str, shown: str) -> None:
    text = f"{preset}\nPRESETINDEX(0) = 5\nPRESETMOVEENABLE(0) = 1\nWAIT = 500\nPRINT {then}\nCANCEL(0)"
    assert ran(RATES + text).output == [shown]


def test_a_preset_homes() -> None:
    home = {"axis.0.home_switch": [-50.0, -40.0]}
    text = (
        "PRESETMOVETYPE(1, 0) = 1 : PRESETMOVEHOMETYPE(1) = 0 : HOMESPEED(0) = 20\n"
        "PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1\n"
    )
    assert ran(RATES + text + "PAUSE IDLE(0)\nPRINT HOMESTATUS(0)", 60.0, **home).output == ["1"]


def test_preset_drives_a_motor_by_torque() -> None:
    motor: dict[str, Any] = {"axis.0.plant.amplifier": "current"}
    text = (
        "PRESETMOVETYPE(1, 0) = 7 : PRESETMOVEPARAMETER(1, 0) = 5\nPRESETINDEX(0) = 1\n"
        "PRESETMOVEENABLE(0) = 1\nWAIT = 50\n"
    )
    assert ran(RATES + text + "PRINT TORQUEDEMAND(0)\nCANCEL(0)", **motor).output == ["5.0000"]


def test_a_trigger_that_cannot_be_done_goes_to_onerror() -> None:
    text = (
        TABLE
        + "PRESETTRIGGERINPUT(0) = 8 : PRESETINDEX(0) = 9\nPRESETMOVEENABLE(0) = 1\nWAIT = 1000\nPRINT 1\nEnd\n"
    )
    handler = "Event ONERROR\nIf ERRORREADNEXT(0, 0) Then PRINT ERRSTRING, ERRLINE\nEnd Event"
    assert ran(text + handler, input=TRIGGER).output == ["preset 9 has no type6", "1"]
    result = run(Source("a.mnt", text), machine={"input": TRIGGER}, cache=False)
    assert [(each.message, each.line) for each in result.diagnostics] == [("preset 9 has no type", 6)]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("PRESETINDEX(0) = 1\nPRESETMOVEENABLE(0) = 1", "preset 1 has no type"),
        ("x = 64\nPRESETMOVEPOSITION(x) = 1", "there is no preset 64"),
        ("PRESETMOVETYPE(1, 1) = 2", "PRESETMOVETYPE has no parameter 1"),
    ],
)
def test_mistakes(text: str, message: str) -> None:
    result = run(Source("a.mnt", text), cache=False)
    assert [each.message for each in result.diagnostics if each.severity == "error"] == [message]
