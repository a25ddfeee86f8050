"""Motion keywords in any order, with any values, with a motor and without one.

They are jogs, references, presets and holding to analogue.
"""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint.keywords import correction as correcting
from motionlang.kernel.mint.keywords import drives, jogging, presets, torque
from motionlang.kernel.mint.keywords import hold_to_analogue as holding
from tests.cases import examples

WORDS = [row for group in (correcting, drives, holding, jogging, presets, torque) for row in group.ROWS]
WORLD = {
    "input": [{"channel": 1, "at": 0.3, "for": 0.1}, {"channel": 1, "at": 1.2, "for": 0.1}],
    "analogue": [
        {"channel": 0, "axis": 0, "above": 0.0, "value": 5.0, "per_unit": 2.0},
        {"channel": 1, "at": 0.5, "for": 1.0, "value": -40.0},
    ],
    "fault": [{"axis": 1, "kind": "error-input", "at": 2.0}],
}
MOTOR = {
    "axis.0.plant.amplifier": "current",
    "axis.0.servo.proportional": 0.02,
    "axis.0.servo.derivative": 0.5,
}
indices = st.sampled_from(["0", "0", "1", "1", "n", "m", "less", "many"])
values = st.sampled_from(["0", "1", "1", "n", "m", "less", "many", "x", "y", "40"])
NAMES = (
    "Dim n As Integer = 1, m As Integer = 3, less As Integer = -1, many As Integer = 1000\n"
    "Dim x As Float = 2.5, y As Float = -20.5"
)
MOTION = [
    "MOVER(0) = 30 : GO(0)",
    "JOG(1) = 50",
    "WAIT = 200",
    "POS(0) = 5",
    "STOP(0)",
    "SUSPEND(0) = 1",
    "RESET(0)",
]


@st.composite
def statements(draw: st.DrawFn) -> str:
    row: Keyword = draw(st.sampled_from(WORDS))
    word = f"{row.name}({', '.join(draw(indices) for _ in row.index.split(', '))})"
    if "W" in row.access and draw(st.booleans()):
        return f"{word} = {draw(values)}"
    return f"PRINT {word}" if "R" in row.access else f"{word} = 1"


programs = st.lists(statements() | st.sampled_from(MOTION), min_size=1, max_size=12)
HANDLER = "Event ONERROR\n  While ERRORREADNEXT(_egALL, 0)\n    PRINT ERRCODE\n  End While\nEnd Event"


@pytest.mark.parametrize("motor", [{}, MOTOR], ids=["no motor", "a motor"])
@settings(max_examples=examples(100), suppress_health_check=list(HealthCheck))
@given(lines=programs)
def test_no_program_ends_in_a_traceback(motor: dict[str, object], lines: list[str]) -> None:
    text = "\n".join(
        [NAMES, "SPEED(0, 1) = 100; : ACCEL(0, 1) = 500;", *lines, "WAIT = 3000", "End", HANDLER]
    )
    result = run(Source("any.mnt", text), machine={**WORLD, **motor}, until=6.0)
    assert result.status in ("ended", "until", "fault")
    assert all(each.line or each.code == "never" for each in result.diagnostics)


def test_there_are_words() -> None:
    assert len(WORDS) > 60
