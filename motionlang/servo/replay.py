"""Changes to a servo during a run, and its replay for reports and pictures."""

from __future__ import annotations

from math import floor
from typing import TYPE_CHECKING

from motionlang.servo.servo import Servo

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from motionlang.servo.demand import Demanded
    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor
    from motionlang.servo.trace import ServoTrace

    # Time and change: another loop, an open loop with a voltage, or a closed one with the index of the
    # profile in force.
    Change = tuple[float, Loop | float | int]

BLOCK = 1 << 13
"""Samples that are run at once."""


def apply(servo: Servo, change: Change) -> None:
    """Apply a recorded change to a servo that has run up to the change."""
    what = change[1]
    if isinstance(what, float):
        servo.open(what)
    elif isinstance(what, int):
        servo.close(what)
    else:
        servo.retune(what)


def sample_at(time: float, rate: float) -> int:
    """Return the number of the last sample up to and including a time."""
    return floor(time * rate + 1e-6)


def run_to(servo: Servo, sample: int) -> ServoTrace | None:
    """Run to `sample` (inclusive) and return the last block; periodic rest is skipped."""
    last = None
    for chunk in chunks(servo, sample):
        last = chunk
    return last


def chunks(servo: Servo, sample: int) -> Iterator[ServoTrace]:
    """Run to `sample` (inclusive) and yield each block; skip periodic rest.

    Only its first block is yielded.
    """
    while servo.sample <= sample:
        count = min(sample + 1 - servo.sample, BLOCK)
        state = servo.state
        yield servo.run(count)
        rest = sample + 1 - servo.sample
        if rest > BLOCK and servo.state == state and stays_at_rest(servo, BLOCK, sample):
            servo.skip(rest)


def stays_at_rest(servo: Servo, count: int, until: int) -> bool:
    """True if the command rests over the last `count` samples and until `until`."""
    starts, rate = servo.track.starts, servo.loop.servo_rate
    since = (servo.sample - count) / rate - 1.0 / servo.loop.trajectory_rate
    k = servo.in_force_at(since)
    if starts[k] > since or servo.track.profiles[k].shape != "hold":
        return False
    return k + 1 == len(starts) or starts[k + 1] > until / rate


def replay(
    track: Demanded,
    loop: Loop,
    plant: Motor | Drive,
    changes: Sequence[Change],
    until: float,
) -> Iterator[tuple[float, ServoTrace]]:
    """Yield a run from time 0 to `until` in consecutive traces.

    Each has the time of its first sample.
    """
    servo = Servo(loop, plant, track)
    for change in (*changes, None):
        end = until if change is None else min(change[0], until)
        first = servo.sample
        for chunk in chunks(servo, sample_at(end, loop.servo_rate)):
            yield first * loop.period, chunk
            first = servo.sample
        if change is not None:
            apply(servo, change)


def whole(
    track: Demanded, loop: Loop, plant: Motor | Drive, changes: Sequence[Change], until: float
) -> ServoTrace:
    """Return the run as one trace, in which skipped rest is filled in."""
    servo = Servo(loop, plant, track, record=True)
    for change in changes:
        if change[0] <= until:
            servo.advance(change[0])
            apply(servo, change)
    servo.advance(until)
    return servo.trace
