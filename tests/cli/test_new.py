"""A user's first commands: `motionlang` alone, and `motionlang new`."""

from __future__ import annotations

from pathlib import Path

import pytest

import motionlang
from tests.cli.programs import Cell


def test_an_empty_folder_gets_the_first_steps(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    monkeypatch.chdir(empty)
    ran = cell()
    assert (ran.status, ran.out) == (2, "")
    assert "  motionlang new feed      write a small program with its machine file\n" in ran.err


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


@pytest.mark.parametrize(
    ("name", "file"), [("feed", "feed.mnt"), ("feed.mnt", "feed.mnt"), ("feed.mcl", "feed.mcl")]
)
def test_a_new_program_runs_and_is_clean(cell: Cell, name: str, file: str) -> None:
    """One cycle takes 2.6 s.

    Button after 0.5 s, 200 mm at 250 mm/s and 1250 mm/s² in 1 s, gripper 0.1 s, 1 s back.
    """
    made = cell("new", name)
    assert made.status == 0
    assert made.out.startswith(f"{file}, feed.machine.toml: written\n  motionlang run {file}\n")
    checked = cell("check", file, "--strict")
    assert (checked.status, checked.err) == (0, "")
    assert "ended after 2.600" in cell("run", file).out
    switched = {each.channel for each in motionlang.run(cell.folder / file).machine.log.outputs}
    assert switched == {1 if file.endswith(".mnt") else 9}
    assert "2 of 2 limits met" in cell("certify", file).out


@pytest.mark.parametrize("present", ["feed.mnt", "feed.machine.toml"])
def test_a_file_that_exists_stays(cell: Cell, present: str) -> None:
    cell.write(present, "mine")
    ran = cell("new", "feed")
    assert ran.status == 1
    assert f"{present} exists" in ran.err
    assert (cell.folder / present).read_text() == "mine"
    assert len([path for path in cell.folder.iterdir() if path.name.startswith("feed")]) == 1


def test_another_suffix_is_refused(cell: Cell) -> None:
    ran = cell("new", "feed.txt")
    assert ran.status == 2
    assert ".mnt" in ran.err


def test_a_folder_that_does_not_exist_is_an_error(cell: Cell) -> None:
    ran = cell("new", "no/feed")
    assert ran.status == 1
    assert ran.err.startswith("error[file]: ")


@pytest.mark.parametrize("name", ["", "folder/", ".mnt"])
def test_a_program_needs_a_name(name: str, cell: Cell) -> None:
    ran = cell("new", name)
    assert ran.status == 2
    assert "NAME needs a name, such as feed" in ran.err


def test_the_commands_quote_a_name_with_blanks(cell: Cell) -> None:
    assert '  motionlang plot "bag feed.mnt" "bag feed.html"\n' in cell("new", "bag feed").out
