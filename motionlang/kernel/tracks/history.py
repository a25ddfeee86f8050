"""Replay of simulated motors after a run, for its report, trace and pictures.

A run records only the changes to the servo loops. From these and the track of the axis all motor data are
computed again, block by block, with identical numbers.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.feedback import Feedback
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.servo.axis_loop import has_gains
from motionlang.kernel.servo.replay import replay, whole
from motionlang.kernel.servo.samples import REST_ERROR
from motionlang.kernel.servo.settings import SERVO
from motionlang.kernel.servo.trace import ServoTrace

Array = NDArray[np.float64]

# Samples beyond which a motor's history is not stored in one object: twenty minutes at 4 kHz.
MAX_SAMPLES = 5_000_000
# The motor quantities of a trace, and their columns of a `ServoTrace`.
COLUMNS = {
    "actual": "measured",
    "actual velocity": "velocity",
    "following error": "error",
    "output": "output",
    "torque": "torque",
}


class MotorFigures(NamedTuple):
    """A motor's figures for one move: counts, volts, N m, seconds.

    `settle_time` is None if the motor did not settle.
    """

    peak_error: float
    peak_output: float
    rms_torque: float
    settle_time: float | None


class MoveFigures:
    """Accumulated motor figures of one move.

    They are the largest following error (counts) and output (volts), torque, and settling time. The motor has
    settled when its error stays within a window until the next move.
    """

    def __init__(self, begin: float, end: float, until: float) -> None:
        self.begin, self.end, self.until = begin, end, until
        self.peak_error = self.peak_output = 0.0
        self._squares, self._count = 0.0, 0
        self._outside, self._seen, self._period = -inf, -inf, 0.0

    @property
    def rms_torque(self) -> float:
        """Root mean square of the torque during the move, N m."""
        return float((self._squares / self._count) ** 0.5) if self._count else 0.0

    @property
    def figures(self) -> MotorFigures:
        """The figures of all samples that were added."""
        return MotorFigures(self.peak_error, self.peak_output, self.rms_torque, self.settle_time)

    @property
    def settle_time(self) -> float | None:
        """Seconds from the end of the move until it settled; None if it did not settle."""
        if self._outside == self._seen > -inf:
            return None
        return max(self._outside + self._period - self.end, 0.0)

    def take(self, first: float, chunk: ServoTrace, window: float) -> None:
        """Add the samples of a block that belong to this move."""
        rate, self._period = chunk.loop.servo_rate, chunk.loop.period
        error, begin = chunk.error, self._sample_index(first, self.begin, rate)
        end = self._sample_index(first, self.end, rate) + 1
        until = self._sample_index(first, self.until, rate)
        moving, resting = slice(max(begin, 0), end), slice(end, max(until, 0))
        self.peak_error = max(self.peak_error, float(np.abs(error[moving]).max(initial=0.0)))
        self.peak_output = max(self.peak_output, float(np.abs(chunk.output[moving]).max(initial=0.0)))
        torque = chunk.torque[moving]
        self._squares, self._count = self._squares + float(torque @ torque), self._count + len(torque)
        rest = error[resting]
        if len(rest):
            outside = np.flatnonzero(np.abs(rest) > window)
            self._seen = first + (end + len(rest) - 1) / rate
            if len(outside):
                self._outside = first + (end + int(outside[-1])) / rate

    @staticmethod
    def _sample_index(first: float, time: float, rate: float) -> int:
        """Return the index in the block of the last sample up to a time; -1 if before it."""
        return max(int(np.floor((time - first) * rate + 1e-6)), -1) if time < inf else 1 << 62


def motors(controller: Controller) -> dict[int, Feedback]:
    """Return the simulated motors of a controller by axis."""
    return {number: a.feedback for number, a in controller.axes.items() if a.feedback is not None}


def chunks(a: Axis, until: float) -> Iterator[tuple[float, ServoTrace]]:
    """Yield the motor data of an axis up to the time `until`, block by block.

    Each block comes with the time of its first sample.
    """
    feedback = a.feedback
    if feedback is None or feedback.chosen is None:
        return iter(())
    return replay(feedback.origin(), feedback.changes, until)


def servo_trace(a: Axis, until: float) -> ServoTrace | None:
    """Return the motor data of an axis as one trace.

    None if the motor was never used, or for too long to be stored in memory.
    """
    feedback = a.feedback
    if feedback is None or feedback.chosen is None:
        return None
    if until * feedback.chosen.loop.servo_rate > MAX_SAMPLES:
        return None
    return whole(feedback.origin(), feedback.changes, until)


def servo_traces(controller: Controller) -> dict[int, ServoTrace]:
    """Return the motor traces of all axes that have one."""
    made = {
        number: servo_trace(controller.axes[number], controller.clock.now) for number in motors(controller)
    }
    return {number: trace for number, trace in made.items() if trace is not None}


def window_of(feedback: Feedback) -> float:
    """Return the settling window of a motor, counts; by default one."""
    error = feedback.windows["program"].error
    return error if feedback.windows["program"].announced and error < inf else REST_ERROR


def figures(controller: Controller) -> dict[int, MotorFigures]:
    """Return the motor figures of the moves in the log, by their numbers."""
    found = motors(controller)
    done = {number: _Done() for number in found}
    for number, move in enumerate(controller.log.moves):
        if move.axis in done and move.profile is not None and not move.overlaid:
            done[move.axis].add(number, move.start_time, move.profile.duration)
    made: dict[int, MotorFigures] = {}
    for axis, feedback in found.items():
        run = chunks(controller.axes[axis], controller.clock.now)
        done[axis].collect(run, window_of(feedback), controller.clock.now, made)
    return made


class _Done:
    """The moves of one axis: log numbers, start times, and planned durations."""

    def __init__(self) -> None:
        self._numbers: list[int] = []
        self._begins: list[float] = []
        self._durations: list[float] = []

    def add(self, number: int, begin: float, duration: float) -> None:
        self._numbers.append(number)
        self._begins.append(begin)
        self._durations.append(duration)

    def collect(
        self,
        run: Iterator[tuple[float, ServoTrace]],
        window: float,
        now: float,
        made: dict[int, MotorFigures],
    ) -> None:
        """Pass every block to the moves that it overlaps; both are in order of time."""
        open_ones: deque[tuple[int, MoveFigures]] = deque()
        following = 0
        for first, chunk in run:
            end = first + len(chunk) * chunk.loop.period
            while following < len(self._begins) and self._begins[following] <= end:
                open_ones.append((self._numbers[following], self._figures(following, now)))
                following += 1
            for _, move in open_ones:
                move.take(first, chunk, window)
            while open_ones and open_ones[0][1].until < end:  # the sample at its end is in the next block
                number, done = open_ones.popleft()
                made[number] = done.figures
        for number, move in open_ones:
            made[number] = move.figures
        for k in range(following, len(self._begins)):
            made[self._numbers[k]] = self._figures(k, now).figures

    def _figures(self, k: int, now: float) -> MoveFigures:
        begin, until = self._begins[k], self._begins[k + 1] if k + 1 < len(self._begins) else inf
        return MoveFigures(begin, min(begin + self._durations[k], until, now), until)


class Reader:
    """Columns of motor data, sampled at any times; fast if the times increase.

    Between two servo samples a column has the value of the earlier one.
    """

    def __init__(self, a: Axis, until: float) -> None:
        self._axis, self._until = a, until
        self._restart()

    def _restart(self) -> None:
        self._chunks = chunks(self._axis, self._until)
        self._loaded: list[tuple[float, ServoTrace]] = []
        self._dropped = False

    def fill(self, quantity: str, times: Array, out: Array) -> None:
        """Sample one of `COLUMNS` at increasing times; 0 before the first sample.

        Units are counts, volts or N m.
        """
        self._hold(float(times[0]), float(times[-1]))
        if not self._loaded:
            out[:] = self._axis.position(self._until) if quantity == "actual" else 0.0
            return
        rate = self._loaded[0][1].loop.servo_rate
        numbers = np.concatenate(
            [round(first * rate) + np.arange(len(chunk)) for first, chunk in self._loaded]
        )
        values = np.concatenate([chunk_column(chunk, quantity) for _, chunk in self._loaded])
        wanted = np.floor(times * rate + 1e-6)
        out[:] = values[np.maximum(np.searchsorted(numbers, wanted, "right") - 1, 0)]

    def _hold(self, begin: float, end: float) -> None:
        if self._dropped and self._loaded and begin < self._loaded[0][0]:
            self._restart()
        while not self._loaded or self._end() <= end:
            following = next(self._chunks, None)
            if following is None:
                break
            self._loaded.append(following)
        while len(self._loaded) > 1 and self._loaded[1][0] <= begin:
            self._loaded.pop(0)
            self._dropped = True

    def _end(self) -> float:
        first, chunk = self._loaded[-1]
        return first + len(chunk) * chunk.loop.period


def recall(controller: Controller, axis: int, quantity: str, times: Sequence[float]) -> list[float]:
    """Return a quantity of `COLUMNS` at increasing times up to now: counts, counts/s, volts or N m."""
    a = controller.axes[axis]
    if a.feedback is None:
        return [a.position(time) if quantity == "actual" else 0.0 for time in times]
    if not times:
        return []
    made = np.empty(len(times))
    Reader(a, controller.clock.now).fill(quantity, np.asarray(times, dtype=np.float64), made)
    values: list[float] = made.tolist()
    return values


def chunk_column(chunk: ServoTrace, quantity: str) -> Array:
    """Return the column of a quantity in a block."""
    column: Array = getattr(chunk, COLUMNS[quantity])
    return column


def notes(controller: Controller) -> list[str]:
    """Return notes for the report: gains never set, without effect, or for another servo rate."""
    found = []
    for number, feedback in motors(controller).items():
        chosen = feedback.chosen
        if chosen is None:
            continue
        # That for which `motionlang servo` tunes the gains of the machine file.
        tuned: float = feedback.section.get("servo_rate", SERVO["servo_rate"].default)  # type: ignore[assignment]
        if chosen.gains == "suggested":
            found.append(
                f"axis {number}: its motor has no gains; it ran with those suggested for {chosen.bandwidth:g} "
                "Hz"
            )
        elif not has_gains(chosen.loop):
            found.append(f"axis {number}: all gains of its motor are 0, so it does not follow its demand")
        elif chosen.gains == "machine file" and chosen.loop.servo_rate != tuned:
            rate = chosen.loop.servo_rate
            found.append(
                f"axis {number}: the gains of the machine file act {rate:.10g} times a second here, and {tuned:.10g} "
                f"times in motionlang servo; servo_rate = {rate:.10g} in [axis.{number}.servo] tunes them for this rate"
            )
    return found
