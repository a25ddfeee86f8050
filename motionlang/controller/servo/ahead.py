"""A servo that is run ahead of the clock, block by block, and taken back where what it saw will be otherwise.

A linear loop goes from one cubic of its demand to the next by its closed form. Plain steps do what lies between them
and around its limits, and all of what is not linear. What a sample is does not depend on where the blocks that were
run from the same mark end.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motionlang.controller.servo.closed_form import SEEN, closed_form
from motionlang.controller.servo.cubics import cubic_behind, moved
from motionlang.controller.servo.demand import ONE_PROFILE
from motionlang.controller.servo.servo import Servo
from motionlang.controller.servo.steps import MEMORY

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from motionlang.controller.servo.closed_form import ClosedForm
    from motionlang.controller.servo.demand import Cubic
    from motionlang.controller.servo.loop import Loop
    from motionlang.controller.servo.steps import State
    from motionlang.controller.servo.trace import ServoTrace

    Array = NDArray[np.float64]
    Mark = tuple[State, int, list[float], dict[str, float]]

_WAIT = MEMORY.index("derivative_wait") - len(MEMORY)
# By plain steps and by the closed form, in which samples cost little beside their block.
_SHORT, _SHORT_FORM = 64, 256
# Samples of plain steps behind one that breaks a limit; as many again each time that was too early, up to the most.
_PATIENCE, _MOST_PATIENCE = 32, 1024


class Ahead(Servo):
    """One axis under servo, seen before its time."""

    few = ONE_PROFILE

    @property
    def short(self) -> int:
        """Samples of the first block behind something that may be followed by something else."""
        return _SHORT if self._form is None else _SHORT_FORM

    _form_of: tuple[Loop, ClosedForm | None] | None = None

    def mark(self) -> Mark:
        """What `back` needs to return here."""
        return self._state, self._sample, list(self._points), self._row

    def back(self, mark: Mark) -> None:
        """Forget what was run since `mark` was made; gains and the track are as they are now."""
        self._state, self._sample, self._points, self._row = mark
        self._points = list(self._points)

    def look(self, count: int) -> Array:
        """Run `count` samples: a row for each of `SEEN`, in the motor's own coordinates."""
        form = self._form
        if form is None:
            return seen_of(self.run(count))
        first, until = self._sample, self._sample + count
        made = np.empty((len(SEEN), count))
        while self._sample < until:
            rest = made[:, self._sample - first :]
            cycle, part = divmod(self._sample, self.loop.ratio)
            cubic, end = None, cycle + 1
            if not part and not self._state[_WAIT]:
                cubic, end = cubic_behind(self._generator, cycle)
            stop = min(end * self.loop.ratio, until)
            if cubic is None:
                self._step(stop, rest)
            else:
                self._glide(form, cubic, stop, rest)
        return made

    def _step(self, until: int, out: Array) -> None:
        """Plain steps to sample `until` (not included)."""
        count = until - self._sample
        out[:, :count] = seen_of(self.run(count))

    def _glide(self, form: ClosedForm, cubic: Cubic, until: int, out: Array) -> None:
        """Go along a cubic to sample `until` (not included)."""
        # Behind two cycles the points before the first one are out of it.
        first, patience, unit = self._sample, _PATIENCE, 2 * form.unit
        while self._sample < until:
            done = self._sample - first
            count = min(until - self._sample, form.longest)
            there = moved(cubic, done // self.loop.ratio)
            before, here, _ = self._points
            off = (0.0, 0.0) if done else (before - moved(there, -1)[0], here - there[0])
            good, self._state = form.run(self._state, there, off, out[:, done : done + count])
            if good:
                self._arrive(self._sample + good, out[:, done + good - 1])
            if good < count:
                done += good
                stop = first + -(-(done + patience) // unit) * unit
                self._step(min(stop, until), out[:, done:])
                patience = min(2 * patience, _MOST_PATIENCE)

    def _arrive(self, sample: int, seen: Array) -> None:
        """All samples before number `sample` were run, the last of which was this."""
        cycle, part = divmod(sample, self.loop.ratio)
        since, given = self._sample // self.loop.ratio - 1, self._points

        def point(k: int) -> float:
            return given[k - since] if k <= since + 1 else self._generator.point(k - 1)

        here = point(cycle)
        self._sample, self._points = sample, [point(cycle - 1), here, point(cycle + 1) if part else here]
        encoder, velocity, error, output, current = seen.tolist()
        self._row = {"demand": encoder + error, "measured": encoder, "velocity": velocity,
                     "output": output, "current": current}  # fmt: skip

    @property
    def _form(self) -> ClosedForm | None:
        """The closed form of the loop in charge."""
        loop = self._in_charge
        if self._form_of is None or self._form_of[0] is not loop:
            self._form_of = loop, closed_form(loop, self.plant)
        return self._form_of[1]


def seen_of(trace: ServoTrace) -> Array:
    """The rows of `SEEN` of a trace."""
    made = np.empty((len(SEEN), len(trace)))
    for row, name in zip(made, SEEN, strict=True):
        row[:] = getattr(trace, name)
    return made
