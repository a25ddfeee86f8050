"""Where a path leads: straight lines and arcs of several axes, measured in user units, run in counts."""

from __future__ import annotations

from math import acos, degrees, hypot, inf, radians, sqrt

from motionlang.profile.arc import arc_over, direction, line_over, rotated
from motionlang.profile.total import total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.profile import Profile


class Segment:
    """One path laid out: its `length` in user units, and each axis's curve over that length, in counts.

    `entry` and `leaving` are unit tangents in user units; `turn` is the curvature (1/radius) of the path.
    """

    __slots__ = ("curves", "ends", "entry", "leaving", "length", "turn")

    def __init__(
        self,
        length: float,
        curves: Sequence[Profile],
        ends: Sequence[float],
        entry: Sequence[float],
        leaving: Sequence[float],
        turn: float = 0.0,
    ) -> None:
        self.length, self.curves, self.ends = length, curves, ends
        self.entry, self.leaving, self.turn = entry, leaving, turn

    def steepest(self, k: int) -> float:
        """The largest number of counts that axis number k of the path moves per user unit of path."""
        return self.curves[k].peak_speed


class Line:
    """Straight to `targets`, counts."""

    __slots__ = ("targets",)

    def __init__(self, targets: Sequence[float]) -> None:
        self.targets = targets

    def moved(self, starts: Sequence[float]) -> Line:
        """The same with its numbers counted from `starts`."""
        return Line([start + target for start, target in zip(starts, self.targets, strict=True)])

    def lay(self, starts: Sequence[float], scales: Sequence[float]) -> Segment:
        """The segment from `starts`."""
        way = [(end - start) / k for start, end, k in zip(starts, self.targets, scales, strict=True)]
        length = hypot(*way)
        if length == 0.0:
            return Segment(0.0, (), self.targets, (), ())
        curves = [line_over(length, a, b) for a, b in zip(starts, self.targets, strict=True)]
        tangent = [x / length for x in way]
        return Segment(length, curves, self.targets, tangent, tangent)


class Arc:
    """About `centre` (counts of the first two axes) by `angle` degrees, positive from the first axis to the second.

    Further axes go evenly to `targets`: a helix, whose length is that of the line in space.
    """

    __slots__ = ("angle", "centre", "rest")

    def __init__(self, centre: tuple[float, float], angle: float, rest: Sequence[float] = ()) -> None:
        self.centre, self.angle, self.rest = centre, angle, rest

    def moved(self, starts: Sequence[float]) -> Arc:
        """The same with its numbers counted from `starts`."""
        x, y, *others = starts
        rest = [start + value for start, value in zip(others, self.rest, strict=True)]
        return Arc((self.centre[0] + x, self.centre[1] + y), self.angle, rest)

    def ends(self, starts: Sequence[float], scales: Sequence[float]) -> list[float]:
        """Where it ends, counts."""
        (cx, cy), (kx, ky) = self.centre, scales[:2]
        if self.angle % 360.0 == 0.0:
            return [*starts[:2], *self.rest]
        x, y = rotated((starts[0] - cx) / kx, (starts[1] - cy) / ky, self.angle)
        return [cx + x * kx, cy + y * ky, *self.rest]

    def lay(self, starts: Sequence[float], scales: Sequence[float]) -> Segment:
        """The segment from `starts`."""
        (cx, cy), (kx, ky) = self.centre, scales[:2]
        x, y = (starts[0] - cx) / kx, (starts[1] - cy) / ky
        radius, sweep = hypot(x, y), radians(self.angle)
        climbs = [(end - start) / k for start, end, k in zip(starts[2:], self.rest, scales[2:], strict=True)]
        round_ = radius * abs(sweep)
        length, ends = hypot(round_, *climbs), self.ends(starts, scales)
        if length == 0.0:
            return Segment(0.0, (), ends, (), ())
        if round_ == 0.0:
            return Line(ends).lay(starts, scales)
        angle = direction(x, y)
        curves = [
            arc_over(length, cx, radius * kx, angle, sweep, ends[0], True),
            arc_over(length, cy, radius * ky, angle, sweep, ends[1], False),
            *(line_over(length, a, b) for a, b in zip(starts[2:], self.rest, strict=True)),
        ]
        slopes = [climb / length for climb in climbs]
        flat = (round_ / length) * (1.0 if sweep > 0.0 else -1.0)
        out_x, out_y = rotated(x, y, self.angle)
        entry = [-y / radius * flat, x / radius * flat, *slopes]
        leaving = [-out_y / radius * flat, out_x / radius * flat, *slopes]
        return Segment(length, curves, ends, entry, leaving, abs(sweep) / length)


def corner(before: Segment, after: Segment) -> float:
    """The angle, degrees, by which the direction changes from one segment to the next."""
    if not before.length or not after.length:
        return 180.0
    cosine = total(a * b for a, b in zip(before.leaving, after.entry, strict=True))
    if cosine > 0.9:  # the chord says more about a small angle than its cosine
        chord = hypot(*(a - b for a, b in zip(before.leaving, after.entry, strict=True)))
        return 2.0 * degrees(acos(sqrt(max(0.0, 1.0 - 0.25 * chord * chord))))
    return degrees(acos(max(-1.0, cosine)))


def limits(
    segment: Segment, speeds: Sequence[float], accels: Sequence[float], decels: Sequence[float]
) -> tuple[float, float, float]:
    """Speed, acceleration and deceleration along the path at which every axis keeps its own limits (infinite: none).

    On an arc half of the square of an axis's acceleration is left for changing direction, half for changing speed.
    """
    speed = accel = decel = inf
    if not segment.length:
        return speed, accel, decel
    share = sqrt(0.5) if segment.turn else 1.0
    for k, (most, up, down) in enumerate(zip(speeds, accels, decels, strict=True)):
        if most == up == down == inf:
            continue
        steepest = segment.steepest(k)
        if steepest == 0.0:
            continue
        speed = min(speed, most / steepest)
        if segment.turn:
            speed = min(speed, sqrt(share * min(up, down) / steepest / segment.turn))
        accel, decel = min(accel, share * up / steepest), min(decel, share * down / steepest)
    return speed, accel, decel
