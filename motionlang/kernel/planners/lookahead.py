"""Speed over a sequence of segments with individual limits, to rest at its end.

For some shapes the distance of a ramp is proportional to the difference of the squares of its speeds (a trapezoid,
PMC's two S-curves). For them, one pass backwards and one forwards over the squares at the joins find the fastest
course: each pass lowers a join only as far as any course must. The other shapes use the same two passes over the
speeds. At a join the acceleration of every shape but the trapezoid is zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain, pairwise
from math import inf, sqrt

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.limits import check_finite, check_positive
from motionlang.kernel.planners.segment_speed import Ramp, between, entry_speed, exit_speed, reaches
from motionlang.kernel.planners.shapes import Ramps, ramps_of
from motionlang.kernel.planners.transition import Steps, joined
from motionlang.kernel.tools import total

# How far a course may overshoot its end, as a fraction of its length, before it counts as overshooting.
_SLACK = 1e-9


@dataclass(eq=False, slots=True)
class PathPace:
    """The limits of a path: `shape`, speed, rates, and the parameters of the S-curves."""

    shape: str
    speed: float
    accel: float
    decel: float
    ramp: float = 0.1
    accel_jerk: float = inf
    decel_jerk: float = inf

    def key(self) -> tuple[object, ...]:
        """Return the values that two segments must share to be planned as one."""
        return (
            self.shape,
            self.speed,
            self.accel,
            self.decel,
            self.ramp,
            self.accel_jerk,
            self.decel_jerk,
        )

    def ramps(self) -> Ramps:
        """Return the ramps of the shape."""
        return ramps_of(self.shape, self.accel, self.decel, self.ramp, self.accel_jerk, self.decel_jerk)


def plan_course(
    stretches: Sequence[tuple[float, PathPace]],
    start: float,
    v0: float,
    a0: float = 0.0,
    joins: Sequence[float] = (),
) -> Profile | None:
    """Plan a run through `stretches` (length and pace of each) to rest at the end.

    It begins at position `start`, counted from the beginning of the first segment, at speed v0 >= 0 and
    acceleration a0, which only jerk-limited ramps use. `joins` are further limits on the speed from
    one segment to the next. A run that begins too fast brakes as hard as allowed; None if it cannot stop
    at its end. Raises ValueError for numbers that no machine can follow.
    """
    check_finite(position=start, start_velocity=v0, start_acceleration=a0)
    for _, pace in stretches:
        check_positive(speed=pace.speed, acceleration=pace.accel, deceleration=pace.decel)
    lengths = [length for length, _ in stretches]
    end, passed = total(lengths), start
    if start > end * (1.0 + _SLACK):
        return None
    for i, length in enumerate(lengths):
        lengths[i] = max(0.0, length - passed)
        passed = max(0.0, passed - length)
    paces = [pace for _, pace in stretches]
    caps: list[float] = []
    if len(paces) > 1:
        caps = [min(a.speed, b.speed) for a, b in pairwise(paces)]
        if joins:
            caps = [min(cap, limit) for cap, limit in zip(caps, joins, strict=True)]
    found = _ramps_of(lengths, paces, caps, v0, a0)
    if found is None:
        return None
    count, steps, ramps = found
    profile = _joined(paces[0].shape, start, end, v0, a0, steps, ramps)
    return profile if count == 1 else _eased(profile, stretches, joins, count - 1)


def _eased(
    profile: Profile, stretches: Sequence[tuple[float, PathPace]], joins: Sequence[float], slowed: int
) -> Profile:
    """Plan again from the stretch on which a run that began too fast has slowed down.

    `slowed` stretches are before it. They were run at the slowest pace of all stretches up to it; from there each may
    have its own pace. Return the new plan if it is shorter in time.
    """
    distance = total(length for length, _ in stretches[:slowed])
    time = profile.crossing(distance)
    if time is None:
        return profile
    here = profile.at(time)
    rest = plan_course(stretches[slowed:], 0.0, here.velocity, here.acceleration, joins[slowed:])
    if rest is None or not time + rest.duration < profile.duration:
        return profile
    return profile.cut(time).then(rest.scaled(here.position, 1.0)).ending_at(profile.end)


def _ramps_of(
    lengths: list[float], paces: list[PathPace], caps: list[float], v0: float, a0: float
) -> tuple[int, Steps, list[Ramp]] | None:
    """Return the ramps of a run, and how many first stretches are run as one."""
    ramps = [pace.ramps() for pace in paces]
    factors = [each.squares for each in ramps if each.squares is not None]
    if len(factors) == len(ramps):
        speeds = _by_squares(lengths, factors, caps, v0)
        return None if speeds is None else (1, *_between_all(lengths, paces, ramps, speeds, a0))
    latest = _back(lengths, paces, ramps, caps)
    for k in range(1, len(lengths) + 1):
        # A run that begins too fast for its first segment uses the slowest pace of as many segments as it
        # needs.
        slow = _slowest(paces[:k])
        distance, own, target = total(lengths[:k]), slow.ramps(), min(latest[k], slow.speed)
        best = exit_speed(own, distance, v0, a0, target)
        leaving = best if best is not None and best < target else target
        if not reaches(own, distance * (1.0 + _SLACK), v0, a0, leaving):
            continue
        speeds = [v0, leaving]
        for i in range(k, len(lengths)):
            following = exit_speed(ramps[i], lengths[i], speeds[-1], 0.0, latest[i + 1])
            speeds.append(latest[i + 1] if following is None else following)
        merged = [distance, *lengths[k:]], [slow, *paces[k:]], [own, *ramps[k:]]
        return k, *_between_all(*merged, speeds, a0)
    return None


def _by_squares(
    lengths: list[float], factors: list[tuple[float, float]], caps: list[float], v0: float
) -> list[float] | None:
    """Return the speeds at both ends and at the joins; None if it cannot stop in time.

    `factors` are the `squares` of the ramps of each segment.
    """
    latest = [0.0]
    for length, factor, cap in reversed(list(zip(lengths[1:], factors[1:], caps, strict=True))):
        latest.append(min(cap * cap, latest[-1] + 2.0 * length / factor[1]))
    squares = [v0 * v0]
    for length, factor in zip(lengths, factors, strict=True):
        before = squares[-1]
        fastest = min(latest.pop(), before + 2.0 * length / factor[0])
        squares.append(max(fastest, before - 2.0 * length / factor[1]))
    if squares[-1] * 0.5 * factors[-1][1] > _SLACK * total(lengths):
        return None
    return [v0, *(sqrt(square) for square in squares[1:-1]), 0.0]


def _back(lengths: list[float], paces: list[PathPace], ramps: list[Ramps], caps: list[float]) -> list[float]:
    """Return the highest feasible speed at the start of each segment; 0 at the end."""
    latest = [0.0]
    for i in range(len(lengths) - 1, 0, -1):
        latest.append(entry_speed(ramps[i], lengths[i], latest[-1], caps[i - 1]))
    latest.append(inf)
    latest.reverse()
    return latest


def _between_all(
    lengths: list[float], paces: list[PathPace], ramps: list[Ramps], speeds: list[float], a0: float
) -> tuple[Steps, list[Ramp]]:
    steps, first = between(ramps[0], lengths[0], paces[0].speed, speeds[0], a0, speeds[1])
    found = list(first)
    for i in range(1, len(lengths)):
        found += between(ramps[i], lengths[i], paces[i].speed, speeds[i], 0.0, speeds[i + 1])[1]
    return steps, found


def _slowest(paces: list[PathPace]) -> PathPace:
    """Return a pace that respects the limits of all given paces."""
    if len(paces) == 1:
        return paces[0]
    first = paces[0]
    return PathPace(
        first.shape,
        min(pace.speed for pace in paces),
        min(pace.accel for pace in paces),
        min(pace.decel for pace in paces),
        first.ramp,
        min(pace.accel_jerk for pace in paces),
        min(pace.decel_jerk for pace in paces),
    )


def _joined(
    shape: str, start: float, end: float, v0: float, a0: float, steps: Steps, ramps: list[Ramp]
) -> Profile:
    """Return the profile of the given steps and ramps; adjoining ramps are merged."""
    rows: list[Ramp] = []
    for ramp in ramps:
        if not ramp[1] > 0.0:
            continue
        if rows and _goes_on(rows[-1], ramp):
            ramp = (rows[-1][0], rows.pop()[1] + ramp[1], 0.0, ramp[3])
        rows.append(ramp)
    recipe = (*chain.from_iterable([row[:3] for row in rows]), rows[-1][3]) if rows else (0.0, 0.0, 0.0, 0.0)
    return joined(shape, start, end, (v0, a0, steps, 1.0), recipe)


def _goes_on(before: Ramp, ramp: Ramp) -> bool:
    if before[2] != 0.0 or ramp[2] != 0.0 or before[3] != ramp[0]:
        return False
    rate, following = (before[3] - before[0]) / before[1], (ramp[3] - ramp[0]) / ramp[1]
    return abs(rate - following) <= 1e-12 * abs(rate)
