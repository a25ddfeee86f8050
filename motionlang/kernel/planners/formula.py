"""Pieces that are neither cubics nor half waves: a curve over a motion, and a sum.

Paths, cams, and offsets on geared axes derive pieces from others. `chain` and `plus` return a plain piece where the
result is one, otherwise a `Chain` or a `Sum`. These are evaluated from what they were made of, never expanded: a cubic
over a cubic has degree 9, an arc over a ramp is the sine of a quadratic. Roots of their derivatives are found by
bracketing.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf, pi

from motionlang.kernel.planners.pieces import (
    Formula,
    State,
    all_in,
    position_in,
    recentred,
    transformed,
)
from motionlang.kernel.planners.ramps import Piece
from motionlang.kernel.planners.root import bracketed_root

# Brackets of a piece; two extrema inside one bracket would be missed.
STEPS = 24


class Smooth(Formula):
    """A formula whose extrema are searched."""

    __slots__ = ()

    def roots(self, order: int, duration: float) -> tuple[float, ...]:
        """Return the local times inside (0, duration) at which derivative `order` changes its sign."""
        if duration == inf:
            return ()
        times = [duration * i / STEPS for i in range(STEPS)] + [duration]
        values = [self.state(x)[order] for x in times]
        return tuple(
            bracketed_root(lambda x: self._with_slope(x, order), low, high, b > 0.0)
            for (low, high), (a, b) in zip(pairwise(times), pairwise(values), strict=True)
            if a * b < 0.0
        )

    def _with_slope(self, x: float, order: int) -> tuple[float, float]:
        state = (*self.state(x), 0.0)
        return state[order], state[order + 1]


@dataclass(eq=False)
class Chain(Smooth):
    """A piece of a curve travelled by a piece of a motion: p(x) = f(s(x)).

    x is in s, s = `inner` in the unit of the path (or counts of the master) since the knot of f, and f = `outer` in
    the length unit of the axis. Over a straight f or a uniform s, `chain` returns a plain piece; over a ramp, f of
    degree 3 has degree 6, over an S-ramp 9. p is monotone, since a piece ends where the motion or the curve turns.
    """

    __slots__ = ("inner", "outer")

    outer: Piece
    inner: Piece

    def state(self, x: float) -> State:
        """Apply the chain rule: v = f' s', a = f'' s'^2 + f' s'', etc."""
        s, v, a, j = all_in(self.inner, x)
        f, slope, bend, third = all_in(self.outer, s)
        return f, slope * v, bend * v * v + slope * a, (third * v * v + 3.0 * bend * a) * v + slope * j

    def roots(self, order: int, duration: float) -> tuple[float, ...]:
        return super().roots(order, duration) if order > 1 else ()

    def recentred(self, x: float) -> Piece:
        return Chain(self.outer, recentred(self.inner, x))

    def transformed(self, factor: float, before: float, after: float) -> Piece:
        return Chain(transformed(self.outer, factor, before, after), self.inner)


@dataclass(eq=False)
class Sum(Smooth):
    """Two motions of one axis at a time: p(x) = `first`(x) + `second`(x), x in s, p in the length unit.

    An example is an offset on a slave. Sums of cubics, and of a wave and a line, are plain pieces; `plus` makes a Sum
    of two waves, of a wave and a curved piece, and of anything and a `Chain`, whose degree it has.
    """

    __slots__ = ("first", "second")

    first: Piece
    second: Piece

    def state(self, x: float) -> State:
        (p, v, a, j), (q, w, b, k) = all_in(self.first, x), all_in(self.second, x)
        return p + q, v + w, a + b, j + k

    def recentred(self, x: float) -> Piece:
        return Sum(recentred(self.first, x), recentred(self.second, x))

    def transformed(self, factor: float, before: float, after: float) -> Piece:
        first = transformed(self.first, factor, before, after)
        return Sum(first, transformed(self.second, factor, 0.0, 0.0))


def chain(outer: Piece, inner: Piece) -> Piece:
    """Return `outer` over `inner`; plain if either of them is straight."""
    if not isinstance(outer, tuple):
        return Chain(outer, inner)
    c0, c1, c2, c3, amplitude, _, _ = outer
    if not (c2 or c3 or amplitude):
        return transformed(inner, c1, 0.0, c0)
    if not isinstance(inner, tuple) or any(inner[2:5]):
        return Chain(outer, inner)
    v = inner[1]
    if not v:
        return (position_in(outer, inner[0]), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    c0, c1, c2, c3, amplitude, omega, phase = recentred(outer, inner[0])
    if amplitude and v < 0.0:  # sin(x) = sin(pi - x)
        omega, phase = -omega, pi - phase
    return (c0, c1 * v, c2 * v * v, c3 * v * v * v, amplitude, omega * v, phase)


def plus(a: Piece, b: Piece) -> Piece:
    """Return the sum of two pieces; plain unless a wave meets another one or a curved piece."""
    if not isinstance(a, tuple) or not isinstance(b, tuple) or (a[4] and b[4]):
        return Sum(a, b)
    wave = a if a[4] else b
    c0, c1, c2, c3 = (a[i] + b[i] for i in range(4))
    return Sum(a, b) if wave[4] and (c2 or c3) else (c0, c1, c2, c3, *wave[4:])
