"""Keywords in any order, with any indices and values, cause no internal error."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint import table
from tests.cases import examples

# Groups of keywords of the machine and of its motion.
MACHINE_GROUPS = (
    "latches", "capture", "comms", "homing", "io", "limits", "stopping", "errors", "remote", "events", "encoders",
    "control",
)  # fmt: skip
MOTION_GROUPS = ("axis", "motion", "servo", "state", "following", "paths", "buffer")
SIMULATED = [
    row for row in table() if row.simulated and row.kind in ("setting", "reading", "move", "command")
]
OTHERS = [row for row in table() if not row.simulated]
WORLD: dict[str, object] = {
    "axis.0.travel": [-50.0, 500.0],
    "axis.0.home_switch": [-5.0, 5.0],
    "axis.0.index_every": 10.0,
    "input": [
        {"channel": 1, "at": 0.3, "for": 1.0},
        {"channel": 2, "axis": 0, "above": 20.0},
        {"channel": 3, "output": 1, "delay": 0.1},
    ],
    "analogue": [
        {"channel": 0, "axis": 0, "above": 0.0, "value": 5.0, "per_unit": 2.0},
        {"channel": 1, "at": 0.5, "for": 1.0, "value": -40.0},
    ],
    "fault": [{"axis": 1, "kind": "following-error", "at": 2.0}],
    "netdata": [{"element": 1, "value": 5, "at": 1.0}],
}
MOTOR: dict[str, object] = {
    "axis.0.plant.amplifier": "current", "axis.0.servo.proportional": 0.02, "axis.0.servo.derivative": 0.5,
}  # fmt: skip
# The compiler finds errors of constants; those of variables occur at run time.
NAMES = (
    "Dim n As Integer = 1, m As Integer = 3, less As Integer = -1, many As Integer = 1000\n"
    "Dim x As Float = 2.5, y As Float = -20.5, huge As Float = 1e30\n"
    "SPEED(0, 1) = 100, 100; : ACCEL(0, 1) = 500, 500;"
)
INDICES = st.sampled_from(["0", "0", "1", "1", "n", "m", "less", "many"])
VALUES = st.sampled_from(["0", "1", "1", "n", "m", "less", "many", "x", "y", "40", "huge"])
MOTION = st.sampled_from([
    "MOVER(0) = 30 : GO(0)", "JOG(1) = 50", "WAIT = 200", "POS(0) = 5", "STOP(0)", "SUSPEND(0) = 1", "RESET(0)",
    "SCALEFACTOR(0) = 10",
])  # fmt: skip
HANDLERS = [f'Event {name}\n  PRINT "{name}"\nEnd Event' for name in ("IN2", "LATCH1", "NETDATA1", "STOP")]
HANDLERS.append("Event ONERROR\n  While ERRORREADNEXT(_egALL, 0)\n    PRINT ERRCODE\n  End While\nEnd Event")


@st.composite
def statements(draw: st.DrawFn, groups: tuple[str, ...]) -> str:
    row: Keyword = draw(st.sampled_from([row for row in SIMULATED if row.group in groups]))
    count = 0 if row.index == "none" else len(row.index.split(", "))
    word = f"{row.name}({', '.join(draw(INDICES) for _ in range(count))})" if count else row.name
    if row.access == "C":
        return word
    if "W" in row.access and draw(st.booleans()):
        return f"{word} = {draw(VALUES)}"
    return f"PRINT {word}" if "R" in row.access else f"{word} = 1"


def ends_in_order(lines: list[str], machine: dict[str, object]) -> None:
    text = "\n".join([NAMES, *lines, "WAIT = 3000", "End", *HANDLERS])
    result = run(Source("any.mnt", text), machine=machine, until=6.0)
    assert result.status in ("ended", "until", "fault")
    assert all(each.line or each.code == "never" for each in result.diagnostics)


@pytest.mark.slow
@settings(max_examples=examples(300), suppress_health_check=list(HealthCheck))
@given(st.lists(statements(MACHINE_GROUPS) | MOTION, min_size=1, max_size=12))
def test_no_program_of_machine_words_ends_in_a_traceback(lines: list[str]) -> None:
    ends_in_order(lines, {**WORLD, "controller.axes": 2})


@pytest.mark.parametrize("motor", [{}, MOTOR], ids=["no motor", "a motor"])
@settings(max_examples=examples(80), suppress_health_check=list(HealthCheck))
@given(lines=st.lists(statements(MOTION_GROUPS) | MOTION, min_size=1, max_size=12))
def test_no_program_of_motion_words_ends_in_a_traceback(motor: dict[str, object], lines: list[str]) -> None:
    ends_in_order(lines, {**WORLD, **motor})


GIVEN = st.sampled_from(["0", "1", "n", "x", '"t"'])


@st.composite
def not_simulated(draw: st.DrawFn) -> str:
    row: Keyword = draw(st.sampled_from(OTHERS))
    count = draw(st.integers(0, 3)) if row.index != "axis" else 1
    index = st.sampled_from(["0", "1", "n", "x", "less", '"a"'])
    use = f"{row.name}({', '.join(draw(index) for _ in range(count))})" if count else row.name
    if row.access == "C":
        return use
    if "W" in row.access and draw(st.booleans()):
        return f"{use} = {draw(GIVEN)}"
    return f"PRINT {use}"


@settings(max_examples=examples(160), suppress_health_check=list(HealthCheck))
@given(st.lists(not_simulated(), min_size=1, max_size=8))
def test_no_program_of_words_that_are_not_simulated_ends_in_a_traceback(lines: list[str]) -> None:
    first = "Dim n As Integer = 3, x As Float = 2.5, less As Integer = -1"
    result = run(Source("a.mnt", "\n".join([first, *lines])), until=60.0)
    assert result.status in ("ended", "fault")
    assert all(each.line for each in result.diagnostics)
