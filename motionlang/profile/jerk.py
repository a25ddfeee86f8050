"""Mint's S-ramp: ACCEL is the peak acceleration, ACCELJERK and DECELJERK the slope of the acceleration."""

from __future__ import annotations

from math import cbrt, inf, sqrt

from motionlang.profile.approach import Ramps, approach
from motionlang.profile.curve import Profile
from motionlang.profile.limits import LARGEST, SMALLEST, check_finite, check_positive, too_large
from motionlang.profile.ramps import FALLING, ramp_distance
from motionlang.profile.root import bracketed_root


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
    """Plan a move of up to seven sections under limits on speed, acceleration and jerk.

    Ramp to V: V/A + A/J if V >= A^2/J, else 2 sqrt(V/J); distance V T/2 (own arithmetic, as AN00118
    defines the S-ramp). A short move peaks at the speed at which the two ramps fill it exactly. An initial
    acceleration `a0` is first brought to zero at the jerk limit. Raises ValueError as `plan_trapezoid`.
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
    if v0 == 0.0 and a0 == 0.0:
        # Written out because planning from rest runs inside the program, for nearly every move.
        distance = target - start
        size = distance if distance >= 0.0 else -distance
        rise, fall = accel / accel_jerk, decel / decel_jerk
        first = speed / accel + rise if speed >= accel * rise else 2.0 * sqrt(speed / accel_jerk)
        last = speed / decel + fall if speed >= decel * fall else 2.0 * sqrt(speed / decel_jerk)
        slew = size / speed - 0.5 * (first + last)
        if slew < 0.0:
            speed = peak_from_rest(size, accel, decel, accel_jerk, decel_jerk)
            first = speed / accel + rise if speed >= accel * rise else 2.0 * sqrt(speed / accel_jerk)
            last = speed / decel + fall if speed >= decel * fall else 2.0 * sqrt(speed / decel_jerk)
            slew = 0.0
        duration = first + slew + last
        if duration < inf:
            ratio = rise / first if speed >= accel * rise else 0.5
            last_ratio = fall / last if speed >= decel * fall else 0.5
            v = speed if distance >= 0.0 else -speed
            recipe = (0.0, first, ratio, v, slew, 0.0, v, last, last_ratio, 0.0)
            return Profile("scurve", start, target, duration, recipe)
    check_finite(position=start, target=target, start_velocity=v0, start_acceleration=a0)
    ramps = jerk_ramps(accel, decel, accel_jerk, decel_jerk)
    if a0 == 0.0:
        # also where a move from rest with figures too large ends: `approach` says so
        return approach(ramps, start, target, speed, v0)
    eased = ease(start, v0, a0, accel_jerk if a0 * v0 >= 0.0 else decel_jerk)
    return eased.then(approach(ramps, eased.end, target, speed, eased.end_velocity))


def ease(start: float, v0: float, a0: float, jerk: float) -> Profile:
    """Bring an acceleration to zero at constant jerk: T = |a0|/J, dv = a0 T/2."""
    time = abs(a0) / jerk
    velocity = v0 + 0.5 * a0 * time
    end = start + ramp_distance(v0, time, FALLING, velocity)
    return Profile("scurve", start, end, time, (v0, time, FALLING, velocity))


def jerk_ramps(accel: float, decel: float, accel_jerk: float, decel_jerk: float) -> Ramps:
    """Ramps of duration dv/A + A/J, or 2 sqrt(dv/J) when the acceleration does not reach A."""

    def up(a: float, b: float) -> tuple[float, float]:
        return ramp_to(b - a, accel, accel_jerk)

    def down(a: float, b: float) -> tuple[float, float]:
        return ramp_to(a - b, decel, decel_jerk)

    def peak(u: float, size: float) -> float:
        if u == 0.0:
            return peak_from_rest(size, accel, decel, accel_jerk, decel_jerk)
        return peak_speed(u, size, (accel, accel_jerk), (decel, decel_jerk))

    return Ramps("scurve", up, down, peak)


def ramp_to(change: float, accel: float, jerk: float) -> tuple[float, float]:
    """Duration and ramp ratio of a change of speed under peak acceleration and jerk."""
    rise = accel / jerk
    if change >= accel * rise:
        time = change / accel + rise
        return time, rise / time
    return 2.0 * sqrt(change / jerk), 0.5


def peak_speed(u: float, size: float, up: tuple[float, float], down: tuple[float, float]) -> float:
    """The speed at which ramps from u up and down to rest fill `size`; up and down are (accel, jerk)."""

    def excess(v: float) -> tuple[float, float]:
        first, first_slope = _ramp_slope(v - u, *up)
        last, last_slope = _ramp_slope(v, *down)
        value = 0.5 * ((u + v) * first + v * last) - size
        return value, 0.5 * (first + (u + v) * first_slope + last + v * last_slope)

    # Without a jerk limit the same acceleration gets further: an upper bound.
    high = sqrt((2.0 * size + u * u / up[0]) / (1.0 / up[0] + 1.0 / down[0])) * (1.0 + 1e-15)
    return bracketed_root(excess, u, max(high, u), True)


def peak_from_rest(size: float, accel: float, decel: float, accel_jerk: float, decel_jerk: float) -> float:
    """The same from rest: in closed form if both ramps reach their acceleration, or neither does."""
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


def _ramp_slope(change: float, accel: float, jerk: float) -> tuple[float, float]:
    """Duration of a ramp and its derivative with respect to the change of speed."""
    rise = accel / jerk
    if change >= accel * rise:
        return change / accel + rise, 1.0 / accel
    time = 2.0 * sqrt(change / jerk)
    return time, 2.0 / (jerk * time) if time > 0.0 else inf
