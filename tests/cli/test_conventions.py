"""Conventions of all commands: --format, -o, -q, -j, -V, and help in 80 columns."""

from __future__ import annotations

import json

import pytest

from motionlang import __version__
from tests.cli.programs import ALL, Cell

MOVE = "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"
SWEEP = ("a.mnt", "--vary", "rate=1,2", "--keep", "time")


@pytest.fixture
def program(cell: Cell) -> Cell:
    cell.write("a.mnt", "Dim rate = 1\nSPEED(0) = rate\nACCEL(0) = 1e5 : DECEL(0) = 1e5\n" + MOVE)
    return cell


@pytest.mark.parametrize("parser", ALL, ids=lambda each: each.prog)
def test_help_fits_80_columns(parser: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    text = parser.format_help()  # type: ignore[attr-defined]
    assert [line for line in text.splitlines() if len(line) > 80] == []


def test_a_wrong_command_line_leaves_the_old_file(program: Cell) -> None:
    path = program.write("out.json", "old")
    assert program("plan", "--distance", "20", "-o", "out.json").status == 2
    assert path.read_text() == "old"


def test_q_prints_no_report(program: Cell) -> None:
    assert program("run", "a.mnt", "-q").out == "5.0000\n"
    assert program("check", "a.mnt", "-q").out == ""
    assert program("check", "a.mnt").out == "a.mnt: no problems\n"


def test_a_certificate_without_a_report_still_has_its_verdict(program: Cell) -> None:
    assert program("certify", "a.mnt", "-q").out.startswith("5.0000\nmotion verified: 1 move, ")


def test_capital_v_is_the_version(cell: Cell) -> None:
    assert cell("-V").out == cell("--version").out == f"motionlang {__version__}\n"


def test_check_writes_diagnostics_to_standard_output(cell: Cell) -> None:
    cell.write("a.mnt", "SPED(0) = 5\n")
    ran = cell("check", "a.mnt")
    assert (ran.status, ran.err) == (1, "")
    assert ran.out.startswith("error[unknown-word]: SPED is unknown")
    assert ran.out.endswith("a.mnt: 1 error\n")
    assert "SPED" not in cell("check", "a.mnt", "--format", "json").err


@pytest.mark.parametrize("verb", ["check", "verify"])
def test_without_a_path_this_folder_is_meant(
    verb: str, tmp_path: object, program: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = program.folder / "cell"
    folder.mkdir()
    (folder / "b.mnt").write_text(MOVE)
    monkeypatch.chdir(folder)
    assert program(verb).out == program(verb, ".").out
    assert "b.mnt" in program(verb).out


def test_rows_of_a_sweep_as_json(program: Cell) -> None:
    """A move of 5 uu at 1 and 2 uu/s takes 5 s and 2.5 s; the ramps add v/a."""
    ran = program("sweep", *SWEEP, "--format", "json")
    rows = json.loads(ran.out)["rows"]
    assert [(row["variant"], row["rate"], row["problem"]) for row in rows] == [(0, 1, None), (1, 2, None)]
    accel = 40_000.0  # MintMT's default, counts/s²
    assert [row["time"] for row in rows] == [
        pytest.approx(5.0 / rate + rate / accel, abs=1e-4) for rate in (1.0, 2.0)
    ]
