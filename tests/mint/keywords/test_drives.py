"""References for speed, velocity and position, against hand arithmetic."""

from __future__ import annotations

from math import radians, sin

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

DRIVE = "DRIVESPEEDMAX(0) = 1000 : SPEEDREFACCELTIME(0) = 500 : SPEEDREFDECELTIME(0) = 1000\n"
EDGES = "SPEEDREFACCELJERKSTARTTIME(0) = 100 : SPEEDREFACCELJERKENDTIME(0) = 200\n"


def ran(text: str, until: float = 60.0, **machine: object) -> Run:
    settings = {key.replace("__", "."): value for key, value in machine.items()}
    result = run(Source("a.mnt", text), cache=False, until=until, machine=settings)
    assert [each.message for each in result.diagnostics] == []
    return result


def test_a_speed_reference_ramps_in_its_times() -> None:
    """2000/s² up to 500 covers 62.5, 0.75 s at 500 375, and 1000/s² down 125."""
    result = ran(
        DRIVE + "SPEEDREF(0) = 500\nWAIT = 1000\nPRINT VEL(0)\nSPEEDREF(0) = 0\nPAUSE IDLE(0)\nPRINT IDLE(0)"
    )
    assert result.output == ["500.0000", "1"]
    assert result.controller.position(0) == pytest.approx(62.5 + 375.0 + 125.0, abs=0.02)
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert move.profile.duration == pytest.approx(1.5, abs=1e-4)


def test_its_edges_make_the_ramp_longer_by_half_of_them() -> None:
    result = ran(DRIVE + EDGES + "SPEEDREF(0) = 500\nWAIT = 1000\nPRINT 1\nCANCEL(0)")
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert move.profile.position(0.4) == pytest.approx(110.0)
    assert move.profile.velocity(0.4) == pytest.approx(500.0)


def test_without_times_the_rates_are_those_of_moves() -> None:
    result = ran(
        "ACCEL(0) = 200 : DECEL(0) = 100\nSPEEDREF(0) = 100\nWAIT = 1000\nSPEEDREF(0) = 0\nPAUSE IDLE(0)"
    )
    assert result.controller.position(0) == pytest.approx(25.0 + 50.0 + 50.0, abs=0.01)


def test_many_references_are_one_entry_of_the_log() -> None:
    result = ran(
        DRIVE
        + "For i = 1 To 50\nSPEEDREF(0) = i\nWAIT = 10\nNext\nSPEEDREF(0) = -50\nWAIT = 500\nPRINT VEL(0)\nSTOP(0)"
    )
    assert result.output == ["-50.0000"]
    assert len(result.controller.log.moves) == 1


def test_the_reference_is_limited_and_disabled() -> None:
    text = "SPEEDREF(0) = 1500\nWAIT = 1000\nPRINT VEL(0)\nSPEEDREFENABLE(0) = 0\nWAIT = 2000\nPRINT VEL(0)\n"
    end = "SPEEDREFENABLE(0) = 1\nWAIT = 1000\nPRINT VEL(0)\nSTOP(0)"
    assert ran(DRIVE + text + end).output == ["1000.0000", "0.0000", "1000.0000"]


def test_the_reference_may_be_an_analogue_input() -> None:
    """An input of 40 % commands 40 % of 1000, with a ramp of 2000 per second²."""
    analogue = [{"channel": 3, "at": 0.5, "value": 40.0}, {"channel": 3, "at": 1.5, "value": 0.0}]
    result = ran(
        DRIVE + "SPEEDREFSOURCE(0) = 4\nWAIT = 1000\nPRINT VEL(0), SPEEDREF(0)\nWAIT = 2000",
        analogue=analogue,
    )
    assert result.output == ["400.0000400.0000"]
    assert result.controller.position(0) == pytest.approx(40.0 + 320.0 + 80.0)


def test_an_error_brakes_in_its_own_time() -> None:
    """From 500 at a rate of 1000/250 ms, the axis stops within 31.25 units."""
    text = (
        DRIVE
        + "SPEEDREFERRORDECELTIME(0) = 250\nERRORINPUTMODE(0) = _emERROR_DECEL\nSPEEDREF(0) = 500\nWAIT = 3000\n"
    )
    result = ran(
        text + "End\nEvent ONERROR\nEnd Event", fault=[{"axis": 0, "kind": "error-input", "at": 1.0}]
    )
    a = result.controller.axes[0]
    position = a.position(1.0)
    assert result.controller.position(0) - position == pytest.approx(500.0**2 / (2 * 4000.0))


def test_the_test_reference_has_ramps_of_its_own() -> None:
    text = "SPEEDTESTREFACCELTIME(0) = 1000 : SPEEDTESTREFDECELTIME(0) = 2000\nSPEEDTESTREF(0) = 100\nWAIT = 1000\n"
    result = ran(DRIVE + text + "SPEEDTESTREF(0) = 0\nPAUSE IDLE(0)")
    assert result.controller.position(0) == pytest.approx(5.0 + 90.0 + 10.0, abs=0.01)


def test_a_move_takes_the_axis_and_the_reference_does_not_take_it_back_by_itself() -> None:
    text = (
        DRIVE
        + "SPEEDREF(0) = 100\nWAIT = 100\nSTOP(0)\nPAUSE IDLE(0)\nMOVEA(0) = 0\nGO(0)\nSPEEDREFENABLE(0) = 1\n"
    )
    assert ran(text + "PAUSE IDLE(0)\nPRINT POS(0)").output == ["0.0000"]


def test_a_velocity_reference_is_reached_in_a_millisecond() -> None:
    result = ran("VELREF(0) = 100\nWAIT = 100\nVELREF(0) = -100\nWAIT = 100\nVELREF(0) = 0\nPAUSE IDLE(0)")
    (move,) = result.controller.log.moves
    assert move.profile is not None
    assert move.profile.velocity(0.0005) == pytest.approx(50.0)
    assert move.profile.velocity(0.001) == pytest.approx(100.0)
    assert result.controller.position(0) == pytest.approx(0.0, abs=0.01)


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


def test_errors_of_speed_are_0_without_a_motor() -> None:
    text = "JOG(0) = 100\nWAIT = 100\nPRINT SPEEDDEMAND(0), SPEEDMEASURED(0), SPEEDERROR(0), VELERROR(0)\nSTOP(0)"
    assert ran(text).output == ["100.0000100.00000.00000.0000"]


@pytest.mark.parametrize("word", ["SPEEDREF(0) = 10", "VELREF(0) = 10", "POSREF(0) = 10", "JOG(0) = 10"])
def test_a_reference_needs_the_drive(word: str) -> None:
    result = run(Source("a.mnt", f"DRIVEENABLE(0) = 0\n{word}"), cache=False)
    assert [each.code for each in result.diagnostics] == ["disabled-axis"]


def test_a_position_reference_is_within_the_present_revolution() -> None:
    """At 400 an axis that wraps at 360 shows 40; a reference of 90 is 50 on, at 450."""
    turn = "POSWRAP(0) = 360\nMOVER(0) = 400 : GO(0) : PAUSE IDLE(0)\nPRINT POS(0)\n"
    result = ran(f"{turn}POSREF(0) = 90\nWAIT = 10\nPRINT POS(0)")
    assert result.output == ["40.0000", "90.0000"]
    assert result.controller.axes[0].profiles[-1].end == pytest.approx(450.0)
