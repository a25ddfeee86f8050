"""The four profiles of TN1069 on one axis under servo control.

They are compared by time, error, torque and jerk.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi
from typing import TYPE_CHECKING

from motionlang.planners import plan
from motionlang.planners.curve import hold
from motionlang.servo.demand import Track
from motionlang.servo.servo import simulate

if TYPE_CHECKING:
    from motionlang.planners import Profile
    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor
    from motionlang.servo.trace import ServoTrace

SHAPES = ("trapezoid", "sinusoidal", "scurve", "parabolic")
BASES = ("acceleration", "time")
REST = 0.5
"""Seconds that are simulated after the move."""


@dataclass(frozen=True, slots=True)
class Row:
    """One profile and its figures under servo control.

    `settle` is the time in seconds from the end of the profile until the error remains within the window.
    `jerk` is the largest jerk of the demand, counts/s³ (inf if the acceleration jumps), and `motor_jerk` the largest
    jerk of the motor.
    """

    shape: str
    accel: float
    time: float
    settle: float
    peak_error: float
    rms_torque: float
    peak_torque: float
    jerk: float
    motor_jerk: float
    trace: ServoTrace


def compare(
    loop: Loop,
    plant: Motor | Drive,
    distance: float,
    speed: float,
    accel: float,
    basis: str = "acceleration",
    window: float = 1.0,
    ramp: float = 0.1,
) -> list[Row]:
    """Simulate the move in each shape, at equal peak acceleration or equal time.

    The equal time is the time of the trapezoid; the other shapes get the acceleration that they need for it.
    `window` is in counts.
    """
    if basis not in BASES:
        raise ValueError(f"profiles are compared at equal {' or '.join(BASES)}, not {basis!r}")
    time = plan("trapezoid", 0.0, distance, speed, accel, accel).duration
    rows = []
    for shape in SHAPES:
        used = accel if basis == "acceleration" else accel_for(shape, distance, speed, time, ramp)
        profile = plan(shape, 0.0, distance, speed, used, used, ramp=ramp)
        rows.append(_row(profile, used, loop, plant, window))
    return rows


def accel_for(shape: str, distance: float, speed: float, time: float, ramp: float) -> float:
    """Return the acceleration at which a move of this shape takes `time`.

    Raises ValueError if there is none.
    """
    if time <= distance / speed:
        raise ValueError(
            f"{distance:g} counts at {speed:g} counts/s take longer than {time:g} s in every shape"
        )
    low = high = distance / (time * time)
    while plan(shape, 0.0, distance, speed, low, low, ramp=ramp).duration < time:
        low *= 0.5
    while plan(shape, 0.0, distance, speed, high, high, ramp=ramp).duration > time:
        high *= 2.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if plan(shape, 0.0, distance, speed, middle, middle, ramp=ramp).duration > time:
            low = middle
        else:
            high = middle
    return high


def peak_jerk(profile: Profile) -> float:
    """Return the largest jerk of a profile; inf if its acceleration jumps."""
    if profile.shape in ("trapezoid", "parabolic"):
        return inf
    worst = 0.0
    for begin, end in zip(profile.knots, profile.knots[1:], strict=False):
        for time in (begin, 0.5 * (begin + end)):
            worst = max(worst, abs(profile.at(time).jerk))
    if profile.shape == "sinusoidal":
        ramp = profile.phases[0]
        worst = max(worst, pi * profile.peak_acceleration / ramp.duration)
    return worst


def _row(profile: Profile, accel: float, loop: Loop, plant: Motor | Drive, window: float) -> Row:
    end = profile.duration
    trace = simulate(Track([0.0, end], [profile, hold(profile.end)]), loop, plant, until=end + REST)
    torque = abs(trace.torque)
    return Row(
        shape=profile.shape,
        accel=accel,
        time=end,
        settle=trace.settled_at(window, end) - end,
        peak_error=trace.peak_error,
        rms_torque=trace.rms_torque_between(0.0, end),
        peak_torque=float(torque.max()),
        jerk=peak_jerk(profile),
        motor_jerk=float(abs(trace.jerk).max()),
        trace=trace,
    )
