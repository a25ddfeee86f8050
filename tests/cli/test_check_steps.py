"""`motionlang check FILE --steps` prints the steps of a program beside its lines."""

from __future__ import annotations

import re

import pytest

from tests.cases import cases
from tests.cli.programs import Cell

FEED = """\
' feed one part
Const _stroke As Float = 25
Print "part"
feed(3)
End
Sub feed(ByVal count As Integer)
  SPEED(0) = count
  If count > 2 Then GO(0)
End Sub
"""


def test_steps_of_mint_are_below_their_lines(cell: Cell) -> None:
    cell.write("feed.mnt", FEED)
    ran = cell("check", "feed.mnt", "--steps", "--quiet")
    assert (ran.status, ran.err) == (0, "")
    main, feed = ran.out.split("program\n")[1].split("sub feed\n")
    assert main.startswith('   3  Print "part"\n        0  now\n        1  do                1 statement\n')
    assert main.endswith("   5  End\n        6  end\n        7  end\n")
    assert "   8    If count > 2 Then GO(0)\n        2  branch to 5       1 statement\n" in feed
    assert re.findall(r"^ {1,3}(\d+)  ", feed, re.MULTILINE) == ["7", "8", "6"]


def test_each_line_of_mccl_has_steps_of_its_own(cell: Cell) -> None:
    cell.write("feed.mcl", "1MN,1MR-25 ; go\n1WS0,RP3\n")
    ran = cell("check", "feed.mcl", "--steps", "--quiet")
    assert ran.out == (
        "   1  1MN,1MR-25 ; go\n"
        "        0  command           1 statement\n"
        "        1  wait\n"
        "        2  command           1 statement\n"
        "        3  wait\n"
        "        4  do\n"
        "        5  return\n"
        "   2  1WS0,RP3\n"
        "        0  command           1 statement\n"
        "        1  try\n"
        "        2  wait\n"
        "        3  branch to 1\n"
        "        4  wait\n"
        "        5  command           1 statement\n"
        "        6  back to 0\n"
        "        7  return\n"
    )


def test_the_steps_are_a_table(cell: Cell) -> None:
    cell.write("a.mnt", "While INX(1)\nEnd While\n")
    assert (
        cell("check", "a.mnt", "--steps", "--format", "csv").out
        == """\
file,unit,line,index,kind,target,cost
a.mnt,program,1,0,jump,1,1.0
a.mnt,program,1,1,note,,
a.mnt,program,1,2,now,,
a.mnt,program,1,3,branch,5,
a.mnt,program,1,4,back,2,1.0
a.mnt,program,1,5,note,,
a.mnt,program,0,6,end,,
"""
    )


def test_a_program_with_an_error_has_no_steps(cell: Cell) -> None:
    cell.write("wrong.mnt", "SPEED(0) = 1\nMOVR(0) = 1\n")
    ran = cell("check", "wrong.mnt", "--steps")
    assert ran.status == 1
    assert ran.out == cell("check", "wrong.mnt").out


@cases("file", ["feed.mnt", "feed.mcl"])
def test_nothing_is_run(cell: Cell, file: str) -> None:
    cell.write("feed.mnt", FEED)
    cell.write("feed.mcl", 'OT"part"\n')
    assert "\npart\n" not in cell("check", file, "--steps").out


def test_colours_only_where_they_are_wanted(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("feed.mnt", FEED)
    plain = cell("check", "feed.mnt", "--steps").out
    monkeypatch.setenv("FORCE_COLOR", "1")
    coloured = cell("check", "feed.mnt", "--steps").out
    assert "\x1b[36mSPEED\x1b[0m" in coloured
    assert re.sub(r"\x1b\[[\d;]*m", "", coloured) == plain
