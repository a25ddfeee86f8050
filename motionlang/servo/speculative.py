"""Speculative servo simulation with rollback: a servo runs ahead of the clock.

It runs in blocks. A sample does not depend on where its block ends.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from motionlang.servo.discrete import discretise
from motionlang.servo.servo import Servo
from motionlang.servo.speculative_points import SpeculativeGenerator
from motionlang.servo.steps import put
from motionlang.servo.stretch import run_steps

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from motionlang.servo.steps import State
    from motionlang.servo.stretch import Floats, Stretch
    from motionlang.servo.trace import ServoTrace

    Array = NDArray[np.float64]
    # State, sample, trajectory points and readings.
    Mark = tuple[State, int, list[float], dict[str, float]]

SEEN = ("encoder", "velocity", "error", "output", "current")
"""The columns of a sample: motor position (counts), counts/s, counts, V, A."""
FIRST = 256
"""Samples after a change whose blocks may be short."""
_SHORT = 64


class SpeculativeServo(Servo):
    """The simulated servo of one axis, run ahead of the clock."""

    points_of = SpeculativeGenerator

    @property
    def first_blocks(self) -> tuple[int, ...]:
        """The sizes of the blocks of the first `FIRST` samples after a change.

        Another change may follow soon, so the first one is short.
        """
        return _SHORT, FIRST - _SHORT

    # The states at the beginning of each stretch of the last block.
    _marks: Sequence[Mark] = ()
    # The last block, if it consisted of plain steps only; then it has its own marks.
    _stepped: Stretch | None = None

    @property
    def began(self) -> State:
        """The state before the last block."""
        return self._marks[0][0]

    def back(self, sample: int) -> None:
        """Roll back to the state before a sample of the last block; keep gains and track."""
        mark = next(each for each in reversed(self._marks) if each[1] <= sample)
        self._state, self._sample, self._points, self._row = mark
        if self._stepped is not None and (nearer := self._stepped.mark_before(sample - self._sample)):
            done, self._state, self._points = nearer
            self._sample += done
        if self._sample < sample:
            self.run_block(sample - self._sample)

    def _mark(self) -> Mark:
        return self._state, self._sample, self._points, self._row

    def run_block(self, count: int) -> Array:
        """Run `count` samples and return a row for each of `SEEN`, in motor coordinates."""
        self._marks, self._stepped = [self._mark()], None
        made = np.empty((len(SEEN), count))
        self._step(self._sample + count, made)
        self._stepped = self._stretch
        return made

    def _step(self, until: int, out: Array) -> None:
        """Run single steps to sample `until` (exclusive)."""
        count = until - self._sample
        self._run(until)
        made, stretch = out[:, :count], self._stretch
        columns, encoder = dict(zip(self._columns, stretch.columns, strict=True)), made[0]
        put(columns["position"], encoder)
        put(columns["velocity"], made[1])
        put(columns["output"], made[3])
        put(columns["current"], made[4])
        at_load, whole = self._encoding
        if at_load:
            encoder -= columns["twist"]
        if whole:
            np.rint(encoder, out=encoder)
        np.subtract(stretch.demand(count), encoder, out=made[2])
        self._notify(made[:, -1])

    @cached_property
    def _encoding(self) -> tuple[bool, bool]:
        """Return true if the encoder is at the load, and true if it gives integer counts."""
        made = discretise(self.plant, self.loop.period)
        return made.load_encoder, made.quantised or self.loop.arithmetic != "real"

    def _stretched(self, points: Floats, offset: int, count: int) -> tuple[Stretch, State]:
        return run_steps(self._in_charge, self.plant, self._columns, points, offset, count, self._state)

    def _notify(self, seen: Array) -> None:
        """Set the readings to those of the last sample."""
        encoder, velocity, error, output, current = seen.tolist()
        self._row = {"demand": encoder + error, "measured": encoder, "velocity": velocity,
                     "output": output, "current": current}  # fmt: skip


def seen_of(trace: ServoTrace) -> Array:
    """Return the rows of `SEEN` of a trace."""
    made = np.empty((len(SEEN), len(trace)))
    made[0], made[1], made[3], made[4] = trace.encoder, trace.velocity, trace.output, trace.current
    np.subtract(trace.commanded, made[0], out=made[2])
    return made
