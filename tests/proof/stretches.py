"""Stretches of a motion: each speeds up or slows down, and its velocity and acceleration are monotone.

A motion may begin above its limits, because the program lowered them or because it takes over an acceleration. It
then has to slow down, without a break, until it observes them; and an acceleration that it took over may only
fall. How fast it does this is a property of the planners.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from math import inf
from typing import NamedTuple

from tests.proof.checker import SLACK
from tests.proof.order import Order
from tests.proof.segments import Span

# Seconds of a stretch whose direction is rounding.
MOMENT = 1e-9

State = tuple[float, float, float, float]


class Stretch(NamedTuple):
    """A stretch, by its states at both ends: position, velocity, acceleration and jerk.

    `side` is 0 for speeding up and 1 for slowing down. `reverses` is true on a piece that does both. `slows` is true
    if the motion has only slowed down so far, or ramped down the acceleration that it took over; `eases` if its
    acceleration has only fallen.
    """

    left: State
    right: State
    begin: float
    length: float
    side: int
    reverses: bool
    slows: bool
    eases: bool

    @property
    def speed(self) -> float:
        """Return the highest speed."""
        return max(abs(self.left[1]), abs(self.right[1]))

    @property
    def rate(self) -> float:
        """Return the largest acceleration."""
        return max(abs(self.left[2]), abs(self.right[2]))

    @property
    def jerk(self) -> float:
        """Return the largest jerk."""
        return max(abs(self.left[3]), abs(self.right[3]))


def stretches(spans: Iterable[Span], slows: bool = True) -> Iterator[Stretch]:
    """Yield the stretches of a motion, in order; it may begin above its limits if it `slows`."""
    eases = True
    for span in spans:
        cuts = span.cuts()
        sections = list(pairwise(cuts))
        for first, last in sections:
            _, v, a, jerk = span.at(0.5 * (first + last))
            if last - first > MOMENT:
                slows = slows and (v * a < 0.0 or v * jerk < 0.0)
                eases = eases and a * jerk < 0.0
            side = 0 if v * a > 0.0 else 1
            yield Stretch(
                span.at(first),
                span.at(last),
                span.begin + first,
                last - first,
                side,
                len(sections) > 1,
                slows,
                eases,
            )


def unavoidable_speed(order: Order, velocity: float, acceleration: float) -> float:
    """Return the speed that a motion reaches while the acceleration that it took over is ramped down.

    The shapes of PMC have no jerk limit: theirs depends on the ramp that the motion leaves.
    """
    if not acceleration or not order.bends:
        return abs(velocity)
    jerk = order.jerks[0 if acceleration * velocity >= 0.0 else 1]
    if jerk == inf:
        return inf
    return max(abs(velocity), abs(velocity + 0.5 * acceleration * abs(acceleration) / jerk))


def stopping_distance(order: Order, velocity: float, acceleration: float) -> float:
    """Return a distance that suffices for a stop.

    It is infinite for shapes without a bound on it, and for a deceleration that cannot be ramped down before rest.
    """
    rate, jerk = order.rates[1], min(order.jerks)
    if not rate or (jerk == inf and order.shape != "trapezoid"):
        return inf
    if jerk == inf:
        return 0.5 * velocity * velocity / rate
    top, ease = unavoidable_speed(order, velocity, acceleration), abs(acceleration) / jerk
    passes = acceleration * velocity < 0.0 and 0.5 * acceleration**2 / jerk >= abs(velocity) * (1.0 - SLACK)
    return inf if passes else top * (ease + 0.5 * (top / rate + rate / jerk))
