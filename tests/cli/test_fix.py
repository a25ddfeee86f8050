"""`check --fix`: what is certain is written, line ends and all the rest of a file stay."""

from __future__ import annotations

import json

import pytest

from tests.cli.programs import Cell


def test_a_number_without_brackets(cell: Cell) -> None:
    path = cell.folder / "a.mnt"
    path.write_bytes("\ufeffMOVER(3) = 5 ' caf\u00e9\r\nGo3 : MOVER(3) = 4\r\nGo3 : SPED(0) = 3\n".encode())
    ran = cell("check", "a.mnt", "--fix")
    assert path.read_bytes() == (
        "\ufeffMOVER(3) = 5 ' caf\u00e9\r\nGO(3) : MOVER(3) = 4\r\nGO(3) : SPED(0) = 3\n".encode()
    )
    assert (ran.status, ran.out) == (1, "a.mnt: 2 fixed, 1 error\n")
    assert ran.err.startswith(
        "a.mnt:2:1: fixed[unknown-word]: Go3 -> GO(3)\na.mnt:3:1: fixed[unknown-word]: Go3 -> GO(3)\nerror["
    )
    assert "did you mean SPEED?" in ran.err


def test_the_notation_of_the_other_age(cell: Cell) -> None:
    text = "SPEED.0 = 10\nIF INX.1 DO\n  x = 7 % 4\nENDIF\nWHILE INX.1\n  WAIT = 5\nENDW\nPRINT x\n"
    cell.write("old.prg", text)
    assert cell("check", "old.prg", "--fix").status == 0
    assert (cell.folder / "old.prg").read_text() == text
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert (cell.folder / "old.prg").read_text() == (
        "SPEED(0) = 10\nIF INX(1) DO\n  x = 7 Mod 4\nEnd If\nWHILE INX(1)\n  WAIT = 5\nEnd While\nPRINT x\n"
    )
    assert "error[model]: IF … DO is Mint v4" in ran.err
    assert ran.out == "old.prg: 6 fixed, 1 error\n"


def test_what_is_not_certain_stays(cell: Cell) -> None:
    cell.write("a.mnt", "SPED(0) = 3\nDim spare As Integer\n")
    cell("check", "a.mnt", "--fix")
    assert (cell.folder / "a.mnt").read_text() == "SPED(0) = 3\nDim spare As Integer\n"
    (cell.folder / "b.mnt").write_bytes(b"' caf\xe9\nGo3\n")
    assert cell("check", "b.mnt", "--fix").status == 1
    assert (cell.folder / "b.mnt").read_bytes() == b"' caf\xe9\nGo3\n"


def test_json_has_what_was_fixed(cell: Cell) -> None:
    cell.write("a.mnt", "MOVER(3) = 5\nGo3\nPAUSE IDLE(3)\n")
    ran = cell("check", "a.mnt", "--fix", "--format", "json")
    (row,) = json.loads(ran.out)["files"]
    assert row["diagnostics"] == []
    (fixed,) = row["fixed"]
    assert (fixed["line"], fixed["column"], fixed["before"], fixed["after"]) == (2, 1, "Go3", "GO(3)")
    (row,) = json.loads(cell("check", "a.mnt", "--fix", "--format", "json").out)["files"]
    assert row["fixed"] == []
    assert cell("check", "a.mnt", "--fix").out == "a.mnt: no mistakes\n"
    assert "fixed" not in json.loads(cell("check", "a.mnt", "--format", "json").out)["files"][0]


def test_a_file_that_cannot_be_written_says_so(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    cell.write("a.mnt", "MOVER(3) = 5\nGo3\nPAUSE IDLE(3)\n")
    monkeypatch.setattr("motionlang.cli.fix.replacing", full)
    ran = cell("check", "a.mnt", "--fix")
    assert "a.mnt cannot be written: no space left on device" in ran.err
    assert "fixed" not in ran.out + ran.err
