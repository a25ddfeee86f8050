"""`motionlang map` as a user sees it."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

PROGRAM = """\
' IN 1 part in place   IN 2 door    OUT 3 clamp
PAUSE INX(1)
OUTX(3) = 1
MOVEA(0) = 50 : GO(0)
PAUSE IDLE(0)
Sub Spare
  OUTX(3) = 0
End Sub
"""
SHOWN = """\
a.mnt: Mint, 2 channels, 1 axis, 2 units, 6 states, 4 transitions

Inputs and outputs
channel   name           use  waited for  read  written  values  starts
───────────────────────────────────────────────────────────────────────
input 1   part in place  in   2
output 3  clamp          out                    3, 7     1, 0

Axes
axis    what   statement   lines
────────────────────────────────
axis 0  moves  MOVEA = 50  4

Structure
unit       line  called by
─────────────────────────────────────────
program
sub Spare     6             never reached

Variables
no variables

Never reached
from line  to line  text
───────────────────────────────
        7        7  OUTX(3) = 0

States

program
  begin
      -> 2 PAUSE INX(1)
     2  PAUSE INX(1)   [waits for input 1 (part in place)]
      OUTX(3) = 1; MOVEA(0) = 50; GO(0); -> 5 PAUSE IDLE(0)
     5  PAUSE IDLE(0)   [waits for axis 0]
      -> end

sub Spare, line 6
  begin
      OUTX(3) = 0; -> return
"""


@pytest.fixture
def program(cell: Cell) -> Cell:
    cell.write("a.mnt", PROGRAM)
    return cell


def test_the_map_as_text(program: Cell) -> None:
    ran = program("map", "a.mnt")
    assert (ran.status, ran.err) == (0, "")
    assert [line.rstrip() for line in ran.out.splitlines()] == SHOWN.splitlines()


def test_a_run_counts_transitions(program: Cell) -> None:
    ran = program("map", "a.mnt", "--run", "--input", "1=1@0.5", "--unit", "program")
    assert ran.out == (
        "program\n  begin\n      -> 2 PAUSE INX(1) (once)\n"
        "     2  PAUSE INX(1)   [waits for input 1 (part in place)]\n"
        "      OUTX(3) = 1; MOVEA(0) = 50; GO(0); -> 5 PAUSE IDLE(0) (once)\n"
        "     5  PAUSE IDLE(0)   [waits for axis 0]\n      -> end (once)\n"
    )


def test_a_run_that_is_stuck_still_has_a_map(program: Cell) -> None:
    ran = program("map", "a.mnt", "--run", "--unit", "program")
    assert "-> 2 PAUSE INX(1) (once)" in ran.out
    assert "-> 5 PAUSE IDLE(0) (not taken)" in ran.out
    assert "error[never]" in ran.err


@pytest.mark.parametrize(
    ("name", "begins"),
    [
        ("m.html", "<!doctype html>"),
        ("m.md", "# a.mnt"),
        ("m.mmd", "flowchart TD"),
        ("m.dot", "digraph"),
        ("m.json", "{"),
        ("m.csv", "channel,name,"),
        ("m.txt", "a.mnt: Mint"),
    ],
)
def test_the_extension_of_the_output_chooses_the_form(name: str, begins: str, program: Cell) -> None:
    assert program("map", "a.mnt", "-o", name).out == ""
    assert (program.folder / name).read_text(encoding="utf-8").startswith(begins)


def test_what_is_wrong_with_the_command_line(program: Cell) -> None:
    assert "need --run" in program("map", "a.mnt", "--until", "5").err
    assert "need --run" in program("map", "a.mnt", "--set", "spare=5").err
    ran = program("map", "a.mnt", "--run", "--set", "spares=5")
    assert (ran.status, ran.out) == (1, "")
    assert "the program has no constant or variable spares" in ran.err
    ran = program("map", "a.mnt", "--unit", "Spar")
    assert (ran.status, ran.err) == (
        2,
        "error[option]: the program has no unit Spar\n  hint: did you mean Spare?\n",
    )


def test_a_program_with_errors_has_no_map(program: Cell) -> None:
    program.write("b.mnt", "MOVEA(0 = 5\n")
    ran = program("map", "b.mnt")
    assert (ran.status, ran.out) == (1, "")
    assert "error[syntax]" in ran.err


def test_a_run_that_goes_on_after_an_error_says_where(cell: Cell) -> None:
    cell.write(
        "a.mnt", 'n = 0\nWAIT = 5\nPRINT 1 / n\nWAIT = 10\nEvent ONERROR\n  PRINT "error"\nEnd Event\n'
    )
    assert cell("map", "a.mnt", "--run", "--unit", "program").out == (
        "program\n  begin\n      n = 0; -> 2 WAIT = 5 (once)\n     2  WAIT = 5\n"
        "      PRINT 1 / n; -> 4 WAIT = 10 (not taken)\n"
        "     4  WAIT = 10   [goes on here after an error, 1 time]\n      -> end (once)\n"
    )
