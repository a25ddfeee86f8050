"""One piece of a curve: values, derivatives, extrema, and changes of its origin.

A piece is a tuple of seven numbers (`ramps.py`), or a `Formula`.
"""

from __future__ import annotations

from math import acos, copysign, cos, inf, pi, sin, sqrt
from typing import TYPE_CHECKING, overload

if TYPE_CHECKING:
    from motionlang.kernel.planners.ramps import Piece, Plain

# Position, velocity, acceleration and jerk.
State = tuple[float, float, float, float]


class Formula:
    """A piece that is neither a cubic nor a half wave (`formula.py`)."""

    __slots__ = ()

    def state(self, x: float) -> State:
        """Return position, velocity, acceleration and jerk at local time x."""
        raise NotImplementedError

    def roots(self, order: int, duration: float) -> tuple[float, ...]:
        """Return the local times inside (0, duration) at which derivative `order` is zero."""
        raise NotImplementedError

    def recentred(self, x: float) -> Piece:
        raise NotImplementedError

    def transformed(self, factor: float, before: float, after: float) -> Piece:
        raise NotImplementedError


def position_in(piece: Piece, x: float) -> float:
    """Return the position at local time x of a piece."""
    if not isinstance(piece, tuple):
        return piece.state(x)[0]
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p = ((c3 * x + c2) * x + c1) * x + c0 if x != 0.0 else c0
    return p + amplitude * sin(omega * x + phase) if amplitude else p


def velocity_in(piece: Piece, x: float) -> float:
    """Return the velocity at local time x of a piece."""
    if not isinstance(piece, tuple):
        return piece.state(x)[1]
    _, c1, c2, c3, amplitude, omega, phase = piece
    if amplitude:
        return c1 + amplitude * omega * cos(omega * x + phase)
    return (3.0 * c3 * x + 2.0 * c2) * x + c1 if c2 or c3 else c1


def acceleration_in(piece: Piece, x: float) -> float:
    """Return the acceleration at local time x of a piece."""
    if not isinstance(piece, tuple):
        return piece.state(x)[2]
    _, _, c2, c3, amplitude, omega, phase = piece
    if amplitude:
        return -amplitude * omega * omega * sin(omega * x + phase)
    return 6.0 * c3 * x + 2.0 * c2 if c3 else 2.0 * c2


def jerk_in(piece: Piece, x: float) -> float:
    """Return the jerk at local time x of a piece."""
    if not isinstance(piece, tuple):
        return piece.state(x)[3]
    _, _, _, c3, amplitude, omega, phase = piece
    if amplitude:
        return -amplitude * omega * omega * omega * cos(omega * x + phase)
    return 6.0 * c3


def all_in(piece: Piece, x: float) -> State:
    """Return position, velocity, acceleration and jerk at local time x of a piece."""
    if not isinstance(piece, tuple):
        return piece.state(x)
    return position_in(piece, x), velocity_in(piece, x), acceleration_in(piece, x), jerk_in(piece, x)


def still_points(piece: Piece, duration: float) -> tuple[float, ...]:
    """Return the local times inside (0, duration) at which the velocity is zero.

    They are in order.
    """
    if not isinstance(piece, tuple):
        return piece.roots(1, duration)
    _, c1, c2, c3, amplitude, omega, phase = piece
    if amplitude:
        cosine = -c1 / (amplitude * omega)
        return _inside(duration, (acos(cosine) - phase) / omega) if -1.0 < cosine < 1.0 else ()
    if c3 == 0.0:
        return _inside(duration, -0.5 * c1 / c2) if c2 else ()
    return _inside(duration, *_quadratic(3.0 * c3, 2.0 * c2, c1))


def even_points(piece: Piece, duration: float) -> tuple[float, ...]:
    """Return the local times inside (0, duration) at which the acceleration is zero.

    A half wave has none.
    """
    if not isinstance(piece, tuple):
        return piece.roots(2, duration)
    _, _, c2, c3, amplitude, _, _ = piece
    if amplitude or c3 == 0.0:
        return ()
    return _inside(duration, -c2 / (3.0 * c3))


def crest_points(piece: Piece, duration: float) -> tuple[float, ...]:
    """Return the local times inside (0, duration) of acceleration peaks.

    Only sine pieces have any.
    """
    if not isinstance(piece, tuple):
        return piece.roots(3, duration)
    _, _, _, _, amplitude, omega, phase = piece
    return _inside(duration, (0.5 * pi - phase) / omega) if amplitude else ()


@overload
def recentred(piece: Plain, x: float) -> Plain: ...
@overload
def recentred(piece: Piece, x: float) -> Piece: ...
def recentred(piece: Piece, x: float) -> Piece:
    """Return the same curve with local time counted from x."""
    if x == 0.0:
        return piece
    if not isinstance(piece, tuple):
        return piece.recentred(x)
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p = ((c3 * x + c2) * x + c1) * x + c0
    v = (3.0 * c3 * x + 2.0 * c2) * x + c1
    return (p, v, 3.0 * c3 * x + c2, c3, amplitude, omega, phase + omega * x)


def transformed(piece: Piece, factor: float, before: float, after: float) -> Piece:
    """Map position `before` to `after` exactly, and scale distances by `factor`."""
    if not isinstance(piece, tuple):
        return piece.transformed(factor, before, after)
    c0, c1, c2, c3, amplitude, omega, phase = piece
    return (
        (c0 - before) * factor + after,
        c1 * factor,
        c2 * factor,
        c3 * factor,
        amplitude * factor,
        omega,
        phase,
    )


def _inside(duration: float, *times: float) -> tuple[float, ...]:
    return tuple(sorted(t for t in times if 0.0 < t < duration))


def _quadratic(a: float, b: float, c: float) -> tuple[float, ...]:
    """Return the real roots of a x^2 + b x + c, a != 0, without cancellation."""
    under = b * b - 4.0 * a * c
    if not 0.0 <= under < inf:
        return ()
    q = -0.5 * (b + copysign(sqrt(under), b))
    return (q / a, c / q) if q else (0.0,)
