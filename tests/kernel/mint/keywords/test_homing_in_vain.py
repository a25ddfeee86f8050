"""Hints for a HOME that never reaches its switch."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Source

SWITCH: dict[str, object] = {"axis.0.home_switch": [50.0, 60.0]}
HOME = "HOMESPEED(0) = 20\nHOME(0) = _hmNEGATIVE_SWITCH\nPAUSE IDLE(0)\n"


def test_other_direction_does_not_help_without_a_switch() -> None:
    for machine, hint in (
        (SWITCH, "home in the other direction, or give"),
        ({}, "give its position in the machine file"),
    ):
        result = run(Source("home.mnt", HOME), machine=machine)
        assert result.diagnostics[-1].hint.startswith(hint)


def test_a_short_pulse_of_the_switch_is_reported_as_passed() -> None:
    """The input is on for 80 ms, but the axis needs 100 ms to stop."""
    setup = "SCALEFACTOR(0) = 1000\nACCEL(0) = 100\nDECEL(0) = 100\nHOMEINPUT(0) = 1\nHOMESPEED(0) = 10\n"
    program = Source("home.mnt", setup + "HOME(0) = 0\nPAUSE IDLE(0)\n")
    result = run(program, inputs=["1=1@0.5..0.58"], until=20.0)
    (diagnostic,) = (d for d in result.diagnostics if d.severity == "error")
    assert diagnostic.message == "axis 0 ran past its switch while stopping and does not meet it again"
    assert diagnostic.hint.startswith("home more slowly, so that the axis stops on its switch, or give")
