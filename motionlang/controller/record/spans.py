"""Stretches of a motion as plain formulas, evaluated and bounded exactly: the proof's own arithmetic, no planner's.

A span is c0 + c1 x + c2 x² + c3 x³ + A sin(ωx + φ) over a length of time; its derivatives have their extrema where the
next ones are zero, and those places are found in closed form.
"""

from __future__ import annotations

from itertools import pairwise
from math import acos, asin, ceil, copysign, cos, floor, fsum, isfinite, pi, sin, sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from motionlang.profile import Profile
    from motionlang.profile.ramps import Piece


class Span:
    """One piece of a motion from `begin` on, seconds since its profile began, for `length` seconds."""

    __slots__ = ("begin", "length", "piece")

    def __init__(self, begin: float, length: float, piece: Piece) -> None:
        self.begin, self.length, self.piece = begin, length, piece

    def at(self, x: float) -> tuple[float, float, float, float]:
        """Position, velocity, acceleration and jerk `x` seconds after it began."""
        return derivatives(self.piece, x)

    def cuts(self) -> list[float]:
        """Its ends, and the times between at which velocity or acceleration change sign or have an extremum."""
        _, c1, c2, c3, amplitude, omega, phase = self.piece
        found: list[float] = []
        if c3:
            found.append(-c2 / (3.0 * c3))
        if amplitude:
            found += _quarters(omega, phase, self.length)
            wave = -c1 / (amplitude * omega)
            if not (c2 or c3) and abs(wave) <= 1.0:
                found += _angles(acos(wave), omega, phase, self.length)
        else:
            found += _roots(3.0 * c3, 2.0 * c2, c1)
        return [0.0, *sorted(x for x in found if 0.0 < x < self.length), self.length]

    def peak(self, order: int) -> float:
        """The largest absolute value of a derivative: 1 the velocity, 2 the acceleration, 3 the jerk."""
        return max(abs(self.at(x)[order]) for x in self.cuts())

    def sides(self) -> Iterator[tuple[float, tuple[float, ...], tuple[float, ...]]]:
        """The parts in which the motion either speeds up or slows down: the power (its sign) and both end states."""
        cuts = self.cuts()
        states = [self.at(x) for x in cuts]
        for (x, left), (y, right) in pairwise(zip(cuts, states, strict=True)):
            _, v, a, _ = self.at(0.5 * (x + y))
            yield v * a, left, right


def derivatives(piece: Piece, x: float) -> tuple[float, float, float, float]:
    """Position, velocity, acceleration and jerk of a piece."""
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p, v = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x)
    a, j = 2.0 * c2 + 6.0 * c3 * x, 6.0 * c3
    if amplitude:
        wave, slope = amplitude * sin(omega * x + phase), amplitude * omega * cos(omega * x + phase)
        p, v, a, j = p + wave, v + slope, a - wave * omega * omega, j - slope * omega * omega
    return p, v, a, j


def spans(profile: Profile, begin: float, length: float) -> list[Span]:
    """The spans of a pieced profile from `begin` on, for `length` seconds."""
    found = []
    knots = profile.knots
    for piece, first, last in zip(profile.pieces, knots, knots[1:], strict=False):
        start, stop = max(first, begin), min(last, begin + length)
        if stop > start and isfinite(stop):
            found.append(Span(start - begin, stop - start, _from(piece, start - first)))
    return found


def combined(parts: Sequence[Span], weights: Sequence[float]) -> Span:
    """The weighted sum of spans of one time, of which no two wave differently."""
    sums = [fsum(w * s.piece[k] for w, s in zip(weights, parts, strict=True)) for k in range(5)]
    waving = next((s for s in parts if s.piece[4]), parts[0])
    return Span(parts[0].begin, parts[0].length, (*sums, *waving.piece[5:]))  # type: ignore[arg-type]


def _from(piece: Piece, x: float) -> Piece:
    """The same piece with its time counted from `x`."""
    if not x:
        return piece
    c0, c1, c2, c3, amplitude, omega, phase = piece
    shifted = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x), c2 + 3.0 * c3 * x
    return (*shifted, c3, amplitude, omega, phase + omega * x)


def _roots(a: float, b: float, c: float) -> list[float]:
    """Where a x² + b x + c is zero."""
    if not a:
        return [-c / b] if b else []
    under = b * b - 4.0 * a * c
    if under < 0.0:
        return []
    q = -0.5 * (b + copysign(sqrt(under), b))
    return [q / a, c / q] if q else [0.0]


def _quarters(omega: float, phase: float, length: float) -> list[float]:
    """Where a wave is zero or has a crest."""
    first, last = ceil(phase / (0.5 * pi)), floor((omega * length + phase) / (0.5 * pi))
    return [(k * 0.5 * pi - phase) / omega for k in range(first, last + 1)]


def _angles(angle: float, omega: float, phase: float, length: float) -> list[float]:
    """Where the cosine of a wave has the value of that of an angle."""
    turns = range(floor(phase / (2.0 * pi)) - 1, ceil((omega * length + phase) / (2.0 * pi)) + 2)
    return [(sign * angle + 2.0 * pi * k - phase) / omega for k in turns for sign in (1.0, -1.0)]


# ------------------------------------------------------------------------------------------------- due times


def due(v0: float, a0: float, v1: float, rates: tuple[float, float], jerks: tuple[float, float]) -> float:
    """How long it takes from velocity v0 and acceleration a0 to v1, by the rules of `docs/decisions.md`.

    `rates` and `jerks` are those of speeding up and of slowing down, infinite jerks a trapezoid's. Velocities of
    opposite signs meet at rest.
    """
    if v0 < 0.0 or (v0 == 0.0 and (a0 < 0.0 or (not a0 and v1 < 0.0))):
        v0, a0, v1 = -v0, -a0, -v1
    if v1 < 0.0:
        return due(v0, a0, 0.0, rates, jerks) + due(0.0, 0.0, v1, rates, jerks)
    up, down = (rates[0], jerks[0]), (rates[1], jerks[1])
    if not a0 or jerks[0] == float("inf"):
        return _ramp_time(v1 - v0, *up) if v1 > v0 else _ramp_time(v0 - v1, *down)
    rate, jerk = up if a0 > 0.0 else down
    eased = v0 + 0.5 * a0 * abs(a0) / jerk
    gain = (v1 - v0) if a0 > 0.0 else (v0 - v1)
    if gain * 1.0 >= 0.5 * a0 * a0 / jerk:
        size = abs(a0)
        if size > rate:  # beyond what is allowed now: it is taken back to that first
            return (size - rate) / jerk + (gain - 0.5 * size * size / jerk) / rate + rate / jerk
        return _ramp_time(gain + 0.5 * a0 * a0 / jerk, rate, jerk) - size / jerk
    return abs(a0) / jerk + due(eased, 0.0, v1, rates, jerks)


def _ramp_time(change: float, rate: float, jerk: float) -> float:
    if jerk == float("inf"):
        return change / rate
    return change / rate + rate / jerk if change >= rate * rate / jerk else 2.0 * sqrt(change / jerk)


def due_from_rest(
    distance: float, speed: float, rates: tuple[float, float], jerks: tuple[float, float]
) -> float:
    """How long a move from rest to rest takes, by halving the speeds that it may have."""

    def ramps(v: float) -> tuple[float, float]:
        times = _ramp_time(v, rates[0], jerks[0]), _ramp_time(v, rates[1], jerks[1])
        return times[0] + times[1], 0.5 * v * (times[0] + times[1])

    time, way = ramps(speed)
    if way <= distance:
        return time + (distance - way) / speed
    low, high = 0.0, speed
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if ramps(middle)[1] <= distance else (low, middle)
    return ramps(high)[0]


def rotation(x: float, y: float, degrees: float) -> tuple[float, float]:
    """A vector turned by an angle."""
    angle = degrees * pi / 180.0
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def half_angle(chord: float) -> float:
    """The angle, degrees, between two unit vectors whose ends lie a chord apart."""
    return 2.0 * asin(min(1.0, 0.5 * chord)) * 180.0 / pi
