"""A curve travelled over time: position = curve(distance(time)) + lift.

The curve is itself a `Profile` whose "time" is the distance along a path, or the position of a master: a
line, an arc (one sine), a cam table (cubics). So every closed form for profiles also applies to curves. All
cycles of a cam share one curve, each with its own `lift`.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from functools import lru_cache
from math import inf, nextafter

from motionlang.kernel.planners.curve import MotionState, Phase, Profile
from motionlang.kernel.planners.formula import FormulaProfile
from motionlang.kernel.planners.pieces import acceleration_in, position_in, still_points, velocity_in
from motionlang.kernel.planners.ramps import Piece

_MAX_CROSSINGS = 10_000
# Curves and positions whose crossings are cached: a program watches a few positions of a few cams.
_MAX_CACHED = 32

# Fractions of a duration by which two crossings at an extremum may differ, and by which one may be inexact.
_EXTREMUM = 1e-7
_ROUNDING = 1e-14
# Fraction of a curve by which rounding may exceed its end. The curvature of the curve applies that far.
AT_END = 1e-9


class Reparametrised(FormulaProfile):
    """`curve` travelled with the motion `along`; linear beyond its ends.

    At an end itself, rounding decides which side a distance is on. There the curve has the curvature that it has
    inside.
    """

    __slots__ = ("_knots", "along", "lift", "path")

    _knots: tuple[float, ...]

    def __init__(self, along: Profile, path: Profile, shape: str = "", lift: float = 0.0) -> None:
        self.along, self.path, self.lift = along, path, lift
        start, rising = _on(path, along.start)
        end, falling = _on(path, along.end)
        super().__init__(
            shape or along.shape,
            start + lift,
            end + lift,
            along.duration,
            rising * along.start_velocity,
            falling * along.end_velocity,
        )

    def state(self, time: float) -> MotionState:
        """Return the state by the chain rule: v = f' s', a = f'' s'^2 + f' s'', etc."""
        s = self.along.at(time)
        if 0.0 <= s.position < self.path.duration:
            f = self.path.at(s.position)
            v, a = s.velocity, s.acceleration
            return MotionState(
                f.position + self.lift,
                f.velocity * v,
                f.acceleration * v * v + f.velocity * a,
                (f.jerk * v * v + 3.0 * f.acceleration * a) * v + f.velocity * s.jerk,
            )
        position, slope = _on(self.path, s.position)
        bend = _bend_at_end(self.path, s.position)
        v, a = s.velocity, s.acceleration
        return MotionState(
            position + self.lift, slope * v, bend * v * v + slope * a, 3.0 * bend * v * a + slope * s.jerk
        )

    # Searches call these three for many times; each equals the component of `state` to the last bit.

    def position(self, time: float) -> float:
        found = self._inside(time)
        return super().position(time) if found is None else position_in(*found[2:]) + self.lift

    def velocity(self, time: float) -> float:
        found = self._inside(time)
        if found is None:
            return super().velocity(time)
        moving, x, piece, distance = found
        return velocity_in(piece, distance) * velocity_in(moving, x)

    def acceleration(self, time: float) -> float:
        """Return the acceleration at `time`; 0 before the beginning and after the end."""
        found = self._inside(time)
        if found is None:
            return super().acceleration(time)
        moving, x, piece, distance = found
        v, slope = velocity_in(moving, x), velocity_in(piece, distance)
        return acceleration_in(piece, distance) * v * v + slope * acceleration_in(moving, x)

    def _inside(self, time: float) -> tuple[Piece, float, Piece, float] | None:
        """Return the pieces of the motion and of the curve at `time`.

        Each is followed by its local argument. None outside either of them, and if one has no pieces.
        """
        along, path = self.along, self.path
        if not (along.pieced and path.pieced and 0.0 < time < along.duration):
            return None
        piece, x = along.piece_at(time)
        distance = position_in(piece, x)
        return (piece, x, *path.piece_at(distance)) if 0.0 < distance < path.duration else None

    @property
    def knots(self) -> tuple[float, ...]:
        """The knots of the motion, and the times at which it passes knots of the curve.

        Extrema of the curve count as its knots. The knots are computed on first use and cached, because a sequence of
        profiles that grows with each change of a path reads those of all its members again.
        """
        try:
            return self._knots
        except AttributeError:
            found = set(self.along.knots)
            low, high = self.along.extrema()
            for distance in knot_distances(self.path):
                if low <= distance <= high:
                    found.update(crossings(self.along, distance))
            self._knots = tuple(sorted(found))
            return self._knots

    @property
    def phases(self) -> tuple[Phase, ...]:
        """The phases of the motion, each with the distance and velocities of this profile."""
        made, begin = [], 0.0
        for phase in self.along.phases:
            finish = begin + phase.duration
            here, there = self.at(begin), self.at(finish) if finish < inf else None
            distance = self.end - here.position if there is None else there.position - here.position
            v1 = self.end_velocity if there is None else there.velocity
            made.append(Phase(phase.name, phase.duration, distance, here.velocity, v1))
            begin = finish
        return tuple(made)

    @property
    def peak_speed(self) -> float:
        """The largest absolute velocity; closed form at uniform speed along the curve."""
        speed = _uniform_speed(self.along)
        if speed is None:
            return super().peak_speed
        low, high = self.along.extrema()
        path, slopes = self._travelled_section(low, high), [0.0]
        if path is not None:
            slopes.append(path.peak_speed)
        if low < 0.0:
            slopes.append(abs(self.path.start_velocity))
        if high > self.path.duration:
            slopes.append(abs(self.path.end_velocity))
        return speed * max(slopes)

    @property
    def speed_bound(self) -> float:
        """An upper bound of the absolute velocity: highest speed times highest slope."""
        path = self.path
        return self.along.speed_bound * max(path.peak_speed, abs(path.start_velocity), abs(path.end_velocity))

    @property
    def peak_acceleration(self) -> float:
        """The largest absolute acceleration; closed form at uniform speed along the curve."""
        speed = _uniform_speed(self.along)
        if speed is None:
            return super().peak_acceleration
        path = self._travelled_section(*self.along.extrema())
        return 0.0 if path is None else speed * speed * path.peak_acceleration

    def crossing(self, position: float, after: float = 0.0) -> float | None:
        """Return the first time >= `after` at `position`, or None if there is none."""
        times = [self.along.crossing(distance, after) for distance in self._distances_at(position)]
        return min((time for time in times if time is not None), default=None)

    def velocity_check(self, velocity: float, after: float) -> float:
        """Return when to compare the velocity again: at `velocity` or at the next knot.

        At uniform speed along the curve its slope is that of the velocity, so the crossing is one of the curve.
        """
        piece = self.along.cubic(after)
        if piece is None or any(piece[2][2:]) or not piece[2][1] > 0.0:
            return super().velocity_check(velocity, after)
        speed, here = piece[2][1], self.along.position(after)
        if not 0.0 <= here < self.path.duration:
            return super().velocity_check(velocity, after)
        until = self.next_knot(after)
        distance = self.path.velocity_crossing(velocity / speed, here)
        return until if distance is None else min(until, after + (distance - here) / speed)

    def extrema(self) -> tuple[float, float]:
        """Return the smallest and the largest position, including extrema inside."""
        low, high = self.along.extrema()
        inside = (distance for distance in knot_distances(self.path) if low <= distance <= high)
        seen = [_on(self.path, distance)[0] + self.lift for distance in (low, high, *inside)]
        return min(seen), max(seen)

    def cut(self, time: float) -> Profile:
        """Return the first `time` seconds, exactly."""
        if time >= self.duration:
            return self
        return Reparametrised(self.along.cut(time), self.path, self.shape, self.lift)

    def after(self, time: float) -> Profile:
        """Return the rest after `time` seconds, with its clock starting at 0."""
        if time <= 0.0:
            return self
        return Reparametrised(self.along.after(time), self.path, self.shape, self.lift)

    def scaled(self, start: float, factor: float) -> Profile:
        """Return the same motion from `start`, with every distance times `factor`."""
        if factor == 1.0:
            return Reparametrised(self.along, self.path, self.shape, self.lift + (start - self.start))
        begin = start + (self.path.start + self.lift - self.start) * factor
        return Reparametrised(self.along, self.path.scaled(begin, factor), self.shape)

    def _travelled_section(self, low: float, high: float) -> Profile | None:
        """Return the section of the curve between two distances; None if it is empty."""
        length = self.path.duration
        if low >= length or high <= 0.0:
            return None
        path = self.path.cut(high) if high < length else self.path
        return path.after(low) if low > 0.0 else path

    def _distances_at(self, position: float) -> list[float]:
        """Return all distances at which the curve is at `position`.

        Distances on its straight continuations are included.
        """
        path, position = self.path, position - self.lift
        found = list(_cached_crossings(path, position))
        for end, slope, edge in (
            (path.start, path.start_velocity, 0.0),
            (path.end, path.end_velocity, path.duration),
        ):
            distance = edge + (position - end) / slope if slope else edge
            if slope and (distance < edge if edge == 0.0 else distance > edge):
                found.append(distance)
        return found


def travelled(along: Profile, path: Profile, shape: str = "", lift: float = 0.0) -> Profile:
    """Return `path` travelled with the motion `along`, displaced by `lift`.

    If the travelled section is straight, the result consists of plain pieces.
    """
    knots, pieces, _ = path.curve
    if len(pieces) == 1:
        if any(pieces[0][2:5]):
            return Reparametrised(along, path, shape, lift)
        return _straight(along, pieces[0], 0.0, shape, lift)
    low, high = along.extrema()
    last = len(pieces) - 1
    i = min(max(bisect_left(knots, low) - 1, 0), last)
    if high > knots[i + 1] and low == knots[i + 1] and i < last:
        i += 1
    if (i == last or high <= knots[i + 1]) and not any(pieces[i][2:5]):
        return _straight(along, pieces[i], knots[i], shape, lift)
    return Reparametrised(along, path, shape, lift)


def _uniform_speed(along: Profile) -> float | None:
    if not along.pieced or len(along.pieces) != 1 or any(along.pieces[0][2:5]):
        return None
    return abs(along.pieces[0][1])


def _straight(along: Profile, piece: Piece, begin: float, shape: str, lift: float) -> Profile:
    made = along.scaled(piece[0] + piece[1] * (along.start - begin) + lift, piece[1])
    made.shape = shape or along.shape
    return made


def knot_distances(path: Profile) -> list[float]:
    """Return the knots and extrema of a curve."""
    found = list(path.knots)
    for piece, begin, finish in zip(path.pieces, path.knots, path.knots[1:], strict=False):
        found += [begin + x for x in still_points(piece, finish - begin)]
    return sorted(found)


def crossings(profile: Profile, position: float) -> list[float]:
    """Return all times at which a profile reaches `position`.

    For a rest at `position` that is its beginning. At an extremum, whose crossings are exact to a ten-millionth of the
    duration, two of them count as one unless the profile goes beyond `position` between them.
    """
    found: list[float] = []
    here = after = 0.0
    duration = 1.0 + min(profile.duration, 1e6)
    nearness, step = _EXTREMUM * duration, _ROUNDING * duration
    least = _ROUNDING * max(map(abs, (*profile.extrema(), position)))
    pause = step
    while len(found) < _MAX_CROSSINGS:
        time = profile.crossing(position, after)
        if time is None or time > profile.duration or time == inf:
            break
        stays = found and (
            time <= after
            or (time - here < nearness and abs(profile.position(0.5 * (here + time)) - position) <= least)
        )
        here = max(time, after)
        if not stays:
            found.append(time)
            after, pause = time + step, step
            continue
        # It rests, or is slow at an extremum: look further and further ahead, up to the next knot.
        next_knot = bisect_right(profile.knots, here)
        if next_knot == len(profile.knots):
            break
        after, pause = min((here + pause, 2.0 * pause), (profile.knots[next_knot], step))
    return found


@lru_cache(_MAX_CACHED)
def _cached_crossings(path: Profile, position: float) -> tuple[float, ...]:
    return tuple(crossings(path, position))


def _bend_at_end(path: Profile, distance: float) -> float:
    """Return the second derivative of the curve at an end, if `distance` is that end.

    Farther out it is 0.0.
    """
    length = path.duration
    if not -AT_END * length <= distance <= length * (1.0 + AT_END) < inf:
        return 0.0
    return path.acceleration(0.0 if distance < 0.0 else nextafter(length, 0.0))


def _on(path: Profile, distance: float) -> tuple[float, float]:
    """Return position and slope of the curve, or of its straight continuation."""
    if distance < 0.0:
        slope = path.start_velocity
        return path.start + slope * distance if slope else path.start, slope
    if distance > path.duration:
        slope = path.end_velocity
        return path.end + slope * (distance - path.duration) if slope else path.end, slope
    return path.position(distance), path.velocity(distance)
