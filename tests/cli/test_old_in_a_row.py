"""`init`, `cover --suggest` and `verify` in a row on the programs of examples/old."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.programs import Cell

OLD = Path(__file__).parents[2] / "examples" / "old"
# The text of glue.mnt needs a larger move buffer than the default.
DEADLOCKS = "glue.mnt"


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(OLD.iterdir()), ids=lambda path: path.name)
def test_every_scenario_that_is_written_passes(path: Path, cell: Cell) -> None:
    cell.write(path.name, path.read_bytes())
    assert cell("init", path.name, "--format", "none").status == (path.name == DEADLOCKS)
    assert cell("cover", path.name, "--suggest").status == 0
    assert cell("verify", path.name).status == 0
