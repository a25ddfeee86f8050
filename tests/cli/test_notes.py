"""The formulas of docs/tn1069.md and docs/an00115.md are correct; `tests/test_docs.py` runs the commands."""

from __future__ import annotations

import pytest

from tests.cases import cases
from tests.cli.notes import PAGES, numbers, worked_out

FORMULAS = [pair for page in PAGES.values() for pair in numbers(page.read_text(encoding="utf-8"))]


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
    assert len(FORMULAS) == 59
