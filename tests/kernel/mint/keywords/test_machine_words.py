"""Machine keywords in any order, with any values, cause no internal error."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint import table
from motionlang.kernel.mint.keywords import auxiliary_latches as fastaux
from motionlang.kernel.mint.keywords import (
    camboxes,
    captures,
    comms,
    homing,
    io_inputs,
    io_outputs,
    io_signals,
    latches,
    latches_position_compare,
    limits,
    limits_resetting,
    limits_switches,
    monitoring,
    relays,
    remote,
    sensing,
    steppers,
)
from motionlang.kernel.mint.keywords import event_flags as pending
from tests.cases import examples

GROUPS = (
    camboxes, captures, comms, fastaux, homing, io_inputs, io_outputs, io_signals, latches, latches_position_compare,
    limits, limits_resetting, limits_switches, monitoring, pending, relays, remote, sensing, steppers,
)  # fmt: skip
WORDS = [row for group in GROUPS for row in group.ROWS if row.kind != "constant"]
MACHINE = {
    "controller.axes": 2,
    "axis.0.travel": [-50.0, 500.0],
    "axis.0.home_switch": [-5.0, 5.0],
    "axis.0.index_every": 10.0,
    "input": [
        {"channel": 1, "at": 0.5, "for": 1.0},
        {"channel": 2, "axis": 0, "above": 20.0},
        {"channel": 3, "output": 1, "delay": 0.1},
    ],
    "fault": [{"axis": 1, "kind": "following-error", "at": 2.0}],
    "netdata": [{"element": 1, "value": 5, "at": 1.0}],
}
# The compiler finds constant errors; those in variables occur at run time.
indices = st.sampled_from(["0", "0", "1", "1", "n", "m", "less", "many"])
values = st.sampled_from(["0", "1", "n", "m", "less", "many", "x", "y", "huge"])
NAMES = (
    "Dim n As Integer = 1, m As Integer = 3, less As Integer = -1, many As Integer = 1000\n"
    "Dim x As Float = 2.5, y As Float = -20.5, huge As Float = 1e30"
)
MOTION = [
    "MOVER(0) = 30 : GO(0)",
    "JOG(1) = 50",
    "WAIT = 200",
    "POS(0) = 5",
    "SCALEFACTOR(0) = 10",
    "RESET(0)",
]


@st.composite
def statements(draw: st.DrawFn) -> str:
    row: Keyword = draw(st.sampled_from(WORDS))
    count = 0 if row.index == "none" else len(row.index.split(", "))
    where = ", ".join(draw(indices) for _ in range(count))
    word = f"{row.name}({where})" if count else row.name
    if row.access == "C":
        return word
    if "W" in row.access and draw(st.booleans()):
        return f"{word} = {draw(values)}"
    return f"PRINT {word}" if "R" in row.access else f"{word} = 1"


programs = st.lists(statements() | st.sampled_from(MOTION), min_size=1, max_size=12)


@pytest.mark.slow
@settings(max_examples=examples(300), suppress_health_check=list(HealthCheck))
@given(programs)
def test_no_program_ends_in_a_traceback(lines: list[str]) -> None:
    text = "\n".join([NAMES, *lines, "WAIT = 3000", "End", *HANDLERS])
    result = run(Source("any.mnt", text), machine=MACHINE, until=30.0)
    assert result.status in ("ended", "until", "fault")
    assert all(each.line or each.code == "never" for each in result.diagnostics)


HANDLERS = [f'Event {name}\n  PRINT "{name}"\nEnd Event' for name in ("IN2", "LATCH1", "NETDATA1", "STOP")]
HANDLERS.append("Event ONERROR\n  While ERRORREADNEXT(_egALL, 0)\n    PRINT ERRCODE\n  End While\nEnd Event")


def test_these_are_the_words_of_the_table() -> None:
    assert len(WORDS) > 100
    assert all(table().get(row.name) is row for row in WORDS)
