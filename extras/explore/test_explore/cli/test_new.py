"""A user's first program: `motionlang init --new`."""

from __future__ import annotations

import pytest

import motionlang
from tests.cli.programs import Cell


@pytest.mark.parametrize(
    ("name", "file"), [("feed", "feed.mnt"), ("feed.mnt", "feed.mnt"), ("feed.mcl", "feed.mcl")]
)
def test_a_new_program_runs_and_is_clean(cell: Cell, name: str, file: str) -> None:
    """One cycle takes 2.6 s.

    Button after 0.5 s, 200 mm at 250 mm/s and 1250 mm/s² in 1 s, gripper 0.1 s, 1 s back.
    """
    made = cell("init", "--new", name)
    assert made.status == 0
    assert made.out.startswith(f"{file}, feed.machine.toml: written\n  motionlang run {file}\n")
    checked = cell("check", file, "--strict")
    assert (checked.status, checked.err) == (0, "")
    assert "ended after 2.600" in cell("run", file).out
    switched = {each.channel for each in motionlang.run(cell.folder / file).machine.log.outputs}
    assert switched == {1 if file.endswith(".mnt") else 9}
    assert "2 of 2 limits met" in cell("certify", file).out


def test_a_folder_that_does_not_exist_is_an_error(cell: Cell) -> None:
    ran = cell("init", "--new", "no/feed")
    assert ran.status == 1
    assert ran.err.startswith("error[file]: ")


@pytest.mark.parametrize("name", ["", "folder/", ".mnt"])
def test_a_program_needs_a_name(name: str, cell: Cell) -> None:
    ran = cell("init", "--new", name)
    assert ran.status == 2
    assert "FILE needs a name, such as feed" in ran.err


def test_the_commands_quote_a_name_with_blanks(cell: Cell) -> None:
    assert '  motionlang plot "bag feed.mnt" "bag feed.html"\n' in cell("init", "--new", "bag feed").out


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            "feed --until 300",
            "--new runs nothing: it takes no --until, --seconds, --cycle, --recording or --format",
        ),
        ("feed -q", "--new runs nothing: it takes no --until, --seconds, --cycle, --recording or --format"),
        ("feed.mnt --lang mccl", "feed.mnt is Mint by its extension"),
    ],
)
def test_options_of_the_run_are_refused(given: str, message: str, cell: Cell) -> None:
    ran = cell("init", "--new", *given.split())
    assert (ran.status, message in ran.err) == (2, True)
    assert not list(cell.folder.glob("feed*"))


def test_the_language_may_be_named_instead_of_an_extension(cell: Cell) -> None:
    assert cell("init", "--new", "feed", "--lang", "mccl").out.startswith(
        "feed.mcl, feed.machine.toml: written"
    )


@pytest.mark.parametrize(
    ("file", "hint"),
    [
        ("pikc.mnt", "did you mean pick.mnt? motionlang init --new pikc.mnt writes a small program"),
        ("zzzzz", "motionlang init --new zzzzz writes a small program"),
        (
            "old/pikc.mnt",
            "did you mean old/pick.mnt? motionlang init --new old/pikc.mnt writes a small program",
        ),
        ("pick.mmt", "did you mean pick.mnt?"),
    ],
)
def test_a_missing_program_gets_the_nearest_name(file: str, hint: str, cell: Cell) -> None:
    (cell.folder / "old").mkdir()
    for folder in ("", "old/"):
        cell.write(f"{folder}pick.mnt", "")
        cell.write(f"{folder}pikc.toml", "")
    ran = cell("init", file)
    assert (ran.status, ran.out) == (1, "")
    assert ran.err == f"error[file]: {file} cannot be read: no such file or directory\n  hint: {hint}\n"
