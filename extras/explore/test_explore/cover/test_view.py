"""The tables of `cover`."""

from __future__ import annotations

from motionlang_explore.cover.view import files_table
from tests.views.test_grid import order_of_dropped


def test_a_narrow_table_drops_the_least_important_column_first() -> None:
    assert order_of_dropped(files_table([])) == [
        "parts",
        "worlds",
        "statements",
        "outcomes",
        "lines to look at",
    ]
