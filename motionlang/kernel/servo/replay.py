"""Changes to a servo during a run, and its replay for reports and pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil

from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.servo import Servo, sample_at
from motionlang.kernel.servo.standstill import extent, is_still
from motionlang.kernel.servo.trace import ServoTrace, joined

# Time and change: another loop, an open loop with a voltage, or a closed one with the index of the
# profile in force.
Change = tuple[float, Loop | float | int]

# Samples that are run at once.
BLOCK = 1 << 13


def apply(servo: Servo, change: Change) -> None:
    """Apply a recorded change to a servo that has run up to the change."""
    what = change[1]
    if isinstance(what, float):
        servo.open(what)
    elif isinstance(what, int):
        servo.close(what)
    else:
        servo.retune(what)


def run_to(servo: Servo, sample: int) -> ServoTrace | None:
    """Run to `sample` (inclusive) and return the last block; rest in which nothing moves is skipped."""
    last = None
    for chunk in chunks(servo, sample):
        last = chunk
    return last


def chunks(servo: Servo, sample: int) -> Iterator[ServoTrace]:
    """Run to `sample` (inclusive) and yield each block; skip rest in which nothing moves.

    Only the first block of such a rest is yielded.
    """
    while servo.sample <= sample:
        before = servo.state
        block = servo.run(min(sample + 1 - servo.sample, BLOCK))
        yield block
        rest = rests_until(servo, len(block), sample) + 1 - servo.sample
        if rest > BLOCK and is_still(extent(block.encoder, block.output), before, servo.state):
            servo.skip(rest)


def rests_until(servo: Servo, count: int, until: int) -> int:
    """Return the last sample, up to `until`, of a rest of the command that has lasted for `count` samples.

    If the command does not rest, it is the last sample that was run.
    """
    starts, rate = servo.track.starts, servo.loop.servo_rate
    since = (servo.sample - count) / rate - 1.0 / servo.loop.trajectory_rate
    k = servo.in_force_at(since)
    if starts[k] > since or servo.track.profiles[k].shape != "hold":
        return servo.sample - 1
    return until if k + 1 == len(starts) else min(until, ceil(starts[k + 1] * rate - 1e-6) - 1)


def replay(servo: Servo, changes: Sequence[Change], until: float) -> Iterator[tuple[float, ServoTrace]]:
    """Run a servo with these changes to `until`, and yield consecutive traces.

    Each has the time of its first sample.
    """
    loop = servo.loop
    for change in (*changes, None):
        end = until if change is None else min(change[0], until)
        first = servo.sample
        for chunk in chunks(servo, sample_at(end, loop.servo_rate)):
            yield first * loop.period, chunk
            first = servo.sample
        if change is not None:
            apply(servo, change)


def whole(servo: Servo, changes: Sequence[Change], until: float) -> ServoTrace:
    """Run a servo with these changes to `until`, and return one trace, in which skipped rest is filled in."""
    rate, traces = servo.loop.servo_rate, []
    for change in changes:
        if change[0] <= until:
            traces.append(servo.run(sample_at(change[0], rate) + 1 - servo.sample))
            apply(servo, change)
    traces.append(servo.run(sample_at(until, rate) + 1 - servo.sample))
    return joined(traces)
