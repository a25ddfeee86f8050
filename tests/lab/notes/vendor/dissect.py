"""Formulas of "Dissecting a Move Profile" (chapter 12).

They give move times, slip of the load, and the size and time of DAC steps. Any consistent units will do; the
chapter's own figures are in feet, minutes and seconds. Where the scanned chapter contradicts physics, the formula
follows physics and `ERRATA` records the difference.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, inf
from typing import NamedTuple

from motionlang.kernel.planners import check_positive

# Steel on steel, dry, in the chapter's example.
FRICTION = 0.1
# ft/s², as the chapter has it.
GRAVITY_FT = 32.2
WEIGHT_LB = 5.0
SPEED_FT_MIN = 100.0
BITS = 12
# Minimum of the motor's electrical time constant, as a share of a step's time. One step is the shortest time that a DAC
# step may take.
ELECTRICAL_SHARE = 2.0 / 3.0
# Electrical time constants for which a DAC step is to be held.
HOLD_TIME_CONSTANTS = 5.0

ERRATA = (
    "The fractions of the slip example are inverted in the scan: (5)(0.1) = (5/32.2)(A) gives A = 3.22 ft/s², "
    "(100/60) = 3.22 T gives T = 0.5176 s, and one DAC step is 100/2048 ft/min.",
    "The print has T_s = D/V - V/A for both profiles; for the S-curve D_a = V²/A, so T_s = D/V - 2 V/A.",
    "The print's T_move = T_a + T_s + T_o is T_a + T_s + T_d.",
    "The DAC formula lost its middle terms: it is (Kp E + (Ki/256) E_T + Kd (E - E_L))/16.",
    "Five time constants are 842.4 microseconds; the chapter says 840, five times the rounded 168.",
    "A step change must not occur in LESS than 253 microseconds; the chapter says 'under'.",
    "A time constant of 2/3 of the update time keeps the mean acceleration of a one-step update at 0.78 of the limit, "
    "but the onset of the step is still 1.5 times the limit: for the onset too the time constant must be the whole "
    "253 microseconds.",
)


@dataclass(frozen=True, slots=True)
class MoveTimes:
    """T_a, D_a, T_s and T_move of a move that reaches its commanded speed."""

    accel_time: float
    accel_distance: float
    slew_time: float
    move_time: float


def trapezoid_times(distance: float, speed: float, accel: float) -> MoveTimes:
    """Return the times of a trapezoid (figure 12.9).

    T_a = V/A, D_a = V²/(2A), T_s = D/V - V/A, T_move = D/V + V/A.

    >>> trapezoid_times(12.0, 8.0, 16.0)
    MoveTimes(accel_time=0.5, accel_distance=2.0, slew_time=1.0, move_time=2.0)
    """
    return _times(distance, speed, speed / accel, 0.5 * speed * speed / accel)


def s_curve_times(distance: float, speed: float, accel: float) -> MoveTimes:
    """Return the times of an S-curve whose ramps have triangular acceleration.

    T_a = 2V/A, D_a = V²/A, T_s = D/V - 2V/A (figure 12.9).

    >>> s_curve_times(12.0, 8.0, 32.0)
    MoveTimes(accel_time=0.5, accel_distance=2.0, slew_time=1.0, move_time=2.0)
    """
    return _times(distance, speed, 2.0 * speed / accel, speed * speed / accel)


def equal_time_accel(accel: float) -> float:
    """Return the peak acceleration of an S-curve as fast as a trapezoid: A_s = 2A.

    >>> equal_time_accel(16.0)
    32.0
    """
    return 2.0 * accel


def _times(distance: float, speed: float, accel_time: float, accel_distance: float) -> MoveTimes:
    check_positive(distance=distance, speed=speed, accel_time=accel_time)
    slew = (distance - 2.0 * accel_distance) / speed
    if slew < 0.0:
        raise ValueError(f"the move is too short to reach its speed: that takes {2.0 * accel_distance:.10g}")
    return MoveTimes(accel_time, accel_distance, slew, 2.0 * accel_time + slew)


class Update(NamedTuple):
    """An update of the discrete trapezoid: velocity in counts per update, position in counts."""

    velocity: int
    position: int


def discrete_trapezoid(distance: int, speed: int, accel: int) -> list[Update]:
    """Return each update of the chapter's algorithm.

    Each update does velocity += accel; position += velocity (figure 12.7). Units are counts, counts per
    update and counts per update². The move decelerates from the update at which the remaining distance would no
    longer suffice to stop, and covers the remainder at a constant creep.

    >>> discrete_trapezoid(200, 20, 2)[8]
    Update(velocity=18, position=90)
    """
    check_positive(distance=distance, speed=speed, accel=accel)
    velocity = position = 0
    made: list[Update] = []
    while position < distance:
        faster = min(velocity + accel, speed)
        if position + faster + _stopping(faster, accel) <= distance:
            velocity = faster
        elif position + velocity + _stopping(velocity, accel) > distance or velocity == 0:
            velocity = max(velocity - accel, 1 if velocity <= accel else 0)
        velocity = min(velocity, distance - position)
        position += velocity
        made.append(Update(velocity, position))
    return made


def _stopping(velocity: int, accel: int) -> int:
    """Return the sum of the positive terms velocity - accel, velocity - 2 accel, …

    It is the stopping distance in counts.
    """
    steps = max(0, -(-velocity // accel) - 1)
    return steps * velocity - accel * steps * (steps + 1) // 2


# ------------------------------------------------------------------------------------------------------- slipping


def slip_acceleration(friction: float, gravity: float) -> float:
    """Return the acceleration at which a load held only by friction slips: a = mu g.

    It does not depend on the mass.

    >>> slip_acceleration(0.25, 9.81)
    2.4525
    """
    check_positive(friction=friction, gravity=gravity)
    return friction * gravity


def friction_force(weight: float, friction: float) -> float:
    """Return the largest force that friction transmits to a load of `weight`.

    See figure 12.4.

    >>> friction_force(5.0, 0.1)
    0.5
    """
    check_positive(weight=weight, friction=friction)
    return weight * friction


def fastest_time(speed: float, acceleration: float) -> float:
    """Return the shortest time to reach `speed` without exceeding `acceleration`.

    >>> round(fastest_time(100.0 / 60.0, 3.22), 7)
    0.5175983
    """
    check_positive(speed=speed, acceleration=acceleration)
    return speed / acceleration


# ----------------------------------------------------------------------------------------------------- DAC steps


@dataclass(frozen=True, slots=True)
class DacTiming:
    """The velocity of one DAC step, and times derived from the acceleration limit."""

    bits: int
    steps: int
    step_speed: float
    step_time: float
    electrical_time_constant: float
    hold_time: float


def dac_timing(full_speed: float, acceleration: float, bits: int = BITS) -> DacTiming:
    """Return the timing of DAC steps if full scale means `full_speed`.

    Steps may follow each other as fast as `acceleration` allows. The electrical time constant is 2/3 of the time of
    one step, the hold time is five time constants.

    >>> timing = dac_timing(100.0 / 60.0, 3.22)
    >>> timing.steps, round(timing.step_time * 1e6, 4), round(timing.hold_time * 1e6, 4)
    (2048, 252.7336, 842.4452)
    """
    check_positive(full_speed=full_speed, acceleration=acceleration)
    if not 2 <= bits <= 32:
        raise ValueError(f"a DAC has 2 to 32 bits, not {bits}")
    steps = 1 << (bits - 1)
    step_speed = full_speed / steps
    step_time = step_speed / acceleration
    constant = ELECTRICAL_SHARE * step_time
    return DacTiming(bits, steps, step_speed, step_time, constant, HOLD_TIME_CONSTANTS * constant)


@dataclass(frozen=True, slots=True)
class StepSegment:
    """One update of figure 12.6.

    Velocities are in DAC steps, accelerations are fractions of the limit.
    """

    steps: float
    time_constant: float
    from_velocity: float
    to_velocity: float
    onset: float
    mean: float


def step_segments(changes: tuple[int, ...], time_constant: float) -> list[StepSegment]:
    """Return the motor's response to DAC changes one update apart.

    The update is the time per step that the acceleration limit allows; `time_constant` is in updates. The velocity
    approaches that of the DAC like the current of an RL circuit. `onset` is the acceleration just after the
    change, `mean` that of the update (figures 12.5, 12.6).

    >>> [round(segment.onset, 3) for segment in step_segments((1, 2, 1), 1.0)]
    [1.0, 2.368, 1.871]
    """
    check_positive(time_constant=time_constant)
    made, dac, velocity = [], 0.0, 0.0
    for change in changes:
        dac += change
        gap = dac - velocity
        after = dac - gap * exp(-1.0 / time_constant)
        made.append(
            StepSegment(change, time_constant, velocity, after, gap / time_constant, after - velocity)
        )
        velocity = after
    return made


def buildup(time: float, time_constant: float) -> float:
    """Return the fraction of a step response after `time`: 63 % at one time constant.

    >>> round(buildup(1.0, 1.0), 4)
    0.6321
    """
    return 1.0 - exp(-time / time_constant) if time < inf else 1.0


def divided(value: int, divisor: int) -> int:
    """Return a quotient that is truncated towards zero.

    >>> divided(-7, 2)
    -3
    """
    whole = abs(value) // divisor
    return whole if value >= 0 else -whole
