"""Copley's PVT: cubic and linear pieces through given positions at given times."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from motionlang.kernel.planners.curve import Profile, from_curve
from motionlang.kernel.planners.limits import check_finite, check_positive, too_large
from motionlang.kernel.planners.pieces import velocity_in
from motionlang.kernel.planners.ramps import Piece, Plain


def plan_pvt(points: Sequence[float], velocities: Sequence[float | None], times: Sequence[float]) -> Profile:
    """Return a profile through `points`.

    `times` are the durations of the segments, s, one fewer than the points. A point whose velocity is None is
    approached on a straight line (Copley's PT mode); a cubic that leaves it begins at the velocity of that line,
    or at rest at the first point. Velocities may be empty: then all pieces are linear.
    """
    if not velocities:
        velocities = [None] * len(points)
    if not len(points) == len(velocities) == len(times) + 1:
        raise ValueError("a PVT profile needs one velocity per point and one time per segment")
    check_finite(position=points[0], start_velocity=velocities[0] or 0.0)
    pieces: list[Piece] = []
    knots = [0.0]
    velocity = first = velocities[0] or 0.0
    for i, time in enumerate(times):
        piece = pvt_piece(points[i], velocity, points[i + 1], velocities[i + 1], time)
        pieces.append(piece)
        knots.append(knots[-1] + time)
        given = velocities[i + 1]
        velocity = piece[1] if given is None else given
    if pieces:
        first = velocity_in(pieces[0], 0.0)
    marks = tuple(("segment", i) for i in range(len(pieces)))
    curve = (tuple(knots), tuple(pieces), marks)
    return from_curve("pvt", points[0], points[-1], curve, first, velocities[-1] or 0.0)


def pvt_piece(p0: float, v0: float, p1: float, v1: float | None, time: float) -> Plain:
    """Return the piece of one segment: linear if `v1` is None, or Copley's cubic.

    b0 = P0, b1 = V0, b2 = 3 (PT - P0)/T^2 - (2 V0 + VT)/T, b3 = (VT + V0)/T^2 + 2 (P0 - PT)/T^3.
    """
    check_positive(segment_time=time)
    step = (p1 - p0) / time
    check_finite(target=p1, velocity=step if v1 is None else v1)
    if v1 is None:
        return (p0, step, 0.0, 0.0, 0.0, 0.0, 0.0)
    b2 = (3.0 * step - 2.0 * v0 - v1) / time
    b3 = (v0 + v1 - 2.0 * step) / time / time
    if not abs(b2) + abs(b3) < inf:
        raise too_large()
    return (p0, v0, b2, b3, 0.0, 0.0, 0.0)
