"""The demand of a servo as cubics over its trajectory cycles, as far as each of them goes."""

from __future__ import annotations

from bisect import bisect_right
from math import ceil, inf
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.servo.demand import Cubic, Generator
    from motionlang.profile import Profile

FOR_EVER = 1 << 62
"""The cycle at which what never ends does."""
# The first moment of a profile behind its beginning.
_BEGUN = 5e-324


def cubic_behind(generator: Generator, cycle: int) -> tuple[Cubic | None, int]:
    """The cubic, counted from the beginning of `cycle`, that the point at its end lies on, and how long it goes on.

    That is the first cycle at whose end the point is another one's. None where that point is on no cubic.
    """
    period, starts = generator.period, generator.track.starts
    k = generator.in_force(cycle)
    start, profile = starts[k], generator.track.profiles[k]
    until = FOR_EVER
    if k + 1 < len(starts):
        until = _first(lambda i: generator.in_force(i) > k, starts[k + 1] / period)
    cubic, end = _on_profile(profile, (cycle + 1) * period - start, period)
    if end < inf:
        until = min(until, _first(lambda i: (i + 1) * period - start >= end, (start + end) / period - 1.0))
    if cubic is None:
        return None, until
    place, *ramp = moved(cubic, -1)
    return (place + generator.offset(k), *ramp), until  # type: ignore[return-value]


def moved(cubic: Cubic, cycles: int) -> Cubic:
    """The same cubic, counted from so many cycles later on."""
    c0, c1, c2, c3 = cubic
    x = float(cycles)
    return (
        ((c3 * x + c2) * x + c1) * x + c0,
        (3.0 * c3 * x + 2.0 * c2) * x + c1,
        3.0 * c3 * x + c2,
        c3,
    )


def _on_profile(profile: Profile, time: float, period: float) -> tuple[Cubic | None, float]:
    """The cubic that a profile is on at a time of its own, counted from there, and when that piece of it is over."""
    if not profile.pieced:
        return None, inf
    if time >= profile.duration:
        return (profile.position(time), profile.end_velocity * period, 0.0, 0.0), inf
    if time <= 0.0:
        return (profile.start, 0.0, 0.0, 0.0), _BEGUN
    knots, pieces, _ = profile.curve
    k = min(bisect_right(knots, time), len(pieces)) - 1
    _, c1, c2, c3, amplitude, _, _ = pieces[k]
    end = knots[k + 1] if k + 1 < len(pieces) else profile.duration
    if amplitude:
        return None, end
    x = time - knots[k]
    rate, bend = (3.0 * c3 * x + 2.0 * c2) * x + c1, 3.0 * c3 * x + c2
    return (profile.position(time), rate * period, bend * period * period, c3 * period**3), end


def _first(holds: Callable[[int], bool], about: float) -> int:
    """The first whole number for which something holds that holds from there on."""
    i = ceil(about)
    while not holds(i):
        i += 1
    while holds(i - 1):
        i -= 1
    return i
