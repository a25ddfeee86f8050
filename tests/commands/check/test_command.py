"""`motionlang check` reports all errors of all files."""

from __future__ import annotations

import io
import sys

import pytest

from tests.cli.programs import Cell


def test_the_machine_is_given_or_next_to_the_program(cell: Cell) -> None:
    cell.write("far.mnt", "ACCEL(0) = 9 : DECEL(0) = 9\nMOVEA(0) = 300\nGO(0)\n")
    cell.write("small.toml", "axis.0.travel = [0.0, 100.0]\n")
    assert cell("check", "far.mnt").out == "far.mnt: no problems\n"
    ran = cell("check", "far.mnt", "--machine", "small.toml")
    assert "the move ends at 300, beyond the limit switch at 100 of axis 0" in ran.out
    cell.write("far.machine.toml", "axis.0.travel = [0.0, 200.0]\n")
    assert "beyond the limit switch at 200 of axis 0" in cell("check", "far.mnt").out


def test_a_mistake_in_the_machine_file_is_reported_there(cell: Cell) -> None:
    cell.write("pick.mnt", "PRINT 1\n")
    cell.write("pick.machine.toml", "axis.0.travle = [0.0, 200.0]\n")
    ran = cell("check", "pick.mnt")
    assert ran.status == 1
    assert " --> pick.machine.toml:1:1\n" in ran.out
    assert "did you mean axis.N.travel?" in ran.out


def test_a_model_of_the_other_age(cell: Cell) -> None:
    cell.write("old.prg", "SPEED.0 = 10\nWHILE INX.1\nENDW\n")
    ran = cell("check", "old.prg", "--model", "mintmt")
    assert ran.status == 1
    assert "error[model]: SPEED.0 is Mint v4: it does not compile on MintMT\n" in ran.out
    assert "error[model]: ENDW is Mint v4: it does not compile on MintMT\n" in ran.out
    assert cell("check", "old.prg", "--model", "NextMove PC").status == 0
    ran = cell("check", "old.prg", "--model", "mint5")
    assert ran.status == 2
    assert "did you mean mint4?" in ran.err


def test_a_model_by_the_name_of_its_product(cell: Cell) -> None:
    cell.write("new.mnt", "Const SIZE = 5\nPRINT SIZE\n")
    assert cell("check", "new.mnt", "--model", "nextmove esb-2").status == 0
    ran = cell("check", "new.mnt", "--model", "MINTDRIVE")
    assert "error[model]: Const is MintMT: it does not compile on Mint v4\n" in ran.out
    ran = cell("check", "new.mnt", "--model", "MotiFlex e18")
    assert ran.status == 2
    assert "'MotiFlex e18' is not a known controller of Mint; did you mean MotiFlex e180?" in ran.err
    cell.write("new.machine.toml", 'controller.model = "Microflex e15"\n')
    ran = cell("run", "new.mnt")
    assert ran.status == 1
    assert "did you mean MicroFlex e150?" in ran.err


def test_standard_input_has_one_name(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Checks and runs call it `<stdin>`, in text as well as in JSON."""
    for arguments, where in [
        (("check", "-", "--lang", "mint"), "out"),
        (("check", "-", "--lang", "mint"), "out"),
        (("check", "-", "--lang", "mint", "--format", "json"), "out"),
        (("run", "-", "--lang", "mint", "--format", "json"), "out"),
        (("run", "-", "--format", "json"), "out"),
    ]:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"x = y\n")))
        assert "<stdin>" in getattr(cell(*arguments), where)


def test_a_board_without_tasks(cell: Cell) -> None:
    cell.write("tasks.mcl", "MD1,1MN,1MR5\nGT1\n")
    assert cell("check", "tasks.mcl").status == 0
    ran = cell("check", "tasks.mcl", "--model", "dcx-pc100")
    assert "error[model]: the DCX-PC100 modular controller has no GT" in ran.out


def test_the_programs_of_a_folder(cell: Cell) -> None:
    (cell.folder / "line" / "deep").mkdir(parents=True)
    for name in ("line/b.mnt", "line/a.mcl", "line/deep/c.MNT"):
        cell.write(name, "")
    cell.write("line/notes.txt", "")
    ran = cell("check", "line")
    assert ran.out == "line/a.mcl: no problems\nline/b.mnt: no problems\nline/deep/c.MNT: no problems\n"
    assert ran.status == 0
    (cell.folder / "none").mkdir()
    empty = cell("check", "none")
    assert (empty.status, empty.err) == (1, "no programs in none\n")
