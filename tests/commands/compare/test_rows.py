"""Rows of a recording that can be compared: those with times that increase."""

from __future__ import annotations

from math import nan

import numpy as np
import pytest

from motionlang.commands.compare.recording import Table, seconds, usable_rows


@pytest.mark.parametrize(
    ("times", "rows", "message", "line"),
    [
        ([0.0, 1.0, 2.0], [0, 1, 2], "", 0),
        ([0.0, nan, 2.0], [0, 2], "", 0),
        ([0.0, 1.0, 1.0, 2.0], [0, 2, 3], "", 0),  # of two at one time the last one
        ([1.0, 1.0], [1], "", 0),
        ([0.0, 1.0, 2.0, 0.5, 0.6], [0, 1, 2], "time runs backwards 1 time", 13),
        ([0.0, 1.0, 0.5, 0.6, 0.7], [2, 3, 4], "time runs backwards 1 time", 12),
        ([0.0, nan, 1.0, 0.5, 0.6, 0.7, 0.2], [3, 4, 5], "time runs backwards 2 times", 13),
        ([0.0, 1.0, 2.0, 2.0, 0.5, 3.0, 4.0], [0, 1, 3], "time runs backwards 1 time", 14),
    ],
)
def test_the_longest_stretch_of_increasing_times(
    times: list[float], rows: list[int], message: str, line: int
) -> None:
    """The first row is line 10 of the file."""
    table = Table({}, {}, np.arange(10, 10 + len(times)), [], {})
    found, remarks = usable_rows(np.array(times), table)
    assert found.tolist() == rows
    assert [(each.message, each.line) for each in remarks] == ([(message, line)] if message else [])
    if remarks:
        assert (remarks[0].hint or "").endswith(f"lines {rows[0] + 10} to {rows[-1] + 10}")


@pytest.mark.parametrize(
    ("unit", "factor", "expected"),
    [("ms", None, 0.004), ("", None, 4.0), ("S", None, 4.0), ("ms", 0.5, 2.0), ("furlong", None, 4.0)],
)
def test_times_of_a_column_in_seconds(unit: str, factor: float | None, expected: float) -> None:
    units = {"t": unit} if unit else {}
    table = Table({"t": np.array([0.0, 4.0])}, units, np.arange(2), [], {})
    assert seconds(table, "t", factor).tolist() == pytest.approx([0.0, expected])
