"""Ramp-down of residual acceleration where no jerk is set: PMC's S-curves.

Their acceleration has a shape instead of a jerk limit. It falls to zero along the falling flank of its ramp, as at
the end of that ramp, but at once. Only ramps that an axis or a path plans for itself have a flank: the acceleration of
a slave is that of its master, on an arc that of the curve, and in a table or a playback its author's.
"""

from __future__ import annotations

from math import cos, inf, pi

from motionlang.kernel.planners.curve import Profile, from_curve, relabelled
from motionlang.kernel.planners.pieces import acceleration_in, jerk_in, position_in, recentred, velocity_in
from motionlang.kernel.planners.ramps import Piece, Plain
from motionlang.kernel.planners.stop import plan_stop
from motionlang.kernel.planners.transition import NOTHING

# The relative rounding of a peak acceleration.
_SLACK = 1e-9


def shaped(shape: str, accel_jerk: float) -> bool:
    """True if the acceleration of a shape's ramps is shaped although no jerk is set."""
    return shape == "sinusoidal" or (shape == "scurve" and accel_jerk == inf)


def residual_ramp_down(profile: Profile, time: float) -> Profile | None:
    """Return the ramp-down from the state at `time` to zero acceleration.

    None if there is no acceleration, or no flank that reduces it.
    """
    if not 0.0 <= time < profile.duration:
        return None
    i = profile._index(time)
    piece = recentred(profile.pieces[i], time - profile.knots[i])
    phase = [name for name, first in profile.curve[2] if first <= i][-1:]
    if not isinstance(piece, tuple) or phase == ["slew"]:  # the acceleration is that of an arc
        return None
    found = _on_wave(piece) if piece[4] else _on_slope(profile, i, piece)
    if found is None:
        return None
    falling, duration = found
    name = "accel" if acceleration_in(piece, 0.0) * velocity_in(piece, 0.0) >= 0.0 else "decel"
    velocity = velocity_in(piece, 0.0)
    curve = ((0.0, duration), (falling,), ((name, 0),))
    end = position_in(falling, duration)
    last = velocity_in(falling, duration)
    if abs(last) <= NOTHING * abs(velocity):  # it leads to rest, and the remaining ramp is rounding
        last = 0.0
    return from_curve(profile.shape, position_in(piece, 0.0), end, curve, velocity, last)


def onset(
    profile: Profile, time: float, shape: str, accel_jerk: float, own: bool = True
) -> tuple[Profile | None, float, float, float]:
    """Return the ramp-down that a new plan begins with, and the state to plan from.

    The ramp-down is None unless the acceleration is shaped, and `own`: not that of a master or a table. The state is
    position, velocity and acceleration.
    """
    if own and shaped(shape, accel_jerk):
        eased = residual_ramp_down(profile, time)
        if eased is not None:
            return eased, eased.end, eased.end_velocity, 0.0
    state = profile.at(time)
    return None, state.position, state.velocity, state.acceleration if shape == "scurve" else 0.0


def admitted(acceleration: float, velocity: float, accel: float, decel: float) -> float:
    """Return the initial acceleration of a ramp that takes over a motion.

    It is limited to `accel` or `decel`, even if the motion exceeds the rates of its axis.
    """
    most = accel if acceleration * velocity >= 0.0 else decel
    return max(-most, min(acceleration, most))


def stop_in_motion(
    profile: Profile,
    time: float,
    shape: str,
    decel: float,
    ramp: float,
    accel_jerk: float = inf,
    decel_jerk: float = inf,
    accel: float | None = None,
) -> Profile:
    """Come to rest at `decel` from motion, without an acceleration jump in an S-curve.

    `accel` is given if the motion may exceed the rates of the axis: the stop then begins with an acceleration within
    both, and at once. A ramp of PMC's that already slows down continues to rest as planned, if that is no farther and
    never harder than `decel`. Raises ValueError like `plan_stop`.
    """
    state = profile.at(time)
    if shape == "trapezoid" or (shape == "scurve" and decel_jerk < inf):
        acceleration = state.acceleration if shape == "scurve" else 0.0
        if accel is not None:
            acceleration = admitted(acceleration, state.velocity, accel, decel)
        return plan_stop(
            shape, state.position, state.velocity, decel, ramp, decel_jerk, acceleration, accel_jerk
        )
    eased = residual_ramp_down(profile, time) if accel is None and shaped(shape, decel_jerk) else None
    if eased is None:
        made = plan_stop(shape, state.position, state.velocity, decel, ramp)
    else:
        rest = plan_stop(shape, eased.end, eased.end_velocity, decel, ramp)
        made = relabelled(eased.then(rest), shape, "stop")
    planned = _rest_ahead(profile, time, decel) if state.acceleration * state.velocity < 0.0 else None
    if planned is not None and abs(planned.end - state.position) <= abs(made.end - state.position):
        return relabelled(planned, shape, "stop")
    return made


def _rest_ahead(profile: Profile, time: float, decel: float) -> Profile | None:
    """Return the rest of a profile up to standstill.

    None if it does not come to rest, or exceeds `decel` before it.
    """
    still = profile.velocity_crossing(0.0, time)
    if still is None or not still <= profile.duration < inf:
        return None
    planned = profile.cut(still).after(time)
    return planned if planned.peak_acceleration <= decel * (1.0 + _SLACK) else None


def _on_wave(piece: Plain) -> tuple[Piece, float] | None:
    """Return a half wave from where it has the same acceleration and falls.

    The second item is the duration of that flank.
    """
    _, _, _, _, amplitude, omega, phase = piece
    if not 0.0 < phase < pi:
        return None
    later = max(phase, pi - phase)
    velocity = velocity_in(piece, 0.0) - amplitude * omega * cos(later)
    moved = (0.0, velocity, 0.0, 0.0, amplitude, omega, later)
    start = position_in(piece, 0.0) - position_in(moved, 0.0)
    return (start, *moved[1:]), (pi - later) / omega


def _on_slope(profile: Profile, index: int, piece: Plain) -> tuple[Piece, float] | None:
    """Return the cubic that ramps the acceleration down at the jerk of this ramp.

    The second item is its duration.
    """
    position, velocity, half, _, _, _, _ = piece
    if not half:
        return None
    slope = jerk_in(profile.pieces[index], 0.0) / 6.0
    if not slope:  # constant: the flank follows
        following = next(iter(profile.pieces[index + 1 : index + 2]), None)
        slope = following[3] if isinstance(following, tuple) and not following[4] else 0.0
        if slope * half >= 0.0:
            return None
    slope = -abs(slope) if half > 0.0 else abs(slope)
    return (position, velocity, half, slope, 0.0, 0.0, 0.0), -half / (3.0 * slope)
