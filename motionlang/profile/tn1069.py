"""PMC's technical note TN1069: its comparison of four profiles, exact and as printed.

Where the print and the physics disagree the exact figure is right; `ERRATA` says what went wrong.
"""

from __future__ import annotations

from motionlang.profile.curve import Profile
from motionlang.profile.parabolic import plan_parabolic
from motionlang.profile.scurve import plan_ratio, plan_sinusoidal
from motionlang.profile.trapezoid import plan_trapezoid

ACCELERATION = 100_000.0
"""counts/s^2"""
VELOCITY = 40_000.0
"""counts/s"""
DISTANCE = 40_000.0
"""counts"""
CYCLES = 1000.0
"""Trajectory cycles a second: the note gives its times in cycles."""

COLUMNS = ("trapezoidal", "sinusoidal", "trapezoidal 0.1", "parabolic")

PRINTED = {
    "T_A": (400.0, 628.0, 444.0, 800.0),
    "S_A": (8000.0, 12560.0, 8880.0, 10667.0),
    "S_V": (24000.0, 14880.0, 22240.0, 18667.0),
    "T_V": (600.0, 372.0, 556.0, 467.0),
}
"""The table on the note's last page."""

ERRATA = (
    "The printed T_A of the trapezoidal S-curve, (1/RAMP) VEL/ACC, contradicts the printed 444: "
    "the right formula is VEL/(ACC (1 - RAMP)).",
    "The printed sinusoidal and 0.1 columns truncate T_A to whole cycles first (628 -> 12560, 444 -> 8880) "
    "and go on from there.",
    "The printed parabolic column uses S_A = 1/3 T_A VEL = 10667 and contradicts the note's own "
    "S_A = 2/3 T_A VEL = 21333. With the formula 40000 counts are too short for VEL = 40: "
    "the peak is sqrt(3 ACC S_TOT/8) = 38.72983346, and T_A is 774.5966692 cycles.",
    'S_V is garbled in both scans ("S_TOT - 2 S_A - S_D"); it is S_TOT - S_A - S_D.',
    '"V maximum velocity (counts/sec^2)" is a misprint for counts/s.',
)


class Row:
    """One quantity of the table for the four profiles; None where the move has no such figure."""

    __slots__ = ("exact", "name", "printed", "unit")

    def __init__(
        self, name: str, unit: str, exact: tuple[float | None, ...], printed: tuple[float, ...] | None
    ) -> None:
        self.name = name
        self.unit = unit
        self.exact = exact
        self.printed = printed


def profiles(
    acceleration: float = ACCELERATION,
    velocity: float = VELOCITY,
    distance: float = DISTANCE,
    ramp: float = 0.1,
) -> tuple[Profile, Profile, Profile, Profile]:
    """The move planned in each of the four shapes (counts, seconds), in the order of `COLUMNS`."""
    limits = (velocity, acceleration, acceleration)
    return (
        plan_trapezoid(0.0, distance, *limits),
        plan_sinusoidal(0.0, distance, *limits),
        plan_ratio(0.0, distance, *limits, ramp),
        plan_parabolic(0.0, distance, *limits),
    )


def nominal(acceleration: float = ACCELERATION, velocity: float = VELOCITY) -> tuple[Row, Row]:
    """T_A (cycles) and S_A (counts) of the ramp to full velocity, whether or not the move has room for it.

    Each is read off a move long enough to reach it.
    """
    room = 8.0 * velocity * velocity / acceleration
    ramps = [made.phases[0] for made in profiles(acceleration, velocity, room)]
    times = tuple(ramp.duration * CYCLES for ramp in ramps)
    return (
        Row("T_A", "cycles", times, PRINTED["T_A"]),
        Row("S_A", "counts", tuple(ramp.distance for ramp in ramps), PRINTED["S_A"]),
    )


def comparison() -> tuple[Row, ...]:
    """The note's table, exact beside printed, with two rows of our own: the peak and the whole move."""
    moves = profiles()
    slews = [next((phase for phase in made.phases if phase.name == "slew"), None) for made in moves]
    distances = tuple(slew.distance if slew else None for slew in slews)
    times = tuple(slew.duration * CYCLES if slew else None for slew in slews)
    return (
        *nominal(),
        Row("S_V", "counts", distances, PRINTED["S_V"]),
        Row("T_V", "cycles", times, PRINTED["T_V"]),
        Row("peak", "counts/cycle", tuple(made.peak_speed / CYCLES for made in moves), None),
        Row("the whole move", "cycles", tuple(made.duration * CYCLES for made in moves), None),
    )
