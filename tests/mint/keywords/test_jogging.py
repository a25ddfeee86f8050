"""Jogs by command, with own ramps, and for a time: against hand arithmetic."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

RATES = "SPEED(0) = 400 : ACCEL(0) = 1000 : DECEL(0) = 500\n"
COMMAND = RATES + "JOGSPEED(0) = 100\n"


def ran(text: str, until: float = 60.0) -> Run:
    result = run(Source("a.mnt", text), cache=False, until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def test_a_jog_for_a_time_slows_down_when_it_is_over() -> None:
    """0.1 s up, at speed until 0.4 s, 0.2 s down: 5 + 30 + 10."""
    result = ran(COMMAND + "JOGMODE(0) = 1 : JOGDURATION(0) = 400\nJOGCOMMAND(0) = 1\nPAUSE IDLE(0)")
    first, last = result.controller.log.moves
    assert last.start_time - first.start_time == pytest.approx(0.4)
    assert last.profile is not None
    assert last.profile.duration == pytest.approx(0.2)
    assert result.controller.position(0) == pytest.approx(45.0)
    assert (first.command, last.command) == ("JOGCOMMAND", "JOGCOMMAND")


def test_a_command_that_stays_jogs_once_and_jogs_again_when_it_was_0() -> None:
    loop = "For i = 1 To 100\nJOGCOMMAND(0) = 1\nWAIT = 10\nNext\n"
    timed = COMMAND + "JOGMODE(0) = 1 : JOGDURATION(0) = 400\n"
    assert ran(timed + loop).controller.position(0) == pytest.approx(45.0)
    assert ran(timed + loop + "JOGCOMMAND(0) = 0\n" + loop).controller.position(0) == pytest.approx(90.0)


def test_without_a_time_it_jogs_until_the_command_is_0() -> None:
    result = ran(
        COMMAND + "JOGCOMMAND(0) = -1\nWAIT = 500\nJOGCOMMAND(0) = 0\nPAUSE IDLE(0)\nPRINT JOGCOMMAND(0)"
    )
    assert result.controller.position(0) == pytest.approx(-(5.0 + 40.0 + 10.0), abs=0.01)
    assert result.output == ["0"]


def test_a_new_speed_acts_at_once_and_the_time_goes_on() -> None:
    """100 until 0.2 s, then 200 until 0.4 s, then down at 500.

    That covers 5 + 10, then 15 + 0.1 * 200, then 200²/1000.
    """
    text = "JOGMODE(0) = 1 : JOGDURATION(0) = 400\nJOGCOMMAND(0) = 1\nWAIT = 200\nJOGSPEED(0) = 200\nPAUSE IDLE(0)"
    result = ran(COMMAND + text)
    assert [move.profile.peak_speed for move in result.controller.log.moves if move.profile] == [
        100.0,
        200.0,
        200.0,
    ]
    assert result.controller.position(0) == pytest.approx(5.0 + 10.0 + 15.0 + 20.0 + 40.0, abs=0.02)
    first, _, last = result.controller.log.moves
    assert last.start_time - first.start_time == pytest.approx(0.4)


def test_the_time_of_a_jog_counts_while_it_lasts() -> None:
    text = "PRINT JOGTIME(0)\nJOGCOMMAND(0) = 1\nWAIT = 123\nPRINT JOGTIME(0)\nSTOP(0)\nPAUSE IDLE(0)\nPRINT JOGTIME(0)"
    assert ran(COMMAND + text).output == ["0", "123", "0"]


@pytest.mark.parametrize("wait", ["PAUSE JOGTIME(0) > 200", "While JOGTIME(0) <= 200\nEnd While"])
def test_a_program_waits_for_the_time_of_a_jog(wait: str) -> None:
    assert ran(COMMAND + f"TIME = 0\nJOGCOMMAND(0) = 1\n{wait}\nPRINT TIME\nCANCEL(0)").output == ["201"]


def test_a_stop_or_another_motion_ends_the_time_too() -> None:
    text = "JOGMODE(0) = 1 : JOGDURATION(0) = 400\nJOGCOMMAND(0) = 1\nWAIT = 100\nJOG(0) = 50\nWAIT = 1000\n"
    result = ran(COMMAND + text + "PRINT VEL(0)\nSTOP(0)")
    assert result.output == ["50.0000"]


def test_ramps_of_jogs_are_times_to_the_highest_speed() -> None:
    """200 in 1 s is 200 per second² up, and 200 in 0.5 s is 400 per second² down.

    The jog at 100 covers 100²/400 + 0.5 * 100 + 100²/800.
    """
    times = "MAXSPEED(0) = 200 : JOGACCELTIMEMAX(0) = 1000 : JOGDECELTIMEMAX(0) = 500\n"
    for end in ("STOP(0)", "JOG(0) = 0"):
        result = ran(RATES + times + f"JOG(0) = 100\nWAIT = 1000\n{end}\nPAUSE IDLE(0)")
        assert result.controller.position(0) == pytest.approx(25.0 + 50.0 + 12.5, abs=0.01)


@pytest.mark.parametrize(
    ("settings", "top"),
    [("DRIVESPEEDMAX(0) = 100 : MAXSPEED(0) = 200\n", 100.0), ("MAXSPEED(0) = 200\n", 200.0), ("", 400.0)],
)
def test_what_the_highest_speed_is(settings: str, top: float) -> None:
    result = ran(RATES + settings + "JOGACCELTIMEMAX(0) = 1000\nJOG(0) = 50\nWAIT = 100\nSTOP(0)")
    profile = result.controller.log.moves[0].profile
    assert profile is not None
    assert profile.peak_acceleration == pytest.approx(max(top, 500.0))
    assert profile.acceleration(0.05) == pytest.approx(top)


def test_a_jog_to_0_ends_and_the_axis_is_idle() -> None:
    result = ran(
        RATES
        + "JOG(0) = 100\nWAIT = 200\nJOG(0) = 0\nPAUSE IDLE(0)\nPRINT POSTARGET(0) = POS(0), AXISMODE(0)"
    )
    assert result.status == "ended"
    assert result.output == ["10"]
    assert result.controller.position(0) == pytest.approx(5.0 + 10.0 + 10.0, abs=0.01)


def test_a_jog_to_0_of_an_axis_at_rest_is_nothing() -> None:
    assert ran("JOG(0) = 0\nJOGCOMMAND(0) = 0\nSPEEDREF(0) = 0\nVELREF(0) = 0\nPRINT IDLE(0)").output == ["1"]


def test_s_ramp_into_another_jog_has_continuous_acceleration() -> None:
    text = "PROFILEMODE(0) = 1 : ACCELJERK(0) = 5000 : DECELJERK(0) = 5000\nJOG(0) = 100\nWAIT = 80\nJOG(0) = 60\n"
    for end in ("WAIT = 500", "WAIT = 15\nSTOP(0)"):
        a = ran(RATES + text + end, until=2.0).controller.axes[0]
        for start, before in zip(a.starts[2:], a.profiles[1:], strict=False):
            time = start - a.starts[a.profiles.index(before)]
            gap = abs(before.acceleration(time - 1e-9) - a.at(start).acceleration)
            assert gap < 1e-3


def test_a_command_without_a_speed_is_refused() -> None:
    result = run(Source("a.mnt", "JOGCOMMAND(0) = 1"), cache=False)
    assert [each.message for each in result.diagnostics] == ["axis 0 cannot jog: its JOGSPEED is 0"]
