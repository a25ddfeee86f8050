"""The four profiles of TN1069 on one axis under servo control.

They are compared by time, error, torque and jerk.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from motionlang.kernel.planners import Profile, hold, jerk_in, plan
from motionlang.kernel.servo import Loop, Motor, Track, VelocityDrive, simulate
from motionlang.kernel.tools import bisected

if TYPE_CHECKING:
    from motionlang.kernel.servo import ServoTrace

SHAPES = ("trapezoid", "sinusoidal", "scurve", "parabolic")
BASES = ("acceleration", "time")
# Seconds that are simulated after the move.
REST = 0.5


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
    plant: Motor | VelocityDrive,
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

    >>> from motionlang.kernel.servo import Loop, Motor
    >>> rows = compare(Loop(proportional=0.04, integral=2e-5, derivative=0.9), Motor(), 4000.0, 20_000.0, 200_000.0)
    >>> [f"{row.shape} {row.time:.3f} s" for row in rows]
    ['trapezoid 0.300 s', 'sinusoidal 0.357 s', 'scurve 0.311 s', 'parabolic 0.346 s']
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

    >>> round(accel_for("sinusoidal", 4000.0, 20_000.0, 0.3, 0.1))
    314159
    """
    if time <= distance / speed:
        raise ValueError(
            f"{distance:.10g} counts at {speed:.10g} counts/s take longer than {time:.10g} s in every shape"
        )

    def duration(acceleration: float) -> float:
        return plan(shape, 0.0, distance, speed, acceleration, acceleration, ramp=ramp).duration

    # Even without a speed limit, a triangle takes twice the time at this acceleration.
    low = high = distance / (time * time)
    while duration(high) > time:
        high *= 2.0
    return bisected(high, low, lambda acceleration: duration(acceleration) <= time)


def peak_jerk(profile: Profile) -> float:
    """Return the largest jerk of a profile; inf if its acceleration jumps.

    >>> peak_jerk(plan("trapezoid", 0.0, 4000.0, 20_000.0, 200_000.0, 200_000.0))
    inf
    """
    if profile.shape in ("trapezoid", "parabolic"):
        return inf
    # The jerk of a cubic is constant, and that of a half wave is largest where it begins.
    return max(abs(jerk_in(piece, 0.0)) for piece in profile.pieces)


def _row(profile: Profile, accel: float, loop: Loop, plant: Motor | VelocityDrive, window: float) -> Row:
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
