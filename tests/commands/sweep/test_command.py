"""`motionlang sweep`: rows, the best variants, failures, and resuming."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.sweep import Sweep
from motionlang.commands.sweep.expression import Expression
from motionlang.commands.sweep.report import SweepReport
from motionlang.commands.sweep.variants import Variants
from tests.cli.programs import STROKE, Cell

VARY = ("sweep", "stroke.mnt", "--vary", "rate=500:2000:4", "--vary", "length=20,100")


@pytest.fixture
def stroke(cell: Cell) -> Cell:
    cell.write("stroke.mnt", STROKE)
    return cell


def test_a_table_of_all_variants_and_the_best(stroke: Cell) -> None:
    ran = stroke(
        *VARY, "--keep", "time,peak.0", "--minimise", "time", "--where", "peak.0 < 150 and length == 20"
    )
    assert (ran.status, ran.err) == (0, "")
    assert ran.out == (
        "2 of 8 variants with peak.0 < 150 and length == 20\n\n"
        "rate  length      time   peak.0\n"
        "                     s     uu/s\n"
        "───────────────────────────────\n"
        " 500      20   0.40006      100\n"
        "1000      20  0.282903  141.421\n\n"
        "best: rate = 1000, length = 20; time is smallest there, 0.282903\n"
    )


@pytest.mark.parametrize(("rows", "listed"), [("0", 4), ("1", 1), ("3", 3)])
def test_a_table_has_as_many_rows_as_asked_for_and_0_are_all(rows: str, listed: int, stroke: Cell) -> None:
    ran = stroke(*VARY[:4], "--keep", "time", "--rows", rows)
    table = ran.out.partition("─\n")[2].partition("\n\n")[0]
    assert [line.split()[0] for line in table.splitlines()][:listed] == ["500", "1000", "1500", "2000"][
        :listed
    ]
    assert ran.out.count("0.") == listed


def test_a_front_and_a_picture(stroke: Cell) -> None:
    for plot, options in (
        ("front.png", ("--pareto", "time,peak.0")),
        ("lines.svg", ()),
        ("map.png", ("--latin", "12")),
    ):
        ran = stroke(*VARY, "--keep", "time,peak.0", *options, "--plot", plot)
        assert (ran.status, ran.err) == (0, "")
        assert (stroke.folder / plot).stat().st_size > 5000
    assert stroke(*VARY, "--pareto", "time,peak.0").out.startswith("4 of 8 variants on the Pareto front\n")


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
        file.write("[7, [0.")  # a truncated line
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


@pytest.mark.slow
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


def test_the_file_beside_the_program_says_what_the_line_does_not(stroke: Cell) -> None:
    stroke.write(
        "stroke.sweep.toml",
        'keep = ["time"]\nminimise = "time"\n[vary]\nrate = "500:2000:4"\nlength = [20]\n',
    )
    ran = stroke("sweep", "stroke.mnt")
    assert ran.out.endswith("best: rate = 2000, length = 20; time is smallest there, 0.20006\n")
    assert stroke("sweep", "stroke.mnt", "--maximise", "time").out.endswith(
        "time is largest there, 0.40006\n"
    )
    stroke.write("stroke.sweep.toml", 'kep = ["time"]\nlatin = 0\n[vary]\nrate = {}\n')
    ran = stroke("sweep", "stroke.mnt")
    assert ran.status == 1
    for message in (
        "there is no key kep",
        "did you mean keep?",
        "latin: '0' is not a whole number above 0",
    ):
        assert message in ran.err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((), "nothing to vary: give --vary"),
        (("--vary", "rate=1:2"), "how many values of rate?"),
        (("--vary", "rate"), "is not NAME=FIRST:LAST:COUNT"),
        (("--vary", "rat=1"), "did you mean rate?"),
        (("--vary", "rate=1", "--keep", "tme"), "a run has no tme; did you mean time"),
        (("--vary", "rate=1", "--minimise", "time +"), "is not an expression"),
        (("--vary", "rate=1", "--where", "tme < 1"), "a run has no tme"),
        (
            ("--vary", "rate=1", "--minimise", "time", "--maximise", "time"),
            "give either --minimise or --maximise",
        ),
        (("--vary", "rate=1", "--pareto", "time"), "a Pareto front needs two"),
        (("--vary", "rate=1", "--random", "4", "--latin", "4"), "not both"),
        (("--vary", "rate=1", "--rows-to", "rows.xls"), "--rows-to writes .csv and .parquet, not .xls files"),
        (("--vary", "rate=1", "--rows-to", "no/rows.csv"), "there is no folder no"),
        (("--vary", "rate=1", "--resume"), "--resume needs --rows-to"),
    ],
)
def test_what_the_command_line_lacks_is_reported(stroke: Cell, words: tuple[str, ...], message: str) -> None:
    ran = stroke("sweep", "stroke.mnt", *words)
    assert ran.status == 2
    assert message in ran.err


def test_what_cannot_be_read_is_reported(stroke: Cell) -> None:
    for words, message in (
        (("stroke.mnt", "--machines", "nowhere"), "nowhere cannot be read"),
        (("stroke.mnt", "--machines", "empty"), "no machine files in empty"),
        (("wrong.mnt", "--vary", "a=1"), "error[unknown-word]"),
    ):
        (stroke.folder / "empty").mkdir(exist_ok=True)
        stroke.write("wrong.mnt", "Const a = 1\nPRINT b\n")
        ran = stroke("sweep", *words)
        assert ran.status in (1, 2)
        assert message in ran.err, ran.err
    assert json.dumps(sorted(each.name for each in Path(stroke.folder).glob("*.part"))) == "[]"


def made_report(where: str | None = None) -> SweepReport:
    """Return the report of a sweep over `x`."""
    variants = Variants(where=None if where is None else Expression(where))
    return SweepReport(variants, ["x"])


@pytest.mark.parametrize(
    ("count", "line", "wanted"),
    [
        (1, 0, "fault: stopped\n    with x = 0\n"),
        (3, 7, "fault: stopped (line 7)\n    with x = 0; x = 1; x = 2\n"),
        (4, 7, "fault: stopped (line 7)\n    with x = 0; x = 1; x = 2; and 1 more\n"),
        (6, 7, "fault: stopped (line 7)\n    with x = 0; x = 1; x = 2; and 3 more\n"),
    ],
)
def test_three_variants_of_an_error_are_named(
    count: int, line: int, wanted: str, capsys: pytest.CaptureFixture[str]
) -> None:
    sweep: Any = SimpleNamespace(space=[(k,) for k in range(9)])
    problem = {"code": "fault", "message": "stopped", "line": line}
    made_report()._report_failures(sweep, dict.fromkeys(range(count), problem), 9)
    assert capsys.readouterr().err == f"{count} of 9 variants failed\n  {wanted}"


def test_errors_that_differ_in_figures_are_one(capsys: pytest.CaptureFixture[str]) -> None:
    sweep: Any = SimpleNamespace(space=[(k,) for k in range(9)])
    messages = ("limit 5.5 passed", "limit 7 passed", "no motion")
    bad = {k: {"code": "limit", "message": each, "line": 0} for k, each in enumerate(messages)}
    made_report()._report_failures(sweep, bad, 9)
    assert capsys.readouterr().err == (
        "3 of 9 variants failed\n  limit: limit 5.5 passed\n    with x = 0; x = 1\n  limit: no motion\n    with x = 2\n"
    )


def test_without_a_best_variant_the_condition_is_named() -> None:
    wanted = Expression("time")
    assert made_report("time < 5")._best_line({}, None, wanted) == "no variant has time < 5"
    assert made_report()._best_line({}, None, wanted) == "no variant has a time"
