"""Exact discretisation of the plant: x' = A x + b u + w with a constant output u.

Friction and backlash make the plant piecewise linear. A `Regime` is one linear piece: it is defined by the
direction in which the motor slides (or that it sticks), and the flank of the backlash in contact. Each has its own
exact matrices.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log2, pi

from motionlang.planners.total import total
from motionlang.servo.plant import Drive, Motor

Matrix = tuple[tuple[float, ...], ...]

SLIDING_UP, STUCK, SLIDING_DOWN = 1, 0, -1
"""Friction: the direction of the motor, 0 while it sticks."""


@dataclass(frozen=True, slots=True)
class Regime:
    """Exact matrices over one sample, and the acceleration without friction.

    The acceleration decides whether the motor breaks away.
    """

    a: Matrix
    b: tuple[float, ...]
    w: tuple[float, ...]
    drive: tuple[float, ...]
    """Acceleration without friction: coefficients of states, output, and the constant."""


@dataclass(frozen=True, slots=True)
class Discrete:
    """A plant at one sample period.

    `names` are its states; `regimes` is keyed by (friction, contact). `current` gives the motor current from
    the states, the output and 1; `coulomb` and `breakaway` are accelerations in counts/s².
    """

    names: tuple[str, ...]
    regimes: dict[tuple[int, int], Regime]
    current: tuple[float, ...]
    breakaway: float
    has_friction: bool
    backlash: float
    quantised: bool
    load_encoder: bool


@lru_cache(maxsize=64)
def discretise(plant: Motor | Drive, period: float) -> Discrete:
    """Return the plant's exact matrices for samples `period` seconds apart."""
    if isinstance(plant, Drive):
        return _drive(plant, period)
    names = ["position", "velocity"]
    if plant.has_current_state:
        names.append("current")
    if plant.resonance:
        names += ["twist", "load_velocity"]
    friction = bool(plant.coulomb or plant.breakaway)
    slides = (SLIDING_UP, STUCK, SLIDING_DOWN) if friction else (SLIDING_UP,)
    contacts = (1, 0, -1) if plant.backlash else (1,)
    side = plant.inertia if plant.resonance else plant.total_inertia
    scale = plant.counts_per_radian / side
    return Discrete(
        names=tuple(names),
        regimes={(f, c): _regime(plant, names, f, c, period) for f in slides for c in contacts},
        current=_current_row(plant, names),
        breakaway=scale * max(plant.coulomb, plant.breakaway),
        has_friction=friction,
        backlash=plant.backlash,
        quantised=plant.quantised,
        load_encoder=plant.encoder == "load" and plant.resonance > 0.0,
    )


def _drive(plant: Drive, period: float) -> Discrete:
    gain = plant.speed_per_volt / plant.time_constant
    continuous = [[0.0, 1.0, 0.0, 0.0], [0.0, -1.0 / plant.time_constant, gain, 0.0]]
    regime = _integrate(continuous, period, (0.0, -1.0 / plant.time_constant, gain, 0.0))
    names = ("position", "velocity")
    return Discrete(names, {(1, 1): regime}, (0.0,) * 4, 0.0, False, 0.0, plant.quantised, False)


def _regime(plant: Motor, names: list[str], friction: int, contact: int, period: float) -> Regime:
    rows = _continuous(plant, names, contact)
    drive = tuple(rows[1])
    if friction == STUCK and (plant.coulomb or plant.breakaway):
        size = len(names) + 2
        rows[0] = [0.0] * size
        rows[1] = [0.0] * size
    else:
        side = plant.inertia if plant.resonance else plant.total_inertia
        rows[1][-1] -= friction * plant.coulomb * plant.counts_per_radian / side
    return _integrate(rows, period, drive)


def _continuous(plant: Motor, names: list[str], contact: int) -> list[list[float]]:
    """Return the rows of dx/dt over (states, output, 1), without friction.

    Positions are in counts.
    """
    size = len(names) + 2
    row_of = {name: i for i, name in enumerate(names)}
    out, one = size - 2, size - 1
    rows = [[0.0] * size for _ in names]
    side = plant.inertia if plant.resonance else plant.total_inertia
    scale = plant.counts_per_radian
    rows[0][1] = 1.0
    rows[1][1] = -plant.viscous / side
    push = scale * plant.torque_constant / side
    for i, share in enumerate(_current_row(plant, names)):
        rows[1][i] += push * share
    if plant.has_current_state:
        row = rows[row_of["current"]]
        row[row_of["current"]] = -plant.resistance / plant.inductance
        row[1] = -plant.torque_constant / (scale * plant.inductance)
        row[out] = plant.amplifier_gain / plant.inductance
    if plant.resonance:
        _couple(plant, rows, row_of, contact)
        rows[row_of["load_velocity"]][one] -= scale * plant.load_torque / plant.load_inertia
    else:
        rows[1][one] -= scale * plant.load_torque / side
    return rows


def _couple(plant: Motor, rows: list[list[float]], row_of: dict[str, int], contact: int) -> None:
    """Add the spring between motor and load, unless the backlash gap is open."""
    twist, load = row_of["twist"], row_of["load_velocity"]
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


def _current_row(plant: Motor, names: list[str]) -> tuple[float, ...]:
    """Return the motor current as coefficients of (states, output, 1)."""
    row = [0.0] * (len(names) + 2)
    if plant.has_current_state:
        row[names.index("current")] = 1.0
    elif plant.amplifier == "current":
        row[-2] = plant.amplifier_gain
    else:
        row[1] = -plant.torque_constant / (plant.counts_per_radian * plant.resistance)
        row[-2] = plant.amplifier_gain / plant.resistance
    return tuple(row)


def _integrate(rows: list[list[float]], period: float, drive: tuple[float, ...]) -> Regime:
    size = len(rows)
    square = [[value * period for value in row] for row in rows] + [[0.0] * (size + 2) for _ in range(2)]
    e = exponential(square)
    return Regime(
        a=tuple(tuple(e[i][:size]) for i in range(size)),
        b=tuple(e[i][size] for i in range(size)),
        w=tuple(e[i][size + 1] for i in range(size)),
        drive=drive,
    )


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
