"""The divergence of two runs agrees with positions at many times, and with figures by hand."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from motionlang import run
from tests.cli.programs import Cell

SCRIPTS = Path(__file__).parents[3] / "scripts"
# The changes of a program; motion of the cam, the contour and the shear is in formulas in addition to pieces.
CHANGES = {
    "palletiser": ("= 600, 600, 300", "= 600, 500, 300"),
    "pick-and-place": ("= 800, 500", "= 700, 500"),
    "cam-lift": ("= 180", "= 190"),
    "contour-glue": ("= 2000", "= 1500"),
    "flying-shear": ("= 200", "= 210"),
}
WAITING = (
    "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nWAIT(100)\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n"
)


def divergence(cell: Cell, *options: str) -> tuple[int, float, float, float]:
    """Return axis, time, and the largest difference of position with its time."""
    ran = cell("diff", "old.mnt", "new.mnt", "--format", "json", *options)
    (found,) = json.loads(ran.out)["positions"]
    return found["axis"], found["time"], found["max_difference"], found["max_difference_at"]


@pytest.mark.parametrize("name", CHANGES)
def test_it_is_what_looking_everywhere_finds(name: str, cell: Cell) -> None:
    text, (was, is_) = (SCRIPTS / "mint" / f"{name}.mnt").read_text(encoding="utf-8"), CHANGES[name]
    assert was in text
    machine = SCRIPTS / "mint" / f"{name}.machine.toml"
    for file, program in (("old", text), ("new", text.replace(was, is_))):
        cell.write(f"{file}.mnt", program)
        if machine.exists():
            cell.write(f"{file}.machine.toml", machine.read_text(encoding="utf-8"))
    runs = [run(str(cell.folder / f"{each}.mnt"), until=20.0) for each in ("old", "new")]
    until = ["--until", "20"] * ("--until" in cell("diff", "--help").out)
    axis, first, largest, at = divergence(cell, *until)
    times = np.linspace(0.0, min(each.time for each in runs), 20_001)
    old, new = (each.trace.at(axis, "position", times) for each in runs)
    apart = np.abs(old - new)
    assert apart[times < first - 1e-9].max(initial=0.0) <= 1e-6
    assert apart.max() <= largest + 1e-6
    here = [float(each.trace.at(axis, "position", np.array([at]))[0]) for each in runs]
    assert abs(here[0] - here[1]) == pytest.approx(largest, abs=1e-4)


def test_the_divergence_of_a_later_start_by_hand(cell: Cell) -> None:
    """The positions are 0.5 uu apart sqrt(2 * 0.5 / 1000) s after the first start.

    That is 0.031623 s at 1000 uu/s², and the first start is at 0.1 s. The later start is 0.1 s behind, so 10 uu at
    100 uu/s: from 0.3 s, when the second axis has its speed, to 1.1 s, when the first one slows down.
    """
    cell.write("old.mnt", WAITING)
    cell.write("new.mnt", WAITING.replace("100)\nM", "200)\nM"))
    axis, first, largest, at = divergence(cell, "--tolerance", "position=0.5uu")
    assert axis == 0
    assert first == pytest.approx(0.131623, abs=1e-4)
    assert largest == pytest.approx(10.0, abs=1e-3)
    assert 0.3 <= at <= 1.1
    ran = cell("diff", "old.mnt", "new.mnt", "--format", "json", "--tolerance", "position=10.1uu")
    assert json.loads(ran.out)["positions"] == []
