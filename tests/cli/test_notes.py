"""docs/tn1069.md and docs/an00115.md: all commands and formulas are correct."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cases import cases
from tests.cli.notes import PAGES, answer, numbers, worked_out
from tests.lab.copley.docs import blocks

COMMANDS = [
    pair for page in PAGES.values() for block in blocks(page.read_text(encoding="utf-8")) for pair in block
]
FORMULAS = [pair for page in PAGES.values() for pair in numbers(page.read_text(encoding="utf-8"))]


@pytest.mark.parametrize(("command", "shown"), COMMANDS, ids=[command[11:70] for command, _ in COMMANDS])
def test_a_command_prints_what_it_shows(
    command: str, shown: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert answer(command) == shown
    assert shown


@cases(("formula", "number"), FORMULAS)
def test_a_formula_gives_its_number(formula: str, number: str) -> None:
    """The tolerance is half a step of the last printed digit, plus rounding of inputs."""
    decimals = len(number.partition(".")[2])
    value = float(number)
    assert worked_out(formula) == pytest.approx(value, rel=2e-9, abs=0.51 * 10.0**-decimals)


def test_no_formula_is_passed_over() -> None:
    assert len(FORMULAS) == sum(
        line.startswith("|") and "`" in line
        for page in PAGES.values()
        for line in page.read_text(encoding="utf-8").splitlines()
    )
    assert (len(COMMANDS), len(FORMULAS)) == (11, 59)
