"""The plant: the effect of an output voltage on the position.

`Motor` is a DC motor, or a brushless one seen through its commutation (terminal-to-terminal R and L, and the
torque constant of the commutated current), with its load. `VelocityDrive` is an amplifier with its own velocity loop:
chapter 12's model of a drive, a first-order lag between commanded and actual velocity. Units are SI except
for positions, which are counts.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi

AMPLIFIERS = ("voltage", "current")
ENCODER_SIDES = ("motor", "load")


@dataclass(frozen=True, slots=True)
class Motor:
    """A motor with a load, and optionally a resonance, friction and backlash.

    `amplifier_gain` is V/V for a voltage amplifier and A/V for a current one. `load_torque` pulls in the
    negative direction (gravity). `resonance` is the frequency in Hz at which motor and load oscillate against
    each other; `backlash` is the free play between them in counts. `quantised` rounds the encoder to integer
    counts.
    """

    resistance: float = 1.0
    inductance: float = 1e-3
    torque_constant: float = 0.05
    inertia: float = 2e-5
    load_inertia: float = 0.0
    viscous: float = 1e-5
    coulomb: float = 0.0
    breakaway: float = 0.0
    load_torque: float = 0.0
    resonance: float = 0.0
    resonance_damping: float = 0.02
    backlash: float = 0.0
    counts_per_rev: float = 4000.0
    quantised: bool = False
    encoder: str = "motor"
    amplifier: str = "voltage"
    amplifier_gain: float = 2.4

    def __post_init__(self) -> None:
        for name in ("resistance", "torque_constant", "inertia", "counts_per_rev", "amplifier_gain"):
            _positive(name, getattr(self, name))
        for name in (
            "inductance",
            "load_inertia",
            "viscous",
            "coulomb",
            "breakaway",
            "resonance",
            "backlash",
        ):
            _not_negative(name, getattr(self, name))
        _not_negative("resonance_damping", self.resonance_damping)
        _finite("load_torque", self.load_torque)
        _one_of("amplifier", self.amplifier, AMPLIFIERS)
        _one_of("encoder", self.encoder, ENCODER_SIDES)
        if self.backlash and not self.resonance:
            raise ValueError("backlash needs a resonance: the stiffness of the part that takes up the play")
        if self.resonance and not self.load_inertia:
            raise ValueError("a resonance needs a load inertia to swing against the motor")
        if 0.0 < self.breakaway < self.coulomb:
            raise ValueError("breakaway torque must not be below the Coulomb friction")

    @property
    def counts_per_radian(self) -> float:
        """Encoder counts per radian of the shaft."""
        return self.counts_per_rev / (2.0 * pi)

    @property
    def total_inertia(self) -> float:
        """Motor and load, kg m²."""
        return self.inertia + self.load_inertia

    @property
    def has_current_state(self) -> bool:
        """True if the current lags: a voltage amplifier drives an inductance."""
        return self.amplifier == "voltage" and self.inductance > 0.0

    @property
    def is_linear(self) -> bool:
        """True if neither friction, backlash nor the encoder make the plant nonlinear."""
        return not (self.coulomb or self.breakaway or self.backlash or self.quantised)

    @property
    def mechanical_time_constant(self) -> float:
        """Time constant of the speed if the current does not lag, s (inf: no damping)."""
        damping = self.viscous
        if self.amplifier == "voltage":
            damping += self.torque_constant**2 / self.resistance
        return self.total_inertia / damping if damping else inf


@dataclass(frozen=True, slots=True)
class VelocityDrive:
    """A drive with a velocity loop: the velocity follows the output with a lag.

    The lag is first-order with `time_constant` in seconds; the final velocity is `speed_per_volt`, counts/s per volt,
    times the output.
    """

    speed_per_volt: float = 10_000.0
    time_constant: float = 2e-3
    quantised: bool = False

    def __post_init__(self) -> None:
        _positive("speed_per_volt", self.speed_per_volt)
        _positive("time_constant", self.time_constant)

    @property
    def is_linear(self) -> bool:
        """True if the encoder is not quantised."""
        return not self.quantised


def _positive(name: str, value: float) -> None:
    if not 0.0 < value < inf:
        raise ValueError(f"{_words(name)} must be greater than zero, not {value}")


def _not_negative(name: str, value: float) -> None:
    if not 0.0 <= value < inf:
        raise ValueError(f"{_words(name)} must be zero or more, not {value}")


def _finite(name: str, value: float) -> None:
    if not -inf < value < inf:
        raise ValueError(f"{_words(name)} must be a finite number")


def _one_of(name: str, value: str, values: tuple[str, ...]) -> None:
    if value not in values:
        raise ValueError(f"{_words(name)} must be {' or '.join(values)}, not {value!r}")


def _words(name: str) -> str:
    return name.replace("_", " ")
