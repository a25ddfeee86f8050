"""`motionlang init` on small machines: the text of each machine file is in a `.txt` next to its program.

Each of them had a wrong world when `init` concluded from the text of a program.

* `stopline.mccl` homes first: the cycle is line 3, with input 2.
* `door.mccl` prints an alarm while the door is open: the cycle is "piece", with the door shut.
* `key.prg` compares the key less 48: the cycle begins with key 1.
* `once.mnt` has a change in a move of the way there, which comes at another time when the start is on from power-up.
* `comms.mnt` waits for an element of the comms array, which the host writes again in each cycle.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.kernel import dialect_of
from tests.cli.programs import Cell

FOLDER = Path(__file__).parent / "machines"
MACHINES = sorted(path for path in FOLDER.iterdir() if dialect_of(path.name) is not None)


@pytest.mark.parametrize(
    "path",
    [pytest.param(each, marks=pytest.mark.slow) if each.stem == "door" else each for each in MACHINES],
    ids=lambda path: path.name,
)
def test_the_machine_file(path: Path, cell: Cell, golden: Callable[[Path, str], None]) -> None:
    cell.write(path.name, path.read_bytes())
    ran = cell("init", path.name, "--format", "none")
    assert ran.status == 0
    machine = (cell.folder / f"{path.stem}.machine.toml").read_text(encoding="utf-8")
    golden(path.with_suffix(".txt"), f"{machine}\n{ran.out}{ran.err}")
    assert cell("run", path.name, "--format", "none").status == 0
    assert cell("verify", path.name).status == 0
