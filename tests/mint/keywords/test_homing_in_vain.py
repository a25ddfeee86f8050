"""HOME away from its switch is an error at its line, whatever the wait.

It is no error if something ahead, such as a limit switch, ends the search.
"""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from motionlang import run
from motionlang.source import Source

AWAY = "axis 0 homes away from its switch and never reaches it"
SWITCH: dict[str, object] = {"axis.0.home_switch": [50.0, 60.0]}
HOME = "HOMESPEED(0) = 20\nHOME(0) = _hmNEGATIVE_SWITCH\n"
WAITS = {
    "a pause": "PAUSE IDLE(0)\n",
    "a loop that polls": "WHILE NOT IDLE(0) : ENDW\n",
    "a loop that polls and waits": "WHILE HOMEPHASE(0) <> 0\n  WAIT 10\nENDW\n",
    "the end of the program": "",
}


def homed(program: str, machine: Mapping[str, object], until: float = 100.0) -> tuple[str, list[str]]:
    result = run(Source("home.mnt", program), machine=machine, until=until, cache=False)
    return result.status, [f"{d.line}:{d.column} {d.severity} {d.message}" for d in result.diagnostics]


@pytest.mark.parametrize("wait", WAITS)
def test_away_from_the_switch_is_an_error_at_the_line_of_home(wait: str) -> None:
    status, found = homed(HOME + WAITS[wait], SWITCH)
    assert found == [f"2:1 error {AWAY}"]
    assert status in ("fault", "until")


@pytest.mark.parametrize("wait", WAITS)
def test_limit_switch_on_the_path_ends_the_search(wait: str) -> None:
    _, found = homed(HOME + WAITS[wait], {**SWITCH, "axis.0.travel": [-30.0, 100.0]})
    assert not [line for line in found if AWAY in line]


def test_a_program_that_ends_the_search_itself_is_right() -> None:
    ends = "WHILE HOMEPHASE(0) <> 0\n  IF TIME > 5000 THEN CANCEL(0)\n  WAIT 10\nENDW\n"
    assert homed("TIME = 0\n" + HOME + ends, SWITCH)[1] == []
    assert homed("TIME = 0\n" + HOME + ends, SWITCH, until=2.0) == ("until", [])


def test_a_switch_ahead_is_met_also_where_time_is_up_before() -> None:
    home = "HOMESPEED(0) = 20\nHOME(0) = _hmPOSITIVE_SWITCH\nPAUSE IDLE(0)\n"
    assert homed(home, SWITCH, until=1.0) == ("until", [])
    assert homed(home, SWITCH) == ("ended", [])


def test_limit_switch_that_homing_searches_for_is_no_error() -> None:
    home = "HOMESPEED(0) = 20\nHOME(0) = _hmNEGATIVE_LIMIT\nPAUSE IDLE(0)\n"
    assert homed(home, {"axis.0.travel": [-30.0, 100.0]}, until=1.0) == ("until", [])


def test_an_index_mark_that_does_not_exist_is_never_met() -> None:
    _, found = homed("HOME(0) = _hmPOSITIVE_INDEX\nPAUSE IDLE(0)\n", {})
    assert found[-1] == "1:1 error axis 0 homes and never reaches an index mark"


def test_other_direction_does_not_help_without_a_switch() -> None:
    for machine, hint in (
        (SWITCH, "home in the other direction, or give"),
        ({}, "give its position in the machine file"),
    ):
        result = run(Source("home.mnt", HOME + WAITS["a pause"]), machine=machine, cache=False)
        assert result.diagnostics[-1].hint.startswith(hint)


def test_a_short_pulse_of_the_switch_is_reported_as_passed() -> None:
    """The input is on for 80 ms, but the axis needs 100 ms to stop."""
    setup = "SCALEFACTOR(0) = 1000\nACCEL(0) = 100\nDECEL(0) = 100\nHOMEINPUT(0) = 1\nHOMESPEED(0) = 10\n"
    program = Source("home.mnt", setup + "HOME(0) = 0\nPAUSE IDLE(0)\n")
    result = run(program, inputs=["1=1@0.5..0.58"], until=20.0, cache=False)
    (diagnostic,) = (d for d in result.diagnostics if d.severity == "error")
    assert diagnostic.message == "axis 0 ran past its switch while stopping and does not meet it again"
    assert diagnostic.hint.startswith("home more slowly, so that the axis stops on its switch, or give")
