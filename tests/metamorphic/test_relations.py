"""Metamorphic tests: programs whose motions must be related; each run is proved.

`MOTIONLANG_LONG=1000` runs that many random programs per relation.
"""

from __future__ import annotations

import os
import random

import pytest

from motionlang.kernel import Run
from tests.metamorphic.runs import grid, proved

SEEDS = range(int(os.environ.get("MOTIONLANG_LONG", "12")))


class Job:
    """A random job on one axis: settings, then moves with waits between them."""

    def __init__(self, seed: int) -> None:
        choose = random.Random(seed)
        self.s_ramp = choose.random() < 0.5
        self.speed, self.accel, self.decel = (round(choose.uniform(5, 200), 3) for _ in range(3))
        self.jerks = [round(choose.uniform(100, 5000), 3) for _ in range(2)]
        self.moves = [
            (round(choose.uniform(-300, 300), 3), choose.randrange(20, 2000))
            for _ in range(choose.randrange(1, 5))
        ]
        self.stops = choose.random() < 0.4

    def text(self, axis: int = 0, factor: float = 1.0, delay: int = 0, absolute: bool = False) -> str:
        lines = [f"SPEED({axis}) = {self.speed * abs(factor)!r}"]
        for word, value in (("ACCEL", self.accel), ("DECEL", self.decel)):
            lines.append(f"{word}({axis}) = {value * abs(factor)!r}")
        if self.s_ramp:
            lines.append(f"PROFILEMODE({axis}) = 1")
            for word, value in zip(("ACCELJERK", "DECELJERK"), self.jerks, strict=True):
                lines.append(f"{word}({axis}) = {value * abs(factor)!r}")
        lines.append(f"WAIT {delay}") if delay else None
        position = 0.0
        for distance, wait in self.moves:
            position += distance
            lines.append(
                f"MOVE{'A' if absolute else 'R'}({axis}) = {(position if absolute else distance) * factor!r}"
            )
            lines += [f"GO({axis})", f"PAUSE IDLE({axis})", f"WAIT {wait}"]
        if self.stops:
            lines += [f"MOVER({axis}) = {500.0 * factor!r}", f"GO({axis})", "WAIT 700", f"STOP({axis})"]
            lines.append(f"PAUSE IDLE({axis})")
        return "\n".join(lines) + "\n"


def positions(result: Run, axis: int, times: list[float]) -> list[float]:
    return [result.controller.axes[axis].position(time) for time in times]


@pytest.mark.parametrize("seed", SEEDS)
def test_the_mirrored_program_moves_the_mirrored_distance(seed: int) -> None:
    one, other = proved(Job(seed).text()), proved(Job(seed).text(factor=-1.0))
    assert other.time == one.time
    assert positions(other, 0, grid(one)) == [-position for position in positions(one, 0, grid(one))]


@pytest.mark.parametrize("seed", SEEDS)
def test_another_axis_does_the_same(seed: int) -> None:
    one, other = proved(Job(seed).text()), proved(Job(seed).text(axis=3))
    assert other.time == one.time
    assert positions(other, 3, grid(one)) == positions(one, 0, grid(one))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_power_of_two_scales_every_position_to_the_last_bit(seed: int) -> None:
    one, other = proved(Job(seed).text()), proved(Job(seed).text(factor=8.0))
    assert other.time == pytest.approx(one.time, rel=1e-12)
    assert positions(other, 0, grid(one)) == pytest.approx(
        [8.0 * p for p in positions(one, 0, grid(one))], abs=1e-6
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_what_begins_later_is_the_same_later(seed: int) -> None:
    one, other = proved(Job(seed).text(delay=1)), proved(Job(seed).text(delay=501))
    times = grid(one)
    assert other.time == pytest.approx(one.time + 0.5, abs=1e-9)
    assert positions(other, 0, [time + 0.5 for time in times]) == pytest.approx(
        positions(one, 0, times), abs=1e-5
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_a_run_that_is_cut_is_the_beginning_of_the_whole(seed: int) -> None:
    whole = proved(Job(seed).text())
    for share in (0.13, 0.5, 0.91):
        prefix = proved(Job(seed).text(), until=share * whole.time)
        times = [share * whole.time * k / 19 for k in range(20)]
        assert positions(prefix, 0, times) == positions(whole, 0, times)


@pytest.mark.parametrize("seed", SEEDS)
def test_relative_moves_and_absolute_ones_come_to_the_same(seed: int) -> None:
    one, other = proved(Job(seed).text()), proved(Job(seed).text(absolute=True))
    assert other.time == pytest.approx(one.time, abs=1e-9)
    assert positions(other, 0, grid(one)) == pytest.approx(positions(one, 0, grid(one)), abs=1e-6)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_skipped_loop_ends_like_one_that_runs_each_iteration(seed: int) -> None:
    text = Job(seed).text()
    polled = text.replace("PAUSE IDLE(0)", "WHILE NOT IDLE(0)\nENDWHILE")
    counted = text.replace("PAUSE IDLE(0)", "WHILE NOT IDLE(0)\nn = n + 1\nENDWHILE")
    runs = [proved("Dim n As Integer = 0\n" + each, fine=1e-3) for each in (polled, counted)]
    ends = [each.controller.axes[0].position(each.time) for each in runs]
    assert ends[1] == pytest.approx(ends[0], abs=1e-3 if Job(seed).stops else 1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_same_trapezoids_in_both_languages(seed: int) -> None:
    job = Job(seed)
    job.s_ramp = job.stops = False
    # Integers: a board of PMC moves in whole counts.
    job.speed, job.accel, job.decel = (float(round(x)) for x in (job.speed, job.accel, job.decel))
    job.moves = [(float(round(distance)), wait) for distance, wait in job.moves]
    mint = proved(job.text())
    lines = ["1MN,1PM,1PT", f"1SV{job.speed:.0f},1SA{job.accel:.0f},1DS{job.decel:.0f}"]
    lines += [f"1MR{distance:.0f},1WS0" for distance, _ in job.moves]
    mccl = proved("\n".join(lines) + "\n", "job.mcl")
    ours, theirs = mint.controller.log.moves, mccl.controller.log.moves
    assert [m.profile.duration for m in ours if m.profile] == pytest.approx(
        [m.profile.duration for m in theirs if m.profile], rel=1e-9
    )
    assert [m.target for m in ours] == pytest.approx([m.target for m in theirs], abs=1e-6)
