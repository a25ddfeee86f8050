r"""Jerk-limited planning: Mint's S-ramp, a move of up to seven sections.

Problem. Move to a target and come to rest there, within limits on speed, acceleration and deceleration (ACCEL, DECEL),
and on how fast these two change (ACCELJERK, DECELJERK). The move may begin at any velocity and acceleration, since a
program may give a new target in motion. Nearly every move is planned while the program runs, so planning must be cheap.

Idea. A ramp is symmetric: the acceleration rises at constant jerk, stays at its peak, and falls at the same jerk.

    acceleration      ____
                     /    \
                    /      \
                 ──/        \────────\        /── time
                                      \      /
                                       \____/
    section        1   2   3     4    5   6   7        4 is the slew

A ramp over a change of speed V takes V/A + A/J if it reaches its peak A (V ≥ A²/J), and 2 √(V/J) if not. Its distance
is that time times the mean of both speeds. So the whole move follows from its top speed. That is the set speed or, if
the distance is too short, the speed at which both ramps fill the distance exactly.

The cases, in the order in which they are tried:
1. At rest, or moving to the target with no acceleration, not above the set speed and with enough distance to stop: two
   ramps and a slew. The top speed of a short move from rest is the root of a quadratic if both ramps reach their peak,
   and a cube root if neither does. Newton's method finds it in all other cases, and here it converges from one side.
2. In motion with an acceleration, target ahead (`_directly`). An acceleration that speeds up is treated as the middle
   of a ramp that began earlier at a lower speed, and case 1 holds from there. One that slows down is ramped down first.
3. Away from the target, or too fast to stop there (`_back`): stop, then move back from rest.
4. Anything else, such as a start above the set speed: `approach`, or `jerk_limited_approach` if there is an
   acceleration. They use the same ramps and search for the top speed where no closed form exists.

Data. The result is a `Profile` with a recipe (`ramps.py`): speeds joined by ramps, each with its duration and the
fraction of it in which the acceleration rises. A move that begins with an acceleration is a `JerkLimited`: sections of
constant jerk, then a recipe. Both become polynomials only when the curve is read. `u` and `b` are velocity and
acceleration in the direction of motion.

Invariants.
- The profile ends at rest at the target. Its acceleration is continuous and its duration finite.
- Speed, acceleration and jerk stay within their limits. A start above a limit returns within it.
- A reversal is at rest and without acceleration, unless the initial acceleration carries the motion through zero speed.
  A faster reversal would keep its acceleration; see `docs/contributing/decisions.md`.
- Figures too many orders of magnitude apart raise ValueError.

Cost. A few square roots. Newton's method, where it is needed, takes some five steps; the maximum in 20 000 random moves
was 15.
"""

from __future__ import annotations

from math import cbrt, inf, sqrt

from motionlang.kernel.planners.curve import Profile
from motionlang.kernel.planners.feasibility import Ramps, approach, is_rounding
from motionlang.kernel.planners.jerk_limited import JerkLimited, jerk_limited_approach
from motionlang.kernel.planners.limits import (
    LARGEST,
    SMALLEST,
    STILL,
    check_finite,
    check_positive,
    too_large,
)
from motionlang.kernel.planners.pieces import position_in
from motionlang.kernel.planners.ramps import FALLING, ramp_distance
from motionlang.kernel.planners.transition import HARDLY, NOTHING, Bounds, Steps

# How near to its target, as a fraction of the distance, a plan must end by itself to be accepted without a
# search.
_CLOSE = 1e-11
# The fraction of a speed, or of a distance, that must remain once an acceleration is ramped down, to plan on
# from there.
_MUCH = 1e-6
# Rates as far apart as this may miss the target by rounding; their plans are checked.
_FAR_APART = 1e9


def plan_jerk(
    start: float,
    target: float,
    speed: float,
    accel: float,
    decel: float,
    accel_jerk: float,
    decel_jerk: float,
    v0: float = 0.0,
    a0: float = 0.0,
) -> Profile:
    """Plan a move of up to seven sections within limits on speed, rates and jerk.

    Ramp to V: V/A + A/J if V >= A^2/J, else 2 sqrt(V/J); distance V T/2 (own arithmetic, from AN00118's
    definition of the S-ramp). A short move peaks at the speed at which the two ramps fill it exactly. An
    initial acceleration `a0` continues if it serves the move, and is ramped down if it does not
    (`initial_steps`). Raises ValueError like `plan_trapezoid`.
    """
    smooth = SMALLEST <= accel_jerk <= LARGEST and SMALLEST <= decel_jerk <= LARGEST
    steady = speed >= SMALLEST and accel >= SMALLEST and decel >= SMALLEST
    if not (smooth and steady and speed + accel + decel <= LARGEST):
        check_positive(
            speed=speed,
            acceleration=accel,
            deceleration=decel,
            acceleration_jerk=accel_jerk,
            deceleration_jerk=decel_jerk,
        )
        raise too_large()
    # Inlined because the running program plans nearly every move from rest, and replans in motion.
    distance = target - start
    size, u = (distance, v0) if distance >= 0.0 else (-distance, -v0)
    rise, fall = accel / accel_jerk, decel / decel_jerk
    if a0 == 0.0 and (u == 0.0 or (0.0 < u <= speed and _stops_within(size, u, decel, decel_jerk))):
        gain = speed - u
        first = gain / accel + rise if gain >= accel * rise else 2.0 * sqrt(gain / accel_jerk)
        last = speed / decel + fall if speed >= decel * fall else 2.0 * sqrt(speed / decel_jerk)
        slew = size / speed - 0.5 * (first + last) - 0.5 * u * first / speed
        if slew < 0.0:
            if u == 0.0:
                speed = peak_from_rest(size, accel, decel, accel_jerk, decel_jerk)
            else:
                speed = peak_speed(u, size, (accel, accel_jerk), (decel, decel_jerk))
            gain = max(speed - u, 0.0)
            first = gain / accel + rise if gain >= accel * rise else 2.0 * sqrt(gain / accel_jerk)
            last = speed / decel + fall if speed >= decel * fall else 2.0 * sqrt(speed / decel_jerk)
            slew = 0.0
        duration = first + slew + last
        if duration < inf:
            ratio = rise / first if first and gain >= accel * rise else 0.5
            last_ratio = fall / last if last and speed >= decel * fall else 0.5
            v = speed if distance >= 0.0 else -speed
            recipe = (v0, first, ratio, v, slew, 0.0, v, last, last_ratio, 0.0)
            return Profile("scurve", start, target, duration, recipe)
    if not abs(start) + abs(target) + abs(v0) + abs(a0) <= LARGEST:  # also NaN
        check_finite(position=start, target=target, start_velocity=v0, start_acceleration=a0)
    return _in_motion(start, target, speed, (accel, decel, accel_jerk, decel_jerk), v0, a0)


def _in_motion(
    start: float,
    target: float,
    speed: float,
    rates: tuple[float, float, float, float],
    v0: float,
    a0: float,
) -> Profile:
    """Plan a move that needs more than two ramps and a slew.

    `rates` are the four limits of `plan_jerk`.
    """
    far_apart = max(rates) > _FAR_APART * min(rates)
    direct = None if far_apart or not (v0 or a0) else _directly(start, target, speed, rates, v0, a0)
    if direct is not None:
        return direct
    ramps = jerk_ramps(*rates)
    if a0 == 0.0:
        # also reached from rest with figures too large: `approach` raises the error
        return approach(ramps, start, target, speed, v0)

    def straight(here: float, velocity: float) -> Profile:
        return plan_jerk(here, target, speed, *rates, velocity)

    made = jerk_limited_approach(ramps, start, target, speed, v0, a0, straight)
    if made is not None and not (far_apart and _is_astray(made)):
        return made
    eased = ease(start, v0, a0, rates[2] if a0 * v0 >= 0.0 else rates[3])
    made = eased.then(approach(ramps, eased.end, target, speed, eased.end_velocity))
    if _is_astray(made):
        raise too_large()
    return made


def _directly(
    start: float,
    target: float,
    speed: float,
    rates: tuple[float, float, float, float],
    v0: float,
    a0: float,
) -> Profile | None:
    """Return the plan from motion by a closed form; None if it needs a search.

    Planning in motion nearly always has a closed form. If the target lies ahead, an acceleration that speeds up is
    treated as the middle of a ramp that began earlier; one that slows down is ramped down before a ramp up begins. If
    the target does not lie ahead, the move stops first and starts again (`_back`). All other cases are left to the
    search of `jerk_limited_approach`.
    """
    accel, decel, accel_jerk, decel_jerk = rates
    sign = 1.0 if v0 > 0.0 or (v0 == 0.0 and a0 > 0.0) else -1.0
    u, b, size = v0 * sign, a0 * sign, (target - start) * sign
    if size <= 0.0 or b == 0.0:
        return _back(start, target, speed, rates, (u, b, sign))
    if b > 0.0:
        time = b / accel_jerk
        eased = u + 0.5 * b * time
        rest = u - 0.5 * b * time  # where the ramp would have begun
        before = (rest + accel_jerk * time * time / 6.0) * time
        if b > accel or speed <= eased or size + before <= 0.0:
            return _back(start, target, speed, rates, (u, b, sign))
    else:
        time = -b / decel_jerk
        eased = rest = u + 0.5 * b * time  # where the acceleration reaches zero
        before = -(rest + decel_jerk * time * time / 6.0) * time
        if not _MUCH * u < rest < speed or size + before <= _MUCH * size:  # it comes to rest instead
            return _back(start, target, speed, rates, (u, b, sign))
    room = size + before
    # A plan that reaches its speed needs no peak.
    top, gain = speed, speed - rest
    first, up = ramp_to(gain, accel, accel_jerk)
    last, down = ramp_to(top, decel, decel_jerk)
    slew = (room - 0.5 * (rest + speed) * first - 0.5 * speed * last) / speed
    if slew < 0.0:
        # True if a stop has the distance that it needs once the acceleration is zero. If not, there is no
        # ramp up.
        stop = ramp_to(eased, decel, decel_jerk)[0]
        if 0.5 * eased * stop + (u + b * time / 3.0) * time > size:
            return _back(start, target, speed, rates, (u, b, sign))
        top = peak_speed(rest, room, (accel, accel_jerk), (decel, decel_jerk))
        gain, slew = top - rest, 0.0
        if top > speed or gain < max(b * time, 0.0):  # by rounding
            return None
        first, up = ramp_to(gain, accel, accel_jerk)
        last, down = ramp_to(top, decel, decel_jerk)
        if abs(0.5 * (rest + top) * first + 0.5 * top * last - room) > _CLOSE * room:
            return None
    v = top * sign
    if b > 0.0:
        peak = min(accel, 0.5 * accel_jerk * first)
        steps = (
            (accel_jerk, (peak - b) / accel_jerk),
            (0.0, max(0.0, first - 2.0 * peak / accel_jerk)),
            (-accel_jerk, peak / accel_jerk),
        )
        duration = steps[0][1] + steps[1][1] + steps[2][1] + (slew + last)
        return JerkLimited(start, target, duration, (u, b, steps, sign), (v, slew, 0.0, v, last, down, 0.0))
    head = (u, b, ((decel_jerk, time),), sign)
    tail = (rest * sign, first, up, v, slew, 0.0, v, last, down, 0.0)
    return JerkLimited(start, target, time + (first + slew + last), head, tail)


def _back(
    start: float,
    target: float,
    speed: float,
    rates: tuple[float, float, float, float],
    state: tuple[float, float, float],
) -> Profile | None:
    """Return the plan that stops first, or None if no stop is needed.

    A stop is needed if the axis moves away from the target or cannot stop there. `state` is the velocity, the
    acceleration in its direction, and that direction.
    """
    _, decel, accel_jerk, decel_jerk = rates
    u, b, sign = state
    steps: Steps = ()
    after, covered, time = u, 0.0, 0.0
    if b > 0.0:
        time = b / accel_jerk
        steps, after, covered = ((-accel_jerk, time),), u + 0.5 * b * time, (u + b * time / 3.0) * time
    elif b < 0.0:
        time = -b / decel_jerk
        after, covered = u + 0.5 * b * time, (u + b * time / 3.0) * time
        if abs(after) <= NOTHING * (decel * decel / decel_jerk + u) and after <= HARDLY * u:
            after = 0.0
        if after <= 0.0:
            steps = ((decel_jerk, time),)
        elif -b > decel:
            return None
        else:  # it continues braking: the ramp is the rest of one that began earlier
            whole = u - 0.5 * b * time
            peak = max(-b, min(decel, sqrt(decel_jerk * whole)))
            flank, hold = peak / decel_jerk, max(0.0, (whole - peak * peak / decel_jerk) / peak)
            covered = whole * (0.5 * hold + flank) - (whole - decel_jerk * time * time / 6.0) * time
            steps, after = ((-decel_jerk, flank - time), (0.0, hold), (decel_jerk, flank)), 0.0
            time = 2.0 * flank + hold - time
    elif u < STILL:
        return None
    size = (target - start) * sign
    if after < 0.0:  # it reverses before the acceleration reaches zero
        rest = plan_jerk(0.0, (size - covered) * sign, speed, *rates, after * sign)
        recipe, duration = rest._recipe, time + rest.duration
    else:
        stopping, stop, kind = covered, 0.0, 0.5
        if after:
            stop, kind = ramp_to(after, decel, decel_jerk)
            stopping += 0.5 * after * stop
        beyond = stopping - size
        if beyond <= 0.0 or is_rounding(beyond, stopping, start, target):
            return None
        rest = plan_jerk(0.0, -beyond * sign, speed, *rates)
        recipe, duration = rest._recipe, time + stop + rest.duration
        if after:
            recipe = (after * sign, stop, kind, *recipe)
    if not duration < inf:
        return None
    if not steps:
        return Profile("scurve", start, target, duration, recipe)
    return JerkLimited(start, target, duration, (u, b, steps, sign), recipe, "" if after else "stop")


def _is_astray(made: Profile) -> bool:
    """True if the last piece misses the profile's end by over 1e-7 of its positions."""
    if not made.pieces:
        return False
    reached = position_in(made.pieces[-1], made.knots[-1] - made.knots[-2])
    return not abs(reached - made.end) <= 1e-7 * max(map(abs, made.extrema()))


def _stops_within(size: float, u: float, decel: float, jerk: float) -> bool:
    """True if a stop from speed `u` is shorter than `size` by more than rounding."""
    return 0.5 * u * ramp_to(u, decel, jerk)[0] < size * (1.0 - 1e-9)


def ease(start: float, v0: float, a0: float, jerk: float) -> Profile:
    """Return a ramp-down of an acceleration to zero at constant jerk.

    T = |a0|/J, dv = a0 T/2.
    """
    time = abs(a0) / jerk
    velocity = v0 + 0.5 * a0 * time
    end = start + ramp_distance(v0, time, FALLING, velocity)
    return Profile("scurve", start, end, time, (v0, time, FALLING, velocity))


def jerk_ramps(accel: float, decel: float, accel_jerk: float, decel_jerk: float) -> Ramps:
    """Return jerk-limited ramps.

    They take dv/A + A/J, or 2 sqrt(dv/J) if the acceleration does not reach A.
    """

    def up(a: float, b: float) -> tuple[float, float]:
        return ramp_to(b - a, accel, accel_jerk)

    def down(a: float, b: float) -> tuple[float, float]:
        return ramp_to(a - b, decel, decel_jerk)

    def peak(u: float, size: float) -> float:
        if u == 0.0:
            return peak_from_rest(size, accel, decel, accel_jerk, decel_jerk)
        return peak_speed(u, size, (accel, accel_jerk), (decel, decel_jerk))

    return Ramps("scurve", up, down, peak, bounds=Bounds(accel, decel, accel_jerk, decel_jerk))


def ramp_to(change: float, accel: float, jerk: float) -> tuple[float, float]:
    """Return duration and ramp ratio of a change of speed within `accel` and `jerk`."""
    rise = accel / jerk
    if change >= accel * rise:
        time = change / accel + rise
        return time, rise / time if time else 0.5  # too short to distinguish from zero
    return 2.0 * sqrt(change / jerk), 0.5


def peak_speed(u: float, size: float, up: tuple[float, float], down: tuple[float, float]) -> float:
    """Return the speed at which ramps from u up and down to rest fill `size`.

    `up` and `down` are (accel, jerk). There is a closed form if both ramps reach their acceleration. If not,
    the distance, divided by the root of the gain of speed, is convex. Newton's steps start above the root and
    descend to it; they stop where rounding reverses them.
    """
    accel, accel_jerk = up
    decel, decel_jerk = down
    rise, fall = accel / accel_jerk, decel / decel_jerk
    per_square, per_speed = 0.5 / accel + 0.5 / decel, 0.5 * (rise + fall)
    whole = size + 0.5 * u * (u / accel - rise)
    if whole > 0.0:
        v = 2.0 * whole / (sqrt(per_speed * per_speed + 4.0 * per_square * whole) + per_speed)
        if v - u >= accel * rise and v >= decel * fall:
            return v
    # Without a jerk limit the same acceleration reaches a higher speed, which is an upper bound. Ramps at
    # their full acceleration are at least as long as others, which gives a lower bound; the first step from
    # it leads above the root.
    high = sqrt((size + 0.5 * u * u / accel) / per_square) * (1.0 + 1e-15)
    low = v - u if whole > 0.0 else 0.0
    x = ceiling = sqrt(max(high - u, 0.0))
    if low > 0.05 * (high - u):
        x, ceiling = sqrt(low), inf
    while True:
        gain = x * x
        v = u + gain
        if gain >= accel * rise:
            first, first_slope = gain / accel + rise, 2.0 * x / accel
        else:
            first_slope = 2.0 / sqrt(accel_jerk)
            first = first_slope * x
        if v >= decel * fall:
            last = v / decel + fall
            last_slope = 1.0 / decel
        else:
            last = 2.0 * sqrt(v / decel_jerk)
            last_slope = 2.0 / (decel_jerk * last) if last else 0.0
        slope = x * (first + last + v * last_slope) + 0.5 * (u + v) * first_slope
        following = x - (0.5 * ((u + v) * first + v * last) - size) / slope if slope > 0.0 else x
        if not 0.0 <= following < ceiling:
            return v
        x = ceiling = following


def peak_from_rest(size: float, accel: float, decel: float, accel_jerk: float, decel_jerk: float) -> float:
    """Return the peak speed of a move from rest, like `peak_speed`.

    There is a closed form if both ramps reach their acceleration, or neither does.
    """
    rise, fall = accel / accel_jerk, decel / decel_jerk
    upper, lower = accel * rise, decel * fall
    if lower > upper:
        lower, upper = upper, lower
    per_square = 0.5 / accel + 0.5 / decel
    per_speed = 0.5 * (rise + fall)
    v = 2.0 * size / (sqrt(per_speed * per_speed + 4.0 * per_square * size) + per_speed)
    if v >= upper:
        return v
    v = cbrt(size / (1.0 / sqrt(accel_jerk) + 1.0 / sqrt(decel_jerk)))
    v *= v
    if v <= lower:
        return v
    return peak_speed(0.0, size, (accel, accel_jerk), (decel, decel_jerk))
