"""No command writes over a file that it reads, or writes two results into one file."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell
from tests.cli.test_written_files import OTHER, TWICE, USED, assert_nothing_is_written


@pytest.mark.parametrize(
    ("command", "why"),
    [
        ("init a.mnt -o a.machine.toml", USED),
        ("improve a.mnt --patch a.mnt", USED),
        ("cover a.mnt --html c.html --lcov c.html", TWICE),
        ("init a.mnt -o new.toml", OTHER),
    ],
)
def test_a_file_that_is_in_use_is_not_written(command: str, why: str, cell: Cell) -> None:
    assert_nothing_is_written(command, why, cell)
