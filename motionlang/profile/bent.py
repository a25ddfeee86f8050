"""A move to a target from any velocity and acceleration, in ramps of bounded jerk."""

from __future__ import annotations

from math import copysign, inf

from motionlang.profile.approach import approach, is_rounding
from motionlang.profile.between import between
from motionlang.profile.curve import Profile, relabelled
from motionlang.profile.fade import fade, fade_distance, faded
from motionlang.profile.limits import too_large
from motionlang.profile.ramps import ramp_distance
from motionlang.profile.total import total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.profile.approach import Ramps


def bent_approach(ramps: Ramps, start: float, target: float, speed: float, v0: float, a0: float) -> Profile:
    """The move from `start` at velocity v0 and acceleration a0, which is not 0, to rest at `target`.

    Where it cannot stop at the target, or runs the wrong way, it stops first, and then moves there from rest.
    """
    assert ramps.bounds is not None
    sign = copysign(1.0, v0 or a0)
    u, b = sign * v0, sign * a0
    steps, after = fade(ramps.bounds, u, b, 0.0)
    bent = faded(start, u, b, steps, after, sign)
    if not (bent.duration < inf and abs(bent.end) < inf):
        raise too_large()
    if after < 0.0:
        return bent.then(approach(ramps, bent.end, target, speed, sign * after))
    time, kind = ramps.down(after, 0.0)
    stopping = fade_distance(u, b, steps) + ramp_distance(after, time, kind, 0.0)
    ahead = sign * (target - start)
    if is_rounding(stopping - ahead, stopping, start, target):
        return _arriving(bent, target, (sign * after, time, kind, 0.0))
    if stopping > ahead:
        if after == 0.0:
            return relabelled(bent, "scurve", "stop").then(approach(ramps, bent.end, target, speed, 0.0))
        return bent.then(approach(ramps, bent.end, target, speed, sign * after))
    steps, rows = between(ramps, ahead, speed, u, b, 0.0)
    recipe = [value if i else value * sign for row in rows for i, value in enumerate(row[:3])]
    return _arriving(faded(start, u, b, steps, rows[0][0], sign), target, (*recipe, 0.0))


def _arriving(bent: Profile, target: float, recipe: tuple[float, ...]) -> Profile:
    """`bent`, and then the ramps of a recipe to `target`."""
    time = total(recipe[1::3])
    if not time < inf:
        raise too_large()
    if time > 0.0:
        return bent.then(Profile("scurve", bent.end, target, time, recipe))
    bent.end = target
    return bent
