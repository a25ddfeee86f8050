"""Keywords without brackets apply to axis 0, unless the program uses AXES."""

from __future__ import annotations

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source

MOVE = "MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\n"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("SPEED = 50\nSPEED(0) = 80\n", ["SPEED of axis 0 is replaced by SPEED in line 2 before any move"]),
        ("SPEED = 50\nSPEED(1) = 80\nMOVER(1) = 1 : GO(1) : PAUSE IDLE(1)\n", []),
        ("AXES(1)\nSPEED = 50\nSPEED(0) = 80\nMOVER(1) = 1 : GO(1) : PAUSE IDLE(1)\n", []),
    ],
    ids=["axis 0", "another axis", "axes of its own"],
)
def test_a_keyword_without_brackets_is_one_of_axis_0_or_of_any(text: str, found: list[str]) -> None:
    assert [each.message for each in DIALECT.check(Source("a.mnt", text + MOVE))] == found
