"""A user's first command: `motionlang` alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.programs import Cell


def test_an_empty_folder_gets_the_first_steps(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    monkeypatch.chdir(empty)
    ran = cell()
    assert (ran.status, ran.out) == (2, "")
    assert "  motionlang init --new feed  write a small program with its machine file\n" in ran.err


def test_a_folder_with_programs_gets_their_names(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folder = tmp_path / "shop"
    folder.mkdir()
    for name in ("b.mnt", "a.prg", "c.mcl", "d.mnt", "notes.txt"):
        (folder / name).write_text("")
    monkeypatch.chdir(folder)
    shown = cell().err
    assert "this folder has a.prg, b.mnt, c.mcl and 1 more\n" in shown
    assert "  motionlang run a.prg  " in shown
    assert "  motionlang init a.prg  " in shown
    (folder / "a.machine.toml").write_text("")
    assert "init" not in cell().err
