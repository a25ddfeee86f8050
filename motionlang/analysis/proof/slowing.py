"""Slowing down, as fast as allowed, of motion that begins above its limits.

A profile may begin above its speed because the speed was lowered, or with more acceleration than its S-ramp
may have. Both are accepted only for as long as the ramp from there takes. Until then the speed is at most the
speed of the ramp; after that the bounds apply as for any other motion. The ramp is computed from the commands
alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import sqrt
from typing import NamedTuple

from motionlang.analysis.proof.checker import SLACK
from motionlang.analysis.proof.segments import Span
from motionlang.analysis.proof.time_bounds import Law, lead, ramp

# Seconds by which a segment may be late, as its time is rounded.
LATE = 1e-9


class Slowing(NamedTuple):
    """Excuses for motion that begins at v0 >= 0 above its limits; `came` is its peak.

    The speed may exceed `speed` until `until`, and the acceleration its rate until `eased`. Times are seconds
    after the entry.
    """

    v0: float
    speed: float
    came: float
    until: float
    eased: float
    stretches: tuple[tuple[float, float, float], ...]

    def bound(self, middle: float) -> float:
        """Return the bound on the speed of a cut segment that contains the time `middle`."""
        return max(self.came, self.speed) if middle < self.until else self.speed

    def cuts(self, spans: Sequence[Span]) -> Iterator[Span]:
        """Yield the segments, divided where the excuses end."""
        for span in spans:
            first = 0.0
            for end in sorted((self.until, self.eased)):
                x = end - span.begin
                if first < x < span.length:
                    yield span.section(first, x)
                    first = x
            yield span.section(first, span.length) if first else span

    def expected(self, time: float) -> float:
        """Return the highest expected speed `time` seconds after the entry."""
        if time >= self.until:
            return self.speed
        if not self.stretches:
            return max(self.came, self.speed)
        v = self.v0
        for a, change, length in self.stretches:
            x = min(time, length)
            v += x * (a + (0.5 * change * x / length if length else 0.0))
            time -= x
            if time <= 0.0:
                break
        return max(v, self.speed)


def slowing(v0: float, a0: float, speed: float, by: Law, extra: float = 0.0) -> Slowing:
    """Return how a motion reaches a speed; the ramp may begin `extra` seconds later."""
    if v0 < 0.0:
        v0, a0 = -v0, -a0
    came, until, eased = v0, 0.0, 0.0
    if by.smooth and a0:
        came += 0.5 * a0 * a0 / by.jerks[0] if a0 > 0.0 else 0.0
        eased = abs(a0) / min(by.jerks) * (1.0 + SLACK) + LATE
    beyond = 0.5 * a0 * a0 / by.jerks[1] - v0 if by.smooth and a0 < 0.0 else 0.0
    if beyond > speed:  # it has that speed in the other direction before its acceleration is ramped down
        until = (abs(a0) / by.jerks[1] + ramp(beyond, speed, by)[0]) * (1.0 + SLACK) + extra + LATE
        return Slowing(v0, speed, max(came, beyond), until, eased, ())
    if came > speed:
        # A shaped ramp that leads to rest at a reversal reaches the speed later than one to that speed.
        to = speed if by.stretch == 1.0 else 0.0
        until = lead(v0, a0 if by.smooth else 0.0, to, by)[0] * (1.0 + SLACK) + extra + LATE
    stretches = _stretches(v0, a0, came, speed, by) if until and by.stretch == 1.0 and not extra else ()
    return Slowing(v0, speed, came, until, eased, stretches)


def _stretches(
    v0: float, a0: float, came: float, speed: float, by: Law
) -> tuple[tuple[float, float, float], ...]:
    """Return the sections of the ramp to a lower speed.

    Each is the initial acceleration, its change, and the duration, s.
    """
    rate, jerk = by.rates[1], by.jerks[1]
    if not by.smooth:
        return ((-rate, 0.0, (v0 - speed) / rate),)
    if a0 > 0.0:
        return ((a0, -a0, a0 / by.jerks[0]), *_stretches(came, 0.0, came, speed, by))
    size, gain = -a0, v0 - speed
    eased = 0.5 * size * size / jerk
    if gain < eased:
        return ((a0, size, size / jerk),)
    peak = rate if size > rate else min(rate, sqrt(jerk * (gain + eased)))
    fall = peak / jerk
    if size > rate:
        hold = (gain - eased) / rate
    else:
        hold = max(0.0, (gain + eased) / peak - fall) if peak else 0.0
    return ((a0, size - peak, abs(size - peak) / jerk), (-peak, 0.0, hold), (-peak, peak, fall))
