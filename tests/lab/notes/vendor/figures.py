"""The example behind the figures of "Dissecting a Move Profile" (chapter 12).

A cube of 5 lb is held on a plate by friction alone and must reach 100 ft/min. Lengths are in ft, times in s. Figures
12.5 to 12.7, 12.9 and 12.10 are functions of `dissect`.
"""

from __future__ import annotations

from typing import NamedTuple

from motionlang.kernel.planners import Profile, plan
from tests.lab.notes.vendor.dissect import (
    FRICTION,
    GRAVITY_FT,
    SPEED_FT_MIN,
    WEIGHT_LB,
    friction_force,
    slip_acceleration,
)

# ft/s², the acceleration at which the cube slips.
LIMIT = slip_acceleration(FRICTION, GRAVITY_FT)
# ft/s
SPEED = SPEED_FT_MIN / 60.0
# In ft: far enough for both profiles of the cube to reach their speed.
DISTANCE = 2.0
# Changes of the DAC in figure 12.6, steps.
CHANGES = (1, 2, 1)
# Time constants of the curves of figure 12.6, in updates.
TIME_CONSTANTS = {"C": 1.0 / 5.0, "D to G": 2.0 / 3.0, "whole": 1.0}
# The chain of figure 12.11: each block with what it does.
BLOCKS = (
    ("host", "moves, settings"),
    ("trajectory", "velocity += accel\nposition += velocity"),
    ("error", "desired - actual"),
    ("PID", "P + I + D, /16"),
    ("override", "near ActVel, held"),
    ("DAC", "±2048 steps"),
    ("amplifier", "volts to current"),
    ("motor + load", "slips beyond μ g"),
)
TITLES = {
    "12.1": "Relationship of acceleration and velocity profiles",
    "12.2": "What is the maximum acceleration before the product will slip?",
    "12.3": "How much time to attain max acceleration?",
    "12.4": "Horizontal free-body force diagram",
    "12.5": "The time it takes to accomplish a DAC step",
    "12.6": "The relationship between DAC steps and electrical time constant",
    "12.7": "Trapezoidal velocity profile versus acceleration",
    "12.8": "Diagram showing an S velocity profile versus acceleration over time",
    "12.9": "Trapezoidal and S profile calculations",
    "12.10": "Acceleration slope with respect to DAC steps",
    "12.11": "A typical microprocessor-based motion system",
}


class AccelerationPoint(NamedTuple):
    """A point of figure 12.1: the acceleration `before` and `after` it, ft/s²."""

    name: str
    time: float
    before: float
    after: float
    velocity: float


class Forces(NamedTuple):
    """The forces on the cube in figure 12.4, lb."""

    acceleration: float
    inertial: float
    friction: float

    @property
    def slides(self) -> bool:
        """True if friction cannot hold the cube."""
        return self.inertial > self.friction * (1.0 + 1e-12)


def trapezoid() -> Profile:
    """Return the fastest trapezoid of the cube over `DISTANCE`.

    >>> round(trapezoid().duration, 7)
    1.7175983
    """
    return plan("trapezoid", 0.0, DISTANCE, SPEED, LIMIT, LIMIT)


def s_curve(accel: float = LIMIT) -> Profile:
    """Return the same move as an S-curve, whose acceleration has two linear ramps.

    >>> round(s_curve().duration, 7), round(s_curve(2.0 * LIMIT).duration, 7)
    (2.2351967, 1.7175983)
    """
    return plan("scurve", 0.0, DISTANCE, SPEED, accel, accel, ramp=0.5)


def acceleration_points() -> list[AccelerationPoint]:
    """Return the points A1 to A6 of figure 12.1.

    >>> point = acceleration_points()[3]
    >>> point.name, round(point.time, 3), point.before, round(point.after, 3), round(point.velocity, 3)
    ('A4', 1.2, 0.0, -3.22, 1.667)
    """
    profile = trapezoid()
    _, full, slow, end = profile.knots
    levels = (
        (0.0, 0.0, LIMIT),
        (0.5 * full, LIMIT, LIMIT),
        (full, LIMIT, 0.0),
        (slow, 0.0, -LIMIT),
        (0.5 * (slow + end), -LIMIT, -LIMIT),
        (end, -LIMIT, 0.0),
    )
    return [AccelerationPoint(f"A{k}", at, before, after, profile.velocity(at))
            for k, (at, before, after) in enumerate(levels, 1)]  # fmt: skip


def forces(acceleration: float) -> Forces:
    """Return the forces on the cube while its plate accelerates (figure 12.4).

    >>> forces(1.61), forces(4.83).slides
    (Forces(acceleration=1.61, inertial=0.25, friction=0.5), True)
    """
    return Forces(acceleration, WEIGHT_LB / GRAVITY_FT * acceleration, friction_force(WEIGHT_LB, FRICTION))
