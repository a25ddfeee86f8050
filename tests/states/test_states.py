"""The tables of motion commands and states hold what runs show."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.states.table import Table

FOLDER = Path(__file__).parent


@pytest.mark.parametrize("language", ["mint", "mccl"])
def test_each_command_does_in_each_state_what_the_table_says(
    language: str, pytestconfig: pytest.Config
) -> None:
    table = Table.read(FOLDER / f"{language}.txt")
    found = table.found()
    if pytestconfig.getoption("update"):
        table.path.write_text(table.text(found), encoding="utf-8")
        table = Table.read(table.path)
    assert {
        cell: (table.cells.get(cell), found[cell]) for cell in found if table.cells.get(cell) != found[cell]
    } == {}
