"""PMC's technical note TN1069: its comparison of four profiles, for any move.

Figures are given exactly and as printed. Where they disagree, the exact figure is right; `ERRATA` explains the
error in print.
"""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.kernel.planners import Profile, plan

# counts/s^2
ACCELERATION = 100_000.0
# counts/s
VELOCITY = 40_000.0
# counts
DISTANCE = 40_000.0
# Trajectory cycles per second; the note states its times in cycles.
CYCLES = 1000.0

# T_1 / T_A of the trapezoidal S-curve.
RAMP = 0.1
# Upper bound of the figures of a demand, so that each of their squares is finite.
LARGEST = 1e100

COLUMNS = ("trapezoidal", "sinusoidal", "trapezoidal 0.1", "parabolic")

# The table on the note's last page.
PRINTED = {
    "T_A": (400.0, 628.0, 444.0, 800.0),
    "S_A": (8000.0, 12560.0, 8880.0, 10667.0),
    "S_V": (24000.0, 14880.0, 22240.0, 18667.0),
    "T_V": (600.0, 372.0, 556.0, 467.0),
}

ERRATA = (
    "The printed T_A of the trapezoidal S-curve, (1/RAMP) VEL/ACC, contradicts the printed 444: "
    "the right formula is VEL/(ACC (1 - RAMP)).",
    "The printed sinusoidal and 0.1 columns truncate T_A to whole cycles first (628 -> 12560, 444 -> 8880) "
    "and go on from there.",
    "The printed parabolic column uses S_A = 1/3 T_A VEL = 10667 and contradicts the note's own "
    "S_A = 2/3 T_A VEL = 21333. With the formula 40000 counts are too short for VEL = 40: "
    "the peak is sqrt(3 ACC S_TOT/8) = 38.72983346, and T_A is 774.5966692 cycles.",
    'S_V is garbled in both scans ("S_TOT - 2 S_A - S_D"); it is S_TOT - S_A - S_D.',
    "The printed position of the sinusoidal S-curve adds its sine, VEL T_A/(2 pi) sin(pi t/T_A), to VEL t/2; it is to "
    "be subtracted: at 0.3 T_A the print gives 7005.98 counts, the move has 533.84.",
    '"V maximum velocity (counts/sec^2)" is a misprint for counts/s.',
    "The printed integrals of the sinusoidal S-curve have sin 2 pi t and cos 2 pi t; their results, and the right "
    "formulas, have pi t/T_A.",
    "The note calls the parabolic profile the smoothest. Its acceleration jumps from 0 to ACC at the start, so its "
    "jerk is infinite there; that of the S-curves is finite.",
)


class Demand:
    """A move for the comparison, in counts and seconds.

    `ramp` is the parameter n of the trapezoidal S-curve.
    """

    __slots__ = ("acceleration", "deceleration", "distance", "ramp", "velocity")

    def __init__(
        self,
        acceleration: float = ACCELERATION,
        velocity: float = VELOCITY,
        distance: float = DISTANCE,
        deceleration: float | None = None,
        ramp: float = RAMP,
    ) -> None:
        self.acceleration, self.velocity, self.distance, self.ramp = acceleration, velocity, distance, ramp
        self.deceleration = acceleration if deceleration is None else deceleration
        for name in ("acceleration", "velocity", "distance", "deceleration"):
            value = getattr(self, name)
            if not 0.0 < value < LARGEST:
                raise ValueError(f"the {name} must be above zero and below {LARGEST:.10g}, not {value:.10g}")
        if not 0.0 < ramp < 0.5:
            raise ValueError(f"the ramp must be above 0 and below 0.5, not {ramp:.10g}")

    @property
    def printed(self) -> bool:
        """True if this is the note's own example."""
        return self.symmetric and (self.acceleration, self.velocity, self.distance, self.ramp) == (
            ACCELERATION, VELOCITY, DISTANCE, RAMP)  # fmt: skip

    @property
    def symmetric(self) -> bool:
        """True if acceleration and deceleration are equal."""
        return self.acceleration == self.deceleration

    @property
    def columns(self) -> tuple[str, str, str, str]:
        """The names of the profiles; the trapezoidal S-curve's includes its ramp."""
        return (*COLUMNS[:2], f"trapezoidal {self.ramp:.10g}", COLUMNS[3])


NOTE = Demand()


@dataclass(frozen=True, slots=True)
class Row:
    """One quantity of the table for the four profiles; None if it does not exist."""

    name: str
    unit: str
    exact: tuple[float | None, ...]
    printed: tuple[float, ...] | None


def profiles(demand: Demand = NOTE) -> tuple[Profile, Profile, Profile, Profile]:
    """Plan the move in each of the four shapes, in the order of `COLUMNS`.

    The units are counts and seconds.

    >>> [round(profile.duration, 6) for profile in profiles()]
    [1.4, 1.628319, 1.444444, 1.549193]
    """
    limits = (demand.velocity, demand.acceleration, demand.deceleration)
    return (
        plan("trapezoid", 0.0, demand.distance, *limits),
        plan("sinusoidal", 0.0, demand.distance, *limits),
        plan("scurve", 0.0, demand.distance, *limits, ramp=demand.ramp),
        plan("parabolic", 0.0, demand.distance, *limits),
    )


def nominal(demand: Demand = NOTE) -> tuple[Row, ...]:
    """Return T_A (cycles) and S_A (counts) of the ramp to full velocity.

    They are taken from a move that is long enough to reach this velocity, even if the demand is not. T_D and S_D follow
    if they differ.

    >>> time, distance = nominal()
    >>> round(distance.exact[3], 3), distance.printed[3]
    (21333.333, 10667.0)
    """
    slowest = min(demand.acceleration, demand.deceleration)
    room = 8.0 * demand.velocity * demand.velocity / slowest
    long = Demand(demand.acceleration, demand.velocity, room, demand.deceleration, demand.ramp)
    made = profiles(long)
    rows = []
    for letter, index in (("A", 0), ("D", -1)) if not demand.symmetric else (("A", 0),):
        ramps = [profile.phases[index] for profile in made]
        rows.append(_row(demand, f"T_{letter}", "cycles", tuple(ramp.duration * CYCLES for ramp in ramps)))
        rows.append(_row(demand, f"S_{letter}", "counts", tuple(ramp.distance for ramp in ramps)))
    return tuple(rows)


def comparison(demand: Demand = NOTE) -> tuple[Row, ...]:
    """Return the note's table, exact next to printed figures, with two more rows.

    The added rows are the peak and the whole move.

    >>> [row.exact[0] for row in comparison()]
    [400.0, 8000.0, 24000.0, 600.0, 40.0, 1400.0]
    """
    moves = profiles(demand)
    slews = [next((phase for phase in made.phases if phase.name == "slew"), None) for made in moves]
    distances = tuple(slew.distance if slew else None for slew in slews)
    times = tuple(slew.duration * CYCLES if slew else None for slew in slews)
    return (
        *nominal(demand),
        _row(demand, "S_V", "counts", distances),
        _row(demand, "T_V", "cycles", times),
        Row("peak", "counts/cycle", tuple(made.peak_speed / CYCLES for made in moves), None),
        Row("the whole move", "cycles", tuple(made.duration * CYCLES for made in moves), None),
    )


def _row(demand: Demand, name: str, unit: str, exact: tuple[float | None, ...]) -> Row:
    return Row(name, unit, exact, PRINTED.get(name) if demand.printed else None)
