"""Shapes: how a velocity is gained and lost over a ramp.

Problem. A plan joins velocities by ramps. Whatever their shape, a planner needs three facts: how long a ramp takes, of
which kind it is (`ramps.py`: the kind decides distance and curve), and how fast a move becomes that is too short to
reach its speed.

Idea. A shape within its limits is a `Ramps` that states these facts for speeds >= 0. Moves to a target (`target.py`),
changes of velocity (`stop.py`) and paths (`lookahead.py`) are planned from them alone. There are two families.

`Proportional`: the acceleration has a fixed course over the time of the ramp, so that this time is proportional to the
change of speed, T = k |dv|/A.

    trapezoid    k = 1              constant (TN1069, AN00115)
    sinusoidal   k = pi/2           half a sine (TN1069)
    scurve       k = 1/(1 - ramp)   rises over `ramp` T, is constant, and falls, 0 < ramp <= 0.5 (TN1069)
    parabolic    k = 2              falls linearly to zero at the higher speed (TN1069)

TN1069 prints (1/RAMP) VEL/ACC for the third, which contradicts its own table. At ramp 0.5 it is chapter 12's S-curve
with triangular acceleration, T = 2 V/A.

The mean speed of a symmetrical ramp is halfway between both ends, S = T (u + v)/2. That of a parabola is two thirds of
the way to the higher speed. With m for that fraction, a move from speed u that peaks at v and comes to rest is

    k/A (v - u) ((1 - m) u + m v) + k/D m v^2

long. So the peak is the root of a quadratic.

`JerkRamps`: Mint's S-ramp. The acceleration rises at constant jerk, stays at its peak, and falls at the same jerk.
A ramp over a change of speed V takes V/A + A/J if it reaches its peak A (V >= A^2/J), and 2 sqrt(V/J) if not (own
arithmetic, from AN00118's definition of the S-ramp). The peak speed of a short move from rest is the root of a
quadratic if both ramps reach their peak, and a cube root if neither does. Newton's method finds it in all other cases,
and here it converges from one side: some five steps, and 15 at most in 20 000 random moves.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cbrt, inf, pi, sqrt

from motionlang.kernel.planners.limits import check_positive, check_ramp
from motionlang.kernel.planners.ramps import FALLING, RISING, SINE


class Ramps:
    """The ramps of one shape within its limits, between speeds >= 0.

    If the distance of both ramps is k/2 times the difference of the squares of their speeds, `squares` has the k of
    speeding up and of slowing down.
    """

    __slots__ = ()

    shape: str

    @property
    def squares(self) -> tuple[float, float] | None:
        return None

    def up(self, u: float, v: float) -> tuple[float, float]:
        """Return duration and kind of the ramp from u up to v."""
        raise NotImplementedError

    def down(self, v: float, u: float) -> tuple[float, float]:
        """Return duration and kind of the ramp from v down to u."""
        raise NotImplementedError

    def peak(self, size: float) -> float | None:
        """Return the speed at which ramps up from rest and down to it fill `size`; None if it has to be searched."""
        raise NotImplementedError


@dataclass(eq=False, slots=True)
class Proportional(Ramps):
    """Ramps of a fixed course, whose time is proportional to the change of speed.

    `accel` and `decel` are the mean rates of a ramp. `mean` states where between its speeds the mean speed is: 1/2 is
    halfway, 2/3 nearer to the higher one.
    """

    shape: str
    accel: float
    decel: float
    up_kind: float
    down_kind: float
    mean: float

    @property
    def squares(self) -> tuple[float, float] | None:
        return (1.0 / self.accel, 1.0 / self.decel) if self.mean == 0.5 else None

    def up(self, u: float, v: float) -> tuple[float, float]:
        return (v - u) / self.accel, self.up_kind

    def down(self, v: float, u: float) -> tuple[float, float]:
        return (v - u) / self.decel, self.down_kind

    def peak(self, size: float) -> float | None:
        return sqrt(size / (self.mean / self.accel + self.mean / self.decel))


@dataclass(eq=False, slots=True)
class JerkRamps(Ramps):
    """Ramps whose acceleration changes at a jerk up to its limit."""

    accel: float
    decel: float
    accel_jerk: float
    decel_jerk: float

    shape = "scurve"

    def up(self, u: float, v: float) -> tuple[float, float]:
        return ramp_to(v - u, self.accel, self.accel_jerk)

    def down(self, v: float, u: float) -> tuple[float, float]:
        return ramp_to(v - u, self.decel, self.decel_jerk)

    def peak(self, size: float) -> float | None:
        return peak_from_rest(size, self.accel, self.decel, self.accel_jerk, self.decel_jerk)


def ramps_of(
    shape: str, accel: float, decel: float, ramp: float, accel_jerk: float, decel_jerk: float
) -> Ramps:
    """Return the ramps of a shape; raise ValueError for an unknown name or parameters of none.

    For "scurve" a finite `accel_jerk` selects Mint's S-ramp (`decel_jerk` defaults to it); without one, `ramp` is
    PMC's ramp ratio.
    """
    if shape == "trapezoid":
        return Proportional(shape, accel, decel, 0.0, 0.0, 0.5)
    if shape == "sinusoidal":
        return Proportional(shape, accel / (0.5 * pi), decel / (0.5 * pi), SINE, SINE, 0.5)
    if shape == "parabolic":
        return Proportional(shape, 0.5 * accel, 0.5 * decel, FALLING, RISING, 2.0 / 3.0)
    if shape != "scurve":
        raise ValueError(f"there is no profile shape {shape!r}")
    if accel_jerk != inf:
        braking = accel_jerk if decel_jerk == inf else decel_jerk
        check_positive(acceleration_jerk=accel_jerk, deceleration_jerk=braking)
        return JerkRamps(accel, decel, accel_jerk, braking)
    check_ramp(ramp)
    return Proportional(shape, accel * (1.0 - ramp), decel * (1.0 - ramp), ramp, ramp, 0.5)


def ramp_to(change: float, accel: float, jerk: float) -> tuple[float, float]:
    """Return duration and ramp ratio of a change of speed within `accel` and `jerk`."""
    rise = accel / jerk
    if change >= accel * rise:
        time = change / accel + rise
        return time, rise / time if time else 0.5  # too short to distinguish from zero
    return 2.0 * sqrt(change / jerk), 0.5


def peak_from_rest(
    size: float, accel: float, decel: float, accel_jerk: float, decel_jerk: float
) -> float | None:
    """Return the peak speed of a move from rest if both ramps reach their acceleration, or neither does."""
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
    return v if v <= lower else None
