"""A servo that is run ahead of the clock, block by block, and taken back where what it saw will be otherwise.

A linear loop goes from one cubic of its demand to the next by its closed form. Plain steps do what lies between them
and around its limits, and all of what is not linear. What a sample is does not depend on where the block ends that it
is in.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from motionlang.controller.servo.closed_form import SEEN, closed_form
from motionlang.controller.servo.cubics import cubic_behind, moved, value
from motionlang.controller.servo.discrete import discretise
from motionlang.controller.servo.foreseen import Foreseen
from motionlang.controller.servo.servo import Servo
from motionlang.controller.servo.steps import MEMORY, put
from motionlang.controller.servo.stretch import run_steps

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from motionlang.controller.servo.closed_form import ClosedForm
    from motionlang.controller.servo.demand import Cubic
    from motionlang.controller.servo.loop import Loop
    from motionlang.controller.servo.steps import State
    from motionlang.controller.servo.stretch import Floats, Stretch
    from motionlang.controller.servo.trace import ServoTrace

    Array = NDArray[np.float64]
    # State, sample, trajectory points and readings.
    Mark = tuple[State, int, list[float], dict[str, float]]

_WAIT = MEMORY.index("derivative_wait") - len(MEMORY)
# By plain steps and by the closed form, in which samples cost little beside their block.
_SHORT, _SHORT_FORM = 64, 256
# Samples of a cubic from which the closed form is quicker than plain steps.
_WORTHWHILE = 48
# Samples of plain steps behind one that breaks a limit; as many again each time that was too early, up to the most.
_PATIENCE, _MOST_PATIENCE = 32, 1024
# Samples that a new loop goes by plain steps first: its table takes as long to make as some thousands of them.
_TRIAL = 256


class Ahead(Servo):
    """One axis under servo, seen before its time."""

    points_of = Foreseen

    @property
    def short(self) -> int:
        """Samples of the first block behind something that may be followed by something else."""
        return _SHORT if self._form(self._sample + _SHORT_FORM) is None else _SHORT_FORM

    _form_of: tuple[Loop, ClosedForm | None] | None = None
    # The loop that was in charge last, and the sample from which it counts as one that stays.
    _loop: Loop | None = None
    _stays = 0
    # Where it stood at the beginning of each stretch of the last block.
    _marks: Sequence[Mark] = ()
    # The last block, where all of it was plain steps: it has marks of its own.
    _stepped: Stretch | None = None

    @property
    def began(self) -> State:
        """The state before the last block that was looked at."""
        return self._marks[0][0]

    def back(self, sample: int) -> None:
        """Stand before a sample of the last block again; gains and the track are as they are now."""
        mark = next(each for each in reversed(self._marks) if each[1] <= sample)
        self._state, self._sample, self._points, self._row = mark
        if self._stepped is not None and (nearer := self._stepped.mark_before(sample - self._sample)):
            done, self._state, self._points = nearer
            self._sample += done
        if self._sample < sample:
            self.look(sample - self._sample)

    def _mark(self) -> Mark:
        return self._state, self._sample, self._points, self._row

    def look(self, count: int) -> Array:
        """Run `count` samples: a row for each of `SEEN`, in the motor's own coordinates."""
        self._marks, self._stepped = [self._mark()], None
        first, until = self._sample, self._sample + count
        form, made = self._form(until), np.empty((len(SEEN), count))
        if form is None:
            self._step(until, made)
            self._stepped = self._stretch
            return made
        if first < self._stays:
            self._step(self._stays, made)
            self._marks.append(self._mark())
        while self._sample < until:
            cubic, begin, stop = self._next_cubic(form, until)
            if self._sample < begin:
                self._step(min(begin, until), made[:, self._sample - first :])
                self._marks.append(self._mark())
            if cubic is not None and begin < until:
                self._glide(form, cubic, min(stop, until), made[:, begin - first :])
                self._marks.append(self._mark())
        return made

    def _step(self, until: int, out: Array) -> None:
        """Plain steps to sample `until` (not included)."""
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
        self._tell(made[:, -1])

    @cached_property
    def _encoding(self) -> tuple[bool, bool]:
        """Whether the encoder is at the load, and whether it gives whole counts."""
        made = discretise(self.plant, self.loop.period)
        return made.load_encoder, made.quantised or self.loop.arithmetic != "real"

    def _next_cubic(self, form: ClosedForm, until: int) -> tuple[Cubic | None, int, int]:
        """The next cubic that is worth it, from which sample to which; None where there is none before `until`.

        How long a cubic is decides, not how much of it comes before `until`: so what is run again is run alike.
        """
        ratio, sample = self.loop.ratio, self._sample
        if self._state[_WAIT]:  # a closed form begins with a sample of the derivative
            begin = (sample // ratio + 1) * ratio
            return None, begin, begin
        least = -(-_WORTHWHILE // ratio)
        while sample < until:
            cycle, part = divmod(sample, ratio)
            cubic, end = (None, cycle + 1) if part else cubic_behind(self._generator, cycle, least)
            if cubic is not None:
                return cubic if (sample - self._sample) % form.every == 0 else None, sample, end * ratio
            sample = end * ratio
        return None, sample, sample

    def _glide(self, form: ClosedForm, cubic: Cubic, until: int, out: Array) -> None:
        """Go along a cubic to sample `until` (not included)."""
        first, patience, ratio = self._sample, _PATIENCE, self.loop.ratio
        unit = 2 * form.unit  # two cycles on, the points before the first one are out of it
        while self._sample < until:
            done = self._sample - first
            count = min(until - self._sample, form.longest)
            here = moved(cubic, done // ratio)
            off = (0.0, 0.0) if done else (self._points[0] - value(cubic, -1), self._points[1] - cubic[0])
            good, self._state = form.run(self._state, here, off, out[:, done : done + count])
            done += good
            if good:
                cycle, part = divmod(done, ratio)
                at = value(cubic, cycle) if cycle else self._points[1]
                before = value(cubic, cycle - 1) if cycle > 1 else self._points[cycle]
                self._points = [before, at, value(cubic, cycle + 1) if part else at]
                self._sample = first + done
                self._tell(out[:, done - 1])
            if good < count:
                stop = first + -(-(done + patience) // unit) * unit
                self._step(min(stop, until), out[:, done:])
                patience = min(2 * patience, _MOST_PATIENCE)

    def _stretched(self, points: Floats, part: int, count: int) -> tuple[Stretch, State]:
        return run_steps(self._in_charge, self.plant, self._columns, points, part, count, self._state)

    def _tell(self, seen: Array) -> None:
        """The last sample was this."""
        encoder, velocity, error, output, current = seen.tolist()
        self._row = {"demand": encoder + error, "measured": encoder, "velocity": velocity,
                     "output": output, "current": current}  # fmt: skip

    def _form(self, until: int) -> ClosedForm | None:
        """The closed form of the loop in charge; None where none of it comes before sample `until`.

        The first loop stays, one that comes later after a while: a torque that rises makes one a cycle.
        """
        loop = self._in_charge
        if loop is not self._loop:
            self._stays = 0 if self._loop is None else self._sample + _TRIAL
            self._loop = loop
        if until <= self._stays:
            return None
        if self._form_of is None or self._form_of[0] is not loop:
            self._form_of = loop, closed_form(loop, self.plant)
        return self._form_of[1]


def seen_of(trace: ServoTrace) -> Array:
    """The rows of `SEEN` of a trace."""
    made = np.empty((len(SEEN), len(trace)))
    made[0], made[1], made[3], made[4] = trace.encoder, trace.velocity, trace.output, trace.current
    np.subtract(trace.commanded, made[0], out=made[2])
    return made
