"""A sensor whose analogue value depends on the position of an axis.

Examples are a force, a distance, the tension of a web. The sensor is sampled when a profile begins or ends, and
at every tick of the profiler while the axis moves.

The motion is known in advance, so the ticks need not be events. A sample is computed when it is read; the log has which
ticks were sampled, and computes the samples again when it is read (`samples.py`). Programs that compare a sample with a
level get the tick at which it passes the level from `until`. The ticks are events only if listeners must be notified of
each sample, the language does not record dependencies, or the axis has a simulated motor.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.io.samples import PERIOD, sample, value_at
from motionlang.kernel.log.records import Sampled
from motionlang.kernel.log.stream import Stream
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis

# `until` searches FIRST_TICKS ahead, then twice as far, and so on, up to MAX_TICKS. It searches again from there.
MAX_TICKS, FIRST_TICKS = 1 << 20, 1 << 10


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

    def __init__(self, a: Axis, origin: float, value: float, per_unit: float, channel: int) -> None:
        self.a, self.channel = a, channel
        self._inputs = a.controller.analogue_inputs
        self.origin, self.value, self.per_unit = origin, value, per_unit
        self.active = False
        self._event: TimedCall | None = None
        # What is sampled from the first tick on that is not logged, and the motion there.
        self._sampled: Sampled
        self._profile: Profile
        a.followers.append(self._moved)

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
            factors = self.a.scale.factors[0]
            self._sampled = self._sampled._replace(factors=factors)

    def tick(self) -> None:
        """Turn the ticks into events from now on."""
        self._cancel()
        clock = self.a.clock
        self._event = clock.at(next_tick(clock.now), self._sample)

    def level(self) -> float | None:
        """Return the latest sample, or None if the log already has it."""
        tick = _last(self.a.clock.now)
        return None if tick < self._sampled.first else self._sample_at(tick)

    def log_samples(self, sampled: Stream[Sampled]) -> float | None:
        """Log that samples were taken up to now; return the latest one, None if there is none."""
        past = _last(self.a.clock.now) + 1
        if past <= self._sampled.first:
            return None
        sampled.add(self._sampled._replace(past=past))
        self._sampled = self._sampled._replace(first=past)
        return self._sample_at(past - 1)

    def _sample_at(self, tick: int) -> float:
        return sample(self._sampled, self._sampled.start, self._profile, tick)

    def until(self, shown: Callable[[float], float], level: float | None) -> float:
        """Return the first tick at which a sample may have passed a level.

        `shown` converts a sample into the unit of the level. The result is infinite if the present profile ends before:
        its end is an event of its own.
        """
        now = self.a.clock.now
        last = _last(now)
        found = self.level()
        value = shown(self._inputs[self.channel] if found is None else found)
        if level is None:
            return (last + 1) * PERIOD
        profile, start, sample_at = self._profile, self._sampled.start, self._sample_at
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
        a = self.a
        first = _next(a.clock.now)
        sampled = Sampled(
            self.channel, a.index, first, first, a.starts[-1],
            self.value, self.per_unit, self.origin, a.datum, a.scale.factors[0],
        )  # fmt: skip
        self._inputs[self.channel] = value_at(sampled, a.actual_position)
        if a.is_still:
            return
        if a.feedback is not None or not self._inputs.may_compute(self.channel):
            self.tick()
            return
        self._sampled, self._profile = sampled, a.profiles[-1]
        self._inputs.computed[self.channel] = self

    def _cancel(self) -> None:
        if self._inputs.computed.get(self.channel) is self:
            self._inputs.settle()
            del self._inputs.computed[self.channel]
        if self._event is not None:
            self._event.cancel()
            self._event = None
