"""Exact discretisation of the plant: x' = A x + b u + w with a constant output u.

Friction and backlash make the plant piecewise linear. A `Regime` is one linear piece: it is defined by the
direction in which the motor slides (or that it sticks), and the flank of the backlash in contact. Each has its own
exact matrix. Rows of coefficients are over `STATES`, the output, and 1; a state that a plant does not have stays zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log2, pi

from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.tools import total

Row = tuple[float, float, float, float, float, float, float]
# The values of `STATES`.
Motion = tuple[float, float, float, float, float]

# Counts, counts/s, A, counts (motor minus load), counts/s.
STATES = ("position", "velocity", "current", "twist", "load_velocity")
_OUTPUT, _ONE = len(STATES), len(STATES) + 1
# Friction: the direction of the motor, 0 while it sticks.
SLIDING_UP, STUCK, SLIDING_DOWN = 1, 0, -1


@dataclass(frozen=True, slots=True)
class Regime:
    """One sample of a linear plant, exactly: a row for each of `STATES`.

    `drive` is the acceleration without friction, which decides whether the motor breaks away.
    """

    rows: tuple[Row, Row, Row, Row, Row]
    drive: Row


@dataclass(frozen=True, slots=True)
class Discrete:
    """A plant at one sample period.

    `regimes` is keyed by (friction, contact). `current` gives the motor current; `breakaway` is an acceleration in
    counts/s².
    """

    regimes: dict[tuple[int, int], Regime]
    current: Row
    period: float
    breakaway: float = 0.0
    has_friction: bool = False
    has_twist: bool = False
    backlash: float = 0.0
    quantised: bool = False
    load_encoder: bool = False

    def advance(self, motion: Motion, output: float) -> Motion:
        """Return the motion one sample later, with a constant output in volts."""
        contact = 1
        if self.backlash:
            twist, half = motion[3], 0.5 * self.backlash
            contact = 1 if twist > half else -1 if twist < -half else 0
        if not self.has_friction:
            return self._linear(motion, output, SLIDING_UP, contact)
        direction = self._direction(motion, output, contact)
        after = self._linear(motion, output, direction, contact)
        if after[1] * direction >= 0.0:
            return after
        # A motor that would reverse within the sample stops, and may stick in the next one.
        position, velocity = motion[0], motion[1]
        stop = position + 0.5 * self.period * velocity * velocity / (velocity - after[1])
        return stop, 0.0, after[2], after[3], after[4]

    def _direction(self, motion: Motion, output: float, contact: int) -> int:
        """Return the direction in which the motor slides or breaks away, or `STUCK`."""
        if motion[1] != 0.0:
            return SLIDING_UP if motion[1] > 0.0 else SLIDING_DOWN
        push = _applied(self.regimes[STUCK, contact].drive, motion, output)
        if abs(push) <= self.breakaway:
            return STUCK
        return SLIDING_UP if push > 0.0 else SLIDING_DOWN

    def _linear(self, motion: Motion, output: float, direction: int, contact: int) -> Motion:
        rows = self.regimes[direction, contact].rows
        if self.has_twist:
            return tuple([_applied(row, motion, output) for row in rows])  # type: ignore[return-value]
        (_, pv, pc, _, _, pu, p1), (_, vv, vc, _, _, vu, v1), (_, cv, cc, _, _, cu, c1), _, _ = rows
        position, velocity, current, _, _ = motion
        return (
            position + pv * velocity + pc * current + pu * output + p1,
            vv * velocity + vc * current + vu * output + v1,
            cv * velocity + cc * current + cu * output + c1,
            0.0,
            0.0,
        )

    def current_of(self, motion: Motion, output: float) -> float:
        """Return the motor current, A."""
        return _applied(self.current, motion, output)


def _applied(row: Row, motion: Motion, output: float) -> float:
    kp, kv, kc, kd, kw, ku, k1 = row
    position, velocity, current, twist, load_velocity = motion
    return kp * position + kv * velocity + kc * current + kd * twist + kw * load_velocity + ku * output + k1


@lru_cache(maxsize=64)
def discretise(plant: Motor | VelocityDrive, period: float) -> Discrete:
    """Return the plant's exact matrices for samples `period` seconds apart."""
    if isinstance(plant, VelocityDrive):
        return _drive(plant, period)
    friction = bool(plant.coulomb or plant.breakaway)
    slides = (SLIDING_UP, STUCK, SLIDING_DOWN) if friction else (SLIDING_UP,)
    contacts = (1, 0, -1) if plant.backlash else (1,)
    side = plant.inertia if plant.resonance else plant.total_inertia
    scale = plant.counts_per_radian / side
    return Discrete(
        regimes={(f, c): _regime(plant, f, c, period) for f in slides for c in contacts},
        current=_current_row(plant),
        period=period,
        breakaway=scale * max(plant.coulomb, plant.breakaway),
        has_friction=friction,
        has_twist=plant.resonance > 0.0,
        backlash=plant.backlash,
        quantised=plant.quantised,
        load_encoder=plant.encoder == "load" and plant.resonance > 0.0,
    )


def _drive(plant: VelocityDrive, period: float) -> Discrete:
    gain, rows = plant.speed_per_volt / plant.time_constant, _no_rows()
    rows[0][1], rows[1][1], rows[1][_OUTPUT] = 1.0, -1.0 / plant.time_constant, gain
    regime = _integrate(rows, period, rows[1])
    return Discrete({(1, 1): regime}, (0.0,) * 7, period, quantised=plant.quantised)


def _no_rows() -> list[list[float]]:
    return [[0.0] * (len(STATES) + 2) for _ in STATES]


def _regime(plant: Motor, friction: int, contact: int, period: float) -> Regime:
    rows = _continuous(plant, contact)
    drive = rows[1][:]
    if friction == STUCK and (plant.coulomb or plant.breakaway):
        rows[:2] = _no_rows()[:2]
    else:
        side = plant.inertia if plant.resonance else plant.total_inertia
        rows[1][_ONE] -= friction * plant.coulomb * plant.counts_per_radian / side
    return _integrate(rows, period, drive)


def _continuous(plant: Motor, contact: int) -> list[list[float]]:
    """Return the rows of dx/dt, without friction; positions are in counts."""
    rows = _no_rows()
    position, velocity, current, _, load_velocity = rows
    side = plant.inertia if plant.resonance else plant.total_inertia
    scale = plant.counts_per_radian
    position[1] = 1.0
    velocity[1] = -plant.viscous / side
    push = scale * plant.torque_constant / side
    for i, share in enumerate(_current_row(plant)):
        velocity[i] += push * share
    if plant.has_current_state:
        current[2] = -plant.resistance / plant.inductance
        current[1] = -plant.torque_constant / (scale * plant.inductance)
        current[_OUTPUT] = plant.amplifier_gain / plant.inductance
    if plant.resonance:
        _couple(plant, rows, contact)
        load_velocity[_ONE] -= scale * plant.load_torque / plant.load_inertia
    else:
        velocity[_ONE] -= scale * plant.load_torque / side
    return rows


def _couple(plant: Motor, rows: list[list[float]], contact: int) -> None:
    """Add the spring between motor and load, unless the backlash gap is open."""
    twist, load = STATES.index("twist"), STATES.index("load_velocity")
    rows[twist][1], rows[twist][load] = 1.0, -1.0
    if contact == 0:
        return
    together = plant.inertia * plant.load_inertia / plant.total_inertia
    stiffness = (2.0 * pi * plant.resonance) ** 2 * together
    damping = 2.0 * plant.resonance_damping * (2.0 * pi * plant.resonance) * together
    slack = contact * 0.5 * plant.backlash
    for row, share in ((rows[1], -1.0 / plant.inertia), (rows[load], 1.0 / plant.load_inertia)):
        row[twist] += stiffness * share
        row[1] += damping * share
        row[load] -= damping * share
        row[-1] -= stiffness * share * slack


def _current_row(plant: Motor) -> Row:
    if plant.has_current_state:
        return 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0
    if plant.amplifier == "current":
        return 0.0, 0.0, 0.0, 0.0, 0.0, plant.amplifier_gain, 0.0
    back = -plant.torque_constant / (plant.counts_per_radian * plant.resistance)
    return 0.0, back, 0.0, 0.0, 0.0, plant.amplifier_gain / plant.resistance, 0.0


def _integrate(rows: list[list[float]], period: float, drive: list[float]) -> Regime:
    size = len(rows)
    square = [[value * period for value in row] for row in rows] + [[0.0] * (size + 2) for _ in range(2)]
    made = tuple(map(tuple, exponential(square)[:size]))
    return Regime(made, tuple(drive))  # type: ignore[arg-type]


def exponential(m: list[list[float]]) -> list[list[float]]:
    """Return the matrix exponential by scaling, a Taylor series and squaring.

    It is accurate to rounding for small matrices.
    """
    norm = max(total(abs(value) for value in row) for row in m)
    halvings = max(0, ceil(log2(norm)) + 5) if norm > 0.0 else 0
    x = [[value / 2.0**halvings for value in row] for row in m]
    # Squaring exp - 1 instead of exp preserves the full precision of the small entries of a short step.
    term, rest = x, [row[:] for row in x]
    for k in range(2, 16):
        term = [[value / k for value in row] for row in product(term, x)]
        rest = _sum(rest, term)
    for _ in range(halvings):
        rest = _sum(product(rest, rest), _sum(rest, rest))
    return [[value + (i == j) for j, value in enumerate(row)] for i, row in enumerate(rest)]


def product(a: list[list[float]], b: list[list[float]]) -> list[list[float]]:
    """Return the matrix product."""
    columns = list(zip(*b, strict=True))
    return [[total(x * y for x, y in zip(row, column, strict=True)) for column in columns] for row in a]


def _sum(a: list[list[float]], b: list[list[float]]) -> list[list[float]]:
    return [[x + y for x, y in zip(p, q, strict=True)] for p, q in zip(a, b, strict=True)]
