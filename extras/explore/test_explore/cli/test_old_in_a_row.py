"""`init`, `cover --suggest` and `verify` in a row on the programs of examples/old."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.programs import Cell

OLD = Path(__file__).parents[4] / "examples" / "old"
# The text of glue.mnt needs a larger move buffer than the default.
DEADLOCKS = "glue.mnt"
# The programs are tested in so many tests.
PARTS = 4


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
def test_every_scenario_that_is_written_passes(part: int, cell: Cell) -> None:
    for path in sorted(OLD.iterdir())[part::PARTS]:
        cell.write(path.name, path.read_bytes())
        assert cell("init", path.name, "--format", "none").status == (path.name == DEADLOCKS), path.name
        assert cell("cover", path.name, "--suggest").status == 0, path.name
        assert cell("verify", path.name).status == 0, path.name
