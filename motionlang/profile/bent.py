"""A move to a target from any velocity and acceleration, in ramps of bounded jerk."""

from __future__ import annotations

from math import copysign, inf

from motionlang.profile.approach import approach, is_rounding
from motionlang.profile.between import between
from motionlang.profile.curve import Profile, relabelled
from motionlang.profile.fade import eased_speed, fade, fade_distance, faded
from motionlang.profile.limits import too_large
from motionlang.profile.ramps import ramp_distance
from motionlang.profile.total import total

# How far from its target a plan may end, as a part of the way, before its figures count as too far apart.
_ASTRAY = 1e-9

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.profile.approach import Ramps
    from motionlang.profile.fade import Bounds


def bent_approach(
    ramps: Ramps, start: float, target: float, speed: float, v0: float, a0: float
) -> Profile | None:
    """The move from `start` at velocity v0 and acceleration a0, which is not 0, to rest at `target`.

    Where it cannot stop at the target, or runs the wrong way, it stops first, and then moves there from rest. None
    where the figures are so many orders apart that rounding loses the target.
    """
    assert ramps.bounds is not None
    sign = copysign(1.0, v0 or a0)
    u, b = sign * v0, sign * a0
    steps, after = fade(ramps.bounds, u, b, 0.0)
    ahead = sign * (target - start)
    time, kind = ramps.down(after, 0.0) if after >= 0.0 else (0.0, 0.0)
    stopping = fade_distance(u, b, steps) + ramp_distance(after, time, kind, 0.0)
    if after >= 0.0 and stopping < ahead and not is_rounding(stopping - ahead, stopping, start, target):
        return _ahead(ramps, start, target, speed, u, b, sign)
    bent = faded(start, u, b, steps, after, sign)
    if not (bent.duration < inf and abs(bent.end) < inf):
        raise too_large()
    if after < 0.0:
        return bent.then(approach(ramps, bent.end, target, speed, sign * after))
    if is_rounding(stopping - ahead, stopping, start, target):
        return _arriving(bent, target, (sign * after, time, kind, 0.0))
    if after == 0.0:
        return relabelled(bent, "scurve", "stop").then(approach(ramps, bent.end, target, speed, 0.0))
    return bent.then(approach(ramps, bent.end, target, speed, sign * after))


def _ahead(
    ramps: Ramps, start: float, target: float, speed: float, u: float, b: float, sign: float
) -> Profile | None:
    """The same where the target lies beyond the shortest stop."""
    assert ramps.bounds is not None
    size = sign * (target - start)
    top = _peak(ramps, ramps.bounds, size, u, b)
    if top is None or speed <= eased_speed(ramps.bounds, u, b):
        steps, rows = between(ramps, size, speed, u, b, 0.0)
        recipe = [value if i else value * sign for row in rows for i, value in enumerate(row[:3])]
        return _arriving(faded(start, u, b, steps, rows[0][0], sign), target, (*recipe, 0.0))
    top = min(top, speed)
    steps, after = fade(ramps.bounds, u, b, top)
    first, kind = ramps.up(after, top)
    last, last_kind = ramps.down(top, 0.0)
    used = fade_distance(u, b, steps) + ramp_distance(after, first, kind, top)
    left = size - used - ramp_distance(top, last, last_kind, 0.0)
    slew = left / top if top == speed and left > 0.0 else 0.0
    v = sign * top
    bent = faded(start, u, b, steps, after, sign)
    return _arriving(bent, target, (sign * after, first, kind, v, slew, 0.0, v, last, last_kind, 0.0))


def _peak(ramps: Ramps, bounds: Bounds, size: float, u: float, b: float) -> float | None:
    """The speed from which the rest of the way is just enough to stop; None if it is not reached by speeding up.

    A ramp that has begun already is the end of one that began earlier without an acceleration.
    """
    jerk = bounds.accel_jerk if b > 0.0 else bounds.decel_jerk
    time = abs(b) / jerk
    if b > bounds.accel:
        return None
    rest = u - 0.5 * b * time
    if b < 0.0:
        rest = u + 0.5 * b * time
        room = size - (rest + jerk * time * time / 6.0) * time
        if rest <= 0.0 or room <= 0.5 * rest * ramps.down(rest, 0.0)[0]:
            return None
        return ramps.peak(rest, room)
    eased = u + 0.5 * b * time
    top = ramps.peak(rest, size + (rest + jerk * time * time / 6.0) * time)
    return top if top >= eased else None


def _arriving(bent: Profile, target: float, recipe: tuple[float, ...]) -> Profile | None:
    """`bent`, and then the ramps of a recipe to `target`; None where they end elsewhere."""
    time = total(recipe[1::3])
    if not time < inf:
        raise too_large()
    ways = [ramp_distance(*recipe[i : i + 4]) for i in range(0, len(recipe) - 1, 3)]
    way = target - bent.end
    if abs(total(ways) - way) > _ASTRAY * max(abs(target), abs(bent.start), abs(way), *map(abs, ways)):
        return None
    if time > 0.0:
        return bent.then(Profile("scurve", bent.end, target, time, recipe))
    bent.end = target
    return bent
