"""`motionlang verify --review`: the golden report differs only by the changes that were rejected."""

from __future__ import annotations

import io
import re

import pytest

from tests.cli.programs import Cell

# Iterations with two axes, then a move that is stopped.
CYCLE = """\
Dim n
SPEED(0, 1) = 200;
ACCEL(0, 1) = 1000;
DECEL(0, 1) = 1000;
For n = 1 To 3
  MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)
  WAIT(100)
  MOVEA(1) = 50 : GO(1) : PAUSE IDLE(1)
  MOVEA(0, 1) = 0; : GO(0, 1) : PAUSE IDLE(0) And IDLE(1)
  PRINT "turn ", n
Next
MOVEA(0) = 400 : GO(0) : WAIT(300) : STOP(0) : PAUSE IDLE(0)
WAIT(50)
"""
EDITS = {
    "rate": [("ACCEL(0, 1) = 1000;", "ACCEL(0, 1) = 1000, 2000")],
    "wait": [("WAIT(100)", "WAIT(130)")],
    "end": [("WAIT(50)", "WAIT(80)"), ("ACCEL(0, 1) = 1000;", "ACCEL(0, 1) = 1000, 2000")],
    "turn": [("To 3", "To 4")],
    "fewer": [("To 3", "To 2"), ("WAIT(50)", "WAIT(40)")],
    "way": [("MOVEA(1) = 50", "MOVEA(1) = 60"), ('"turn "', '"part "')],
    "stop": [("WAIT(300)", "WAIT(320)")],
    "word": [('PRINT "turn ", n', "PRINT n"), ("WAIT(100)", "WAIT(90)")],
}
RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
# Both runs of a pair take equally long: the wait after the motion makes up for its duration.
AS_LONG = {
    "another distance": ("MOVER(0) = 1 : GO(0)\nWAIT = 500", "MOVER(0) = 2 : GO(0)\nWAIT = 500"),
    "a later stop": (
        "MOVEA(0) = 50 : GO(0)\nWAIT = 10\nSTOP(0)\nWAIT = 100\nABORT",
        "MOVEA(0) = 50 : GO(0)\nWAIT = 60\nSTOP(0)\nWAIT = 50\nABORT",
    ),
    "a timer that goes on": (
        "TIMEREVENT = 100\nWAIT = 1\nMOVER(0) = 1 : GO(0)\nWAIT = 499\nEnd\nEvent TIMER\nEnd Event",
        "TIMEREVENT = 100\nWAIT = 2\nMOVER(0) = 1 : GO(0)\nWAIT = 498\nEnd\nEvent TIMER\nEnd Event",
    ),
}


def reviewed(cell: Cell, answers: str, monkeypatch: pytest.MonkeyPatch) -> int:
    """Answer a review of the changes, and return how many there are."""
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(answers) + "\n"))
    asked = re.findall(r"accept change \d+ of (\d+)\?", cell("verify", "c.mnt", "--review").out)
    return int(asked[0]) if asked else 0


def expect(cell: Cell, program: str) -> None:
    """Write the golden files of a program."""
    cell.write("c.mnt", program)
    cell("verify", "c.mnt", "--update")


@pytest.mark.parametrize("edit", EDITS)
def test_a_rejected_change_is_the_only_difference_left(
    edit: str, monkeypatch: pytest.MonkeyPatch, cell: Cell
) -> None:
    """One change is rejected or accepted alone, or every second one."""
    program = CYCLE
    for was, is_ in EDITS[edit]:
        assert was in program
        program = program.replace(was, is_)
    expect(cell, CYCLE)
    cell.write("c.mnt", program)
    count = reviewed(cell, "d", monkeypatch)
    assert count
    alone = ["y" * n + "n" + "y" * (count - n - 1) for n in range(min(count, 2))]
    for answers in (
        *alone,
        *(each.translate({121: 110, 110: 121}) for each in alone),
        ("yn" * count)[:count],
    ):
        expect(cell, CYCLE)
        cell.write("c.mnt", program)
        assert reviewed(cell, answers, monkeypatch) == count
        assert reviewed(cell, "d", monkeypatch) == answers.count("n"), answers
        reviewed(cell, "a", monkeypatch)
        assert cell("verify", "c.mnt").status == 0


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("pair", AS_LONG)
def test_all_changes_make_the_new_report(
    pair: str, back: bool, monkeypatch: pytest.MonkeyPatch, cell: Cell
) -> None:
    old, new = (RATES + each + "\n" for each in AS_LONG[pair][:: -1 if back else 1])
    expect(cell, old)
    cell.write("c.mnt", new)
    assert "  time: " not in cell("verify", "c.mnt").out
    count = reviewed(cell, "d", monkeypatch)
    reviewed(cell, "y" * count, monkeypatch)
    assert cell("verify", "c.mnt").status == 0
