"""Trials that go on from a snapshot do what a run from power-up does."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Source, dialect
from motionlang_explore.exploration.changes import Change, Timeline
from motionlang_explore.exploration.trials import Trial, Trials

PROGRAM = """\
Auto
Dim k As Integer
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
Loop
  k = READKEY
  If INX(1) Then MOVER(0) = 10 : GO(0) : Pause IDLE(0) : Print "moved "; COMMS(5)
  If ADC(0) > 30 Then OUTX(2) = 1 Else OUTX(2) = 0
  If k = 65 Then Print "key"
  Wait(20)
End Loop
"""
BEFORE: Timeline = ((0.4, Change("input", 1, 1.0)), (1.1, Change("input", 1, 0.0)))
CHANGES = [
    Change("input", 1, 1.0),
    Change("analogue", 0, 50.0),
    Change("comms", 5, 7.0),
    Change("key", 0, "A"),
]


def done(trial: Trial, since: float) -> list[object]:
    """Return what a trial did from a time on."""
    moves = [(each.line, each.words) for each in trial.moves if each.begin >= since]
    outputs = [
        (round(each.time, 6), each.channel, each.value) for each in trial.outputs if each.time >= since
    ]
    return [moves, outputs, [(round(each.time, 6), each.text) for each in trial.prints], trial.status]


@pytest.mark.parametrize("number", range(len(CHANGES) + 1))
def test_a_trial_does_the_same_from_a_snapshot(number: int) -> None:
    """Several trials start from the one that comes first, also after another one has been played."""
    language = dialect("mint")
    program = language.program(Source("trial.mnt", PROGRAM), is_debug=True)
    trials = Trials(program, {}, 100)
    changes = CHANGES[:number]
    timeline = (*BEFORE, *((2.0, each) for each in changes))
    trials.play((*BEFORE, (2.0, Change("input", 1, 1.0))), 2.0)
    first = trials.play(timeline, 2.0)
    known = done(first, 2.0)
    assert done(trials.play(timeline, 0.0), 2.0) == known
    assert done(first, 2.0) == known


def test_a_later_start_is_reached_from_an_earlier_one() -> None:
    program = dialect("mint").program(Source("trial.mnt", PROGRAM), is_debug=True)
    trials = Trials(program, {}, 100)
    on, off = Change("input", 1, 1.0), Change("input", 1, 0.0)
    timeline: Timeline = ((1.0, on), (1.5, off), (3.0, on), (3.5, off))
    for count in range(1, len(timeline)):
        trials.play(timeline[:count], timeline[count - 1][0])
    later = trials.play(timeline, 3.5)
    assert done(later, 3.5) == done(trials.play(timeline, 0.0), 3.5)
    assert all(each.end < inf for each in later.moves)


def test_a_run_in_a_world_goes_on_to_the_last_time_unless_it_stands() -> None:
    program = dialect("mint").program(Source("trial.mnt", PROGRAM), is_debug=True)
    trials = Trials(program, {}, 100)
    world = {"input": [{"channel": 1, "at": 0.4}]}
    whole, *_ = trials.run_in(world, 30.0)
    for stands, until in ((True, 10.0), (False, 30.0)):
        run, begun, read = trials.run_in(
            world, 10.0, 30.0, stands=[lambda run: False, lambda run: True][stands]
        )
        known = [(each.start_time, each.line) for each in whole.machine.log.moves if each.start_time <= until]
        assert (run.time, [(each.start_time, each.line) for each in run.machine.log.moves]) == (until, known)
        assert read["input", 1][-1].last > until - 1.0
        assert begun
