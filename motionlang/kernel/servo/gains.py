"""Gains of both languages, converted to the one loop, and their units.

Mint computes in DAC steps, 2048 of them for 10 V, and in counts per servo loop (Baldor MN1957, 5.8.1, and the
worked example of MN1274: KVELFF = 2048 / counts per loop at full speed). MCCL's MultiFlex gains are volts
(PMC UM, feed-forward: output = velocity in counts/s times the gain); the DCX modules compute like National's
LM628.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf

from motionlang.kernel.servo.loop import FULL_SCALE, Loop

# The value of a gain and the keyword that set it, by its quantity.
Gains = Mapping[str, tuple[float, str]]

# DAC steps for full scale in Mint's servo loop.
MINT_STEPS = 2048.0
MINT_STEP = FULL_SCALE / MINT_STEPS
# Hz: one sample every 2048 clocks of 6 MHz, 341 microseconds.
LM628_RATE = 6e6 / 2048.0
# The servo models of MCCL's boards.
MODELS = ("multiflex", "dcx")
# The initial gains of a language, by the quantity of the loop that each sets, in the units of the language:
# `tunes` in the rows of its keywords. If a quantity sets other fields than the one it is named after, `SETS`
# has them.
MINT = {
    "proportional": 0.0,  # DAC steps per count
    "integral": 0.0,  # DAC steps per count and loop
    "integral_limit": 100.0,  # percent of full scale
    "integral_mode": 0.0,  # 0 never, 1 always, 2 at steady speed, 3 at rest
    "derivative": 0.0,  # DAC steps per count a loop
    "velocity_feedback": 0.0,
    "velocity_ff": 0.0,
    "accel_ff": 0.0,  # DAC steps per count a loop²
    "output_limit": 100.0,  # percent of full scale
    "period": 1000.0,  # microseconds
}
MCCL = {
    "proportional": 0.0,  # V per count
    "integral": 0.0,  # V per count and sample
    "derivative": 0.0,  # V per count and derivative sample
    "integral_limit": 0.0,  # counts, summed
    "derivative_every": 0.00025,  # seconds
    "velocity_ff": 0.0,  # V per unit/s
    "accel_ff": 0.0,  # V per unit/s²
    "decel_ff": 0.0,
    "output_deadband": 0.0,  # V
    "output_offset": 0.0,  # V
    "reversed": 0.0,  # 1 reverses the output
    "output_limit": 10.0,  # V
    "integral_mode": 0.0,  # 0 always, 1 frozen in motion, 2 cleared and frozen in motion
    "rate": 4000.0,  # Hz
}
SETS = {
    "mint": {"accel_ff": ("accel_ff", "decel_ff"), "period": ("servo_rate", "trajectory_rate")},
    "mccl": {"integral": ("integral", "integral_limit"), "rate": ("servo_rate", "trajectory_rate")},
}
_MINT_MODES = ("never", "always", "steady", "stopped")
_MCCL_MODES = ("always", "stopped", "zeroed")


def fields(language: str, quantities: Iterable[str]) -> set[str]:
    """Return the fields of a `Loop` that gains of a language set."""
    sets = SETS[language]
    return {field for quantity in quantities for field in sets.get(quantity, (quantity,))}


def mint_loop(gains: Gains) -> Loop:
    """Return the loop of a Mint program's gains; omitted ones have their defaults.

    An invalid gain raises ValueError, which names the keyword.
    """
    v = _Complete(gains, MINT)
    rate = 1e6 / v.within("period", 50.0, 100_000.0)
    return Loop(
        proportional=v["proportional"] * MINT_STEP,
        integral=v["integral"] * MINT_STEP,
        integral_limit=v.within("integral_limit", 0.0, 100.0) / 100.0 * FULL_SCALE,
        integral_mode=_MINT_MODES[int(v.within("integral_mode", 0, 3))],
        derivative=v["derivative"] * MINT_STEP,
        velocity_feedback=v["velocity_feedback"] * MINT_STEP,
        velocity_ff=v["velocity_ff"] * MINT_STEP / rate,
        accel_ff=v["accel_ff"] * MINT_STEP / rate**2,
        decel_ff=v["accel_ff"] * MINT_STEP / rate**2,
        output_limit=v.within("output_limit", 0.0, 100.0) / 100.0 * FULL_SCALE,
        servo_rate=rate,
        trajectory_rate=rate,
    )


def mccl_loop(gains: Gains, model: str = "multiflex", scale: float = 1.0) -> Loop:
    """Return the loop of an MCCL program's gains.

    `scale` is counts per user unit, for VG, AG and DG.
    """
    if model not in MODELS:
        raise ValueError(f"there is no servo model {model!r}: {' or '.join(MODELS)}")
    if not 0.0 < abs(scale) < inf:
        raise ValueError(f"the scale must not be {scale}")
    v = _Complete(gains, MCCL)
    return _lm628(v) if model == "dcx" else _multiflex(v, scale)


def _multiflex(v: _Complete, scale: float) -> Loop:
    rate = v.within("rate", 1000.0, 4000.0)
    return Loop(
        proportional=v["proportional"],
        integral=v["integral"],
        integral_limit=abs(v["integral"]) * v.within("integral_limit", 0.0, inf),
        integral_mode=_MCCL_MODES[int(v.within("integral_mode", 0, 2))],
        derivative=v["derivative"],
        derivative_every=max(1, round(v.within("derivative_every", 0.0, 10.0) * rate)),
        velocity_ff=v["velocity_ff"] / scale,
        accel_ff=v["accel_ff"] / scale,
        decel_ff=v["decel_ff"] / scale,
        output_deadband=v.within("output_deadband", 0.0, FULL_SCALE),
        output_offset=v["output_offset"],
        reversed=bool(v.within("reversed", 0, 1)),
        output_limit=v.within("output_limit", 0.0, FULL_SCALE),
        servo_rate=rate,
        trajectory_rate=min(rate, 1000.0),
    )


def _lm628(v: _Complete) -> Loop:
    """Return the loop of LM628 gains, integers from 0 to 32767.

    FR counts further samples between two derivatives (the API's period / 341 us - 1).
    """
    return Loop(
        arithmetic="lm628",
        dac_bits=12,
        proportional=round(v.within("proportional", 0, 32767)),
        integral=round(v.within("integral", 0, 32767)),
        integral_limit=round(v.within("integral_limit", 0, 32767)),
        integral_mode=_MCCL_MODES[int(v.within("integral_mode", 0, 2))],
        derivative=round(v.within("derivative", 0, 32767)),
        derivative_every=1
        + (round(v.within("derivative_every", 0, 255)) if v["derivative_every"] >= 1.0 else 0),
        reversed=bool(v.within("reversed", 0, 1)),
        output_limit=v.within("output_limit", 0.0, FULL_SCALE),
        servo_rate=LM628_RATE,
        trajectory_rate=LM628_RATE,
    )


def mint_values(loop: Loop) -> dict[str, float]:
    """Return the Mint gains of this loop, at its servo rate, by quantity."""
    rate = loop.servo_rate
    return {
        "proportional": loop.proportional / MINT_STEP,
        "integral": loop.integral / MINT_STEP,
        "integral_limit": min(loop.integral_limit, FULL_SCALE) / FULL_SCALE * 100.0,
        "integral_mode": float(
            _MINT_MODES.index("stopped" if loop.integral_mode == "zeroed" else loop.integral_mode)
        ),
        "derivative": loop.derivative / MINT_STEP,
        "velocity_feedback": loop.velocity_feedback / MINT_STEP,
        "velocity_ff": loop.velocity_ff / MINT_STEP * rate,
        "accel_ff": loop.accel_ff / MINT_STEP * rate**2,
        "period": 1e6 / rate,
    }


def mccl_values(loop: Loop, scale: float = 1.0) -> dict[str, float]:
    """Return the MultiFlex gains of this loop, except for its rate, by quantity."""
    limit = min(loop.integral_limit, loop.output_limit)
    return {
        "proportional": loop.proportional,
        "integral": loop.integral,
        "integral_limit": limit / abs(loop.integral) if loop.integral else 0.0,
        "derivative": loop.derivative,
        "derivative_every": loop.derivative_every / loop.servo_rate,
        "velocity_ff": loop.velocity_ff * scale,
        "accel_ff": loop.accel_ff * scale,
        "decel_ff": loop.decel_ff * scale,
        "output_limit": loop.output_limit,
    }


class _Complete(dict[str, float]):
    """The values of all gains of a language, by quantity."""

    __slots__ = ("_gains",)

    def __init__(self, gains: Gains, table: Mapping[str, float]) -> None:
        super().__init__(table)
        self._gains = gains
        for quantity, (value, word) in gains.items():
            if quantity not in table:
                raise ValueError(f"{word} sets {quantity}, which is none of {', '.join(table)}")
            self[quantity] = float(value)

    def within(self, quantity: str, low: float, high: float) -> float:
        """Return the value; ValueError if it is out of range."""
        value = self[quantity]
        if not low <= value <= high:
            word = self._gains[quantity][1]
            raise ValueError(f"{word} must be {low:.10g} to {high:.10g}, not {value:.10g}")
        return value
