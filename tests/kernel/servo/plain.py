"""The servo in its simplest form, step by step: the reference for the real one.

It shares no code with the package: the plant is integrated by a separate matrix exponential, one regime at a
time.
"""

from __future__ import annotations

from math import copysign, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.servo import Loop, Motor, VelocityDrive

Array = NDArray[np.float64]


def expm(m: Array) -> Array:
    """Return the exponential of a matrix by its definition: (1 + m/2^k + ...)^(2^k).

    It uses extended precision.
    """
    k = max(0, int(np.ceil(np.log2(max(1e-12, float(np.abs(m).sum(axis=1).max()))))) + 4)
    x: Any = m.astype(np.longdouble) / 2.0**k
    total: Any = np.eye(len(m), dtype=np.longdouble)
    term = total
    for n in range(1, 25):
        term = term @ x / n
        total = total + term
    for _ in range(k):
        total = total @ total
    made: Array = total.astype(np.float64)
    return made


def clamp(value: float, low: float, high: float) -> float:
    return max(low, min(high, value))


class PlainPlant:
    """A plant with the states position, velocity, current, twist, load velocity.

    States that the plant does not have stay zero.
    """

    def __init__(self, plant: Motor | VelocityDrive, h: float, position: float) -> None:
        self.plant, self.h = plant, h
        # Numbers of Python, with which arithmetic takes a fifth of the time that NumPy's take.
        self.x = [float(position), 0.0, 0.0, 0.0, 0.0]
        self.cache: dict[tuple[int, int], Array] = {}

    def measured(self) -> float:
        plant = self.plant
        y = self.x[0]
        if isinstance(plant, Motor) and plant.encoder == "load":
            y = y - self.x[3]
        return float(np.rint(y)) if plant.quantised else float(y)

    def current(self, u: float) -> float:
        plant = self.plant
        if isinstance(plant, VelocityDrive):
            return 0.0
        if plant.amplifier == "current":
            return plant.amplifier_gain * u
        if plant.inductance:
            return float(self.x[2])
        back = plant.torque_constant * self.x[1] / plant.counts_per_radian
        return float((plant.amplifier_gain * u - back) / plant.resistance)

    def torques(self, u: float, contact: int) -> float:
        """Return the torque on the shaft, N m, without Coulomb friction and own damping."""
        plant = self.plant
        assert isinstance(plant, Motor)
        total = plant.torque_constant * self.current(u)
        if not plant.resonance:
            return total - plant.load_torque
        if contact == 0:
            return total
        together = plant.inertia * plant.load_inertia / (plant.inertia + plant.load_inertia)
        omega = 2 * pi * plant.resonance
        swing = self.x[3] - contact * plant.backlash / 2
        slip = self.x[1] - self.x[4]
        spring = omega**2 * together * swing + 2 * plant.resonance_damping * omega * together * slip
        return float(total - spring / plant.counts_per_radian)

    def step(self, u: float) -> None:
        plant = self.plant
        if isinstance(plant, VelocityDrive):
            self.x = self.next(1, 1, u)
            return
        half = plant.backlash / 2
        contact = 1 if not half else 1 if self.x[3] > half else -1 if self.x[3] < -half else 0
        side = 1
        if plant.coulomb or plant.breakaway:
            push = self.torques(u, contact)
            hold = max(plant.coulomb, plant.breakaway)
            side = int(np.sign(self.x[1])) or (int(np.sign(push)) if abs(push) > hold else 0)
        before = self.x
        self.x = self.next(side, contact, u)
        if (plant.coulomb or plant.breakaway) and self.x[1] * side < 0.0:
            self.x[0] = before[0] + 0.5 * self.h * before[1] ** 2 / (before[1] - self.x[1])
            self.x[1] = 0.0

    def next(self, side: int, contact: int, u: float) -> list[float]:
        found: list[float] = (self.matrix(side, contact) @ np.array([*self.x, u, 1.0])).tolist()
        return found

    def matrix(self, side: int, contact: int) -> Array:
        key = (side, contact)
        if key not in self.cache:
            self.cache[key] = expm(self.continuous(side, contact) * self.h)[:5]
        return self.cache[key]

    def continuous(self, side: int, contact: int) -> Array:
        m, plant = np.zeros((7, 7)), self.plant
        m[0, 1] = 1.0
        if isinstance(plant, VelocityDrive):
            m[1, 1], m[1, 5] = -1 / plant.time_constant, plant.speed_per_volt / plant.time_constant
            return m
        kappa = plant.counts_per_radian
        inertia = plant.inertia if plant.resonance else plant.inertia + plant.load_inertia
        torque = np.zeros(7)
        if plant.amplifier == "current":
            torque[5] = plant.torque_constant * plant.amplifier_gain
        elif plant.inductance:
            torque[2] = plant.torque_constant
            m[2] = [0, -plant.torque_constant / kappa, -plant.resistance, 0, 0, plant.amplifier_gain, 0]
            m[2] /= plant.inductance
        else:
            torque[5] = plant.torque_constant * plant.amplifier_gain / plant.resistance
            torque[1] = -(plant.torque_constant**2) / plant.resistance / kappa
        torque[1] -= plant.viscous / kappa
        torque[6] -= side * plant.coulomb
        if plant.resonance:
            together = plant.inertia * plant.load_inertia / (plant.inertia + plant.load_inertia)
            omega = 2 * pi * plant.resonance
            spring = np.zeros(7)
            if contact:
                spring[3] = omega**2 * together
                spring[6] = -spring[3] * contact * plant.backlash / 2
                spring[1] = 2 * plant.resonance_damping * omega * together
                spring[4] = -spring[1]
            spring /= kappa
            m[3, 1], m[3, 4] = 1.0, -1.0
            m[4] = spring
            m[4, 6] -= plant.load_torque
            m[4] *= kappa / plant.load_inertia
            torque -= spring
        else:
            torque[6] -= plant.load_torque
        m[1] = torque * kappa / inertia
        if side == 0 and (plant.coulomb or plant.breakaway):
            m[0] = m[1] = 0.0
        return m


class PlainLoop:
    """The control law of `Loop`, computed one sample at a time."""

    def __init__(self, loop: Loop, position: float) -> None:
        self.loop = loop
        self.total = self.last_error = self.change = 0.0
        self.last_position = position
        self.derivative_wait = self.hold_wait = 0
        self.held = 0.0
        self.contribution = 0.0

    def output(self, demand: float, y: float, velocity: float, feed: float, acts: bool) -> float:
        loop = self.loop
        whole = loop.arithmetic != "real"
        e = float(np.rint(demand) - np.rint(y)) if whole else demand - y
        if loop.arithmetic == "lm628":
            e = clamp(e, -32768, 32767)
        if acts:
            self.total += e
        if self.derivative_wait:
            self.derivative_wait -= 1
        else:
            self.derivative_wait = loop.derivative_every - 1
            self.change, self.last_error = e - self.last_error, e
        steps = self.whole_sum(e) if whole else self.real_sum(e, y, feed)
        if loop.reversed and whole:
            steps = -steps
        if whole:
            top = float(int(loop.output_limit / loop.dac_step))
            return self.dac(clamp(steps, -top, top), velocity)
        return steps if not loop.dac_bits else self.dac(float(np.rint(steps / loop.dac_step)), velocity)

    def real_sum(self, e: float, y: float, feed: float) -> float:
        loop = self.loop
        if loop.limit_style == "sum" and loop.integral:
            self.total = clamp(
                self.total,
                *sorted((-loop.integral_limit / loop.integral, loop.integral_limit / loop.integral)),
            )
        self.contribution = clamp(loop.integral * self.total, -loop.integral_limit, loop.integral_limit)
        u = loop.proportional * e + self.contribution + loop.derivative * self.change
        u += feed - loop.velocity_feedback * (y - self.last_position)
        self.last_position = y
        if abs(u) < loop.output_deadband:
            u = 0.0
        u += loop.output_offset
        return clamp(-u if loop.reversed else u, -loop.output_limit, loop.output_limit)

    def whole_sum(self, e: float) -> float:
        """Return the integer output: the sum of all terms, in Python's own integers."""
        loop = self.loop
        e, change = int(e), int(self.change)
        kp, ki, kd = int(loop.proportional), int(loop.integral), int(loop.derivative)
        divisor = 1 << (16 - loop.dac_bits)
        limit = loop.integral_limit
        if loop.arithmetic == "chapter12":
            i = int(clamp(_truncated(ki * int(self.total), 256), -limit, limit))
            total = _truncated(kp * e + kd * change + i, divisor)
        else:
            self.total = clamp(self.total, -(2**23), 2**23 - 1)
            i = int(clamp(ki * (int(self.total) >> 8), -limit, limit))
            total = self.word(self.word(kp * e) + self.word(kd * change) + i) // divisor
        self.contribution = i / divisor * loop.dac_step
        return float(total)

    def word(self, value: int) -> int:
        if self.loop.wrap:
            return (value + 32768) % 65536 - 32768
        return int(clamp(value, -32768, 32767))

    def dac(self, steps: float, velocity: float) -> float:
        loop = self.loop
        full = 1 << (loop.dac_bits - 1)
        if loop.override and self.hold_wait:
            self.hold_wait -= 1
            steps = self.held
        elif loop.override:
            self.hold_wait = loop.override.hold - 1
            actual = float(np.rint(velocity / loop.override.speed * full))
            steps = self.held = clamp(steps, actual - loop.override.steps, actual + loop.override.steps)
        return clamp(steps, -full, full - 1) * loop.dac_step


def _truncated(value: int, divisor: int) -> int:
    return int(copysign(abs(value) // divisor, value))


def run_plain(loop: Loop, plant: Motor | VelocityDrive, points: Array, demanded: Array) -> dict[str, Array]:
    """Return the columns of a simulation, with a sample for every demanded position.

    `points` are those of the trajectory, for the terms that depend on its cycle.
    """
    at: list[float] = points.tolist()
    controller, motor = PlainLoop(loop, at[0]), PlainPlant(plant, loop.period, at[0])
    ratio, rows = loop.ratio, []
    for n, demand in enumerate(demanded.tolist()):
        i = n // ratio
        before, here, there = at[max(i - 1, 0)], at[i], at[i + 1]
        acts = _acts(loop.integral_mode, there - here, there - 2 * here + before)
        if loop.integral_mode == "zeroed" and not acts:
            controller.total = 0.0
        y, velocity = motor.measured(), motor.x[1]
        feed = _feed(loop, here - before, there - here)
        u = controller.output(demand, y, velocity, feed, acts)
        rows.append((motor.x[0], velocity, motor.current(u), motor.x[3], controller.contribution, u))
        motor.step(u)
    names = ("position", "velocity", "current", "twist", "integral", "output")
    return dict(zip(names, np.array(rows).T, strict=True))


def _acts(mode: str, speed: float, change: float) -> bool:
    if mode in ("always", "never"):
        return mode == "always"
    return abs(change if mode == "steady" else speed) < 1e-8


def _feed(loop: Loop, last: float, speed: float) -> float:
    rate = loop.trajectory_rate
    slowing = abs(speed) < abs(last)
    gain = loop.decel_ff if slowing else loop.accel_ff
    return loop.velocity_ff * speed * rate + gain * (speed - last) * rate**2
