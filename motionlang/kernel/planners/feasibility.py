"""A move to a target from any velocity, independent of the shape of its ramps.

A shape answers three questions about speeds >= 0: how it speeds up, how it slows down (each as duration and
ramp kind), and which peak speed a move has that is too short for its slew speed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf, nextafter, sqrt

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.limits import STILL, check_finite, too_large
from motionlang.kernel.planners.ramps import Recipe, ramp_distance
from motionlang.kernel.planners.transition import Bounds
from motionlang.kernel.tools import total

Ramp = Callable[[float, float], tuple[float, float]]

Peak = Callable[[float, float], float]


# The fraction of a distance that is too large to be the rounding of its sum.
_COARSE = 1e-11


@dataclass(eq=False, slots=True)
class Ramps:
    """One shape with its limits: `up` and `down` between speeds, and its `peak` speed.

    `peak` takes the speed and the distance. Some shapes have ramps whose distance is k/2 times the difference of the
    squares of both speeds: `squares` has the k of speeding up and of slowing down. Ramps with limited jerk have
    `bounds`.
    """

    shape: str
    up: Ramp
    down: Ramp
    peak: Peak
    squares: tuple[float, float] | None = None
    bounds: Bounds | None = None


def stretched(shape: str, accel: float, decel: float, kind: float, stretch: float) -> Ramps:
    """Return symmetrical ramps that take `stretch` times as long as a trapezoid's.

    T = stretch |dv|/A, S = T (v1 + v2)/2.
    """
    up = stretch / accel
    down = stretch / decel

    def peak(u: float, size: float) -> float:
        return sqrt((2.0 * size + u * u * up) / (up + down))

    return Ramps(
        shape, lambda a, b: ((b - a) * up, kind), lambda a, b: ((a - b) * down, kind), peak, (up, down)
    )


def approach(ramps: Ramps, start: float, target: float, speed: float, v0: float) -> Profile:
    """Return the move from `start` at velocity `v0` to rest at `target`.

    If the axis moves away from the target, it stops first. If it is faster than `speed`, it brakes to `speed`
    first. If it is too fast to stop at the target, it stops beyond the target and returns.
    """
    if -STILL < v0 < STILL:
        v0 = 0.0
    distance = target - start
    sign = 1.0 if distance > 0.0 or (distance == 0.0 and v0 > 0.0) else -1.0
    size, u = abs(distance), sign * v0
    if u == 0.0:
        return finish(ramps.shape, start, target, (0.0, *_travel(ramps, size, speed, 0.0, sign)))
    time, kind = ramps.down(abs(u), 0.0)
    stopping = ramp_distance(abs(u), time, kind, 0.0)
    if u < 0.0:
        rest = _travel(ramps, size + stopping, speed, 0.0, sign)
        return finish(ramps.shape, start, target, (v0, time, kind, 0.0, *rest))
    beyond = stopping - size
    if is_rounding(beyond, stopping, start, target):
        return finish(ramps.shape, start, target, (v0, time, kind, 0.0))
    if beyond > 0.0:
        back = _travel(ramps, beyond, speed, 0.0, -sign)
        return finish(ramps.shape, start, target, (v0, time, kind, 0.0, *back))
    return finish(ramps.shape, start, target, (v0, *_travel(ramps, size, speed, u, sign)))


def is_rounding(beyond: float, stopping: float, start: float, target: float) -> bool:
    """True if a stop overshoots its target by no more than rounding.

    `stopping` is its length, `beyond` the overshoot.
    """
    return abs(beyond) <= 1e-12 * stopping + 2.3e-16 * (abs(start) + abs(target)) < inf


def from_rest(
    shape: str,
    start: float,
    target: float,
    speed: float,
    up: tuple[float, float],
    down: tuple[float, float],
    mean: float,
) -> Profile:
    """Return the move from rest for ramps whose time is proportional to the speed.

    `up` and `down` are (T/V, kind). A ramp's distance is `mean` V T. This case is separate from `approach` for speed:
    the running program plans nearly every move from rest.
    """
    distance = target - start
    size = distance if distance >= 0.0 else -distance
    rise, kind = up
    fall, last_kind = down
    per_square = mean * (rise + fall)
    ramps = speed * speed * per_square
    slew = 0.0
    if size >= ramps:
        slew = (size - ramps) / speed
    else:
        speed = sqrt(size / per_square)
    rise *= speed
    fall *= speed
    duration = rise + slew + fall
    if not duration < inf:
        check_finite(position=start, target=target)
        raise too_large()
    if distance < 0.0:
        speed = -speed
    return Profile(
        shape, start, target, duration, (0.0, rise, kind, speed, slew, 0.0, speed, fall, last_kind, 0.0)
    )


def finish(shape: str, start: float, target: float, recipe: Recipe) -> Profile:
    """Return the profile of a recipe that ends at rest at `target`.

    Raises ValueError if its duration is not finite.
    """
    duration = total(recipe[1::3])
    if not duration < inf:
        check_finite(position=start, target=target, start_velocity=recipe[0])
        raise too_large()
    return Profile(shape, start, target, duration, recipe)


def _travel(ramps: Ramps, size: float, speed: float, u: float, sign: float) -> Recipe:
    """Return ramps that cover `size` in direction `sign`, from speed u >= 0 to rest."""
    if u > speed:
        v, slewing = _braked(ramps, size, speed, u)
        first, kind = ramps.down(u, v)
    else:
        v = ramps.peak(u, size)
        slewing = v >= speed
        v = max(u, min(v, speed))  # not below u by rounding
        first, kind = ramps.up(u, v)
    last, last_kind = ramps.down(v, 0.0)
    left = size - ramp_distance(u, first, kind, v) - ramp_distance(v, last, last_kind, 0.0)
    if not slewing and abs(left) > _COARSE * size:
        # If jerk hardly affects a long ramp, the last bit of the peak makes a noticeable distance. Choose a
        # lower peak, and slew.
        while left < 0.0 and v > u:
            v = nextafter(v, 0.0)
            first, kind = ramps.up(u, v)
            last, last_kind = ramps.down(v, 0.0)
            left = size - ramp_distance(u, first, kind, v) - ramp_distance(v, last, last_kind, 0.0)
        slewing = v > 0.0
    slew = left / v if slewing and left > 0.0 else 0.0
    v *= sign
    return (first, kind, v, slew, 0.0, v, last, last_kind, 0.0)


def _braked(ramps: Ramps, size: float, speed: float, u: float) -> tuple[float, bool]:
    """Return the speed to brake to, and true if a section at that speed follows.

    With limited jerk, two ramps down need more distance than one. If that distance is missing, the slew speed
    is raised above `speed` until the distance suffices (own arithmetic).
    """
    if _braking(ramps, u, speed) <= size:
        return speed, True
    low, high = speed, u
    while True:
        v = 0.5 * (low + high)
        if v in (low, high):
            return high, True
        if _braking(ramps, u, v) <= size:
            high = v
        else:
            low = v


def _braking(ramps: Ramps, u: float, v: float) -> float:
    first, kind = ramps.down(u, v)
    last, last_kind = ramps.down(v, 0.0)
    return ramp_distance(u, first, kind, v) + ramp_distance(v, last, last_kind, 0.0)
