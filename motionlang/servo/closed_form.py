"""The closed form of a linear servo: samples along a cubic in one expression.

A linear loop goes from one cubic of its command to the next by its closed form. Single steps (`SpeculativeServo`)
compute the samples between cubics and around the limits, and everything nonlinear.

Between its limits, loop and plant are one linear system, and a cubic of the command is four numbers. So a sample is a
linear function of the state and the command at the beginning of its stretch. The factors are constant: a table,
computed once for a loop and a plant by doubling. Products are added term by term, which no matrix library promises, so
a sample is equal to the last bit whatever the processor and the length of the stretch.

The points of the command are on the cubic from the end of the first cycle on. The point at the beginning of that cycle
and the one before it were given already, and so are their offsets from the cubic.
"""

from __future__ import annotations

from functools import lru_cache
from math import inf, lcm
from typing import TYPE_CHECKING

import numpy as np

from motionlang.servo.cubics import cubic_behind, moved, value
from motionlang.servo.discrete import discretise
from motionlang.servo.linear import Probe, remembered_states
from motionlang.servo.speculative import FIRST, SEEN, SpeculativeServo
from motionlang.servo.steps import MEMORY

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from motionlang.servo.demand import Cubic
    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor
    from motionlang.servo.steps import State

    Array = NDArray[np.float64]

MAX_TABLE = 512
"""The longest table, in samples."""
_MAX_UNIT = 64
_OUTPUT = SEEN.index("output")
# A motion smaller than this, in any unit, is zero.
_NOTHING = 1e-30
# Beyond this a loop that diverges is left to the plain steps.
_FAR = 1e250
_WAIT = MEMORY.index("derivative_wait") - len(MEMORY)
# Samples of a cubic from which the closed form is quicker than plain steps.
_WORTHWHILE = 48
# Samples of plain steps after one that exceeds a limit; each premature retry doubles them, up to the maximum.
_PATIENCE, _MAX_PATIENCE = 32, 1024
# Samples of plain steps at the start of a new loop: its table takes as long to make as some thousands of
# them.
_TRIAL = 256


@lru_cache(maxsize=32)
def closed_form(loop: Loop, plant: Motor | Drive) -> ClosedForm | None:
    """Return the closed form of a loop and a plant.

    None if more than their state decides which terms of the loop act.
    """
    unit = lcm(loop.ratio, loop.derivative_every if loop.derivative else 1)
    if not (loop.is_linear and plant.is_linear) or unit > _MAX_UNIT:
        return None
    if loop.accel_ff != loop.decel_ff or (loop.has_integral and loop.integral_mode != "always"):
        return None
    return ClosedForm(loop, plant, unit)


class ClosedForm:
    """The table of one loop and one plant, relative to the command at the start.

    A stretch begins with a trajectory cycle, and with a sample of the derivative. `longest` is its maximum number of
    samples.
    """

    def __init__(self, loop: Loop, plant: Motor | Drive, unit: int) -> None:
        made = discretise(plant, loop.period)
        self.ratio, self.unit, self.every = loop.ratio, unit, loop.derivative_every if loop.derivative else 1
        self._indices = remembered_states(loop, made.names)
        memory = len(made.names) + MEMORY.index("last_position")
        self._width = len(self._indices) + 6
        self._memory_rows = [i for i, index in enumerate(self._indices) if index in (0, memory)]
        self._bounds = [(_OUTPUT, min(loop.output_limit, _FAR))]
        if loop.has_integral and loop.integral_limit < inf:
            self._bounds.append((len(SEEN), loop.integral_limit))
        # A loop that overflows within a stretch exceeds its limits before that.
        with np.errstate(all="ignore"):
            self._begin(loop, plant, unit)
            while self.longest < MAX_TABLE:
                self._double()
        self._has = [
            bool(rows.any() or states.any()) for rows, states in zip(self._rows, self._states, strict=True)
        ]

    @property
    def longest(self) -> int:
        """The maximum length of a stretch, in samples."""
        return int(self._rows.shape[2])

    # -- the table: over (state, 1, three coefficients of the command, offsets of the two points before)

    def _begin(self, loop: Loop, plant: Motor | Drive, unit: int) -> None:
        """Compute the table for the first samples, one by one."""
        made = discretise(plant, loop.period)
        columns = ["position", "velocity", "output", "current", "integral", *["twist"] * made.load_encoder]
        probe = Probe(loop, plant, tuple(columns))
        nz, width = len(self._indices), self._width
        state, rows, states = np.eye(nz, width), [], []
        for k in range(2 * unit):  # the offsets of those two points have no effect after that
            demand, feed = self._demand(k), self._feed(loop, k // self.ratio)
            step, outputs = probe.held if k % self.every else probe.sampled
            given = np.vstack((state, demand, feed, np.eye(width)[nz]))
            seen = dict(zip(columns, _product(outputs, given), strict=True))
            encoder = seen["position"] - seen["twist"] if made.load_encoder else seen["position"]
            every = (
                encoder,
                seen["velocity"],
                demand - encoder,
                seen["output"],
                seen["current"],
                seen["integral"],
            )
            rows.append(every[: len(SEEN) + len(self._bounds) - 1])
            states.append(state)
            state = _product(step, given)
        # Factor by column and sample.
        self._rows = np.ascontiguousarray(np.array(rows).transpose(2, 1, 0))
        self._states = np.ascontiguousarray(np.array([*states, state]).transpose(2, 1, 0))

    def _point(self, cycle: int) -> Array:
        """Return the point at the beginning of a cycle."""
        made = np.zeros(self._width)
        made[-5:-2] = cycle, cycle**2, cycle**3
        if -1 <= cycle <= 0:
            made[cycle - 1] = 1.0
        return made

    def _demand(self, sample: int) -> Array:
        """Return the command at a sample; it is linear between points."""
        cycle, fraction = divmod(sample, self.ratio)
        here, there = self._point(cycle), self._point(cycle + 1)
        made: Array = here + (fraction / self.ratio) * (there - here)
        return made

    def _feed(self, loop: Loop, cycle: int) -> Array:
        """Return the feed-forward in a cycle, by the rule in `stretch.py`."""
        before, here, there = (self._point(cycle + k) for k in (-1, 0, 1))
        rate = loop.trajectory_rate
        made: Array = loop.velocity_ff * rate * (there - here)
        made += loop.accel_ff * rate * rate * ((there - here) - (here - before))
        return made

    def _double(self) -> None:
        """Double the table: append a stretch that begins where this one ends."""
        count, nz = self.longest, len(self._indices)
        cycles = count // self.ratio
        moved = self._point(cycles)
        onward = np.zeros((self._width, self._width))
        onward[:nz] = self._states[:, :, -1].T
        onward[self._memory_rows] -= moved
        onward[nz, nz] = 1.0
        onward[nz + 1, nz + 1 : nz + 4] = 1.0, 2.0 * cycles, 3.0 * cycles * cycles
        onward[nz + 2, nz + 2 : nz + 4] = 1.0, 3.0 * cycles
        onward[nz + 3, nz + 3] = 1.0
        rows, states = (_after(onward, factors) for factors in (self._rows, self._states[:, :, 1:]))
        rows[:, 0] += moved[:, None]
        states[:, self._memory_rows] += moved[:, None, None]
        self._rows = np.concatenate((self._rows, rows), axis=2)
        self._states = np.concatenate((self._states, states), axis=2)

    # -- running

    def run(self, state: State, cubic: Cubic, off: tuple[float, float], out: Array) -> tuple[int, State]:
        """Fill `out`, a row for each of `SEEN`, as if there were no limits.

        `off` are the offsets from the cubic of the points before and at the beginning of the first cycle.
        Returns the number of samples within the limits, and the state after these samples.
        """
        base, *ramp = cubic
        start = [state[index] for index in self._indices]
        for i in self._memory_rows:
            start[i] -= base
        terms = [(i, z) for i, z in enumerate((*start, 1.0, *ramp, *off)) if z and self._has[i]]
        count = out.shape[1]
        with np.errstate(all="ignore"):
            made = _summed([(self._rows[i, :, :count], z) for i, z in terms], self._rows.shape[1], count)
            good = self._inside(made)
            after = _summed(
                [(self._states[i, :, good : good + 1], z) for i, z in terms], len(self._indices), 1
            )
        np.add(made[0], base, out=out[0])
        out[1:] = made[1 : len(SEEN)]
        full = list(state)
        for index, (number,) in zip(self._indices, after.tolist(), strict=True):
            full[index] = number if abs(number) > _NOTHING else 0.0
        for i in self._memory_rows:
            full[self._indices[i]] += base
        full[_WAIT] = -good % self.every
        return good, tuple(full)

    def _inside(self, made: Array) -> int:
        """Return how many samples, counted from the first, are within the limits."""
        good = int(made.shape[1])
        for row, limit in self._bounds:
            values = made[row, :good]
            if not (values.max() <= limit and values.min() >= -limit):
                good = int(((values <= limit) & (values >= -limit)).argmin())
                if not good:
                    break
        return good


def _summed(terms: list[tuple[Array, float]], height: int, count: int) -> Array:
    """Return the sum of arrays times their factors, in order."""
    made = np.zeros((height, count))
    one = np.empty((height, count))
    for array, factor in terms:
        np.multiply(array, factor, out=one)
        made += one
    return made


def _after(onward: Array, factors: Array) -> Array:
    """Convert the factors of a continuation to factors of the stretch's start."""
    made = np.zeros_like(factors)
    for row, each in zip(onward, factors, strict=True):
        made += row[:, None, None] * each
    return made


def _product(a: Array, b: Array) -> Array:
    """Return the matrix product, term by term."""
    made: Array = (a[:, :, None] * b).sum(axis=1)
    return made


class ClosedFormServo(SpeculativeServo):
    """The simulated servo of one axis, run ahead of the clock by its closed form."""

    _form_of: tuple[Loop, ClosedForm | None] | None = None
    # The loop last in control, and the sample from which it counts as permanent.
    _loop: Loop | None = None
    _stays = 0

    @property
    def first_blocks(self) -> tuple[int, ...]:
        """The sizes of the blocks of the first `FIRST` samples after a change.

        In closed form one block costs less than two.
        """
        return super().first_blocks if self._form(self._sample + FIRST) is None else (FIRST,)

    def run_block(self, count: int) -> Array:
        """Run `count` samples and return a row for each of `SEEN`, in motor coordinates."""
        first, until = self._sample, self._sample + count
        form = self._form(until)
        if form is None:
            return super().run_block(count)
        self._marks, self._stepped, made = [self._mark()], None, np.empty((len(SEEN), count))
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

    def _next_cubic(self, form: ClosedForm, until: int) -> tuple[Cubic | None, int, int]:
        """Return the next cubic that is long enough, and its first and last sample.

        The cubic is None if there is none before `until`. The complete length of a cubic decides, not its length up to
        `until`, so that repeated samples are computed equally.
        """
        ratio, sample = self.loop.ratio, self._sample
        if self._state[_WAIT]:  # a closed form begins with a sample of the derivative
            begin = (sample // ratio + 1) * ratio
            return None, begin, begin
        least = -(-_WORTHWHILE // ratio)
        while sample < until:
            cycle, fraction = divmod(sample, ratio)
            cubic, end = (None, cycle + 1) if fraction else cubic_behind(self._generator, cycle, least)
            if cubic is not None:
                return cubic if (sample - self._sample) % form.every == 0 else None, sample, end * ratio
            sample = end * ratio
        return None, sample, sample

    def _glide(self, form: ClosedForm, cubic: Cubic, until: int, out: Array) -> None:
        """Run along a cubic to sample `until` (exclusive), by the closed form."""
        first, patience, ratio = self._sample, _PATIENCE, self.loop.ratio
        unit = 2 * form.unit  # two cycles on, the points before the first one have no effect
        while self._sample < until:
            done = self._sample - first
            count = min(until - self._sample, form.longest)
            here = moved(cubic, done // ratio)
            off = (0.0, 0.0) if done else (self._points[0] - value(cubic, -1), self._points[1] - cubic[0])
            good, self._state = form.run(self._state, here, off, out[:, done : done + count])
            done += good
            if good:
                cycle, fraction = divmod(done, ratio)
                at = value(cubic, cycle) if cycle else self._points[1]
                before = value(cubic, cycle - 1) if cycle > 1 else self._points[cycle]
                self._points = [before, at, value(cubic, cycle + 1) if fraction else at]
                self._sample = first + done
                self._notify(out[:, done - 1])
            if good < count:
                stop = first + -(-(done + patience) // unit) * unit
                self._step(min(stop, until), out[:, done:])
                patience = min(2 * patience, _MAX_PATIENCE)

    def _form(self, until: int) -> ClosedForm | None:
        """Return the closed form of the present loop; None if none applies before `until`.

        The first loop gets its form at once, a later one only when it has stayed for a while: a rising torque limit
        changes the loop in every cycle.
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
