"""`--format` of `check` and `verify`."""

from __future__ import annotations

import json
from xml.etree import ElementTree

import pytest

from tests.cli.programs import Cell

SPARE = "PRINT 1\nDim spare As Integer\n"


def test_sarif(cell: Cell) -> None:
    cell.write("idle.mnt", SPARE)
    ran = cell("check", "idle.mnt", "wrong.mcl", "--format", "sarif")
    document = json.loads(ran.out)
    (run,) = document["runs"]
    warning, error, *_ = run["results"]
    assert (ran.status, ran.err, document["version"]) == (1, "", "2.1.0")
    assert run["tool"]["driver"]["name"] == "motionlang"
    assert (warning["ruleId"], warning["level"], error["level"]) == ("unused-variable", "warning", "error")
    assert warning["locations"] == [
        {
            "physicalLocation": {
                "artifactLocation": {"uri": "idle.mnt"},
                "region": {"startLine": 2, "startColumn": 5, "endColumn": 10},
            }
        }
    ]
    assert {rule["id"] for rule in run["tool"]["driver"]["rules"]} == {
        each["ruleId"] for each in run["results"]
    }


def uris(document: str) -> list[str]:
    """Return the URI of each result of a SARIF document."""
    results = json.loads(document)["runs"][0]["results"]
    return [each["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] for each in results]


def test_sarif_has_uris(cell: Cell) -> None:
    (cell.folder / "e08 #1").mkdir()
    path = cell.write("e08 #1/Kühl 50%.mnt", "PRINT )\n")
    escaped = "e08%20%231/K%C3%BChl%2050%25.mnt"
    assert uris(cell("check", "e08 #1", "--format", "sarif").out) == [escaped]
    assert uris(cell("check", str(path), "--format", "sarif").out) == [path.as_uri()]
    assert path.as_uri().endswith(escaped)


def test_junit_keeps_line_ends(cell: Cell) -> None:
    cell.write("a.mnt", 'PRINT "a"\n')
    cell("verify", "a.mnt", "--update")
    cell.write("a.mnt", 'PRINT "b"\nPRINT "c"\n')
    failure = ElementTree.fromstring(cell("verify", "a.mnt", "--format", "junit").out).find(".//failure")
    assert failure is not None
    assert failure.text is not None
    assert "\u240a" not in failure.text
    assert failure.text.splitlines()[:2] == [
        "error[golden]: a.mnt: differs",
        "    A 'a' after 0.00 s, B 'b', then 'c' after 0.00 s (line 1 of A, line 1 of B)",
    ]


def test_junit_counts_files(cell: Cell) -> None:
    cell.write("idle.mnt", SPARE)
    root = ElementTree.fromstring(
        cell("check", "idle.mnt", "wrong.mcl", "ballscrew.mcl", "--format", "junit").out
    )
    suite = root[0]
    assert (suite.get("tests"), suite.get("failures")) == ("3", "1")
    assert [(each.get("name"), [child.tag for child in each]) for each in suite] == [
        ("idle.mnt", ["system-out"]),
        ("wrong.mcl", ["failure"]),
        ("ballscrew.mcl", []),
    ]
    failure = suite.find("testcase/failure")
    assert failure is not None
    assert failure.get("message") == "1 error"
    assert " --> wrong.mcl:2:1" in str(failure.text)
    strict = cell("check", "idle.mnt", "--format", "junit", "--strict")
    assert (strict.status, ElementTree.fromstring(strict.out)[0].get("failures")) == (1, "1")


def test_github_escapes(cell: Cell) -> None:
    cell.write("a,b.mnt", SPARE)
    assert cell("check", "a,b.mnt", "--format", "github").out == (
        "::warning file=a%2Cb.mnt,line=2,col=5,endColumn=10,title=unused-variable::spare is declared and never used\n"
    )


@pytest.mark.parametrize("form", ["json", "sarif", "junit", "github"])
def test_verify(form: str, cell: Cell) -> None:
    cell("verify", "ballscrew.mcl", "--update")
    ran = cell("verify", "ballscrew.mcl", "jog.mcl", "--format", form)
    assert ran.status == 1
    assert "no jog.golden.json next to it" in ran.out
    if form == "json":
        document = json.loads(ran.out)
        assert [each["matches_golden"] for each in document["verdicts"]] == [True, False]


def test_many_at_once_are_reported_as_one_by_one(cell: Cell) -> None:
    (cell.folder / "line").mkdir()
    for number in range(6):
        cell.write(f"line/{number}.mnt", SPARE if number % 2 else "PRINT 1 +\n")
    one, two = cell("check", "line", "--jobs", "1"), cell("check", "line", "--jobs", "2")
    assert (one.status, one.out, one.err) == (two.status, two.out, two.err)
    assert one.status == 1
    one, two = cell("verify", "line", "--jobs", "1"), cell("verify", "line", "--jobs", "2")
    assert (one.out, one.err) == (two.out, two.err)
