"""The geometry of paths: lines and arcs of several axes.

They are measured in user units and run in counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import acos, atan2, cos, degrees, hypot, inf, pi, radians, sin, sqrt
from typing import TypeVar

from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.arc import arc_over, direction, line_over, rotated
from motionlang.kernel.tools import total

_Value = TypeVar("_Value")


class PathSegment:
    """One path laid out: `length` in user units and each axis's curve in counts.

    `entry` and `leaving` are the tangents at its ends, in user units per unit of length; `curvature` is the curvature
    (1/radius) of the path. `starts` are the exact start positions of an arc whose end a language gives.
    """

    __slots__ = ("curvature", "curves", "ends", "entry", "leaving", "length", "starts")

    def __init__(
        self,
        length: float,
        curves: Sequence[Profile],
        ends: Sequence[float],
        entry: Sequence[float],
        leaving: Sequence[float],
        curvature: float = 0.0,
    ) -> None:
        self.length, self.curves, self.ends = length, curves, ends
        self.entry, self.leaving, self.curvature = entry, leaving, curvature
        self.starts: Sequence[float] | None = None

    def shift(self, k: int, by: float) -> None:
        """Add `by` counts to the positions of axis index k, for another zero."""
        if self.length:
            self.curves = [each.shifted(by) if i == k else each for i, each in enumerate(self.curves)]
        self.ends = [each + by if i == k else each for i, each in enumerate(self.ends)]
        if self.starts is not None:
            self.starts = [each + by if i == k else each for i, each in enumerate(self.starts)]

    def steepest(self, k: int) -> float:
        """Return the largest number of counts of axis index k per user unit of path."""
        return self.curves[k].peak_speed


class StraightLine:
    """A line to `targets`, counts; `length`, if given, replaces the distance in space."""

    __slots__ = ("length", "targets")

    def __init__(self, targets: Sequence[float], length: float | None = None) -> None:
        self.targets, self.length = targets, length

    def moved(self, starts: Sequence[float]) -> StraightLine:
        """Return the geometry with its coordinates counted from `starts`."""
        return StraightLine(
            [start + target for start, target in zip(starts, self.targets, strict=True)], self.length
        )

    def shift(self, k: int, by: float) -> None:
        """Add `by` counts to the positions of axis index k."""
        self.targets = [each + by if i == k else each for i, each in enumerate(self.targets)]

    def ends(self, starts: Sequence[float], scales: Sequence[float]) -> Sequence[float]:
        """Return the end positions, counts."""
        return self.targets

    def lay(self, starts: Sequence[float], scales: Sequence[float]) -> PathSegment:
        deltas = [(end - start) / k for start, end, k in zip(starts, self.targets, scales, strict=True)]
        length = hypot(*deltas) if self.length is None else self.length
        if length == 0.0:
            return PathSegment(0.0, (), self.targets, (), ())
        curves = [line_over(length, a, b) for a, b in zip(starts, self.targets, strict=True)]
        tangent = [x / length for x in deltas]
        return PathSegment(length, curves, self.targets, tangent, tangent)


@dataclass(eq=False, slots=True)
class Arc:
    """An arc about `centre` (counts of two axes) by `angle` degrees.

    A positive angle turns from the first of them to the second. Further axes move linearly to `rest`: a helix, whose
    length is that of the curve in space unless `length` is given. `plane` are the indices of the two among the axes;
    `arrives` is their end, if a language gives it.
    """

    centre: Sequence[float]
    angle: float
    rest: Sequence[float] = ()
    length: float | None = None
    plane: tuple[int, int] = (0, 1)
    arrives: Sequence[float] | None = None

    def moved(self, starts: Sequence[float]) -> Arc:
        """Return the geometry with its coordinates counted from `starts`."""
        (x, y), others = self._split(starts)
        rest = [start + value for start, value in zip(others, self.rest, strict=True)]
        arrives = None if self.arrives is None else (self.arrives[0] + x, self.arrives[1] + y)
        centre = self.centre[0] + x, self.centre[1] + y
        return Arc(centre, self.angle, rest, self.length, self.plane, arrives)

    def shift(self, k: int, by: float) -> None:
        """Add `by` counts to the positions of axis index k."""
        if k not in self.plane:
            index = [i for i in range(len(self.rest) + 2) if i not in self.plane].index(k)
            self.rest = [each + by if i == index else each for i, each in enumerate(self.rest)]
            return
        shifts = [by if each == k else 0.0 for each in self.plane]
        self.centre = self.centre[0] + shifts[0], self.centre[1] + shifts[1]
        if self.arrives is not None:
            self.arrives = self.arrives[0] + shifts[0], self.arrives[1] + shifts[1]

    def ends(self, starts: Sequence[float], scales: Sequence[float]) -> Sequence[float]:
        """Return the end positions, counts."""
        start, scale = self._split(starts)[0], self._split(scales)[0]
        _, last = self._radii(start, scale)
        return self._joined(self._end(start, last, scale), self.rest)

    def lay(self, starts: Sequence[float], scales: Sequence[float]) -> PathSegment:
        (start, others), (scale, along) = self._split(starts), self._split(scales)
        (x, y), (out_x, out_y) = self._radii(start, scale)
        radius, sweep = hypot(x, y), radians(self.angle)
        climbs = [(end - start) / k for start, end, k in zip(others, self.rest, along, strict=True)]
        round_ = radius * abs(sweep)
        length = hypot(round_, *climbs) if self.length is None else self.length
        end = self._end(start, (out_x, out_y), scale)
        ends = self._joined(end, self.rest)
        if length == 0.0:
            return PathSegment(0.0, (), ends, (), ())
        if round_ == 0.0:
            return StraightLine(ends, self.length).lay(starts, scales)
        angle = direction(x, y)
        curves = self._joined(
            [
                arc_over(length, self.centre[i], radius * scale[i], angle, sweep, end[i], cosine=i == 0)
                for i in (0, 1)
            ],
            [line_over(length, a, b) for a, b in zip(others, self.rest, strict=True)],
        )
        slopes = [climb / length for climb in climbs]
        flat = (round_ / length) * (1.0 if sweep > 0.0 else -1.0)
        entry = self._joined((-y / radius * flat, x / radius * flat), slopes)
        leaving = self._joined((-out_y / radius * flat, out_x / radius * flat), slopes)
        laid = PathSegment(length, curves, ends, entry, leaving, abs(sweep) / length)
        laid.starts = starts if self.arrives is not None else None
        return laid

    def _radii(
        self, start: Sequence[float], scale: Sequence[float]
    ) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return the vectors from the centre to both ends of the arc, user units."""
        (cx, cy), (kx, ky) = self.centre, scale
        x, y = (start[0] - cx) / kx, (start[1] - cy) / ky
        return (x, y), rotated(x, y, self.angle)

    def _end(self, start: Sequence[float], last: Sequence[float], scale: Sequence[float]) -> Sequence[float]:
        """Return the end of the arc, counts.

        `last` leads there from the centre, in user units.
        """
        if self.arrives is not None:
            return self.arrives
        if self.angle % 360.0 == 0.0:
            return start
        (cx, cy), (kx, ky) = self.centre, scale
        return cx + last[0] * kx, cy + last[1] * ky

    def _split(self, values: Sequence[float]) -> tuple[tuple[float, float], list[float]]:
        """Return the values of the two axes of the circle and of the other axes."""
        i, j = self.plane
        if not values[2:]:
            return (values[i], values[j]), []
        others = list(values)
        del others[max(i, j)], others[min(i, j)]
        return (values[i], values[j]), others

    def _joined(self, plane: Sequence[_Value], others: Sequence[_Value]) -> list[_Value]:
        """Merge the values of the circle and of the other axes, one for each axis."""
        i, j = self.plane
        if (i, j) == (0, 1):
            return [*plane, *others]
        values = list(others)
        values.insert(min(i, j), plane[0 if i < j else 1])
        values.insert(max(i, j), plane[1 if i < j else 0])
        return values


def corner(before: PathSegment, after: PathSegment) -> float:
    """Return the angle, degrees, between the directions of two segments."""
    if not before.length or not after.length:
        return 180.0
    cosine = total(a * b for a, b in zip(before.leaving, after.entry, strict=True))
    if cosine > 0.9:  # for a small angle the chord is more precise than the cosine
        chord = hypot(*(a - b for a, b in zip(before.leaving, after.entry, strict=True)))
        return 2.0 * degrees(acos(sqrt(max(0.0, 1.0 - 0.25 * chord * chord))))
    return degrees(acos(max(-1.0, cosine)))


def limits(
    segment: PathSegment, speeds: Sequence[float], accels: Sequence[float], decels: Sequence[float]
) -> tuple[float, float, float]:
    """Return the highest speed and rates along the path that respect every axis limit.

    Infinite means no limit. On an arc an axis accelerates both by the curvature and by the change of speed. Each of
    the two may use the same share of the axis's limit, the largest that respects it where they add up most (1/√2 on a
    complete circle).
    """
    speed = accel = decel = inf
    if not segment.length:
        return speed, accel, decel
    for k, (most, up, down) in enumerate(zip(speeds, accels, decels, strict=True)):
        if most == up == down == inf:
            continue
        steepest = segment.steepest(k)
        bend, share = _bend(segment.curves[k])
        if steepest:
            speed = min(speed, most / steepest)
            accel, decel = min(accel, share * up / steepest), min(decel, share * down / steepest)
        if bend:
            speed = min(speed, sqrt(share * min(up, down) / bend))
    return speed, accel, decel


def _bend(curve: Profile) -> tuple[float, float]:
    """Return the largest second derivative of a curve, and the share of a limit.

    Curvature and change of speed may each use that share of an acceleration limit.
    """
    slope = bend = 0.0
    angles: list[float] = []
    waves = [
        (piece[4:], finish - begin)
        for piece, (begin, finish) in zip(curve.pieces, pairwise(curve.knots), strict=True)
        if isinstance(piece, tuple) and piece[4]
    ]
    if not waves:
        return 0.0, 1.0
    for (_, omega, phase), span in waves:
        last = phase + omega * span
        inside = [0.5 * pi] if phase < 0.5 * pi < last else []
        angles += [phase, *inside, last]
        slope = max(slope, *(abs(cos(angle)) for angle in (phase, *inside, last)))
        bend = max(bend, *(abs(sin(angle)) for angle in (phase, *inside, last)))
    both = atan2(slope, bend)
    for (_, omega, phase), span in waves:
        angles += [angle for angle in (both, pi - both) if phase < angle < phase + omega * span]
    worst = max(abs(cos(x)) / slope + abs(sin(x)) / bend for x in angles)  # the cosine of no float is 0
    (amplitude, omega, _), _ = waves[0]
    return abs(amplitude) * omega * omega * bend, 1.0 / worst
