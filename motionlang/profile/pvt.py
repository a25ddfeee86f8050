"""Copley's PVT: cubic pieces through given positions and velocities at given times."""

from __future__ import annotations

from math import inf

from motionlang.profile.curve import Profile, from_curve
from motionlang.profile.limits import check_finite, check_positive, too_large

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.profile.ramps import Piece


def pvt_segment(p0: float, v0: float, p1: float, v1: float, time: float) -> Profile:
    """One cubic from position p0 at velocity v0 to p1 at v1 in `time` seconds."""
    return plan_pvt((p0, p1), (v0, v1), (time,))


def plan_pvt(points: Sequence[float], velocities: Sequence[float | None], times: Sequence[float]) -> Profile:
    """A profile through `points`, one of `times` (durations, seconds) fewer than points.

    A segment with a velocity of None at either end is linear (Copley's PT mode). Velocities may be empty:
    all linear. b2 = 3 (PT - P0)/T^2 - (2 V0 + VT)/T, b3 = (VT + V0)/T^2 + 2 (P0 - PT)/T^3 (Copley).
    """
    if not velocities:
        velocities = [None] * len(points)
    if not len(points) == len(velocities) == len(times) + 1:
        raise ValueError("a PVT profile needs one velocity per point and one time per segment")
    pieces: list[Piece] = []
    knots = [0.0]
    for i, time in enumerate(times):
        pieces.append(_segment(points[i], velocities[i], points[i + 1], velocities[i + 1], time))
        knots.append(knots[-1] + time)
    marks = tuple(("segment", i) for i in range(len(pieces)))
    curve = (tuple(knots), tuple(pieces), marks)
    last = velocities[-1] or 0.0
    return from_curve("pvt", points[0], points[-1], curve, pieces[0][1] if pieces else 0.0, last)


def average_velocities(points: Sequence[float], time: float) -> list[float]:
    """Copley's first guess for equal times: v = (P[n+1] - P[n-1])/(2T), zero at both ends."""
    inner = [(after - before) / (2.0 * time) for before, after in zip(points, points[2:], strict=False)]
    return [0.0, *inner, 0.0]


def refined_velocities(points: Sequence[float], velocities: Sequence[float], time: float) -> list[float]:
    """One sweep of Copley's refinement towards continuous acceleration, for equal times.

    Formula F2 for each inner point from the values already refined before it, F1 for the last.
    """
    v, p = list(velocities), points
    for n in range(1, len(p) - 1):
        step = (p[n + 1] - p[n - 1]) / time
        if n + 2 < len(p):
            v[n] = (12.0 * step - 4.0 * v[n - 1] + 3.0 * (p[n] - p[n + 2]) / time + v[n + 2]) / 15.0
        else:
            v[n] = (3.0 * step - v[n - 1] - v[n + 1]) / 4.0
    return v


def smooth_velocities(
    points: Sequence[float], times: Sequence[float], first: float = 0.0, last: float = 0.0
) -> list[float]:
    """The velocities at which the acceleration is continuous: the clamped cubic spline, any times.

    With h the times: V[n-1]/h[n-1] + 2 V[n] (1/h[n-1] + 1/h[n]) + V[n+1]/h[n] equals
    3 ((P[n] - P[n-1])/h[n-1]^2 + (P[n+1] - P[n])/h[n]^2); one tridiagonal solve.
    """
    if len(points) != len(times) + 1:
        raise ValueError("a spline needs one time per segment")
    for time in times:
        check_positive(segment_time=time)
    slopes = [(after - before) / h for before, after, h in zip(points, points[1:], times, strict=False)]
    upper, right = [0.0], [first]
    for n in range(1, len(points) - 1):
        left, ahead = 1.0 / times[n - 1], 1.0 / times[n]
        pivot = 2.0 * (left + ahead) - left * upper[-1]
        load = 3.0 * (slopes[n - 1] * left + slopes[n] * ahead)
        right.append((load - left * right[-1]) / pivot)
        upper.append(ahead / pivot)
    v = [last]
    for up, value in zip(reversed(upper), reversed(right), strict=True):
        v.append(value - up * v[-1])
    return v[::-1]


def _segment(p0: float, v0: float | None, p1: float, v1: float | None, time: float) -> Piece:
    check_positive(segment_time=time)
    check_finite(position=p0, target=p1, start_velocity=v0 or 0.0, end_velocity=v1 or 0.0)
    step = (p1 - p0) / time
    if v0 is None or v1 is None:
        return (p0, step, 0.0, 0.0, 0.0, 0.0, 0.0)
    b2 = (3.0 * step - 2.0 * v0 - v1) / time
    b3 = (v0 + v1 - 2.0 * step) / (time * time)
    if not abs(b2) + abs(b3) < inf:
        raise too_large()
    return (p0, v0, b2, b3, 0.0, 0.0, 0.0)
