"""Torque references: a value that is in force already is no change of the feedback."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source

MOTOR: dict[str, object] = {
    "axis.0.plant.amplifier": "current",
    "axis.0.plant.torque_constant": 0.05,
    "axis.0.plant.inertia": 1e-4,
}


@pytest.mark.parametrize("word", ["TORQUEREF", "TORQUE"])
def test_repeated_writes_are_recorded_once(word: str) -> None:
    loop = f"For i = 1 To 10\n{word}(0) = 20\nWAIT = 10\nNext\nPRINT VEL(0)\nCANCEL(0)"
    result = run(Source("a.mnt", loop), machine=MOTOR)
    feedback = result.controller.axes[0].feedback
    assert result.diagnostics == []
    assert feedback is not None
    assert [what for _, what in feedback.changes if what == 2.0] == [2.0]
