"""The tables of motion commands and states hold what runs show."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.states.table import Table

TABLES = [Table.read(Path(__file__).with_name(name)) for name in ("mint.txt", "mccl.txt")]
ROWS = [(table, command) for table in TABLES for command in table.commands]


@pytest.mark.parametrize(("table", "command"), ROWS, ids=[command for _, command in ROWS])
def test_a_command_does_in_each_state_what_the_table_says(
    table: Table, command: str, pytestconfig: pytest.Config
) -> None:
    found = table.found(command)
    if pytestconfig.getoption("update"):
        table.cells |= found
        table.path.write_text(table.text(table.cells), encoding="utf-8")
    assert {cell: table.cells.get(cell) for cell in found} == found
