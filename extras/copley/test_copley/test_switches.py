"""The switches of a served drive."""

from __future__ import annotations

from motionlang_copley.serve import _switches
from motionlang_copley.switches import Switches


def test_the_switches_are_those_of_the_machine_file() -> None:
    settings = {
        "axis.2.travel": [-900.0, 900.0],
        "axis.2.home_switch": [0.0, 50.0],
        "axis.2.index_every": 100.0,
    }
    assert _switches(settings, 1) == Switches()
    assert _switches(settings, 2) == Switches(-900.0, 900.0, 0.0, 100.0)
