"""A sensor whose analogue value depends on the position of an axis.

Examples are a force, a distance, the tension of a web. The sensor is sampled when a profile begins or ends, and
at every tick of the profiler while the axis moves.

The motion is known in advance, so the ticks need not be events. A sample is computed when it is read, and the
samples of a profile are logged when it is over or the log is read (these sensors are in
`AnalogueInputs.computed`). Most of them become a template, from which the log computes them (`log/sampled.py`).
Programs that compare a sample with a level get the tick at which it passes the level from `until`. The ticks are
events only if listeners must be notified of each sample, the language does not record dependencies, or the axis has a
simulated motor.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.log.sampled import Sampling

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.controller.clock import Event
    from motionlang.controller.controller import Controller
    from motionlang.log.sampled import Row
    from motionlang.log.stream import Stream
    from motionlang.planners import Profile

# The period of the profiler, seconds.
PERIOD = 1e-3
# `until` searches FIRST_TICKS ahead, then twice as far, and so on, up to MAX_TICKS. It searches again from there.
MAX_TICKS, FIRST_TICKS = 1 << 20, 1 << 10
# The least number of samples that become a template, and the number of those at each end that do not.
MIN_TEMPLATE, AT_ENDS = 64, 4


def next_tick(now: float) -> float:
    """Return the next tick of the profiler; all functions run at ticks share it."""
    return _next(now) * PERIOD


def _next(now: float) -> int:
    return int(now / PERIOD + 1e-6) + 1


def _last(now: float) -> int:
    """Return the number of the last tick up to a time."""
    number = int(now / PERIOD) + 1
    while number * PERIOD > now:
        number -= 1
    return number


class Sensor:
    """A sensor on an axis that puts its value on a channel while it is active.

    The value is `value` plus `per_unit` for each user unit beyond `origin`, a machine position.
    """

    def __init__(
        self, controller: Controller, axis: int, origin: float, value: float, per_unit: float, channel: int
    ) -> None:
        self._controller, self.axis, self.channel = controller, axis, channel
        self._inputs = controller.analogue_inputs
        self.origin, self.value, self.per_unit = origin, value, per_unit
        self.active = False
        self._event: Event | None = None
        # The first tick that is not logged, and the motion sampled there.
        self._next = 0
        self._sampling: Sampling
        controller.axes[axis].followers.append(self._moved)

    def switch(self, active: bool) -> None:
        """Activate or deactivate the sensor as the axis enters or leaves its region."""
        self.active = active
        if active:
            self._sample()
        else:
            self._cancel()
            self._inputs[self.channel] = 0.0

    def rescale(self) -> None:
        """Use the new scale of the axis for further samples."""
        if self._inputs.computed.get(self.channel) is self:
            self._inputs.settle()
            value, per_unit, origin, datum, _ = self._sampling.conversion
            factors = self._controller.axes[self.axis].scale.factors[0]
            self._sampling.conversion = value, per_unit, origin, datum, factors

    def tick(self) -> None:
        """Turn the ticks into events from now on."""
        self._cancel()
        clock = self._controller.clock
        self._event = clock.at(next_tick(clock.now), self._sample)

    def level(self) -> float | None:
        """Return the latest sample, or None if the log already has it."""
        number = _last(self._controller.clock.now)
        return None if number < self._next else self._sampling.value(number)

    def samples(self, last: float) -> list[Row]:
        """Return the samples not yet logged, up to now, as (time, channel, value).

        A sample equal to the one before it is omitted; `last` is the latest logged value.
        """
        first, past = self._next, _last(self._controller.clock.now) + 1
        if past <= first:
            return []
        self._next = past
        return self._changes(range(first, past), last)

    def log_samples(self, changes: Stream[Any], last: float) -> float:
        """Log the samples up to now like `samples`; return the latest value."""
        first, past = self._next, _last(self._controller.clock.now) + 1
        begin, finish = first + AT_ENDS, past - AT_ENDS
        sampling = self._sampling
        if finish - begin < MIN_TEMPLATE or not sampling.is_distinct(begin - 1, finish):
            rows = self.samples(last)
            changes.extend(rows)
            return rows[-1][2] if rows else last
        self._next = past
        before = self._changes(range(first, begin), last)
        after = sampling.rows(range(finish, past))
        changes.add_samples(sampling.template(before, after, begin, finish - begin))
        return after[-1][2]

    def _changes(self, ticks: range, last: float) -> list[Row]:
        """Return the samples at some ticks that differ from those before them."""
        rows = []
        for row in self._sampling.rows(ticks):
            if row[2] != last:
                last = row[2]
                rows.append(row)
        return rows

    def until(self, shown: Callable[[float], float], level: float | tuple[float, float] | None) -> float:
        """Return the first tick at which a sample may have passed a level.

        `shown` converts a sample into the unit of the level. A level `(distance, centre)` is passed at `distance` on
        either side of `centre`. The result is infinite if the present profile ends before: its end is an event of its
        own.
        """
        if isinstance(level, tuple):
            distance, centre = level
            return min(self.until(shown, centre + distance), self.until(shown, centre - distance))
        now = self._controller.clock.now
        last = _last(now)
        found = self.level()
        value = shown(self._inputs[self.channel] if found is None else found)
        if level is None:
            return (last + 1) * PERIOD
        profile, start, sample_at = self._sampling.profile, self._sampling.start, self._sampling.value
        elapsed = now - start
        reversal: float | None = None
        if not profile.direction:
            reversal = profile.velocity_crossing(0.0, elapsed) if profile.velocity(elapsed) else elapsed
        ends = start + profile.duration
        monotonic_until = ends if reversal is None else min(start + reversal, ends)
        farthest = last + MAX_TICKS
        if monotonic_until < INFINITY:
            farthest = min(_last(monotonic_until), farthest)

        def differs(number: int) -> bool:
            sample = shown(sample_at(number))
            return (sample > level) is not (value > level) or (sample < level) is not (value < level)

        low, high = last, min(last + FIRST_TICKS, farthest)
        while high > low and not differs(high):
            low, high = high, min(2 * high - last, farthest)
        if high <= low:
            return INFINITY if farthest * PERIOD + PERIOD > ends else (max(farthest, last) + 1) * PERIOD
        while high - low > 1:
            middle = (low + high) // 2
            if differs(middle):
                high = middle
            else:
                low = middle
        return high * PERIOD

    def _moved(self, profile: Profile) -> None:
        if self.active:
            self._sample()

    def _sample(self) -> None:
        self._cancel()
        controller, a = self._controller, self._controller.axes[self.axis]
        conversion = self.value, self.per_unit, self.origin, a.datum, a.scale.factors[0]
        sampling = Sampling(self.channel, PERIOD, a.starts[-1], conversion, a.profiles[-1])
        self._inputs[self.channel] = sampling.value_at(controller.position(self.axis))
        if controller.is_still(self.axis):
            return
        if a.feedback is not None or not self._inputs.may_compute(self.channel):
            self.tick()
            return
        self._next = _next(controller.clock.now)
        self._sampling = sampling
        self._inputs.computed[self.channel] = self

    def _cancel(self) -> None:
        if self._inputs.computed.get(self.channel) is self:
            self._inputs.settle()
            del self._inputs.computed[self.channel]
        if self._event is not None:
            self._event.cancel()
            self._event = None
