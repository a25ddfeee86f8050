"""Waits of a program's only task need no task switch, with an equal result."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from motionlang import profile
from motionlang.kernel import Source, run
from motionlang.kernel.log import Waited
from motionlang.kernel.mint import DIALECT as MINT
from motionlang.kernel.report import text
from tests.cases import blocks

WAITS = "WAIT(1) : WAIT(0) : WAIT(0.3) : WAIT(7.77)"
# Its iterations are skipped without a record of each wait, but not beyond the time up to which a run is paced.
SKIPPED = "a loop that polls"
# The same with loops of several tasks, whose times in a profile are sums that round.
SUMMED = ("two tasks", "a task that begins and one that is ended")
PROGRAMS = blocks(Path(__file__).with_name("waits_in_place.txt"))


def waits_of(program: str) -> list[Waited]:
    return list(run(Source("waits.mnt", program)).machine.log.waits)


INPUTS: dict[str, object] = {
    "input": [
        {"channel": 1, "at": 0.02, "for": 0.01, "every": 0.043, "times": 5},
        {"channel": 2, "at": 0.01, "for": 0.003, "every": 0.017, "times": 9},
    ]
}


@pytest.mark.parametrize("until", [None, 0.0121, 0.006, 0.03505])
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_wait_is_over_at_once_or_waited_out(name: str, until: float | None) -> None:
    """The run ends with the program, in the middle of a wait, or at the end of a wait."""
    source = Source("waits.mnt", PROGRAMS[name])
    at_once = run(source, machine=INPUTS, until=until)
    # The clock is observed.
    waited_out = run(source, machine=INPUTS, until=until, pace=lambda now: None)
    assert at_once.output or until
    assert text(at_once) == text(waited_out)
    if name in SUMMED:
        assert profile(at_once).seconds == pytest.approx(profile(waited_out).seconds, abs=1e-9)
        return
    assert list(map(str, profile(at_once).lines())) == list(map(str, profile(waited_out).lines()))
    if name != SKIPPED:
        assert list(at_once.machine.log.waits) == list(waited_out.machine.log.waits)


@pytest.mark.parametrize(("written", "told"), [("-1", "-1"), ("0 - 5", "-5"), ("1e308 * 10", "inf")])
def test_a_wait_is_no_less_than_nothing_and_has_an_end(written: str, told: str) -> None:
    result = run(Source("waits.mnt", f"Dim x As Float\nx = {written}\nWAIT(x)\n"))
    assert [each.message for each in result.diagnostics] == [f"WAIT cannot be {told}"]


def test_a_wait_of_a_number_ends_when_one_of_the_same_value_does() -> None:
    """A literal is converted before the start, a variable at each wait, equally."""
    waits = "".join(f"WAIT({{{k}}})\n" for k in range(6))
    lengths = ("1", "0.3", "7.77", "0.000001", "0.123456789", "500000")
    begin = "Dim a As Float, b As Float, c As Float, d As Float, e As Float, f As Float, i As Integer\n"
    begin += "".join(f"{name} = {length}\n" for name, length in zip("abcdef", lengths, strict=True))
    loop = f"{begin}For i = 1 To 40\n{waits}Next\n"
    numbers, values = waits_of(loop.format(*lengths)), waits_of(loop.format(*"abcdef"))
    assert [wait[2:] for wait in numbers] == [wait[2:] for wait in values]
    assert len(numbers) == 240


def test_wait_in_a_sub_is_reported_with_its_callers() -> None:
    program = """
Dim i As Integer
For i = 1 To 2
  Twice(3)
  Twice(4)
Next
End
Sub Twice(x As Float)
  WAIT(x)
  WAIT(5)
End Sub
"""
    waits = waits_of(program)
    first, second = (MINT.locate(Source("waits.mnt", program), waits[k].callers[0])[0] for k in (0, 2))
    assert (first, second) == (4, 5)
    assert [wait.callers for wait in waits] == [waits[k].callers for k in (0, 0, 2, 2) * 2]
    assert [round(1e3 * (wait.until - wait.since), 6) for wait in waits] == [3, 5, 4, 5] * 2


MOVES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (
            "MOVER(0) = 10 : GO(0)\nThere\nBack\nWAIT 5\nEnd\nSub There\nPAUSE POS(0) > 5\nPAUSE IDLE(0)\nEnd Sub\n"
            "Sub Back\nMOVER(0) = -10 : GO(0)\nRests\nEnd Sub\nSub Rests\nPAUSE IDLE(0)\nEnd Sub",
            [
                ("ParentTask", 8, 0, 100, "condition", "until POS(0) > 5", [3]),
                ("ParentTask", 9, 100, 200, "condition", "until IDLE(0)", [3]),
                ("ParentTask", 16, 200, 400, "condition", "until IDLE(0)", [4, 13]),
                ("ParentTask", 5, 400, 405, "time", "", []),
            ],
        ),
        (
            "Run Side\nMOVER(0) = 10 : GO(0)\nThere\nEnd\nSub There\nPAUSE POS(0) > 5\nPAUSE IDLE(0)\nWAIT 3\nEnd Sub\n"
            "Task Side\nDwell\nPAUSE IDLE(0)\nEnd Task\nSub Dwell\nWAIT 20\nWAIT 1\nEnd Sub",
            [
                ("side", 16, 0, 20, "time", "", [12]),
                ("side", 17, 20, 21, "time", "", [12]),
                ("ParentTask", 7, 0, 100, "condition", "until POS(0) > 5", [4]),
                ("side", 13, 21, 200, "condition", "until IDLE(0)", []),
                ("ParentTask", 8, 100, 200, "condition", "until IDLE(0)", [4]),
                ("ParentTask", 9, 200, 203, "time", "", [4]),
            ],
        ),
    ],
    ids=["one task", "two tasks"],
)
def test_a_wait_is_logged_with_its_task_its_reason_and_its_calls(
    program: str, expected: list[tuple[object, ...]]
) -> None:
    """10 at 100 per second and 1000 per s² take 200 ms, and half of it 100 ms."""
    source = Source("waits.mnt", MOVES + program)
    result = run(source, machine={"controller.instruction_time": 1e-9})
    assert [
        (
            each.task,
            MINT.locate(source, each.at)[0],
            round(1e3 * each.since, 3),
            round(1e3 * each.until, 3),
            each.cause,
            each.why,
            [MINT.locate(source, at)[0] for at in each.callers],
        )
        for each in result.machine.log.waits
    ] == expected


def test_task_of_a_wait_is_the_one_that_runs_its_statement() -> None:
    program = """
Run One
Run Other
WAIT(30)
End
Task One
  WAIT(3)
  Beside()
End Task
Task Other
  WAIT(5)
  Beside()
End Task
Sub Beside()
  WAIT(1)
End Sub
"""
    told = [(wait.task, round(wait.since, 3)) for wait in waits_of(program)]
    assert told == [("one", 0.0), ("one", 0.003), ("other", 0.0), ("other", 0.005), ("ParentTask", 0.0)]


def test_many_waits_are_in_the_log() -> None:
    program = "Dim n As Integer\nFor n = 1 To 30000\n  OUTX(1) = n Mod 2\n  WAIT(1)\nNext\n"
    waits = run(Source("waits.mnt", program)).machine.log.waits
    assert len(waits) == 30_000
    # An iteration is a WAIT of 1 ms, and its three statements take 10 µs each.
    assert [round(wait.since, 9) for wait in waits[:3]] == [2e-5, 0.00105, 0.00208]
    assert all(before.until < wait.since for before, wait in pairwise(waits))
    assert waits[0][4:] == waits[-1][4:] == ("time", (), "", ())  # sealed or not


def test_a_pause_for_a_position_ends_where_it_is_passed_however_late_that_is() -> None:
    """50 at a speed of 33 takes 50/33 s plus half of the ramp, also after 20 000 s.

    The ramp to 33 takes 33/1000 s.
    """
    text = "SPEED(0) = 50 : ACCEL(0) = 1000\nWAIT = 20000000\nJOG(0) = 33\nPAUSE POS(0) > 50\nSTOP(0)\n"
    waits = run(Source("late.mnt", text)).machine.log.waits
    (began, ended) = next((each.since, each.until) for each in waits if each.cause == "condition")
    assert ended - began == pytest.approx(50 / 33 + 0.033 / 2, abs=2e-5)


@pytest.mark.parametrize("length", ["10", "x"])
def test_a_statement_after_a_wait_sees_what_has_changed_before_it(length: str) -> None:
    """The statements begin at 10.01, 10.02, 10.03 and 10.04 ms.

    x = 10 and the wait take 10.01 ms.
    """
    text = f"Dim x As Float = 10\nWAIT({length})\na = INX(1) : b = INX(1) : c = INX(1) : d = INX(1)\nPRINT a, b, c, d\n"
    program = "Dim a As Integer\nDim b As Integer\nDim c As Integer\nDim d As Integer\n" + text
    for microseconds, seen in ((5, "1111"), (15, "0111"), (25, "0011"), (35, "0001"), (45, "0000")):
        machine = {"input": [{"channel": 1, "at": 0.01 + 1e-6 * microseconds}]}
        result = run(Source("waits.mnt", program), machine=machine)
        assert result.output == [seen]


@pytest.mark.parametrize(
    ("length", "milliseconds"), [("1", 4.33666667), ("x", 4.33666667), ("0.123456789", 3.46012346)]
)
def test_a_wait_ends_on_a_multiple_of_the_time_unit(length: str, milliseconds: float) -> None:
    """1001 statements of 3.333... us are 3.33666666... ms, and a unit is 10 ps."""
    text = f"Dim n As Integer\nDim x As Float = 1\nFor n = 1 To 1000\nNext\nWAIT({length})\nOUTX(1) = 1"
    machine = {"controller.instruction_time": 1e-5 / 3}
    result = run(Source("waits.mnt", text), machine=machine)
    (output,) = result.machine.log.outputs
    assert output.time == pytest.approx(1e-3 * milliseconds + 1e-5 / 3, abs=1e-12)
