"""The tables of motion commands and states hold what runs show."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.states.table import Table

ROWS = [
    (path, command)
    for path in map(Path(__file__).with_name, ("mint.txt", "mccl.txt"))
    for command in Table.read(path).commands
]


@pytest.mark.parametrize(("path", "command"), ROWS, ids=[command for _, command in ROWS])
def test_a_command_does_in_each_state_what_the_table_says(
    path: Path, command: str, golden: Callable[[Path, str], None]
) -> None:
    table = Table.read(path)
    golden(path, table.text(table.cells | table.found(command)))
