"""`motionlang sweep`: pictures, files of rows, and resuming; the rest is in `tests/cli/transcripts_sweep.txt`."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from typing import Any

import pytest

from motionlang.commands.sweep import Sweep
from tests.cli.programs import STROKE, Cell

VARY = ("sweep", "stroke.mnt", "--vary", "rate=500:2000:4", "--vary", "length=20,100")


@pytest.fixture
def stroke(cell: Cell) -> Cell:
    cell.write("stroke.mnt", STROKE)
    return cell


def test_a_front(stroke: Cell) -> None:
    ran = stroke(*VARY, "--pareto", "time,peak.0")
    assert ran.out.startswith("4 of 8 variants on the Pareto front\n")


def test_bad_variants_are_distinguished_and_retained(stroke: Cell) -> None:
    ran = stroke(*VARY[:2], "--vary", "rate=0,500,-1,0", "--keep", "time", "--rows-to", "rows.csv")
    assert ran.status == 1
    assert [line.split() for line in ran.out.splitlines()[3:]] == [["500", "0.90006"]]
    assert ran.err.startswith("3 of 4 variants failed\n  ")
    assert "with rate = 0; rate = -1; rate = 0" in ran.err or "with rate = 0; rate = 0" in ran.err
    with open(stroke.folder / "rows.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["problem"] == "" for row in rows] == [False, True, False, False]
    assert not (stroke.folder / "rows.csv.part").exists()


def test_a_sweep_that_was_ended_goes_on(stroke: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = stroke(*VARY, "--rows-to", "whole.csv", "--format", "none")
    assert (whole.status, whole.out, whole.err) == (0, "", "")
    ran: list[int] = []
    all_results = Sweep.results

    def ended(self: Sweep, *args: Any, **kwargs: Any) -> Iterator[Any]:
        for result in all_results(self, *args, **kwargs):
            ran.append(result[0])
            yield result
            if len(ran) == 3:
                raise KeyboardInterrupt

    monkeypatch.setattr(Sweep, "results", ended)
    first = stroke(*VARY, "--rows-to", "rows.csv")
    assert (first.status, first.err) == (130, "ended after 3 of 8 variants; --resume continues\n")
    assert len((stroke.folder / "rows.csv").read_text().splitlines()) == 4
    with open(stroke.folder / "rows.csv.part", "a", encoding="ascii") as file:
        file.write('7\n\n[0, [1]]\n["0", [1], null]\n{}\n[[[\n[7, [0.')  # no rows, and a truncated line
    other = stroke(*VARY, "--keep", "peak.0", "--rows-to", "rows.csv", "--resume")
    assert other.status == 2
    assert "has the rows of another sweep" in other.err
    second = stroke(*VARY, "--rows-to", "rows.csv", "--resume", "--format", "none")
    assert (second.status, second.err) == (0, "")
    assert sorted(ran) == list(range(8))
    assert (stroke.folder / "rows.csv").read_text() == (stroke.folder / "whole.csv").read_text()
    again = stroke(*VARY, "--rows-to", "rows.csv", "--resume", "--format", "none")
    assert again.err == "rows.csv.part does not exist: nothing to resume, so all 8 variants run\n"


def test_machines_of_a_folder(stroke: Cell) -> None:
    (stroke.folder / "machines").mkdir()
    stroke.write("machines/long.machine.toml", "[axis.0]\ntravel = [-5, 500]\n")
    stroke.write("machines/short.toml", "[axis.0]\ntravel = [-5, 50]\n")
    ran = stroke("sweep", "stroke.mnt", "--machines", "machines", "--keep", "position.0", "--format", "csv")
    assert ran.out.splitlines()[0] == "variant,machine,position.0,problem"
    assert ran.out.splitlines()[1] == "0,long,100.0,"
    stroke.write("machines/short.toml", "[axis.0]\ntravell = [-5, 50]\n")
    ran = stroke("sweep", "stroke.mnt", "--machines", "machines")
    assert ran.status == 1
    assert "short.toml, line 2: there is no key axis.0.travell" in ran.err


def test_parquet_has_the_rows_of_the_csv(stroke: Cell) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    for out in ("rows.csv", "rows.parquet"):
        assert stroke(*VARY, "--keep", "time,prints", "--rows-to", out, "--format", "none").status == 0
    table = parquet.read_table(stroke.folder / "rows.parquet").to_pydict()
    with open(stroke.folder / "rows.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert table["time"] == [float(row["time"]) for row in rows]
    assert table["prints"] == ["there"] * 8
    assert table["problem"] == [None] * 8
