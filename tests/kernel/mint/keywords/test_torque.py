"""Torque references: tables and changes of the feedback."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

MOTOR = {
    "axis.0.plant.amplifier": "current",
    "axis.0.plant.amplifier_gain": 1.0,
    "axis.0.plant.torque_constant": 0.05,
    "axis.0.plant.inertia": 1e-4,
    "axis.0.plant.viscous": 0.0,
}


def ran(text: str, **machine: object) -> Run:
    result = run(Source("a.mnt", text), machine={**MOTOR, **machine}, until=20.0)
    assert [each.message for each in result.diagnostics] == []
    return result


def numbers(text: str, **machine: object) -> list[float]:
    return [float(line) for line in ran(text, **machine).output]


@pytest.mark.parametrize("word", ["TORQUEREF", "TORQUE"])
def test_repeated_writes_are_reported_once(word: str) -> None:
    loop = f"For i = 1 To 10\n{word}(0) = 20\nWAIT = 10\nNext\nPRINT VEL(0)\nCANCEL(0)"
    feedback = ran(loop).controller.axes[0].feedback
    assert feedback is not None
    assert [what for _, what in feedback.changes if what == 2.0] == [2.0]
