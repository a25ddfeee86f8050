"""Run-time faults between statements: ONERROR is called, and the axis is at rest."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source

READY = "Dim c(5) As Float = 3, 10, 20, 5\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
CAM = (
    READY
    + "MASTERCHANNEL(1) = 0 : MASTERDISTANCE(1) = 10\nCAMTABLE(1, c, NULL)\nCAM(1) = {}\nGO(1)\nJOG(0) = 50\n"
)
HANDLER = (
    '\nEnd\nEvent ONERROR\nWhile ERRORREADNEXT(0, 0)\nPRINT ERRSTRING, " in ", ERRLINE\nEnd While\nEnd Event'
)
BAD = "CAMTABLE: element 1 of the table says that it has 9 segments, and the array has room for 4"
# A table that is invalid when the next cycle begins; a queue whose second entry is invalid when it starts; a
# spline.
SPLINE = (
    READY
    + "SPLINETABLE(1, c)\nSPLINETIME(1) = 200\nSPLINE(1) = 4\nGO(1)\nWAIT = 300\nc(1) = 9\nWAIT = 3000\n"
)
CASES = {
    "a cam that goes on": (
        CAM.format(4) + "WAIT = 200\nc(1) = 9\nWAIT = 2000\nSTOP(0)\nPAUSE IDLE(1)\n",
        5,
        BAD,
    ),
    "a cam that waits": (
        READY
        + "MASTERCHANNEL(1) = 0 : MASTERDISTANCE(1) = 10\nCAMTABLE(1, c, NULL)\nMOVER(1) = 1\nCAM(1) = 0\nGO(1)\n"
        "c(1) = 9\nPAUSE IDLE(1)\n",
        6,
        BAD,
    ),
    "a spline that goes on": (SPLINE, 5, BAD.replace("CAM", "SPLINE")),
}


@pytest.mark.parametrize("case", CASES)
def test_onerror_hears_of_it_and_the_program_goes_on(case: str) -> None:
    text, line, message = CASES[case]
    result = run(Source("a.mnt", text + "PRINT VEL(1), IDLE(1)" + HANDLER), until=30.0)
    assert result.output == [f"{message} in {line}", "0.00001"]
    assert [each.message for each in result.diagnostics] == []


@pytest.mark.parametrize("case", CASES)
def test_without_onerror_the_program_ends_with_it(case: str) -> None:
    text, line, message = CASES[case]
    result = run(Source("a.mnt", text), until=30.0)
    assert [(each.message, each.line) for each in result.diagnostics] == [(message, line)]
    assert result.status == "fault"


def test_what_waits_behind_the_bad_entry_is_done() -> None:
    text = CASES["a cam that waits"][0].replace("GO(1)\nc(1)", "MOVER(1) = 5\nGO(1)\nc(1)")
    result = run(Source("a.mnt", "MOVEBUFFERSIZE(1) = 5\n" + text + "PRINT POS(1)" + HANDLER), until=30.0)
    assert result.output[-1] == "6.0000"  # 5 from the axis's position when it starts


def test_ctrl_c_in_a_computing_loop_reports_its_progress(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """An iteration is three statements of 10 µs; the axis moves on with that time.

    The program has not read its position since.
    """
    calls = iter(range(1000))

    def root(value: float) -> float:
        if next(calls, None) is None:
            raise KeyboardInterrupt
        return value

    monkeypatch.setattr("motionlang.kernel.mint.runtime.functions.root", root)
    text = (
        "Dim n As Integer, x As Float\nACCEL(0) = 1e9\nJOG(0) = 100\nLoop\nn = n + 1\nx = Sqrt(n)\nEnd Loop"
    )
    result = run(Source("loop.mnt", text))
    assert (result.status, result.diagnostics[0].code, result.diagnostics[0].line) == (
        "interrupted",
        "interrupted",
        6,
    )
    assert result.time == pytest.approx(1000 * 30e-6, rel=0.01)
    assert result.controller.position(0) == pytest.approx(100 * result.time, rel=0.01)


def test_slave_at_rest_never_leaves_its_position() -> None:
    """The slave is exactly at the level of the wait; its master moves only after 5 s."""
    text = "MASTERCHANNEL(1) = 0\nFOLLOW(1) = 1\nRun Belt\nPAUSE POS(1) > 0\nPRINT TIME > 4999\nEnd\n"
    line = "Task Belt\nWAIT = 5000\nJOG(0) = 10\nEnd Task"
    assert run(Source("a.mnt", text + line)).output == ["1"]
    stuck = run(Source("a.mnt", "FOLLOW(1) = 1\nPAUSE POS(1) > 0"))
    assert [each.code for each in stuck.diagnostics] == ["never"]
