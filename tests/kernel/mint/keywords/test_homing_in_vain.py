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
