"""The texts that users see of generated programs have not changed.

`results.txt` has their digests. An unexpected difference is a fault, or shows code that no other test
reaches.
"""

from __future__ import annotations

import os
from functools import cache
from itertools import groupby
from pathlib import Path

import pytest

from tests import cases
from tests.generated.damage import damaged
from tests.generated.results import DIGESTS, LEFT_OUT, digests, main, names, rounded
from tests.mutants.recorder import ACTIVE

# Cases of one test. The normal run compares one case in `STEP`, and those with a kind of text that their family has not
# had before.
BATCH, STEP = 1, 5
SLOW = ("tasks-5", "words-14")


def batches() -> dict[str, list[str]]:
    """Return the names of the cases in batches, each of one family."""
    families = {family: list(found) for family, found in groupby(names(), lambda name: name.split("-")[0])}
    return {
        f"{family}-{first // BATCH}": found[first : first + BATCH]
        for family, found in families.items()
        for first in range(0, len(found), BATCH)
    }


def recorded() -> dict[str, dict[str, str]]:
    """Return the digests in `results.txt`, by case and kind."""
    lines = (line.split() for line in DIGESTS.read_text(encoding="utf-8").splitlines())
    return {
        name: {kind: digest for kind, digest in (each.split("=") for each in kinds) if kind not in LEFT_OUT}
        for name, *kinds in lines
    }


def rewrite(found: dict[str, dict[str, str]]) -> None:
    """Write digests into `results.txt`, and remove cases that no longer exist."""
    known = recorded() | found
    lines = [" ".join([name, *map("=".join, known[name].items())]) for name in names() if name in known]
    DIGESTS.write_text("\n".join([*lines, ""]), encoding="utf-8")


def differences(name: str, found: dict[str, str], expected: dict[str, str]) -> str:
    """Return a message that lists the kinds of text that differ.

    If the program itself has changed, its texts differ anyway, so they are not listed.
    """
    if found.get("program") != expected.get("program"):
        return f"{name}: the program itself, by the generator, the keyword rows or the gallery"
    kinds = [kind for kind in {**expected, **found} if found.get(kind) != expected.get(kind)]
    return f"{name}: {', '.join(kinds)}" if kinds else ""


@cache
def normal_run() -> set[str]:
    """Return the names of the cases that the normal run compares."""
    known, chosen, seen = recorded(), set[str](), set[tuple[str, str]]()
    for number, name in enumerate(names()):
        kinds = {(name.split("-")[0], kind) for kind in known.get(name, {})}
        if number % STEP == 0 or not kinds <= seen:
            chosen.add(name)
            seen |= kinds
    return chosen


@pytest.mark.parametrize(
    "batch", [pytest.param(each, marks=pytest.mark.slow) if each in SLOW else each for each in batches()]
)
def test_what_users_see_of_programs_has_not_changed(
    batch: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / ".cache"))
    for name in ("NO_COLOR", "FORCE_COLOR", "COLUMNS", "TERM"):
        monkeypatch.delenv(name, raising=False)
    of_batch = batches()[batch]
    if request.config.getoption("--update"):
        assert "PYTEST_XDIST_WORKER" not in os.environ, "give -n 0, too: workers write over each other's rows"
        assert not LEFT_OUT, "install motionlang-lsp and motionlang-explore: the rows have their texts, too"
        rewrite({name: digests(name) for name in of_batch})
        return
    known, changed = recorded(), []
    for name in of_batch if cases.is_complete() else [name for name in of_batch if name in normal_run()]:
        told = differences(name, digests(name), known.get(name, {}))
        changed += [told] if told else []
        if told and ACTIVE in os.environ:
            break
    some = " ".join(line.partition(":")[0] for line in changed)
    assert not changed, "\n".join(
        [
            "these texts differ from those recorded in tests/generated/results.txt:",
            *changed,
            "show the differences:",
            f"  python -m tests.generated.results /tmp/now {some}",
            f"  python -m tests.generated.results /tmp/before {some} --commit HEAD",
            "  diff -r /tmp/before /tmp/now",
            "if all are intended: pytest tests/generated/test_results.py --update",
        ]
    )


def test_the_file_has_each_case_once_in_order() -> None:
    assert [line.split()[0] for line in DIGESTS.read_text(encoding="utf-8").splitlines()] == names()


def test_long_figures_are_rounded_and_short_ones_are_not() -> None:
    """0.1 + 0.2 becomes 0.3; 0.1234567895 is a half, and rounds like its neighbours."""
    assert rounded("0.30000000000000004 0.299999999999999999 x1.50") == "0.3 0.3 x1.50"
    assert rounded("0.1234567895") == rounded("0.12345678949999999") == "0.12345679"
    assert rounded("5.551115123125783e-17 2.5e-05 12000 1.0") == "0.0 2.5e-05 12000 1.0"


def test_a_case_that_differs_names_its_kinds_or_its_program() -> None:
    known = {"program": "a1", "report": "b2", "table": "c3"}
    assert differences("motion-1", dict(known), known) == ""
    assert differences("motion-1", known | {"table": "d4", "trace": "e5"}, known) == "motion-1: table, trace"
    assert differences("motion-1", known | {"program": "f6"}, known).startswith(
        "motion-1: the program itself"
    )


def test_a_damaged_program_differs_in_three_lines_at_most() -> None:
    lines = [f"SPEED({number % 4}) = {number}" for number in range(40)]
    for seed in range(50):
        left = damaged("\n".join(lines), "mint", seed).split("\n")
        assert 0 < len(set(lines) - set(left)) + max(len(left) - len(lines), 0) <= 3


def test_texts_are_written_into_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
    assert main([str(tmp_path / "now"), "motion-1", "commands-1"]) == 0
    written = {path.name for path in (tmp_path / "now").iterdir()}
    assert {"motion-1.program.txt", "motion-1.report.txt", "commands-1.output.txt"} <= written
    assert "exit status" in (tmp_path / "now" / "motion-1.report.txt").read_text()
