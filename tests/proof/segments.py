"""Segments of a motion as formulas, evaluated and bounded exactly.

This is the proof's own arithmetic, not a planner's. A segment is c0 + c1 x + c2 x² + c3 x³ + A sin(ωx + φ)
over a length of time. Its derivatives have their extrema at the zeros of the next ones, which are found in
closed form.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, asin, ceil, copysign, cos, floor, fsum, isfinite, pi, sin, sqrt

from motionlang.kernel.planners import Piece, Plain, Profile


class Span:
    """A piece of a motion over `length` s, from `begin` s after its profile began."""

    __slots__ = ("begin", "length", "piece")

    def __init__(self, begin: float, length: float, piece: Plain) -> None:
        self.begin, self.length, self.piece = begin, length, piece

    def at(self, x: float) -> tuple[float, float, float, float]:
        """Return position, velocity, acceleration and jerk `x` seconds after its start."""
        return derivatives(self.piece, x)

    def cuts(self) -> list[float]:
        """Return its ends, and the zeros and extrema of velocity and acceleration inside."""
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
        """Return the largest magnitude of derivative 1 velocity, 2 acceleration or 3 jerk."""
        return max(abs(self.at(x)[order]) for x in self.cuts())


def derivatives(piece: Piece, x: float) -> tuple[float, float, float, float]:
    """Return position, velocity, acceleration and jerk of a cubic or a half wave."""
    assert isinstance(piece, tuple)
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p, v = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x)
    a, j = 2.0 * c2 + 6.0 * c3 * x, 6.0 * c3
    if amplitude:
        wave, slope = amplitude * sin(omega * x + phase), amplitude * omega * cos(omega * x + phase)
        p, v, a, j = p + wave, v + slope, a - wave * omega * omega, j - slope * omega * omega
    return p, v, a, j


def spans(profile: Profile, begin: float, length: float) -> list[Span]:
    """Return the segments of a piecewise profile from `begin` on for `length` seconds."""
    found = []
    knots = profile.knots
    for piece, first, last in zip(profile.drawn[1], knots, knots[1:], strict=False):
        start, stop = max(first, begin), min(last, begin + length)
        if stop > start and isfinite(stop):
            found.append(Span(start - begin, stop - start, _from(piece, start - first)))
    return found


def combined(spans: Sequence[Span], weights: Sequence[float], origin: float) -> Span:
    """Return the weighted sum of simultaneous segments with equal waves.

    Its positions are relative to an origin.
    """
    sums = [fsum(w * s.piece[k] for w, s in zip(weights, spans, strict=True)) for k in range(5)]
    sums[0] -= origin
    waving = next((s for s in spans if s.piece[4]), spans[0])
    return Span(spans[0].begin, spans[0].length, (*sums, *waving.piece[5:]))  # type: ignore[arg-type]


def _from(piece: Plain, x: float) -> Plain:
    """Return the same piece with its time origin moved to `x`."""
    if not x:
        return piece
    c0, c1, c2, c3, amplitude, omega, phase = piece
    shifted = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x), c2 + 3.0 * c3 * x
    return (*shifted, c3, amplitude, omega, phase + omega * x)


def _roots(a: float, b: float, c: float) -> list[float]:
    """Return the real roots of a x² + b x + c."""
    if not a:
        return [-c / b] if b else []
    under = b * b - 4.0 * a * c
    if under < 0.0:
        return []
    q = -0.5 * (b + copysign(sqrt(under), b))
    return [q / a, c / q] if q else [0.0]


def _quarters(omega: float, phase: float, length: float) -> list[float]:
    """Return the times at which a wave is zero or has a crest."""
    first, last = ceil(phase / (0.5 * pi)), floor((omega * length + phase) / (0.5 * pi))
    return [(k * 0.5 * pi - phase) / omega for k in range(first, last + 1)]


def _angles(angle: float, omega: float, phase: float, length: float) -> list[float]:
    """Return the times at which the cosine of a wave equals that of an angle."""
    wraps = range(floor(phase / (2.0 * pi)) - 1, ceil((omega * length + phase) / (2.0 * pi)) + 2)
    return [(sign * angle + 2.0 * pi * k - phase) / omega for k in wraps for sign in (1.0, -1.0)]


def rotation(x: float, y: float, degrees: float) -> tuple[float, float]:
    """Return a vector rotated by an angle."""
    angle = degrees * pi / 180.0
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def half_angle(chord: float) -> float:
    """Return the angle, degrees, between unit vectors, from the chord of their ends."""
    return 2.0 * asin(min(1.0, 0.5 * chord)) * 180.0 / pi
