"""Checks before a keyword's operation: the value is in range, and the axis exists."""

from __future__ import annotations

from math import nan
from typing import Any

import pytest

from motionlang.kernel import Keyword, Machine, Rejected
from motionlang.kernel.mint import table
from motionlang.kernel.mint.runtime import binding
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from tests.cases import cases

# Keywords that switch something: any number except 0 is on. TIME and POSROLLOVER take every Integer, which is
# their range.
ANY_NUMBER = {
    "DRIVEENABLE", "HOMESTATUS", "LATCHENABLE", "FASTENABLE", "FASTAUXENABLE", "COMPAREENABLE", "TIME", "POSROLLOVER",
}  # fmt: skip
# WAIT is no operation: the compiler makes it.
RANGED = [
    row
    for row in table().rows
    if row.simulated and row.kind == "setting" and "W" in row.access and row.verb != "wait"
    if row.high is not None or row.low is not None
]
OF_AXES = [
    row
    for row in table().rows
    if row.simulated and row.kind in ("setting", "reading") and row.index == "axis" and "R" in row.access
]


def bound(row: Keyword, how: str) -> tuple[Any, list[int]]:
    """Return the operation of a keyword on an idle machine, and its indices."""
    environment = Environment(Machine(), Places())
    environment.prepare()
    count = 0 if row.index == "none" else len(row.index.split(", "))
    return binding.bind(environment, how, row), [0] * count


def beyond(row: Keyword) -> list[float]:
    """Return values outside the range of a row."""
    found = [nan]
    found += [row.high + 1.0] if row.high is not None else []
    found += [row.low - 1.0] if row.low is not None else []
    return found


@cases("row", [row for row in RANGED if row.name not in ANY_NUMBER], ids=lambda row: row.name)
def test_a_value_outside_the_range_of_its_row_is_refused(row: Keyword) -> None:
    write, where = bound(row, "write")
    for value in beyond(row):
        with pytest.raises(Rejected, match=f"{row.name} cannot be ") as refused:
            write(*where, value)
        assert refused.value.code == "range"


def test_words_that_take_any_number_are_these() -> None:
    taking = {row.name for row in RANGED if hasattr(row.actions.write, "unchecked")}
    assert taking == ANY_NUMBER


@cases("row", OF_AXES, ids=lambda row: row.name)
def test_an_axis_that_there_is_not_is_refused(row: Keyword) -> None:
    read, _ = bound(row, "read")
    with pytest.raises(Rejected, match="there is no axis 99"):
        read(99)


def test_what_is_read_of_an_axis_is_made_once() -> None:
    made: list[int] = []

    def make(environment: Environment, row: Keyword, axis: int) -> Any:
        made.append(axis)
        return lambda: axis

    environment = Environment(Machine(), Places())
    read = binding.by_axis(make)(environment, Keyword("", "", "reading", "R", "axis", "integer", "", ""))
    assert [read(1), read(0), read(1)] == [1, 0, 1]
    assert made == [1, 0]
