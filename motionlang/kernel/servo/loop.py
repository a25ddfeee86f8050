"""The control loop: from commanded and measured position to a voltage.

One object serves both languages: Mint's and MCCL's gains are scaled onto it in `gains`. Positions are counts,
outputs volts at the controller's +-10 V output, rates Hz; gains are per servo sample where a sample is
involved.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite

ARITHMETICS = ("real", "chapter12", "lm628")
LIMIT_STYLES = ("sum", "term")
INTEGRAL_MODES: dict[str, str] = {
    "never": "The integral is off (KINTMODE 0).",
    "always": "The integral always acts (KINTMODE 1; PMC's normal mode).",
    "steady": "The integral acts at constant or zero demanded speed and is frozen otherwise (KINTMODE 2).",
    "stopped": "The integral acts at zero demanded speed and is frozen in motion (KINTMODE 3; PMC's second mode).",
    "zeroed": "As stopped, and cleared when motion begins (PMC's third mode).",
}
# Gains; at least one must be set for a nonzero output.
GAINS = (
    "proportional",
    "integral",
    "derivative",
    "velocity_feedback",
    "velocity_ff",
    "accel_ff",
    "decel_ff",
)
# Volts at the end of the DAC's range.
FULL_SCALE = 10.0
# Bits of the integer forms' words, and of the finest DAC.
FINE_BITS = 16


@dataclass(frozen=True, slots=True)
class Override:
    """The direct DAC override of chapter 12.

    The output is at most `steps` DAC steps away from the actual velocity, for `hold` updates. `speed` is the motor's
    velocity in counts/s at the full scale of the DAC.
    """

    steps: int
    hold: int
    speed: float

    def __post_init__(self) -> None:
        _check(self.steps >= 1, f"the DAC override must allow at least 1 step, not {self.steps}")
        _check(self.hold >= 1, f"the DAC must be held at least 1 update, not {self.hold}")
        _check(0.0 < self.speed < inf, f"the speed at full scale must be greater than zero, not {self.speed}")


@dataclass(frozen=True, slots=True)
class Loop:
    """A position loop; every field has a default, and only a gain is required.

    With `arithmetic` "real" the loop computes u = Kp e + Ki sum(e) + Kd (e - e_last) - Kv (y - y_last) + feed-forward
    in volts. "chapter12" and "lm628" compute in integers and give DAC steps: proportional, integral and
    derivative are then the integer gains of those forms, and `integral_limit` is in their units before the last
    division. Feed-forward gains are volts per count/s and per count/s². `integral_limit` bounds the
    integral's contribution, by stopping the sum ("sum") or by limiting only the contribution ("term": the sum
    continues to wind up).
    """

    proportional: float = 0.0
    integral: float = 0.0
    derivative: float = 0.0
    velocity_feedback: float = 0.0
    velocity_ff: float = 0.0
    accel_ff: float = 0.0
    decel_ff: float = 0.0
    integral_limit: float = inf
    limit_style: str = "sum"
    integral_mode: str = "always"
    derivative_every: int = 1
    output_limit: float = FULL_SCALE
    output_offset: float = 0.0
    output_deadband: float = 0.0
    reversed: bool = False
    arithmetic: str = "real"
    dac_bits: int = 0
    wrap: bool = False
    override: Override | None = None
    servo_rate: float = 4000.0
    trajectory_rate: float = 1000.0

    def __post_init__(self) -> None:
        _check_numbers(self)
        _check(self.arithmetic in ARITHMETICS, f"there is no arithmetic {self.arithmetic!r}")
        _check(self.limit_style in LIMIT_STYLES, f"there is no limit style {self.limit_style!r}")
        _check(self.integral_mode in INTEGRAL_MODES, f"there is no integral mode {self.integral_mode!r}")
        _check(self.derivative_every >= 1, "the derivative sample time is at least one servo sample")
        low = 0 if self.arithmetic == "real" else 8
        _check(
            self.dac_bits == 0 == low or 8 <= self.dac_bits <= FINE_BITS,
            f"a DAC has 8 to {FINE_BITS} bits, not {self.dac_bits}",
        )
        _check(
            self.override is None or self.dac_bits > 0,
            "the DAC override counts DAC steps: give the DAC's bits",
        )
        ratio = self.servo_rate / self.trajectory_rate
        _check(
            ratio >= 1.0 and abs(ratio - round(ratio)) < 1e-9 * ratio,
            f"the servo rate must be a multiple of the trajectory rate, not {ratio:.10g} times it",
        )

    @property
    def period(self) -> float:
        """Seconds between two servo samples."""
        return 1.0 / self.servo_rate

    @property
    def ratio(self) -> int:
        """Servo samples per trajectory cycle."""
        return round(self.servo_rate / self.trajectory_rate)

    @property
    def dac_step(self) -> float:
        """Volts of one DAC step; 0 if the output is not quantised."""
        return FULL_SCALE / (1 << (self.dac_bits - 1)) if self.dac_bits else 0.0

    @property
    def has_integral(self) -> bool:
        """True if the integral can contribute."""
        return self.integral != 0.0 and self.integral_limit > 0.0 and self.integral_mode != "never"

    @property
    def is_linear(self) -> bool:
        """True if the loop is linear as long as no limit is reached."""
        plain = self.arithmetic == "real" and not self.dac_bits and not self.override
        return plain and self.output_deadband == 0.0


def _check_numbers(loop: Loop) -> None:
    for name in (*GAINS, "output_offset"):
        _check(isfinite(getattr(loop, name)), f"{name.replace('_', ' ')} must be a finite number")
    for name in ("integral_limit", "output_limit", "output_deadband"):
        _check(getattr(loop, name) >= 0.0, f"{name.replace('_', ' ')} must not be negative")
    if loop.arithmetic != "real":
        for name in ("proportional", "integral", "derivative", "integral_limit"):
            value = getattr(loop, name)
            whole = value == inf or value == int(value)
            _check(whole, f"{name.replace('_', ' ')} must be a whole number in this form, not {value}")
    for name in ("servo_rate", "trajectory_rate"):
        value = getattr(loop, name)
        _check(1.0 <= value <= 1e6, f"{name.replace('_', ' ')} must be 1 to 1e6 Hz, not {value:.10g}")


def _check(good: bool, message: str) -> None:
    if not good:
        raise ValueError(message)
