"""Initial gains for a plant and a bandwidth: a start for tuning, not its result.

The plant is modelled as K/(s (tau s + 1)) and three closed-loop poles are put at one frequency. That frequency
is then varied until the real loop, sampled and with the complete plant, has the requested bandwidth.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from math import inf, pi

from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.servo.response import LoopFigures, bandwidth, is_stable, loop_figures, reaches

# A phase margin below this many degrees causes a warning.
SUSPECT = 30.0
# The relative accuracy of the pole frequency.
_SAME = 1e-12


@dataclass(frozen=True, slots=True)
class Suggestion:
    """A loop, its figures on the linear plant, and warnings."""

    loop: Loop
    figures: LoopFigures
    warnings: tuple[str, ...]


class BeyondPlant(ValueError):
    """Raised for a bandwidth that no gains can reach.

    `best` is about the highest possible one, Hz; 0 if no gains close the loop stably.
    """

    def __init__(self, message: str, best: float = 0.0) -> None:
        super().__init__(message)
        self.best = best


@lru_cache(maxsize=256)
def suggest(
    plant: Motor | VelocityDrive, target: float, base: Loop | None = None, *, integral: bool = True
) -> Suggestion:
    """Return gains for a closed-loop bandwidth of `target` Hz.

    Rates and limits are those of `base`. Raises `BeyondPlant` with the possible bandwidth.
    """
    linear = linearised(plant)
    loop = suggested_loop(linear, target, base or Loop(), integral)
    figures = loop_figures(loop, linear)
    return Suggestion(loop, figures, _warnings(plant, figures))


# Every axis with the same motor, whatever its friction, and every run of it in a session, needs the same.
@lru_cache(maxsize=256)
def suggested_loop(linear: Motor | VelocityDrive, target: float, base: Loop, integral: bool = True) -> Loop:
    """Return the suggested loop for a `linearised` plant.

    It has no DAC steps and no deadband of the output.
    """
    if not 0.0 < target < inf:
        raise ValueError(f"the bandwidth must be greater than zero, not {target}")
    plain = replace(
        base, override=None, dac_bits=0, output_deadband=0.0, arithmetic="real", derivative_every=1
    )
    shaped = _shape(linear, plain, integral)
    low, high = _range(linear, shaped, target)
    return shaped(_least(lambda w: bandwidth(shaped(w), linear) - target, low, high))


def _least(value: Callable[[float], float], low: float, high: float) -> float:
    """Return where `value` becomes non-negative, to a relative accuracy of 10⁻¹².

    This is the Illinois method (Dowell and Jarratt). One value costs about a millisecond; bisection needs
    more than fifty of them, the secant method some twenty.
    """
    below, above = value(low), value(high)
    last = 0
    while high - low > _SAME * high:
        middle = low - below * (high - low) / (above - below)
        edge = 0.25 * _SAME * high  # a secant that ends in a corner steps over it
        middle = min(max(middle, low + edge), high - edge)
        found = value(middle)
        if found < 0.0:
            low, below = middle, found
            above *= 0.5 if last < 0 else 1.0
            last = -1
        else:
            high, above = middle, found
            below *= 0.5 if last > 0 else 1.0
            last = 1
        if not below < 0.0 < above:
            break
    return high


def linearised(plant: Motor | VelocityDrive) -> Motor | VelocityDrive:
    """Return the plant without friction, backlash and encoder steps."""
    if isinstance(plant, VelocityDrive):
        return replace(plant, quantised=False)
    return replace(plant, coulomb=0.0, breakaway=0.0, backlash=0.0, quantised=False, load_torque=0.0)


def _shape(plant: Motor | VelocityDrive, base: Loop, integral: bool) -> Callable[[float], Loop]:
    """Return a function that maps a triple-pole frequency (rad/s) to a loop.

    tau s³ + (1 + K Kd) s² + K Kp s + K Ki = tau (s + w)³ gives K/tau Kd = 3w - 1/tau, K/tau Kp = 3w², K/tau
    Ki = w³. If the plant's own damping is higher, there is no derivative, and (s + w)² of the slower poles
    remains.
    """
    push, damping = _constants(plant)

    def shaped(w: float) -> Loop:
        kd, kp, ki = 3.0 * w - damping, 3.0 * w * w, w**3
        if kd < 0.0:
            kd, kp, ki = 0.0, 2.0 * w * damping, w * w * damping
        if not integral:
            kd, kp, ki = max(0.0, 2.0 * w - damping), w * max(w, 0.5 * damping), 0.0
        return replace(
            base,
            proportional=kp / push,
            integral=ki / push / base.servo_rate,
            integral_limit=min(base.integral_limit, base.output_limit),
            derivative=kd / push * base.servo_rate,
            velocity_feedback=0.0,
            velocity_ff=damping / push,
            accel_ff=1.0 / push,
            decel_ff=1.0 / push,
        )

    return shaped


def _constants(plant: Motor | VelocityDrive) -> tuple[float, float]:
    """Return K/tau (counts/s² per volt) and 1/tau (1/s)."""
    if isinstance(plant, VelocityDrive):
        return plant.speed_per_volt / plant.time_constant, 1.0 / plant.time_constant
    torque = plant.torque_constant * plant.amplifier_gain
    if plant.amplifier == "voltage":
        torque /= plant.resistance
    return torque * plant.counts_per_radian / plant.total_inertia, 1.0 / plant.mechanical_time_constant


def _range(
    plant: Motor | VelocityDrive, shaped: Callable[[float], Loop], target: float
) -> tuple[float, float]:
    """Return stable pole frequencies with bandwidths below and above the target."""
    low = 2.0 * pi * target
    # Stability of a loop takes a hundredth of the time of its bandwidth.
    while not is_stable(shaped(low), plant) or reaches(shaped(low), plant, target):
        low *= 0.7
        if low < 1e-4 * target:
            raise BeyondPlant("this plant cannot be closed stably with a PID loop at this servo rate")
    high = low
    tried: list[Loop] = []
    while True:
        high *= 1.05
        loop = shaped(high)
        if not is_stable(loop, plant):
            best = max((bandwidth(each, plant) for each in tried), default=0.0)
            where = f"this plant at {loop.servo_rate:.10g} servo samples a second"
            raise BeyondPlant(
                f"a bandwidth of {target:.10g} Hz is beyond {where}: about {best:.3g} Hz is possible", best
            )
        if reaches(loop, plant, target):
            return low, high
        tried.append(loop)


def _warnings(plant: Motor | VelocityDrive, figures: LoopFigures) -> tuple[str, ...]:
    found = []
    if figures.phase_margin < SUSPECT:
        found.append(f"the phase margin is only {figures.phase_margin:.0f} degrees: ask for less bandwidth")
    if isinstance(plant, Motor) and plant.coulomb:
        found.append(
            "Coulomb friction is not in these figures: expect a slow last count, and let the integral act"
        )
    if isinstance(plant, Motor) and plant.backlash:
        found.append("backlash is not in these figures: the loop may hunt inside it")
    if isinstance(plant, Motor) and plant.resonance and figures.bandwidth > plant.resonance / 3.0:
        found.append(
            f"the resonance at {plant.resonance:.10g} Hz is less than three times the bandwidth away"
        )
    return tuple(found)
