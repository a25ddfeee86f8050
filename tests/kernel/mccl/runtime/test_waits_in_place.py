"""A single task waits without yielding to the scheduler, with no other difference."""

from __future__ import annotations

from random import Random

import pytest

from motionlang import run
from motionlang.kernel import Run, Scheduler, Source
from motionlang.kernel.report import text as report_text
from tests.cases import cases, examples


def all_of(result: Run) -> list[object]:
    """Return the complete result of a run."""
    c, log = result.controller, result.machine.log
    tracks = [
        (start, profile.shape, profile.start, profile.end, profile.duration, profile.knots, profile.pieces)
        for a in c.axes.values()
        for start, profile in zip(a.starts, a.profiles, strict=True)
    ]
    streams = (log.waits, log.slices, log.events, log.settings, log.prints, log.outputs, log.inputs)
    moves = [
        (
            m.axis,
            m.command,
            m.line,
            m.target,
            m.commanded_speed,
            m.base,
            m.id,
            m.speed,
            m.released,
            m.start_time,
            m.ended,
        )
        for stream in (log.moves, log.dropped)
        for m in stream
    ]
    rest = [(a.target, a.last_id, a.datum, a.move is None, len(a.buffer)) for a in c.axes.values()]
    return [
        report_text(result),
        c.clock.fired,
        c.clock.now,
        tracks,
        [list(each) for each in streams],
        moves,
        rest,
    ]


def commands(seed: int) -> str:
    """Return an MCCL program whose moves are read, changed and stopped at any time."""
    random = Random(seed)
    lines = ["1MN,2MN", "0SV2000,0SA9000,0DS7000", "MD1,{k}WS,{k}TP".format(k=random.randint(1, 2))]
    for _ in range(random.randint(8, 25)):
        k, far, near = random.randint(1, 2), random.randint(-900, 900), random.randint(1, 90)
        lines.append(
            random.choice(
                (
                    f"{k}MR{far}",
                    f"{k}MA{far}",
                    f"{k}MR{near},{k}WS",
                    f"{k}MA{far},{k}WS0.{near:02d}",
                    f"{k}MR{far},WA0.{near:02d},{k}TP,{k}TT",
                    f"{k}MR{far},{k}WR{far // 2},{k}TV",
                    f"{k}MR{far},WA0.05,{k}ST,{k}WS",
                    f"{k}MR{far},{k}WT",
                    f"{k}MR{far},MC1",
                    f"{k}SV{10 * near},{k}MR{near},{k}WS",
                    "0WS",
                    f"{k}MR0,{k}WS",
                    f"{k}MR{near},{k}WS,RP2",
                )
            )
        )
    return "\n".join(lines) + "\n"


@cases("seed", range(examples(30)))
def test_waits_within_a_time_slice_make_no_difference(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    source = Source("a.mcl", commands(seed))
    in_place = run(source, until=9.0)
    monkeypatch.setattr(Scheduler, "passes", lambda *_: False)
    monkeypatch.setattr(Scheduler, "comes_to_rest", lambda *_: False)
    assert all_of(in_place) == all_of(run(source, until=9.0))


def test_a_wait_yields_to_another_task() -> None:
    """Task 3 reports the position every second while the parent waits for a move.

    300 at 100 with 1000 takes 3.1 s. The ramp of 0.1 s puts the axis 5 behind 100 times the time.
    """
    text = "1MN,1SV100,1SA1000,1DS1000\nMD3,1TP,WA1,RP\nGT3\n1MR300,1WS,CN33,WA0.5\n"
    result = run(Source("a.mcl", text), until=20.0)
    assert [float(line.split()[-1]) for line in result.output[:4]] == [0.0, 95.0, 195.0, 295.0]
    assert result.machine.log.outputs[0].time == pytest.approx(3.1, abs=1e-3)
