"""The geometry of a commanded path: directions, shares of axes, positions."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, ceil, copysign, cos, fsum, hypot, pi, sin

from tests.proof.order import PathOrder
from tests.proof.segments import rotation


class PathLayout:
    """A commanded path, laid out from its start, in user units.

    `unit` is the direction of a line, None for an arc. For an arc, `angle_rate` is the angle of the radius
    per distance along the path and `begin` its initial direction. `flat` is the fraction of the distance in
    its plane, `climbs` are the fractions of the further axes. `stretch` is the distance in space per unit of
    the nominal length. `origin` is the distance, along the direction of a line, from the point where all axes
    are at 0 to its start.
    """

    def __init__(self, path: PathOrder, starts: Sequence[float]) -> None:
        self.path, self.starts = path, starts
        self.first = [start / k for start, k in zip(starts, path.scales, strict=True)]
        self.ends = end_positions(path, starts)
        deltas = [(end - start) / k for start, end, k in zip(starts, self.ends, path.scales, strict=True)]
        self.angle_rate = 0.0
        self.unit: list[float] | None = None
        if path.line or not path.angle:
            space = hypot(*deltas)
            self.length = space if path.length is None else path.length
            self.unit = [delta / space for delta in deltas] if space else deltas
            self.stretch = space / self.length if self.length else 1.0
            along = fsum(u * start for u, start in zip(self.unit, self.first, strict=True))
            self.origin = along / self.stretch if space else 0.0
            return
        i, j = path.plane
        self.centre = _centre(path, starts)
        x, y = self.first[i] - self.centre[0], self.first[j] - self.centre[1]
        self.radius = hypot(x, y)
        climbs = [0.0 if k in path.plane else delta for k, delta in enumerate(deltas)]
        round_ = self.radius * abs(path.angle) * pi / 180.0
        self.length = hypot(round_, *climbs) if path.length is None else path.length
        size = self.length or 1.0
        self.stretch = 1.0
        self.flat, self.angle_rate = round_ / size, abs(path.angle) * pi / 180.0 / size
        self.begin = atan2(y, x)
        self.climbs = [abs(climb) / size for climb in climbs]

    def slopes(self, first: float, last: float) -> list[float]:
        """Return each axis's largest fraction of the path speed between two distances."""
        if self.unit is not None:
            return [abs(each) * self.stretch for each in self.unit]
        angles = self._angles(first, last, 0.0)
        found = list(self.climbs)
        found[self.path.plane[0]] = self.flat * max(abs(sin(angle)) for angle in angles)
        found[self.path.plane[1]] = self.flat * max(abs(cos(angle)) for angle in angles)
        return found

    def rates(self, first: float, last: float, rate: float, speed: float) -> list[float]:
        """Return each axis's largest acceleration between two distances along the path.

        `rate` and `speed` are the acceleration and the speed along the path.
        """
        if self.unit is not None:
            return [abs(each) * self.stretch * rate for each in self.unit]
        across = self.angle_rate * speed * speed
        both = atan2(across, rate)
        x = max(abs(sin(a)) * rate + abs(cos(a)) * across for a in self._angles(first, last, 0.5 * pi - both))
        y = max(abs(cos(a)) * rate + abs(sin(a)) * across for a in self._angles(first, last, both))
        found = [climb * rate for climb in self.climbs]
        found[self.path.plane[0]], found[self.path.plane[1]] = self.flat * x, self.flat * y
        return found

    def _angles(self, first: float, last: float, summit: float) -> list[float]:
        """Return the directions of the radius at two distances and at extrema in between.

        The extrema are at all quarters, and at `summit` counted from these.
        """
        angle_rate = copysign(self.angle_rate, self.path.angle)
        low, high = sorted((self.begin + angle_rate * first, self.begin + angle_rate * last))
        found = [low, high]
        high = min(high, low + 2.0 * pi)
        for angle in (0.0, summit, -summit):
            k = ceil((low - angle) / (0.5 * pi))
            while angle + k * 0.5 * pi < high and len(found) < 16:
                found.append(angle + k * 0.5 * pi)
                k += 1
        return found

    def at(self, along: float) -> list[float]:
        """Return the position, counts, at a distance along an arc."""
        angle = self.begin + copysign(self.angle_rate, self.path.angle) * along
        fraction = along / self.length
        found = [start + fraction * (end - start) for start, end in zip(self.starts, self.ends, strict=True)]
        (i, j), scales = self.path.plane, self.path.scales
        found[i] = (self.centre[0] + self.radius * cos(angle)) * scales[i]
        found[j] = (self.centre[1] + self.radius * sin(angle)) * scales[j]
        return found

    def off(self, positions: Sequence[float]) -> float:
        """Return the distance of a point, given in counts, from the path, user units."""
        point = [position / k for position, k in zip(positions, self.path.scales, strict=True)]
        if self.unit is not None:
            offsets = [p - f for p, f in zip(point, self.first, strict=True)]
            along = fsum(g * u for g, u in zip(offsets, self.unit, strict=True))
            return max(abs(g - along * u) for g, u in zip(offsets, self.unit, strict=True))
        i, j = self.path.plane
        return abs(hypot(point[i] - self.centre[0], point[j] - self.centre[1]) - self.radius)


def _centre(path: PathOrder, starts: Sequence[float]) -> tuple[float, float]:
    """Return the centre of an arc, user units."""
    x, y = (
        (c + (starts[k] if path.relative else 0.0)) / path.scales[k]
        for c, k in zip(path.centre, path.plane, strict=True)
    )
    return x, y


def end_positions(path: PathOrder, starts: Sequence[float]) -> list[float]:
    """Return the end of a path that begins at `starts`; both are in counts."""
    if path.line:
        return [s + t for s, t in zip(starts, path.line, strict=True)] if path.relative else list(path.line)
    rest = iter(path.rest)
    ends = [
        s if k in path.plane else next(rest) + (s if path.relative else 0.0) for k, s in enumerate(starts)
    ]
    centre, (i, j) = _centre(path, starts), path.plane
    x, y = rotation(
        starts[i] / path.scales[i] - centre[0], starts[j] / path.scales[j] - centre[1], path.angle
    )
    ends[i], ends[j] = (centre[0] + x) * path.scales[i], (centre[1] + y) * path.scales[j]
    return ends
