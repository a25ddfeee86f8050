"""`motionlang run FILE --show-code` prints the code of a program and runs nothing."""

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
  MOVER(0) = _stroke
  GO(0)
End Sub
"""


def test_each_line_of_the_program_is_above_its_code(cell: Cell) -> None:
    cell.write("feed.mnt", FEED)
    ran = cell("run", "feed.mnt", "--show-code")
    assert (ran.status, ran.err) == (0, "")
    _, main, feed = ran.out.split("\n\n")
    assert main.startswith(" def main():\n")
    assert "#   3  Print \"part\"\n  if T(0.0): yield\n  P('part' '\\n')\n" in main
    assert re.findall(r"^#  ..  (.*)", feed, re.MULTILINE) == FEED.splitlines()[5:9]
    assert "#   8    MOVER(0) = _stroke\n  if k1(1.0, 25.0, 8): yield  # k1 load MOVER(0)\n" in feed


def test_nothing_is_run(cell: Cell) -> None:
    cell.write("feed.mnt", FEED)
    assert "\npart\n" not in cell("run", "feed.mnt", "--show-code").out
    assert not (cell.folder / ".cache").exists()


def test_the_code_is_that_of_the_values_and_the_machine_given(cell: Cell) -> None:
    cell.write("feed.mnt", FEED)
    assert "k1(1.0, 40.0, 8)" in cell("run", "feed.mnt", "--show-code", "--set", "_stroke=40").out
    ran = cell("run", "feed.mnt", "--show-code", "--set", "strok=40")
    assert (ran.status, ran.out) == (1, "")
    assert "no constant or variable strok" in ran.err


def test_the_code_is_that_with_or_without_accelerators(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("feed.mnt", "Dim v = 40\nWhile v < 50\n  v = v + 1\nEnd While\nSPEED(0) = v\n")
    assert "\n  v_v = 40\n" in cell("run", "feed.mnt", "--show-code").out
    monkeypatch.setenv("MOTIONLANG_FAST", "0")
    assert "\n  v_v = 40.0\n" in cell("run", "feed.mnt", "--show-code").out


def test_mccl_has_operations_instead_of_code(cell: Cell) -> None:
    cell.write("feed.mcl", '1SV@10 ; speed\n1MR-2.5,1WS0,OT"ok"\n')
    ran = cell("run", "feed.mcl", "--show-code")
    assert (ran.status, ran.err) == (0, "")
    head, lines = ran.out.split("\n\n")
    assert "there is no generated code" in head
    assert lines == (
        "#   1  1SV@10 ; speed\n"
        " 1SV@10  # trajectory.speed(axis 1, register 10)\n"
        '#   2  1MR-2.5,1WS0,OT"ok"\n'
        " 1MR-2.5  # motion.move_by(axis 1, -2.5)\n"
        " 1WS0     # flow_waits.wait_stop(axis 1, 0)\n"
        " OT\"ok\"   # miscellaneous_texts.put_text('ok')\n"
    )


def test_long_commands_of_mccl_are_not_broken(cell: Cell) -> None:
    text = f'OT"{"part " * 20}"'
    cell.write("feed.mcl", f"1MR-2.5,{text}\n")
    lines = [line.rstrip() for line in cell("run", "feed.mcl", "--show-code").out.splitlines()]
    assert [line for line in lines if line.startswith(" 1MR") or "OT" in line] == [
        f"#   1  1MR-2.5,{text}", " 1MR-2.5", f" {text}",
    ]  # fmt: skip


@cases("file", ["wrong.mnt", "wrong.mcl"])
def test_mistakes_are_those_of_check(cell: Cell, file: str) -> None:
    cell.write("wrong.mnt", "SPEED(0) = 1\nMOVR(0) = 1\nPRINT TIEM\n")
    shown, checked = cell("run", file, "--show-code"), cell("check", file)
    assert (shown.status, shown.out) == (1, "")
    errors = re.findall(r"error\[.*", checked.out)
    assert errors
    assert re.findall(r"error\[.*", shown.err) == errors


@cases("option", ["--until=3", "--plot=a.png", "--format=none", "--prove", "--trace=a.csv"])
def test_options_of_a_run_are_refused(cell: Cell, option: str) -> None:
    ran = cell("run", "ballscrew.mcl", "--show-code", option)
    name = option.partition("=")[0]
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(
        f"motionlang run: error: {name} has no effect with --show-code, which runs nothing\n"
    )


def test_colours_only_where_they_are_wanted(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("feed.mnt", FEED)
    plain = cell("run", "feed.mnt", "--show-code").out
    monkeypatch.setenv("FORCE_COLOR", "1")
    coloured = cell("run", "feed.mnt", "--show-code").out
    assert "\x1b[36mMOVER\x1b[0m" in coloured
    assert re.sub(r"\x1b\[[\d;]*m", "", coloured) == plain
    monkeypatch.setenv("NO_COLOR", "1")
    assert cell("run", "feed.mnt", "--show-code").out == plain


def test_show_tree_runs_nothing(cell: Cell) -> None:
    cell.write("a.mcl", '1PS0.1,OT"hello"\n  1WS@3\n')
    ran = cell("run", "a.mcl", "--show-tree")
    assert (ran.status, ran.err) == (0, "")
    assert ran.out.splitlines() == [
        "Module",
        "  Line number=1",
        "    Command axis=1 word='PS' argument=0.1",
        "    Command word='OT' argument='hello'",
        "  Line number=2",
        "    Command axis=1 word='WS'",
        "      argument: Register number=3",
    ]
    cell.write("a.mnt", "If INX(1) Then MOVER(0) = -5\n")
    assert cell("run", "a.mnt", "--show-tree").out.splitlines()[:3] == [
        "Module",
        "  If",
        "    condition: Name name='INX'",
    ]
    cell.write("b.mcl", "1MR5 5\n")
    ran = cell("run", "b.mcl", "--show-tree")
    assert (ran.status, ran.out) == (1, "")
    assert "a number alone is not a command" in ran.err
    ran = cell("run", "a.mcl", "--show-tree", "--until", "1")
    assert (ran.status, ran.out) == (2, "")
    assert "--until has no effect with --show-tree, which runs nothing" in ran.err
