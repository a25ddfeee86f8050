"""Literals addressed by line on the command line."""

from __future__ import annotations

from tests.cli.programs import Cell

STROKE = (
    "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 50 : GO(0)\nPAUSE IDLE(0)\nWAIT = 20\n"
)


def test_on_the_command_line(cell: Cell) -> None:
    cell.write("a.mnt", STROKE)
    ran = cell("run", "a.mnt", "--set", "SPEED.0=50")
    assert "ended after 1.07" in ran.out
    assert "note: SPEED[0] = 50 sets 1 literal, line 1" in ran.out
    swept = cell("sweep", "a.mnt", "--vary", "SPEED(0)@1=50:100:2", "--vary", "WAIT=0,20", "--format", "csv")
    assert [line.split(",")[1:3] for line in swept.out.splitlines()] == [
        ["SPEED[0]@1", "WAIT"],
        ["50", "0"],
        ["50", "20"],
        ["100", "0"],
        ["100", "20"],
    ]
    assert "  MOVEA[0]@2    50  MOVEA(0) = 50 : GO(0)\n" in cell("check", "a.mnt", "--literals").out
    wrong = cell("run", "a.mnt", "--set", "SPEED[0]@9=5", "--format", "none")
    assert wrong.err.splitlines()[0] == "error[option]: line 9 writes no literal to SPEED[0]"
