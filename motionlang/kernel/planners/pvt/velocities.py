"""Velocities for positions at given times.

The methods are Copley's averages, his refinement, and the exact solution. `times` is one duration for every
segment, or one per segment (seconds). Copley's note derives its formulas for equal times only. Here they come from
the same condition, equal acceleration on both sides of a point, for any times: V[n-1]/h[n-1] + 2 V[n]
(1/h[n-1] + 1/h[n]) + V[n+1]/h[n] = 3 (s[n-1]/h[n-1] + s[n]/h[n]), with h the times and s[n] = (P[n+1] -
P[n])/h[n].
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from motionlang.kernel.planners.limits import check_finite, check_positive

Times = float | Sequence[float]

# The ways to choose a velocity at each point, and what each is.
VELOCITY_METHODS: dict[str, str] = {
    "zero": "every velocity zero: the drive stops at each point",
    "average": "the mean velocity over the two segments that meet at the point, zero at both ends",
    "refine": "the average, then sweeps of the formulas F2 and F1 towards continuous acceleration",
    "exact": "the velocities at which the acceleration is continuous everywhere: the clamped cubic spline",
}


def pvt_velocities(method: str, points: Sequence[float], times: Times, sweeps: int = 1) -> list[float]:
    """Return one velocity per point, by one of `VELOCITY_METHODS`.

    Raises ValueError for an unknown method or impossible points.
    """
    if method == "zero":
        _segment_times(points, times)
        return [0.0] * len(points)
    if method == "average":
        return average_velocities(points, times)
    if method == "refine":
        velocities = average_velocities(points, times)
        for _ in range(sweeps):
            velocities = refined_velocities(points, velocities, times)
        return velocities
    if method == "exact":
        return smooth_velocities(points, times)
    raise ValueError(
        f"there is no method {method!r} to choose velocities; choose from {', '.join(VELOCITY_METHODS)}"
    )


def average_velocities(
    points: Sequence[float], times: Times, first: float = 0.0, last: float = 0.0
) -> list[float]:
    """Return Copley's first guess: v[n] = (P[n+1] - P[n-1]) / (h[n-1] + h[n]).

    `first` and `last` are the velocities at the ends.
    """
    h = _segment_times(points, times)
    inner = [(points[n + 1] - points[n - 1]) / (h[n - 1] + h[n]) for n in range(1, len(h))]
    return [first, *inner, last]


def refined_velocities(points: Sequence[float], velocities: Sequence[float], times: Times) -> list[float]:
    """Refine velocities by one sweep of Copley's method.

    F2 gives each inner point from the refined velocity of the point before it. F1 finds V1 from V0 and V2; F2 finds
    V1 from V0 and V3, with V2 eliminated. The last inner point has no V3 and uses F1. The end velocities do
    not change.
    """
    h = _segment_times(points, times)
    if len(velocities) != len(points):
        raise ValueError("the refinement needs one velocity per point")
    v = list(velocities)
    for n in range(1, len(h)):
        before, middle, load = _condition(points, h, n)
        load -= before * v[n - 1]
        if n + 1 < len(h):
            left, pivot, further = _condition(points, h, n + 1)
            load -= left / pivot * (further - v[n + 2] / h[n + 1])
            middle -= left / pivot / h[n]
        else:
            load -= v[n + 1] / h[n]
        v[n] = load / middle
    return v


def smooth_velocities(
    points: Sequence[float], times: Times, first: float = 0.0, last: float = 0.0
) -> list[float]:
    """Return the velocities at which the acceleration is continuous.

    This is the clamped cubic spline, one tridiagonal solve.
    """
    h = _segment_times(points, times)
    ratio, right = [0.0], [first]
    for n in range(1, len(h)):
        left, middle, load = _condition(points, h, n)
        pivot = middle - left * ratio[-1]
        right.append((load - left * right[-1]) / pivot)
        ratio.append(1.0 / h[n] / pivot)
    v = [last]
    for up, value in zip(reversed(ratio), reversed(right), strict=True):
        v.append(value - up * v[-1])
    return v[::-1]


def knot_accelerations(
    points: Sequence[float], velocities: Sequence[float], times: Times
) -> list[tuple[float, float]]:
    """Return the accelerations before and after each point; 0 outside the move.

    a(0) = 2 b2 and a(T) = 2 b2 + 6 b3 T of the segments that meet there.
    """
    h = _segment_times(points, times)
    before, after = [0.0], []
    for n, time in enumerate(h):
        step = (points[n + 1] - points[n]) / time
        v0, v1 = velocities[n], velocities[n + 1]
        after.append((6.0 * step - 4.0 * v0 - 2.0 * v1) / time)
        before.append((2.0 * v0 + 4.0 * v1 - 6.0 * step) / time)
    return list(zip(before, [*after, 0.0], strict=True))


def largest_jump(points: Sequence[float], velocities: Sequence[float], times: Times) -> float:
    """Return the largest acceleration jump at an inner point.

    Copley's note uses it as the measure of a rough move.
    """
    sides = knot_accelerations(points, velocities, times)[1:-1]
    return max((abs(after - before) for before, after in sides), default=0.0)


def compare_velocities(
    points: Sequence[float], times: Times, sweeps: Sequence[int] = (1, 2)
) -> list[tuple[str, list[float], float]]:
    """Return each method with its velocities and its largest acceleration jump.

    These are the figures of the comparison in Copley's note.
    """
    rows: list[tuple[str, int]] = [
        ("zero", 0),
        ("average", 0),
        *(("refine", n) for n in sweeps),
        ("exact", 0),
    ]
    table = []
    for method, count in rows:
        v = pvt_velocities(method, points, times, count)
        name = method if method != "refine" else f"{count} sweep{'s' if count > 1 else ''}"
        table.append((name, v, largest_jump(points, v, times)))
    return table


def _condition(points: Sequence[float], h: Sequence[float], n: int) -> tuple[float, float, float]:
    """Return the coefficients of the condition at point n.

    They are 1/h[n-1], the factor of V[n], and the right-hand side.
    """
    left, ahead = 1.0 / h[n - 1], 1.0 / h[n]
    load = 3.0 * ((points[n] - points[n - 1]) * left * left + (points[n + 1] - points[n]) * ahead * ahead)
    return left, 2.0 * (left + ahead), load


def _segment_times(points: Sequence[float], times: Times) -> list[float]:
    if len(points) < 2:
        raise ValueError("a PVT move needs at least two points")
    count = len(points) - 1
    h = [float(times)] * count if isinstance(times, (int, float)) else list(times)
    if len(h) != count:
        raise ValueError(f"{len(points)} points have {count} segments between them, not {len(h)}")
    for time in h:
        check_positive(segment_time=time)
    for point in points:
        if not isfinite(point):
            check_finite(position=point)
    return h
