"""`motionlang notes tn1069`: the comparison of TN1069, exact and as printed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.programs import Cell
from tests.generated.pictures import described

TABLE = """\
TN1069: one move in four profiles
A = 100000 counts/s², V = 40000 counts/s, S = 40000 counts; 1000 cycles per second

                                       trapezoidal   sinusoidal  trapezoidal 0.1    parabolic
───────────────────────────────────────────────────────────────────────────────────────────────────────────
T_A             acceleration time              400  628.3185307      444.4444444          800  cycles
S_A             acceleration distance         8000  12566.37061      8888.888889  21333.33333  counts
S_V             slew distance                24000  14867.25877      22222.22222         none  counts
T_V             slew time                      600  371.6814693      555.5555556         none  cycles
peak            peak velocity                   40           40               40  38.72983346  counts/cycle
the whole move  duration                      1400  1628.318531      1444.444444  1549.193338  cycles
"""


def test_the_exact_table(cell: Cell) -> None:
    assert cell("notes", "tn1069").out == TABLE


def test_as_printed_with_every_erratum(cell: Cell) -> None:
    lines = cell("notes", "tn1069", "--published").out.splitlines()
    printed = [line.split()[2:] for line in lines if line.strip().startswith("as printed")]
    assert printed == [
        ["400", "628", "444", "800"],
        ["8000", "12560", "8880", "10667"],
        ["24000", "14880", "22240", "18667"],
        ["600", "372", "556", "467"],
    ]
    assert [line[:2] for line in lines if line[:1].isdigit()] == [
        "1.",
        "2.",
        "3.",
        "4.",
        "5.",
        "6.",
        "7.",
        "8.",
    ]


def test_json_has_full_precision(cell: Cell) -> None:
    document = json.loads(cell("notes", "tn1069", "--format", "json").out)
    rows = {row["name"]: row for row in document["rows"]}
    assert rows["T_A"]["exact"][1] == pytest.approx(628.3185307179587, rel=1e-12)
    assert rows["S_V"]["exact"][3] is None
    assert rows["peak"]["printed"] is None
    assert len(document["errata"]) == 8


def test_a_move_of_ones_own(cell: Cell) -> None:
    line = "notes tn1069 --acceleration 200 --deceleration 100 --velocity 50 --distance 1000 --ramp 0.25"
    out = cell(*line.split()).out
    assert "A = 200 counts/s², D = 100 counts/s², V = 50 counts/s, S = 1000 counts;" in out
    assert "trapezoidal 0.25" in out
    assert [line.split()[0] for line in out.splitlines()[5:9]] == ["T_A", "S_A", "T_D", "S_D"]
    document = json.loads(cell(*line.split(), "--format", "json").out)
    assert document["given"]["ramp"] == 0.25
    assert document["errata"] == []
    assert document["rows"][2]["exact"][0] == pytest.approx(500.0)


@pytest.mark.parametrize(("kind", "head"), [("png", b"\x89PNG"), ("svg", b"<?xml")])
def test_it_is_drawn(cell: Cell, tmp_path: Path, kind: str, head: bytes) -> None:
    pytest.importorskip("matplotlib")
    path = tmp_path / f"a.{kind}"
    ran = cell("notes", "tn1069", "--velocity", "20000", "--plot", str(path))
    assert (ran.status, ran.err) == (0, "")
    assert path.read_bytes().startswith(head)


def test_the_move_of_the_options_is_drawn(cell: Cell, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    path = tmp_path / "a.svg"
    pictures = []
    with described():
        for velocity in ("20000", "30000"):
            assert cell("notes", "tn1069", "--velocity", velocity, "--plot", str(path)).status == 0
            pictures.append(path.read_text(encoding="utf-8"))
    assert pictures[0] != pictures[1]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("--velocity 0", "the velocity must be above zero"),
        ("--acceleration nan", "the acceleration must be above zero"),
        ("--deceleration -3", "the deceleration must be above zero"),
        ("--distance inf", "the distance must be above zero"),
        ("--ramp 0.5", "the ramp must be above 0 and below 0.5, not 0.5"),
        ("--velocity 3 --published", "--published works only for the move of the note"),
        ("--plot a.txt", "--plot writes .png and .svg files"),
    ],
)
def test_a_move_that_there_is_not(cell: Cell, line: str, message: str) -> None:
    ran = cell("notes", "tn1069", *line.split())
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(f"motionlang notes tn1069: error: {message}")


def test_a_plot_that_cannot_be_written(cell: Cell, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    ran = cell("notes", "tn1069", "--plot", str(tmp_path / "no" / "a.png"))
    assert (ran.status, ran.out) == (1, "")
    assert "cannot be written: no such file or directory" in ran.err
