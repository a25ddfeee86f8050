"""At the start of a program its axes are at 0 and have no speed set.

0 is the position at power-up.
"""

from __future__ import annotations

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source


def messages(text: str, **settings: object) -> list[str]:
    found = DIALECT.check(Source("a.mnt", text), {"axis.0.travel": settings["travel"]} if settings else {})
    return [each.message for each in found]


@pytest.mark.parametrize(("limit", "found"), [(99.5, True), (100, False)])
def test_the_first_move_by_a_distance_begins_at_0(limit: float, found: bool) -> None:
    move = f"SOFTLIMITFORWARD(0) = {limit}\nMOVER(0) = 100 : GO(0)\n"
    message = f"the move ends at 100, beyond the software limit at {limit} of axis 0"
    assert messages(move) == [message] * found


@pytest.mark.parametrize(("end", "found"), [(99.5, True), (100, False)])
def test_the_first_position_is_that_of_power_up(end: float, found: bool) -> None:
    message = f"the move ends at 100, beyond the limit switch at {end} of axis 0"
    assert messages("MOVEA(0) = 100 : GO(0)\n", travel=[-10.0, end]) == [message] * found


def test_no_speed_has_been_set() -> None:
    text = "ACCELTIME(0) = 200\nSPEED(0) = 50\nMOVER(0) = 1 : GO(0)\n"
    assert messages(text) == ["the time of a ramp of axis 0 is set before SPEED, on which it depends"]


def test_a_command_that_has_no_axis_leaves_a_move_of_axis_0_under_way() -> None:
    read = "the position of axis 0 is read while the move just started is in motion"
    assert messages("MOVER(0) = 10 : GO(0)\nBEEP\nPRINT POS(0)\n") == [read]
