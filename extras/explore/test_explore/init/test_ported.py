"""Old programs that `check --fix` ports, in the worlds that `init` finds for them."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import Source, dialect_of
from test_explore.worlds import world_of
from tests.cli.programs import Cell
from tests.commands.check.test_fix import assert_port_is_the_same, of_v4

OLD = Path(__file__).parents[4] / "examples" / "old"
# Old machines whose world takes `init` more than half a second; others of them are always tested.
SLOW = ("label", "palletiser", "drill", "packer")


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, id=path.stem, marks=pytest.mark.slow if path.stem in SLOW else ())
        for path in of_v4(OLD)
    ],
)
def test_a_ported_program_does_the_same(path: Path, cell: Cell) -> None:
    language = dialect_of(path.name)
    assert language is not None
    assert_port_is_the_same(path, world_of(Source.read(path), language), cell)
