"""The texts and properties that follow from the row of a keyword."""

from __future__ import annotations

from motionlang.kernel import Keyword
from motionlang.kernel.lang.keyword import ROLES, TRAITS, value
from motionlang.kernel.mccl import MODELS
from motionlang.kernel.mccl import table as mccl_table
from motionlang.kernel.mint import table as mint_table
from motionlang.kernel.mint.models import ABSENT, LARGEST, STRINGS
from motionlang.kernel.servo import gains
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


def test_a_value_that_can_only_be_read_is_a_reading() -> None:
    kinds = [
        value("A", "", access, "axis", "uu", None, "", "").kind  # type: ignore[arg-type]
        for access in ("R", "RW", "W")
    ]
    assert kinds == ["reading", "setting", "setting"]


def test_columns_of_rows_have_known_words() -> None:
    for each in (*mint_table(), *mccl_table()):
        effects = each.effect.split()
        assert set(effects) <= ROLES.keys() | TRAITS.keys(), each.name
        assert len(ROLES.keys() & set(effects)) <= 1, each.name
        assert not (each.role and each.gives), each.name
        assert each.tunes in {"", *gains.MINT, *gains.MCCL}, each.name
        assert each.changes in ("", "motion", "always"), each.name


def test_families_of_rows_are_those_that_a_model_lacks_or_limits() -> None:
    families = {each.family for each in mccl_table()} - {""}
    assert {family for model in MODELS.values() for family in model.lacks} == families
    assert {each.family for each in mint_table()} - {""} == ABSENT.keys() | LARGEST.keys() | {STRINGS}
