"""The texts and properties that follow from the row of a keyword."""

from __future__ import annotations

from motionlang.kernel import Keyword
from tests.cases import cases


def row(**given: object) -> Keyword:
    unit = str(given.pop("unit", "uu"))
    return Keyword("A", "", "setting", "RW", "axis", unit, "a", "help", **given)  # type: ignore[arg-type]


@cases(
    "low, high, below, text",
    [
        (0.0, 8388607.0, False, "0 to 8388607"),
        (-1.5, 2.5, False, "-1.5 to 2.5"),
        (0.0, 1.0, True, "0 to below 1"),
        (0.0, None, False, "0 or more"),
        (None, 100.0, False, "100 or less"),
        (None, None, False, ""),
        (1e-9, 12345678901.0, False, "1e-09 to 1.23456789e+10"),
    ],
)
def test_the_accepted_range(low: float | None, high: float | None, below: bool, text: str) -> None:
    assert row(low=low, high=high, below=below).accepted == text


@cases(
    "unit, whole, fractions",
    [("uu", False, True), ("bool", True, False), ("ms", True, True), ("bits", True, False)],
)
def test_units_of_integers(unit: str, whole: bool, fractions: bool) -> None:
    """A time in ms reads as an integer, and a written one keeps its fraction."""
    found = row(unit=unit)
    assert (found.is_whole, found.takes_fractions) == (whole, fractions)


def test_the_effect_is_words() -> None:
    """One of them may be the role of the keyword."""
    found = row(effect="stop abrupt")
    assert (found.does("stop"), found.does("abrupt"), found.does("sto")) == (True, True, False)
    assert (found.role, row().role, row(effect="all go").role) == ("stop", "", "go")
