"""Random MCCL contours: each run reaches its end, and its proof passes.

A Mint program with the same paths takes the same time. `MOTIONLANG_LONG=2000` runs 2000 contours.
"""

from __future__ import annotations

import os
from random import Random

import pytest

from motionlang import Run
from motionlang.kernel import Source
from tests.cases import examples
from tests.proof import prove, run

SEEDS = range(int(os.environ.get("MOTIONLANG_LONG", examples(25))))
FINE = {"controller.instruction_time": 1e-9}


def proved(text: str, name: str) -> Run:
    result = run(Source(name, text), machine=FINE)
    assert result.diagnostics == [], text
    assert prove(result).violations == [], text
    return result


class Job:
    """A random contour of three to twelve lines and arcs, some tangent, with events."""

    def __init__(self, seed: int) -> None:
        self.choose = choose = Random(seed)
        self.shape = choose.choice(["PT", "PT", "PS", "PS0.3", "PP"])
        self.vector = [choose.randrange(2000, 40000), *(choose.randrange(20000, 400000) for _ in range(2))]
        self.paths: list[str] = []
        x = y = 0
        for _ in range(choose.randrange(3, 13)):
            kind = choose.choice(["on", "on", "line", "quarter", "helix"])
            if kind == "on" and self.paths:
                x += choose.randrange(1, 20) * 500
                self.paths.append(f"1CP1,1MA{x},2MA{y}")
            elif kind == "quarter":
                radius = choose.randrange(1, 20) * 250
                self.paths.append(f"1CP3,1CA{x},2CA{y + radius},1ER90")
                x, y = x + radius, y + radius
            elif kind == "helix":
                self.paths.append(
                    f"1CP2,1CR{choose.randrange(1, 9) * 500},2CR0,1MR0,2MR0,3MR{choose.randrange(-900, 900)}"
                )
            else:
                x, y = choose.randrange(-9000, 9000), choose.randrange(-9000, 9000)
                self.paths.append(f"1CP1,1MA{x},2MA{y}")
        self.end = x, y

    def text(self, events: bool) -> str:
        velocity, accel, decel = self.vector
        head = f"MN,1CM1,2CM1,3CM1,1{self.shape},1VV{velocity},1VA{accel},1VD{decel}"
        paths = list(self.paths)
        if events:
            for _ in range(self.choose.randrange(1, 4)):
                index = self.choose.randrange(1, len(paths) + 1)
                word = self.choose.choice(
                    ["1VO0.4", "1VO1.7", "1VO1", "1DH50", "2DH-70", "1SN", "1NS", "1ST,1WS"]
                )
                paths.insert(index, f"WA{self.choose.randrange(1, 900) / 1000},{word}")
        return "\n".join([head, *paths, "1SN,1NS,WA0.01,1WS,1TP,2TP"])


@pytest.mark.parametrize("seed", SEEDS)
def test_a_contour_is_proved_and_arrives(seed: int) -> None:
    job = Job(seed)
    run_through = proved(job.text(events=False), "job.mcl")
    assert run_through.output == [f"01 {job.end[0]}", f"02 {job.end[1]}"]
    proved(job.text(events=True), "job.mcl")


@pytest.mark.parametrize("seed", SEEDS)
def test_a_contour_of_mint_takes_the_same_time(seed: int) -> None:
    """Lines, some of them tangent: the planner is the same, the rule for joins is not."""
    choose = Random(seed)
    velocity, accel, decel = 20000, choose.randrange(50000, 400000), choose.randrange(50000, 400000)
    x = y = 0
    ends = []
    for _ in range(choose.randrange(3, 9)):
        if choose.random() < 0.6:
            x += choose.randrange(1, 9) * 500
        else:
            x, y = choose.randrange(-9000, 9000), choose.randrange(-9000, 9000)
        ends.append((x, y))
    mccl = [
        f"MN,1CM1,2CM1,1VV{velocity},1VA{accel},1VD{decel},1SN",
        *(f"1CP1,1MA{x},2MA{y}" for x, y in ends),
    ]
    mint = [
        f"SPEED(0) = {velocity} : ACCEL(0) = {accel} : DECEL(0) = {decel}",
        "MOVEBUFFERSIZE(0) = 10 : MOVEBUFFERSIZE(1) = 10 : CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 0.00005",
        *(f"VECTORA(0, 1) = {x}, {y}" for x, y in ends),
        "GO(0) : PAUSE IDLE(0)",
    ]
    times = []
    for lines, name in (([*mccl, "1GO,1WS"], "job.mcl"), (mint, "job.mnt")):
        moves = [move for move in proved("\n".join(lines), name).controller.log.moves if move.axis == 1]
        assert len(moves) == len(ends)
        times.append([move.profile.duration for move in moves])  # type: ignore[union-attr]
    assert times[0] == pytest.approx(times[1], rel=1e-12)
