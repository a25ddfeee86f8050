"""A replay skips rest that repeats itself, and keeps each block of motion."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.kernel.planners import hold, plan_trapezoid
from motionlang.kernel.servo import Loop, Motor, Servo, Track
from motionlang.kernel.servo.replay import BLOCK, apply, chunks, replay, rests_until, run_to
from motionlang.kernel.servo.servo import sample_at

# 4096 samples a second: a block takes 2 s.
LOOP = Loop(proportional=0.01, derivative=0.1, servo_rate=4096.0, trajectory_rate=1024.0)
AT_REST = Track([0.0], [hold(0.0)])
# 10 counts from 0 s to 1 s.
MOVING = Track([0.0, 1.0], [plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0), hold(10.0)])


@pytest.mark.slow
def test_rest_up_to_a_later_motion_is_skipped() -> None:
    """Behind the rest of 100 s, the samples are those of a run without the skip."""
    later = Track([0.0, 100.0], [hold(0.0), plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0)])
    servo, twin = Servo(LOOP, Motor(), later), Servo(LOOP, Motor(), later)
    *_, last = chunks(servo, 411_000)
    twin.advance(411_000 / 4096.0)
    assert servo.state == twin.state
    assert last.error[-1] == twin.error > 0.0


@pytest.mark.parametrize(
    ("samples", "blocks"),
    [
        (1, [1]),
        (BLOCK, [BLOCK]),
        (BLOCK + 5, [BLOCK, 5]),
        (3 * BLOCK, [BLOCK] * 3),
        (3 * BLOCK + 1, [BLOCK] * 2),
        (99 * BLOCK, [BLOCK] * 2),
    ],
)
def test_rest_of_more_than_a_block_is_skipped(samples: int, blocks: list[int]) -> None:
    """The axis has to rest since before the block, so the first block is too early."""
    servo = Servo(LOOP, Motor(), AT_REST)
    assert [len(block.error) for block in chunks(servo, samples - 1)] == blocks
    assert servo.sample == samples


def test_motion_is_not_skipped() -> None:
    servo = Servo(LOOP, Motor(), MOVING)
    assert len(list(chunks(servo, 2 * BLOCK + 1))) == 3


def test_a_run_to_a_sample_has_its_last_block() -> None:
    servo = Servo(LOOP, Motor(), MOVING)
    last = run_to(servo, BLOCK + 4)
    assert last is not None
    assert len(last.error) == 5
    assert run_to(servo, BLOCK + 4) is None


# The starts and shapes of a track, how many samples have passed, and until which sample the rest matters and lasts. A
# block of 64 samples takes 2 s, and a trajectory point 0.125 s; so the rest has to begin 2.125 s earlier.
RESTS: dict[str, tuple[list[tuple[float, str]], int, int, int]] = {
    "always": ([(0.0, "hold")], 96, 999, 999),
    "not yet for a block": ([(1.0, "hold")], 96, 999, 95),
    "just since a block and a point": ([(0.0, "jog"), (0.875, "hold")], 96, 999, 999),
    "since a little later": ([(0.0, "jog"), (0.876, "hold")], 96, 999, 95),
    "in motion": ([(0.0, "jog")], 96, 999, 95),
    "before a later motion": ([(0.0, "hold"), (5.0, "jog")], 96, 159, 159),
    "up to the motion": ([(0.0, "hold"), (5.0, "jog")], 96, 160, 159),
    "up to a motion between samples": ([(0.0, "hold"), (5.01, "jog")], 96, 999, 160),
}  # fmt: skip


@pytest.mark.parametrize("name", RESTS)
def test_a_command_rests_before_and_after(name: str) -> None:
    entries, sample, until, rests = RESTS[name]
    starts = [start for start, _ in entries]
    servo: Any = SimpleNamespace(
        sample=sample,
        loop=SimpleNamespace(servo_rate=32.0, trajectory_rate=8.0),
        track=SimpleNamespace(starts=starts, profiles=[SimpleNamespace(shape=each) for _, each in entries]),
        in_force_at=lambda time: max([k for k, start in enumerate(starts) if start <= time], default=0),
    )
    assert rests_until(servo, 64, until) == rests


@pytest.mark.parametrize(
    ("time", "sample"), [(0.0, 0), (0.99, 9), (1.0, 10), (1.0 - 5e-8, 10), (1.0 - 2e-7, 9)]
)
def test_the_last_sample_up_to_a_time(time: float, sample: int) -> None:
    """At 10 samples/s; a millionth of a sample is rounding."""
    assert sample_at(time, 10.0) == sample


def test_a_replay_applies_each_change_at_its_time() -> None:
    """The loop is opened at 0.5 s, closed at 1 s and retuned at 1.5 s.

    A change after the run has no effect.
    """
    stiff = Loop(proportional=0.02, derivative=0.1, servo_rate=4096.0, trajectory_rate=1024.0)
    changes: list[tuple[float, Loop | float | int]] = [(0.5, 1.5), (1.0, 0), (1.5, stiff), (9.0, 2.5)]
    found = list(replay(Servo(LOOP, Motor(), AT_REST), changes, 2.0))
    assert [time for time, _ in found] == [0.0, 2049.0 / 4096.0, 4097.0 / 4096.0, 6145.0 / 4096.0]
    assert [len(block.error) for _, block in found] == [2049, 2048, 2048, 2048]
    assert set(found[1][1].output) == {1.5}
    assert set(found[0][1].output) == {0.0}


def test_a_change_is_a_voltage_a_profile_or_a_loop() -> None:
    servo = Servo(LOOP, Motor(), AT_REST)
    apply(servo, (0.0, 2.0))
    assert servo._open_output == 2.0
    apply(servo, (0.0, 0))
    assert servo._open_output is None
    stiff = Loop(proportional=0.02, servo_rate=4096.0, trajectory_rate=1024.0)
    apply(servo, (0.0, stiff))
    assert servo.loop is stiff
