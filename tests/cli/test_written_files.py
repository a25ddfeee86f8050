"""No command writes over a file that it reads, or writes two results into one file."""

from __future__ import annotations

import os

import pytest

from tests.cli.programs import STROKE, Cell

USED = "this command already uses"
TWICE = "both write"
OTHER = "--output writes neither machine files nor programs"


@pytest.mark.parametrize(
    ("command", "why"),
    [
        ("certify a.mnt -o a.machine.toml", USED),
        ("run a.mnt -o a.mnt", USED),
        ("run a.mnt -o ./a.mnt", USED),
        ("run a.mnt -o link.mnt", USED),
        ("run a.mnt -o soft.mnt", USED),
        ("run a.mnt --nv a.mnt", USED),
        ("trace a.mnt nv.csv --nv nv.csv", TWICE),
        ("run a.mnt --machine m.toml -o m.toml", USED),
        ("compare a.mnt rec.csv -o rec.csv", USED),
        ("diff a.mnt b.mnt -o b.mnt", USED),
        ("sweep a.mnt --vary rate=1,2 -o a.mnt", USED),
        ("sweep a.mnt --scenarios worlds --vary rate=1,2 -o worlds/one.toml", USED),
        ("verify . -o a.mnt", USED),
        ("verify . -o worlds/one.toml", USED),
        ("plot a.mnt out.html -o out.html", TWICE),
        ("run a.mnt -o new.mnt", OTHER),
        ("profile a.mnt --format none -o rec.csv", "nothing to write into rec.csv"),
    ],
)
def test_a_file_that_is_in_use_is_not_written(command: str, why: str, cell: Cell) -> None:
    assert_nothing_is_written(command, why, cell)


def assert_nothing_is_written(command: str, why: str, cell: Cell) -> None:
    """Check that a command ends with 2, says why, and changes no file."""
    for name in ("a.mnt", "b.mnt", "rec.csv", "m.toml", "worlds/one.toml"):
        cell.write(name, STROKE)
    os.link(cell.folder / "a.mnt", cell.folder / "link.mnt")
    (cell.folder / "soft.mnt").symlink_to("a.mnt")
    before = {path: path.read_bytes() for path in cell.folder.rglob("*") if path.is_file()}
    ran = cell(*command.split())
    assert (ran.status, ran.out) == (2, "")
    assert why in ran.err
    assert {path: path.read_bytes() for path in cell.folder.rglob("*") if path.is_file()} == before


def test_a_report_in_the_folder_that_is_read_is_written_again(cell: Cell) -> None:
    cell.write("line/a.mnt", "MOVER(0) = 10 : GO(0)\nPAUSE IDLE(0)\n")
    for _ in range(2):
        assert cell("check", "line", "-o", "line/report.json").status == 0


def test_the_output_of_plot_is_its_picture(cell: Cell) -> None:
    cell.write("a.mnt", STROKE)
    ran = cell("plot", "a.mnt", "-o", "other.html")
    assert (ran.status, ran.out) == (0, "there\n")
    assert sorted(path.name for path in cell.folder.glob("*.html")) == ["other.html"]
