"""Running a track through a loop and a motor, at once or along with a clock.

`Servo.advance` runs every servo sample up to a time and leaves the readings of the last one. `simulate` does this
over a complete track and returns all columns. The numbers do not depend on how a run is divided.
"""

from __future__ import annotations

from copy import copy
from math import floor
from typing import TYPE_CHECKING

from motionlang.kernel.servo.demand import Demanded, Generator
from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.servo.step import COLUMNS, LoopStep, Reading, State, at_rest

if TYPE_CHECKING:
    from motionlang.kernel.servo.trace import ServoTrace

# Samples whose readings are in tuples, which are four times as large as arrays.
_CHUNK = 1 << 13
# Counts in a trajectory cycle, and as a fraction of the position, below which the command does not move.
_STILL, _ROUNDING = 1e-9, 4e-15


class Servo:
    """The simulated servo of one axis, from its track's position at time 0.

    The readings are those of the last sample.
    """

    def __init__(self, loop: Loop, plant: Motor | VelocityDrive, track: Demanded) -> None:
        self.loop, self.plant = loop, plant
        self._step = LoopStep(loop, plant)
        self._generator = Generator(track, 1.0 / loop.trajectory_rate)
        start = self._generator.first()
        # The state before the next sample, and its number.
        self.state: State = at_rest(start)
        self.sample = 0
        # The trajectory points before the cycle of the last sample, at its beginning, and at its end.
        self._points = (start, start, start)
        self._reading: Reading = (start, self._step.measured(self.state[0]), start, 0.0, 0.0, 0.0, 0.0)
        self._open_output: float | None = None

    def copy(self) -> Servo:
        """Return a servo that continues from here by itself, on the same generator."""
        return copy(self)

    def replayed(self) -> Servo:
        """Return a servo that continues from here on a generator of its own, with its own changes of the loop."""
        made = copy(self)
        made._generator = self._generator.copy()
        return made

    def drop(self, count: int) -> None:
        """Continue on the track without its first `count` profiles, which it drops next."""
        self._generator.drop(count)

    # -- readings of the last sample

    @property
    def time(self) -> float:
        """Time of the last sample, seconds (before the first: minus one period)."""
        return (self.sample - 1) * self.loop.period

    @property
    def demand(self) -> float:
        """Commanded position, counts, in the program's coordinates."""
        return self._read("demand") - self._offset

    @property
    def position(self) -> float:
        """Measured position, counts, in the program's coordinates."""
        return self._read("measured") - self._offset

    @property
    def error(self) -> float:
        """Following error: commanded minus measured position, counts."""
        return self._read("demand") - self._read("measured")

    @property
    def velocity(self) -> float:
        """Velocity, counts/s."""
        return self._read("velocity")

    @property
    def integral(self) -> float:
        """The integral's contribution to the output, volts."""
        return self._read("integral")

    @property
    def output(self) -> float:
        """Output, volts."""
        return self._read("output")

    @property
    def current(self) -> float:
        """Motor current, A."""
        return self._read("current")

    @property
    def torque(self) -> float:
        """Motor torque, N m; 0 for a `VelocityDrive`."""
        constant: float = getattr(self.plant, "torque_constant", 0.0)
        return self.current * constant

    def _read(self, column: str) -> float:
        return self._reading[COLUMNS.index(column)]

    @property
    def _offset(self) -> float:
        """The program's offset at the last sample."""
        return self._generator.shifts(self.sample - 1, self.sample, self.loop.servo_rate)[-1][1]

    # -- the track

    @property
    def track(self) -> Demanded:
        """The track that the servo follows."""
        return self._generator.track

    @property
    def offset(self) -> float:
        """Counts to add to the motor's own coordinates for those of the program, now."""
        return self._generator.offset(len(self._generator.track.starts) - 1)

    def in_force_at(self, time: float) -> int:
        """Return the index of the profile in force at a time."""
        return self._generator.in_force_at(time)

    # -- running

    def advance(self, to: float) -> None:
        """Run every sample up to the time `to` (seconds, inclusive)."""
        until = sample_at(to, self.loop.servo_rate) + 1
        while self.sample < until:
            self._run(min(until - self.sample, _CHUNK))

    def run(self, count: int) -> ServoTrace:
        """Run and return `count` samples; imports numpy."""
        from motionlang.kernel.servo.trace import ServoTrace, columns_of

        first, until, chunks = self.sample, self.sample + count, []
        while self.sample < until:
            chunks.append(columns_of(self._run(min(until - self.sample, _CHUNK))))
        shifts = self._generator.shifts(first, until, self.loop.servo_rate)
        return ServoTrace(self.loop, self.plant, chunks, shifts)

    def skip(self, count: int) -> None:
        """Count `count` samples without computing them; the state must be a fixed point."""
        self.sample += count

    def _run(self, count: int) -> list[Reading]:
        """Run and return one or more samples, computing each cycle's point as it begins."""
        step, state, ratio = self._step, self.state, self.loop.ratio
        until = self.sample + count
        cycle = -(-self.sample // ratio)  # the first one that begins
        coming = iter(self._generator.points(cycle, -(-until // ratio) - cycle))
        before, here, there = self._points
        slope, (feed, acts) = (there - here) / ratio, self._command(before, here, there)
        readings = []
        for sample in range(self.sample, until):
            k = sample % ratio
            if k == 0:
                before, here, there = here, there, next(coming)
                slope, (feed, acts) = (there - here) / ratio, self._command(before, here, there)
            state, reading = step(state, here + k * slope, feed, acts)
            readings.append(reading)
        self.state, self.sample, self._points = state, until, (before, here, there)
        self._reading = readings[-1]
        return readings

    def _command(self, before: float, here: float, there: float) -> tuple[float, bool]:
        """Return the feed-forward of a cycle in volts, and true if the integral acts in it.

        The points are at the beginning of the cycle before, of this one, and at its end. The integral acts by
        `loop.INTEGRAL_MODES`; rounding of the points is no motion.
        """
        loop, rate = self.loop, self.loop.trajectory_rate
        last, now = here - before, there - here
        change = now - last
        is_slowing = change * (now + last) < 0.0
        gain = loop.decel_ff if is_slowing else loop.accel_ff
        feed = loop.velocity_ff * rate * now + gain * rate * rate * change
        if loop.integral_mode == "always":
            return feed, True
        motion = there - 2.0 * here + before if loop.integral_mode == "steady" else now
        return feed, abs(motion) <= _STILL + _ROUNDING * abs(here)

    # -- changes of the loop

    def open(self, output: float = 0.0) -> None:
        """Open the loop and apply `output` volts to the motor (0: it coasts)."""
        self._open_output = output
        self._step = LoopStep(self.loop, self.plant, output)

    def close(self, profile: int | None = None) -> None:
        """Close the loop at the motor's position, without wind-up.

        The track must already be at the motor's position. `profile` is the index of the profile in force, needed if the
        track continues after the present time.
        """
        measured = self._read("measured")
        self._generator.rebase(-(-self.sample // self.loop.ratio), measured, profile)
        self._points = (measured, measured, measured)
        self.state = self.state[0], at_rest(measured)[1]
        self._open_output, self._step = None, LoopStep(self.loop, self.plant)

    def retune(self, loop: Loop) -> None:
        """Continue with other gains; rates and arithmetic must not change."""
        for name in ("servo_rate", "trajectory_rate", "arithmetic"):
            if getattr(loop, name) != getattr(self.loop, name):
                raise ValueError(f"the {name.replace('_', ' ')} cannot change while the loop runs")
        self.loop = loop
        self._step = LoopStep(loop, self.plant, self._open_output)


def simulate(track: Demanded, loop: Loop, plant: Motor | VelocityDrive, *, until: float) -> ServoTrace:
    """Run a track through a loop and a motor from time 0 to `until` seconds.

    The track is an `Axis`, or a `Track` of profiles.
    """
    return Servo(loop, plant, track).run(sample_at(until, loop.servo_rate) + 1)


def sample_at(time: float, rate: float) -> int:
    """Return the number of the last sample up to and including a time."""
    return floor(time * rate + 1e-6)
