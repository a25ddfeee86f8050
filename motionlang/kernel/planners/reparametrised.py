"""A curve travelled over time: position = curve(distance(time)) + lift.

The curve is itself a `Profile` whose "time" is the distance along a path, or the position of a master: a
line, an arc (one sine), a cam table (cubics). All cycles of a cam share one curve, each with its own `lift`. The
pieces of the result, one for each section of the motion on one piece of the curve, are made when they are read.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from math import inf

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.formula import chain
from motionlang.kernel.planners.pieces import position_in, recentred, still_points, transformed, velocity_in
from motionlang.kernel.planners.ramps import Curve, Piece
from motionlang.kernel.planners.root import bracketed_root

# Curves whose edges are cached: those of a few paths and cams.
_MAX_CACHED = 32
# Pieces of a short curve.
_SHORT = 8
# Fraction of a duration from its ends within which a motion that turns has not moved.
_NEAR = 1e-7
# Fraction of a curve by which rounding may exceed its end. Its first and last piece apply that far.
AT_END = 1e-11


class Reparametrised(Profile):
    """`path` travelled with the motion `along`; linear beyond its ends."""

    __slots__ = ("along", "lift", "path")

    is_large = True

    def __init__(self, along: Profile, path: Profile, shape: str = "", lift: float = 0.0) -> None:
        self.along, self.path, self.lift = along, path, lift
        (start, rising), (end, falling) = _on(path, along.start), _on(path, along.end)
        recipe = rising * along.start_velocity, falling * along.end_velocity
        super().__init__(shape or along.shape, start + lift, end + lift, along.duration, recipe)

    def _made(self) -> Curve:
        return _composed(self.along, self.path, self.lift)

    def piece_at(self, time: float) -> tuple[Piece, float]:
        """Return the piece in force at a time from 0 up to the duration, and the time since its knot.

        It is one of the list, unless the curve is so long that the list is only made for a search.
        """
        if len(self.path.pieces) <= _SHORT:
            return super().piece_at(time)
        piece, x = self.along.piece_at(time)
        edges, outer, begins = _edges(self.path)
        i = bisect_right(edges, position_in(piece, x))
        return _over(outer[i], begins[i], piece, self.lift), x

    @property
    def speed_bound(self) -> float:
        """An upper bound of the absolute velocity: highest speed times highest slope."""
        path = self.path
        return self.along.speed_bound * max(path.peak_speed, abs(path.start_velocity), abs(path.end_velocity))

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `position`, or None if there is none; a long table is looked up."""
        times = [self.along.crossing(each, after) for each in _distances(self.path, position - self.lift)]
        return min((time for time in times if time is not None), default=None)


def travelled(along: Profile, path: Profile, shape: str = "", lift: float = 0.0) -> Profile:
    """Return `path` travelled with the motion `along`, displaced by `lift`.

    If the travelled section is straight, the result has the ramps of `along`.
    """
    knots, pieces, _ = path.curve
    i = 0
    if len(pieces) > 1:
        low, high = along.extrema()
        last = len(pieces) - 1
        i = min(max(bisect_left(knots, low) - 1, 0), last)
        if high > knots[i + 1] and low == knots[i + 1] and i < last:
            i += 1
        if i < last and high > knots[i + 1]:
            return Reparametrised(along, path, shape, lift)
    piece = pieces[i]
    if not isinstance(piece, tuple) or any(piece[2:5]):
        return Reparametrised(along, path, shape, lift)
    made = along.scaled(piece[0] + piece[1] * (along.start - knots[i]) + lift, piece[1])
    made.shape = shape or along.shape
    return made


def _composed(along: Profile, path: Profile, lift: float) -> Curve:
    edges, outer, begins = _edges(path)
    knots, pieces, marks = [0.0], list[Piece](), list[tuple[str, int]]()
    on = -1
    names = {first: name for name, first in along.curve[2]}
    for n, (piece, (begin, finish)) in enumerate(zip(along.pieces, pairwise(along.knots), strict=True)):
        if n in names:
            marks.append((names[n], len(pieces)))
        for x, i in _sections(piece, finish - begin, edges, path.duration):
            made = _over(outer[i], begins[i], piece, lift)
            if x and i == on and isinstance(made, tuple):
                continue  # a plain piece turns here
            on = i
            if x:
                knots.append(begin + x)
            pieces.append(recentred(made, x))
        knots.append(finish)
    return tuple(knots), tuple(pieces), tuple(marks)


def _over(outer: Piece, begin: float, inner: Piece, lift: float) -> Piece:
    return chain(transformed(outer, 1.0, 0.0, lift), transformed(inner, 1.0, begin, 0.0))


def _sections(
    piece: Piece, duration: float, edges: list[float], length: float
) -> Iterator[tuple[float, int]]:
    """Yield when a piece of the motion enters a piece of the curve or turns, and which piece it is then on."""
    low = 0.0
    turns = [x for x in still_points(piece, duration) if _NEAR * duration < x < duration * (1.0 - _NEAR)]
    for high in (*turns, duration):
        here = position_in(piece, low)
        there = here + velocity_in(piece, low) * inf if high == inf else position_in(piece, high)
        if not there < here and not there > here:
            there = here
        if there < here:
            i = bisect_left(edges, here) if here > 0.0 else 0
            steps = range(i - 1, bisect_right(edges, there) - 1, -1)
        else:
            i = bisect_right(edges, here) if here < length or there == here else len(edges)
            steps = range(i, bisect_left(edges, there))
        yield low, i
        for k in steps:
            yield _reached(piece, edges[k], low, high, there > here), k + (there > here)
        low = high


def _reached(piece: Piece, edge: float, low: float, high: float, rising: bool) -> float:
    if high == inf:
        return low + (edge - position_in(piece, low)) / velocity_in(piece, low)
    return bracketed_root(lambda x: (position_in(piece, x) - edge, velocity_in(piece, x)), low, high, rising)


@lru_cache(_MAX_CACHED)
def _edges(path: Profile) -> tuple[list[float], list[Piece], list[float]]:
    """Return the distances that divide a curve and its continuations, their pieces, and the knot of each piece.

    They are the knots and extrema of the curve, its ends by a rounding farther out.
    """
    length, (knots, pieces, _) = path.duration, path.curve
    edges: list[float] = [-AT_END * length]
    outer: list[Piece] = [(path.start, path.start_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)]
    begins = [0.0]
    for piece, (begin, finish) in zip(pieces, pairwise(knots), strict=True):
        for x in (*still_points(piece, finish - begin), finish - begin):
            edges.append(begin + x)
            outer.append(piece)
            begins.append(begin)
    edges[-1] = length * (1.0 + AT_END)
    return edges, [*outer, (path.end, path.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)], [*begins, length]


@lru_cache(_MAX_CACHED)
def _distances(path: Profile, position: float) -> list[float]:
    """Return the distances at which a curve or a continuation is at `position`; of a rest both ends."""
    edges, outer, begins = _edges(path)
    edges = [0.0, *edges[1:-1], path.duration]
    rows = [*zip(edges, outer[1:], begins[1:], strict=True)]
    values = [position_in(piece, edge - begin) for edge, piece, begin in rows]
    found = [edge for edge, value in zip(edges, values, strict=True) if value == position]
    for (low, piece, begin), high, (a, b) in zip(rows, edges[1:], pairwise(values), strict=False):
        if (a - position) * (b - position) < 0.0:
            found.append(
                begin
                + _reached(transformed(piece, 1.0, position, 0.0), 0.0, low - begin, high - begin, a < b)
            )
    for edge, value, slope in (
        (0.0, path.start, path.start_velocity),
        (edges[-1], path.end, path.end_velocity),
    ):
        distance = (position - value) / slope if slope else 0.0
        if distance and (distance < 0.0) is not bool(edge):
            found.append(edge + distance)
    return found


def _on(path: Profile, distance: float) -> tuple[float, float]:
    """Return position and slope of the curve, or of its straight continuation."""
    if distance < 0.0:
        slope = path.start_velocity
        return path.start + slope * distance if slope else path.start, slope
    return path.position(distance), path.velocity(distance)
