"""The profile of a move: from the settings of its axis to a motion, or to rest."""

from __future__ import annotations

from functools import lru_cache

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import clamped
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove, keeps_rates
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.dwell import with_rest
from motionlang.kernel.planners.ramp_down import onset, stop_in_motion
from motionlang.kernel.planners.target import plan, plan_trapezoid


def rates(a: Axis, speed: float) -> tuple[float, float]:
    """Return the rates of the settings for a move at `speed`; raise Rejected unless both are positive."""
    accel, decel = a.rates(speed)
    _check_rate(a, accel, "an acceleration", "move")
    _check_rate(a, decel, "a deceleration", "move")
    return accel, decel


def checked_speed_and_rates(a: Axis, move: LoggedMove) -> tuple[float, float, float]:
    """Return speed and rates of a move; at speed 0 the axis holds, and the rates in force stay.

    Raises Rejected if the axis cannot move.
    """
    speed = a.speed if move.speed is None else move.speed
    accel, decel = rates(a, speed) if speed else a.rates(speed)
    if move.rates is not None:
        accel, decel = move.rates[0] or accel, move.rates[1] or decel
    if speed:
        return speed, accel, decel
    a.controller.notify("held", a.index)
    in_force = move.rates_in_force or (a.accel, a.decel)
    return 0.0, accel or in_force[0], decel or in_force[1]


def plan_move(a: Axis, move: LoggedMove, in_force: tuple[float, float] | None = None) -> Profile:
    """Return the profile of a move from the present state of its axis.

    Its rates are those of the settings, or `in_force`.
    """
    speed, accel, decel = checked_speed_and_rates(a, move)
    accel, decel = in_force or (accel, decel)
    shape = a.shape
    jerks = a.jerks(speed, accel, decel) if shape == "scurve" else (INFINITY, INFINITY)
    if move.overridden:
        speed *= a.override
    move.commanded_speed = speed
    if a.limited:
        clamped(a, move.line, speed, a.max_speed)
        speed, accel, decel = min(speed, a.max_speed), min(accel, a.max_accel), min(decel, a.max_decel)
    move.rates_in_force = _shared_rates(accel, decel)
    if a.suspended or not speed:
        return with_standstill(a)
    last = a.profiles[-1]
    try:
        if last.shape == "hold" and shape == "trapezoid":  # the case of nearly every move
            return plan_trapezoid(last.end, move.target, speed, accel, decel)
        eased, start, velocity, acceleration = onset(
            last, a.clock.now - a.starts[-1], shape, jerks[0], keeps_rates(a.move)
        )
        made = plan(shape, start, move.target, speed, accel, decel, velocity, a.ramp, *jerks, acceleration)
        return made if eased is None else eased.then(made)
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot move: {problem}") from None


@lru_cache(typed=True)
def _shared_rates(accel: float, decel: float) -> tuple[float, float]:
    """Return two rates as a tuple that equal moves share, since a log may have millions."""
    return accel, decel


def plan_distance(
    a: Axis,
    shape: str,
    start: float,
    end: float,
    limits: tuple[float, float, float],
    jerks: tuple[float, float],
    velocity: float = 0.0,
) -> Profile:
    """Return a profile from `start` to `end` with given `limits`, a speed and rates.

    Raises Rejected if there is none.
    """
    try:
        return plan(shape, start, end, *limits, velocity, a.ramp, *jerks)
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot move: {problem}") from None


def stop_rate(a: Axis, move: LoggedMove | None) -> float:
    """Return the deceleration of a stop, at the rate of `move` if it has its own.

    Raises Rejected unless it is positive.
    """
    speed, _, decel = a.speed_and_rates(move)
    if not decel and not speed and move is not None and move.rates_in_force is not None:
        decel = move.rates_in_force[1]  # a ramp time says nothing about a stop at speed 0
    if not decel:
        decel = a.rates(speed)[1]
        _check_rate(a, decel, "a deceleration", "stop")
    return min(decel, a.max_decel)


def braking(a: Axis, decel: float) -> Profile:
    """Return the motion from the state of the axis to rest."""
    now, (speed, own_accel, own_decel) = a.clock.now, a.speed_and_rates(a.move)
    jerks = a.jerks(speed, own_accel, own_decel)
    accel = None if keeps_rates(a.move) else min(own_accel, a.max_accel)
    try:
        made = stop_in_motion(a.profiles[-1], now - a.starts[-1], a.shape, decel, a.ramp, *jerks, accel)
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot stop: {problem}") from None
    rounding = a.here(now) - made.start
    return made.shifted(rounding) if rounding else made


def to_rest(a: Axis) -> Profile:
    """Return the motion from the state of the axis to rest at its set rate."""
    return braking(a, stop_rate(a, a.move))


def with_standstill(a: Axis) -> Profile:
    """Return the motion to rest, followed by rest until another command."""
    return with_rest(to_rest(a))


def _check_rate(a: Axis, rate: float, what: str, purpose: str) -> None:
    """Raise Rejected unless a rate is positive; `what` is its name with an article."""
    if not rate > 0:
        name = what.split()[1]
        raise Rejected(
            "zero-acceleration",
            f"axis {a.index} cannot {purpose}: its {name} is {rate:.10g}",
            f"a {purpose} needs {what} above zero",
        )
