"""Fourteen programs written for machines run after `init` and at most three edits.

The programs in examples/old are as machine builders wrote them. An edit changes one line of
the machine file that `init` writes. The duration of a cycle, or of the time between two printed lines, is
calculated here by hand, without the 10 µs that each statement takes and without the steps of a polling loop.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import motionlang
from motionlang.kernel import Run
from tests.cli.programs import Cell

OLD = Path(__file__).parents[4] / "examples" / "old"
PAGE = (Path(__file__).parents[2] / "docs" / "old-machine.md").read_text(encoding="utf-8")
MAX_EDITS = 3


def ramp(distance: float, speed: float, rate: float) -> float:
    """Return the duration of a trapezoidal or triangular move, s."""
    if distance * rate < speed * speed:
        return float(2 * (distance / rate) ** 0.5)
    return distance / speed + speed / rate


def packer() -> float:
    layer = ramp(250, 600, 5000) + ramp(250, 1000, 5000) + ramp(10, 300, 2000)
    stop, clamp, release = 0.3 + 0.15, 0.3, 0.3 + 0.4
    return stop + clamp + ramp(30, 300, 2000) + 3 * layer + release


def drill() -> float:
    down = [ramp(6, 8, 800), ramp(5, 8, 800), ramp(5, 8, 800)]
    clear = [ramp(6, 120, 800), ramp(5, 120, 800), ramp(10, 120, 800), ramp(9, 120, 800), ramp(14, 120, 800)]
    hole = ramp(18, 120, 800) + sum(down) + sum(clear) + ramp(18, 120, 800) + ramp(36, 90, 360)
    first = ramp(38, 120, 800) - ramp(18, 120, 800)
    return 0.3 + first + 10 * hole + ramp(20, 120, 800) + 0.3 + 0.5


def winder() -> float:
    spool = ramp(2, 1, 20) + ramp(198, 15, 20)
    layer = ramp(40, 7.5, 1000)
    there = (ramp(198, 15, 20) - 2 * layer) * 7.5  # the third layer is not full when the spool is
    return spool + 0.2 + 0.25 + ramp(there, 100, 1000)


def glue() -> float:
    bead = 2 * 160 + 2 * 60 + 2 * 3.14159265 * 20
    travel = ramp((50**2 + 30**2) ** 0.5, 250, 2500)
    z = ramp(42.5, 100, 1000)
    return travel + z + 0.08 + ramp(bead, 50, 2500) + 0.15 + ramp(8, 250, 2500) + z


def label() -> float:
    """Return the time of a label whose gap comes in the middle of the longest feed, s."""
    to_gap = 1.5 * 62 / 2 / 300 + 300 / 4000 / 2
    stop, length = 300 / 4000, 300**2 / 4000 / 2
    return 10 / 400 + to_gap + stop + ramp(15 - length, 300, 4000)


def pick_and_place() -> float:
    x = ramp(900e3, 400e3, 2e6) + 0.05 + ramp(100e3, 400e3, 2e6) + ramp(800e3, 400e3, 2e6) + 0.05
    z = 2 * (ramp(120e3, 150e3, 1e6) + 0.02) + 2 * (ramp(95e3, 150e3, 1e6) + 0.02)
    return x + z + 0.15 + 0.1 + 0.1


def table() -> float:
    index_time = ramp(2000, 4000, 8000) + 0.1  # the pin is always where it should be
    press = 2 * (ramp(40e3, 60e3, 400e3) + 0.02) + 0.35
    return index_time + press + 0.2 + 0.1


def saw_feed() -> float:
    """Return the duration of the third order, which has six pieces, s."""
    saw = ramp(30e3, 6e3, 200e3) + ramp(30e3, 40e3, 200e3)
    piece = 4 * 0.3 + 2 * (ramp(12_500, 100e3, 300e3) + 0.05) + saw
    return 6 * piece + 0.5


def bag_welder() -> float:
    return ramp(250, 500, 2500) + 2 * ramp(35, 200, 2000) + 0.5 + 0.08


def coiler() -> float:
    return ramp(1, 1, 8) + ramp(15, 4, 8) + 0.3


def rotary() -> float:
    return ramp(2000, 8000, 16000) + 0.05 + 0.2


def palletiser() -> float:
    """Return the duration of the tenth bag, the fourth of the second layer, s."""
    fetch = ramp(1300, 1000, 2500) + 2 * ramp(500, 400, 2000)
    return fetch + ramp(700, 800, 2500) + 2 * ramp(490, 400, 2000) + 0.25


def press_feed() -> float:
    return ramp(10, 900, 8000) + 0.3 + 0.06


def dispenser() -> float:
    turn = 0.3 + ramp(1000, 4000, 8000) + 0.05 + 0.4
    needle = 2 * (ramp(42e3, 60e3, 400e3) + 0.02)
    shot = ramp(1000, 800, 4000) + 0.05 + 0.15 + 2 * ramp(200, 800, 4000)
    return turn + needle + shot


ASSUMPTIONS = 'assumptions."mint.movebuffersize-default" = 20\n'
# Program: the edits, how its cycle is found in what it prints, and how long it takes.
CASES = {
    "packer.prg": ([], "ms", packer()),
    "drill.prg": ([], "ms", drill()),
    "winder.mnt": (
        [
            ('{ prompt = "Turns", text = "10"', '{ prompt = "Turns", text = "200"'),
            ('{ prompt = "Wire dia mm", text = "10"', '{ prompt = "Wire dia mm", text = "0.5"'),
            ('{ prompt = "Bobbin width mm", text = "10"', '{ prompt = "Bobbin width mm", text = "40"'),
        ],
        "ms",
        winder(),
    ),
    "glue.mnt": (
        [
            ("run.until = 300", f"{ASSUMPTIONS}run.until = 300"),
            (
                "{ channel = 0, at = 0.0, guess = true }",
                "{ channel = 0, at = 3.0, for = 40.0, every = 45.0 }",
            ),
        ],
        "ms",
        glue(),
    ),
    "label.prg": ([], "ms", label()),
    "pickplace.mccl": ([], "part", pick_and_place()),
    "table.mccl": ([], "cycle", table()),
    "sawfeed.mccl": ([], "order", saw_feed()),
    "bagwelder.prg": ([], "MS", bag_welder()),
    "coiler.prg": ([], "MS", coiler()),
    "rotary.mccl": ([], "nest", rotary()),
    "palletiser.prg": ([], "MS", palletiser()),
    "pressfeed.mnt": ([], "ms", press_feed()),
    "dispenser.mccl": ([], "part", dispenser()),
}


# `init` finds the world of each of these in less than a second; both languages and edits are among them.
QUICK = ("bagwelder.prg", "coiler.prg", "rotary.mccl")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in QUICK else pytest.mark.slow) for name in CASES]
)
def test_it_runs_from_nothing(cell: Cell, name: str) -> None:
    edits, found, seconds = CASES[name]
    program = cell.write(name, (OLD / name).read_bytes())
    assert cell("init", name, "--format", "none").out.startswith(f"{program.stem}.machine.toml: written, ")
    machine = program.with_suffix(".machine.toml")
    text = machine.read_text(encoding="utf-8")
    assert len(edits) <= MAX_EDITS
    for old, new in edits:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    machine.write_text(text, encoding="utf-8")
    assert "error[" not in cell("check", name).err
    run = motionlang.run(str(program))
    assert [each.code for each in run.diagnostics] == ["guess"]
    assert cycle(run, found) == pytest.approx(seconds, abs=0.01)
    assert f"| `{name}` | {len(edits)} | " in PAGE


def cycle(run: Run, found: str) -> float:
    """Return the duration of one cycle of a production loop, s.

    If `found` is "ms" or "MS" it is the last number that is printed with this unit, otherwise the time between the
    last two printed lines that begin with `found`.
    """
    printed = [*run.machine.log.prints, *(p for each in run.machine.terminals.values() for p in each.prints)]
    if found in ("ms", "MS"):
        texts = [each.text for each in printed]
        text = next((each for each in reversed(texts) if each.endswith(f" {found}")), texts[-1])
        return float(text.removesuffix(f" {found}").split()[-1]) / 1000
    lines = [each.time for each in printed if each.text.startswith(found)]
    return float(lines[-1] - lines[-2])


def test_there_are_fourteen_in_both_languages() -> None:
    names = sorted(path.name for path in OLD.iterdir())
    assert names == sorted(CASES)
    assert sum(name.endswith(".mccl") for name in names) == 5
