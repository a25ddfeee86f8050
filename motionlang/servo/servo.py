"""Running a track through a loop and a motor, at once or along with a clock.

`Servo.advance` runs every servo sample up to a time and leaves the readings of the last one. `simulate` does
this over a complete track and records all columns. The numbers do not depend on how a run is divided, except
for rounding.
"""

from __future__ import annotations

from dataclasses import replace
from math import floor, inf
from typing import TYPE_CHECKING

from motionlang.servo.demand import Generator
from motionlang.servo.discrete import discretise
from motionlang.servo.steps import COLUMNS, initial_state
from motionlang.servo.stretch import Stretch, run_stretch

if TYPE_CHECKING:
    from motionlang.servo.demand import Demanded
    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor
    from motionlang.servo.steps import State
    from motionlang.servo.stretch import Floats
    from motionlang.servo.trace import ServoTrace

SPAN = 1 << 18
"""Samples that are run at once, a bound of the memory of a servo without a record."""
WATCH = 4096
"""Samples that are run at once while the following error is watched."""


class Servo:
    """The simulated servo of one axis, from its track's position at time 0.

    The readings are those of the last sample, only of `columns`; with `record` those of all samples are stored for
    `trace`.
    """

    points_of: type[Generator] = Generator
    """The class that makes the points of its track."""

    def __init__(
        self,
        loop: Loop,
        plant: Motor | Drive,
        track: Demanded,
        *,
        record: bool = False,
        columns: tuple[str, ...] = COLUMNS,
    ) -> None:
        for name in columns:
            if name not in COLUMNS:
                raise ValueError(f"a servo has no column {name!r}; it has {', '.join(COLUMNS)}")
        self.loop, self.plant = loop, plant
        self.peak_error = 0.0
        self._columns = columns
        self._generator = self.points_of(track, 1.0 / loop.trajectory_rate)
        self._open_output: float | None = None
        self._sample = 0
        self._stored: list[Stretch] | None = [] if record else None
        start = self._generator.first()
        # The trajectory point before this cycle, its beginning, and its end.
        self._points = [start, start, start]
        self._state: State = initial_state(discretise(plant, loop.period), start)
        self._row = dict.fromkeys(COLUMNS, 0.0) | {"position": start, "demand": start}
        self._row["measured"] = self._measured()

    # -- readings of the last sample

    @property
    def time(self) -> float:
        """Time of the last sample, seconds (before the first: minus one period)."""
        return (self._sample - 1) * self.loop.period

    @property
    def demand(self) -> float:
        """Commanded position, counts, in the program's coordinates."""
        return self._row["demand"] - self._offset

    @property
    def position(self) -> float:
        """Measured position, counts, in the program's coordinates."""
        return self._row["measured"] - self._offset

    @property
    def error(self) -> float:
        """Following error: commanded minus measured position, counts."""
        return self._row["demand"] - self._row["measured"]

    @property
    def velocity(self) -> float:
        """Velocity, counts/s."""
        return self._row["velocity"]

    @property
    def integral(self) -> float:
        """The integral's contribution to the output, volts."""
        return self._row["integral"]

    @property
    def output(self) -> float:
        """Output, volts."""
        return self._row["output"]

    @property
    def current(self) -> float:
        """Motor current, A."""
        return self._row["current"]

    @property
    def torque(self) -> float:
        """Motor torque, N m; 0 for a `Drive`."""
        constant: float = getattr(self.plant, "torque_constant", 0.0)
        return self._row["current"] * constant

    @property
    def trace(self) -> ServoTrace:
        """The record so far; imports numpy."""
        from motionlang.servo.trace import joined

        if self._stored is None:
            raise ValueError("this servo records nothing: create it with record=True")
        return joined(self.loop, self.plant, self._columns, self._stored)

    # -- running

    def advance(self, to: float, error_limit: float = inf) -> float | None:
        """Run every sample up to the time `to` (seconds, inclusive).

        With an `error_limit` (counts) it stops at the first sample whose following error exceeds the limit, and returns
        that sample's time. If there is none, it returns None.
        """
        until = floor(to * self.loop.servo_rate + 1e-6) + 1
        span = SPAN if error_limit == inf else WATCH
        while self._sample < until:
            before = self._state, self._sample, self._points
            self._run(min(until, before[1] + span))
            if error_limit < inf and self._peak() > error_limit:
                trip = before[1] + self._first_beyond(error_limit)
                self._state, self._sample, self._points = before
                self._run(trip + 1)
            self._store()
            if error_limit < inf and abs(self.error) > error_limit:
                return self.time
        return None

    def open(self, output: float = 0.0) -> None:
        """Open the loop and apply `output` volts to the motor (0: it coasts)."""
        self._open_output = output

    def close(self, profile: int | None = None) -> None:
        """Close the loop at the motor's position, without wind-up.

        The track must already be at the motor's position. `profile` is the index of the profile in force, needed if the
        track continues after the present time.
        """
        measured = self._row["measured"]
        self._generator.rebase(-(-self._sample // self.loop.ratio), measured, profile)
        self._points = [measured, measured, measured]
        fresh = initial_state(discretise(self.plant, self.loop.period), measured)
        plant_states = len(discretise(self.plant, self.loop.period).names)
        self._state = self._state[:plant_states] + fresh[plant_states:]
        self._open_output = None

    def retune(self, loop: Loop) -> None:
        """Continue with other gains; rates and arithmetic must not change."""
        for name in ("servo_rate", "trajectory_rate", "arithmetic"):
            if getattr(loop, name) != getattr(self.loop, name):
                raise ValueError(f"the {name.replace('_', ' ')} cannot change while the loop runs")
        self.loop = loop

    # -- from block to block

    @property
    def sample(self) -> int:
        """The number of the next sample, whose time is that number of periods."""
        return self._sample

    @property
    def track(self) -> Demanded:
        """The track that the servo follows."""
        return self._generator.track

    def in_force_at(self, time: float) -> int:
        """Return the index of the profile in force at a time."""
        return self._generator.in_force_at(time)

    @property
    def state(self) -> State:
        """The plant's state and the loop's memory before the next sample."""
        return self._state

    @property
    def offset(self) -> float:
        """Counts to add to the motor's own coordinates for those of the program, now."""
        return self._generator.offset(len(self._generator.track.starts) - 1)

    def run(self, count: int) -> ServoTrace:
        """Run and return `count` samples, in motor coordinates.

        Only `demand` and `position` are in the program's coordinates.
        """
        from motionlang.servo.trace import joined

        self._run(self._sample + count)
        self._store()
        return joined(self.loop, self.plant, self._columns, [self._stretch])

    def skip(self, count: int) -> None:
        """Count `count` samples without computing them; the state must be a fixed point."""
        self._sample += count

    # -- inside

    @property
    def _offset(self) -> float:
        """The program's offset at the last sample."""
        return self._generator.shifts(self._sample - 1, self._sample, self.loop.servo_rate)[-1][1]

    def _run(self, until: int) -> None:
        """Run to sample `until` (exclusive), computing each cycle's point as it begins."""
        ratio, first = self.loop.ratio, self._sample
        cycle, offset = divmod(first, ratio)
        cycles = -(-until // ratio) - cycle
        known = 3 if offset else 2
        points = self._generator.points(cycle + known - 2, cycles + 2 - known, self._points[:known])
        self._stretch, self._state = self._stretched(points, offset, until - first)
        self._stretch.shifts = self._generator.shifts(first, until, self.loop.servo_rate)
        final = [float(point) for point in points[-3:]]
        self._points = [*final[1:], final[2]] if until % ratio == 0 else final
        self._sample = until

    def _stretched(self, points: Floats, offset: int, count: int) -> tuple[Stretch, State]:
        return run_stretch(self._in_charge, self.plant, self._columns, points, offset, count, self._state)

    def _store(self) -> None:
        stretch = self._stretch
        self._row = {
            name: float(column[-1]) for name, column in zip(self._columns, stretch.columns, strict=True)
        }
        self._row["demand"] = stretch.last_demand(len(stretch.columns[0]))
        self._row["measured"] = self._measured()
        if self._stored is not None:
            self._stored.append(stretch)

    def _peak(self) -> float:
        from motionlang.servo.trace import joined

        return joined(self.loop, self.plant, self._columns, [self._stretch]).peak_error

    def _first_beyond(self, limit: float) -> int:
        from motionlang.servo.trace import joined

        seen = joined(self.loop, self.plant, self._columns, [self._stretch])
        return round(seen.first_beyond(limit) * self.loop.servo_rate)

    @property
    def _in_charge(self) -> Loop:
        """The loop, or while it is open a loop without gains.

        That one has the open-loop voltage as its output offset; only output limits and DAC act on it.
        """
        if self._open_output is None:
            return self.loop
        names = ("proportional", "integral", "derivative", "velocity_feedback")
        none = dict.fromkeys((*names, "velocity_ff", "accel_ff", "decel_ff", "output_deadband"), 0.0)
        bare = replace(self.loop, arithmetic="real", override=None, reversed=False, **none)  # type: ignore[arg-type]
        return replace(bare, output_offset=self._open_output)

    def _measured(self) -> float:
        made = discretise(self.plant, self.loop.period)
        position = self._row["position"] - (self._row["twist"] if made.load_encoder else 0.0)
        return float(round(position)) if made.quantised or self.loop.arithmetic != "real" else position


def simulate(
    track: Demanded,
    loop: Loop,
    plant: Motor | Drive,
    *,
    until: float,
    columns: tuple[str, ...] = COLUMNS,
) -> ServoTrace:
    """Run a track through a loop and a motor from time 0 to `until` seconds.

    The track is an `Axis`, or a `Track` of profiles.
    """
    servo = Servo(loop, plant, track, record=True, columns=columns)
    servo.advance(until)
    return servo.trace
