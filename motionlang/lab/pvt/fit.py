"""Any motion as PVT points for a drive, in as few segments as a tolerance allows.

Knots lie on the motion, at whole milliseconds from its beginning. Their positions and velocities are rounded like
those sent to the drive. A segment may join two knots if the drive's cubic stays within the tolerance of the
motion everywhere between them. The fewest segments are then a shortest path, found layer by layer: all knots
that one segment reaches, all that two reach, and so on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners import PieceTable, Profile
from motionlang.kernel.tools import total
from motionlang.lab.pvt.points import Point, plan_points

Array = NDArray[np.float64]

Indices = NDArray[np.int64]

MILLISECOND = 0.001
MAX_SEGMENT_MS = 255
# Points per millisecond at which a candidate segment is compared with the motion.
FINE = 4
# Points per millisecond at which the finished fit is measured.
FINER = 20
# Longest motion, s, that is fitted; more candidates would exhaust the memory.
MAX_SPAN = 3600.0
ATTEMPTS = 4


class OutOfTolerance(ValueError):
    """Raised if no whole-millisecond segments stay within tolerance, from `time` on."""

    def __init__(self, tolerance: float, time: float) -> None:
        super().__init__(
            f"no PVT segments of 1 to {MAX_SEGMENT_MS} ms follow the motion to {tolerance:g} counts "
            f"beyond {time:.3f} s"
        )
        self.tolerance = tolerance
        self.time = time


@dataclass(frozen=True, slots=True)
class Fit:
    """Points that follow a motion, and their accuracy.

    `error` is the largest position difference (counts), at `error_time`.
    """

    points: list[Point]
    error: float
    error_time: float


@dataclass(frozen=True, slots=True)
class Rounding:
    """The resolution of the protocol: positions in counts, velocities in 0.1 counts/s."""

    position: float = 1.0
    velocity: float = 0.1


WIRE = Rounding()


def fit_track(
    starts: Sequence[float],
    profiles: Sequence[Profile],
    tolerance: float,
    begin: float,
    end: float,
    rounding: Rounding = WIRE,
) -> Fit:
    """Fit a history of moves between two times (seconds) to within `tolerance` counts.

    Raises ValueError for an invalid span or tolerance, and `OutOfTolerance` if the rounding or the motion
    itself (a jump) allows no fit.
    """
    if not 0.0 < end - begin <= MAX_SPAN:
        raise ValueError(f"a fit needs a motion of more than 0 and at most {MAX_SPAN:g} s")
    if not 0.0 < tolerance < np.inf:
        raise ValueError("the tolerance must be greater than zero")
    motion = _Motion(PieceTable(starts, profiles), begin, end, rounding)
    aim = tolerance
    for _ in range(ATTEMPTS):
        fit = motion.fitted(_shortest_path(motion, aim))
        if fit.error <= tolerance:
            return fit
        # Between the compared points the error was a little larger than at them: aim that much lower.
        aim *= 0.98 * tolerance / fit.error
    raise OutOfTolerance(tolerance, fit.error_time)


def least_tolerance(
    starts: Sequence[float], profiles: Sequence[Profile], above: float, begin: float, end: float
) -> float | None:
    """Return a tolerance just above the smallest one that a fit can meet, for a hint.

    None if that exceeds 1000 times `above`.
    """
    tolerance = above
    for _ in range(28):
        tolerance *= 1.28
        try:
            return fit_track(starts, profiles, tolerance, begin, end).error
        except OutOfTolerance:
            continue
    return None


class _Motion:
    """A motion sampled on the grid of candidates, and its rounded states at the knots."""

    def __init__(self, table: PieceTable, begin: float, end: float, rounding: Rounding) -> None:
        self.table, self.begin = table, begin
        self.steps = max(1, ceil((end - begin) / MILLISECOND - 1e-6))
        self.fine = table.sample(begin, MILLISECOND / FINE, self.steps * FINE + 1)
        self.positions = np.rint(self.fine[::FINE] / rounding.position) * rounding.position
        velocities = table.sample(begin, MILLISECOND, self.steps + 1, order=1)
        velocities[-1] = table.sample(end, MILLISECOND, 1, order=1)[0]
        self.velocities = np.rint(velocities / rounding.velocity) * rounding.velocity

    def errors(self, first: Indices, length: Indices, at: Indices) -> Array:
        """Return |cubic - motion| at fine points `at` after knot `first`.

        The segment lasts `length` milliseconds.
        """
        x = at / (length * FINE)
        last = first + length
        rise = self.positions[last] - self.positions[first]
        span = length * MILLISECOND
        v0, v1 = self.velocities[first] * span, self.velocities[last] * span
        cubic = x * (v0 + x * ((3.0 * rise - 2.0 * v0 - v1) + x * (v0 + v1 - 2.0 * rise)))
        error: Array = np.abs(cubic + self.positions[first] - self.fine[first * FINE + at])
        return error

    def worst(self, first: Indices, length: Indices) -> Array:
        """Return the largest error of each segment at all its fine points."""
        at = np.arange(0, int(length.max()) * FINE + 1)
        inside = np.minimum(at[None, :], (length * FINE)[:, None])
        largest: Array = self.errors(first[:, None], length[:, None], inside).max(axis=1)
        return largest

    def fitted(self, path: list[int]) -> Fit:
        """Return the points of a path of knots, and the largest error of a drive on them."""
        spans = [b - a for a, b in pairwise(path)]
        points = [
            Point(float(self.positions[k]), float(self.velocities[k]), span * MILLISECOND)
            for k, span in zip(path, [*spans, 0], strict=True)
        ]
        made = PieceTable([0.0], [plan_points(points)])
        return Fit(points, *_largest(self.table, self.begin, made, 0.0, self.steps))


def _shortest_path(motion: _Motion, tolerance: float) -> list[int]:
    """Return knots from 0 to the last with the fewest segments between them.

    Raises `OutOfTolerance` if there is no path.
    """
    parents = np.full(motion.steps + 1, -1, dtype=np.int64)
    parents[0] = 0
    layer = np.zeros(1, dtype=np.int64)
    while parents[motion.steps] < 0:
        found = _next_layer(motion, layer, parents, tolerance)
        if not len(found):
            reached = int(np.flatnonzero(parents >= 0)[-1])
            raise OutOfTolerance(tolerance, motion.begin + reached * MILLISECOND)
        layer = found
    path = [motion.steps]
    while path[-1]:
        path.append(int(parents[path[-1]]))
    return path[::-1]


def _next_layer(motion: _Motion, layer: Indices, parents: Indices, tolerance: float) -> Indices:
    """Return the knots that one more segment reaches, and record their parents."""
    first, length, score = _promising(motion, layer, parents, tolerance)
    found: list[Indices] = []
    while len(first):
        last = first + length
        # Of segments that fit equally well the first is tried first, whatever the rounding of the motion.
        order = np.lexsort((np.rint(score * 1e6), last))
        lead = np.ones(len(order), dtype=bool)
        lead[1:] = last[order][1:] != last[order][:-1]
        tried, waiting = order[lead], order[~lead]
        good = tried[motion.worst(first[tried], length[tried]) <= tolerance]
        parents[last[good]] = first[good]
        found.append(last[good])
        open_ = waiting[parents[last[waiting]] < 0]
        first, length, score = first[open_], length[open_], score[open_]
    return np.sort(np.concatenate(found)) if found else np.zeros(0, dtype=np.int64)


def _promising(
    motion: _Motion, layer: Indices, parents: Indices, tolerance: float
) -> tuple[Indices, Indices, Array]:
    """Return the segments from the layer to unreached knots that pass a coarse check.

    The check is at a few points of each segment; the error at these points is returned too.
    """
    first = np.repeat(layer, MAX_SEGMENT_MS)
    length = np.tile(np.arange(1, MAX_SEGMENT_MS + 1), len(layer))
    keep = first + length <= motion.steps
    first, length = first[keep], length[keep]
    keep = parents[first + length] < 0
    first, length = first[keep], length[keep]
    score = np.zeros(len(first))
    for sixteenths in (8, 4, 12, 0, 16, 2, 14, 6, 10):
        seen = motion.errors(first, length, length * FINE * sixteenths // 16)
        keep = seen <= tolerance
        first, length, score = first[keep], length[keep], np.maximum(score, seen)[keep]
    return first, length, score


def motion_error(
    starts: Sequence[float],
    profiles: Sequence[Profile],
    points: Sequence[Point],
    begin: float = 0.0,
    start_position: float = 0.0,
) -> tuple[float, float]:
    """Return the largest difference (counts) of `points` from a history, and its time.

    The time counts from `begin`. `start_position` is the motor position before the points, from which relative
    ones count.
    """
    made = PieceTable([0.0], [plan_points(points, start_position)])
    steps = round(total(point.time for point in points) / MILLISECOND)
    return _largest(PieceTable(starts, profiles), begin, made, 0.0, steps)


def track_error(
    starts: Sequence[float],
    profiles: Sequence[Profile],
    other_starts: Sequence[float],
    other_profiles: Sequence[Profile],
    begin: float,
    end: float,
) -> float:
    """Return the largest difference (counts) of two histories from `begin` to `end`."""
    steps = max(1, ceil((end - begin) / MILLISECOND))
    tables = PieceTable(starts, profiles), PieceTable(other_starts, other_profiles)
    return _largest(tables[0], begin, tables[1], begin, steps)[0]


def _largest(
    table: PieceTable, begin: float, other: PieceTable, other_begin: float, steps: int
) -> tuple[float, float]:
    count, step = steps * FINER + 1, MILLISECOND / FINER
    error = np.abs(table.sample(begin, step, count) - other.sample(other_begin, step, count))
    where = int(error.argmax())
    return float(error[where]), where * step
