"""A statement may be delayed, so that an event due at its time comes first.

Nothing else changes.
"""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.source import Source

STATEMENT = 1e-5
# An input changes when the program has executed this many statements.
CHANGE = 20
MACHINE: dict[str, object] = {"input": [{"channel": 0, "at": CHANGE * STATEMENT, "value": 1}]}
# How many precede the checked one, which is the one after the change, or next to it.
BEFORE = [CHANGE - 2, CHANGE - 1, CHANGE, CHANGE + 1]
FILL = "Dim n As Integer, x\n"


def ran(text: str) -> Run:
    return run(Source("t.mnt", text), machine=MACHINE, until=1.0, cache=False)


@pytest.mark.parametrize("value", ["x", "x + 0", "x / 1", "given(x)"])
@pytest.mark.parametrize("before", BEFORE)
def test_a_handler_at_the_moment_of_a_statement_decides_what_it_writes(value: str, before: int) -> None:
    handler = "Event IN0\n x = 7\nEnd Event\nFunction given(p)\n given = p\nEnd Function\n"
    text = (
        f"{FILL}x = 3\n"
        + "n = n + 1\n" * (before - 1)
        + f"SPEED(1) = {value}\nPRINT SPEED(1)\nEnd\n{handler}"
    )
    assert ran(text).output == ["7.0000" if before >= CHANGE else "3.0000"]


@pytest.mark.parametrize("before", BEFORE)
def test_what_fails_when_it_is_done_at_last_fails_in_its_line_at_its_moment(before: int) -> None:
    """A delayed statement that fails is reported with its own line and time.

    It is in a sub, from which the program continues.
    """
    text = (
        f"{FILL}x = -5\nbad\nEnd\nSub bad\n"
        + "n = n + 1\n" * (before - 1)
        + "MOVEBUFFERSIZE(0) = x\nEnd Sub\n"
    )
    result = ran(text)
    assert [each.line for each in result.diagnostics] == [4 + before + 1]
    assert result.machine.clock.now == pytest.approx(before * STATEMENT)
    assert len(result.machine.log.inputs) == (before >= CHANGE)


@pytest.mark.parametrize("before", BEFORE)
def test_onerror_hears_of_it_in_the_same_line(before: int) -> None:
    handler = "Event ONERROR\n PRINT ERRLINE\nEnd Event\n"
    fill = "n = n + 1\n" * (before - 2)
    assert ran(f"{FILL}SPEED(0) = 0\nMOVER(0) = 5\n{fill}GO(0)\nPRINT 0\nEnd\n{handler}").output == [
        str(before + 2),
        "0",
    ]


@pytest.mark.parametrize("before", BEFORE)
def test_all_that_one_statement_writes_is_written_at_one_moment(before: int) -> None:
    fill = "n = n + 1\n" * before
    result = ran(f"{FILL}{fill}JOG(0, 1) = 10;\nOUTX(0) = 1\nWAIT = 1\n")
    (after,) = result.machine.log.outputs
    begins = [each.start_time for each in result.machine.log.moves]
    assert begins == pytest.approx([before * STATEMENT] * 2)
    assert after.time == pytest.approx((before + 1) * STATEMENT)


@pytest.mark.parametrize("before", BEFORE)
def test_postponed_move_waits_for_space_in_the_buffer(before: int) -> None:
    settings = "SPEED(0) = 10 : ACCEL(0) = 1000 : DECEL(0) = 1000 : MOVEBUFFERSIZE(0) = 2\n"
    moves = "MOVER(0) = 1 : MOVER(0) = 1 : GO(0) : MOVER(0) = 1\n"
    fill = "n = n + 1\n" * (before - 8)
    result = ran(f"{FILL}{settings}{moves}{fill}MOVER(0) = 1\nOUTX(0) = 1\n")
    (full,) = [wait for wait in result.machine.log.waits if "space" in wait.why]
    (after,) = result.machine.log.outputs
    assert full.since == pytest.approx(before * STATEMENT)
    assert after.time == pytest.approx(full.until + STATEMENT)


def test_a_value_that_a_sub_works_out_is_written_when_the_sub_is_done() -> None:
    text = f"{FILL}OUTX(0) = late(1)\nEnd\nFunction late(p)\n WAIT = 100\n late = p\nEnd Function\n"
    (written,) = ran(text).machine.log.outputs
    assert written.time == pytest.approx(0.1 + 2 * STATEMENT)
