"""The gains of both languages on the one loop: what a unit of each keyword is worth.

Mint computes in DAC steps, 2048 of them for 10 V, and in counts per servo loop (Baldor MN1957, 5.8.1, and the worked
example of MN1274: KVELFF = 2048 / counts per loop at full speed). MCCL's MultiFlex gains are volts (PMC UM, feed-
forward: output = velocity in counts/s times the gain); the DCX modules compute like National's LM628.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from motionlang.controller.servo.loop import FULL_SCALE, Loop

if TYPE_CHECKING:
    from collections.abc import Mapping

MINT_STEPS = 2048.0
"""DAC steps for full scale in Mint's servo loop."""
MINT_STEP = FULL_SCALE / MINT_STEPS
LM628_RATE = 6e6 / 2048.0
"""Hz: one sample every 2048 clocks of 6 MHz, 341 microseconds."""
MODELS = ("multiflex", "dcx")


@dataclass(frozen=True, slots=True)
class Gain:
    """A keyword: the value it has before a program sets it, its unit, what it sets, and how this is known."""

    word: str
    default: float
    unit: str
    help: str
    trust: str
    fields: str
    """The fields of the loop that it decides."""


def _table(*rows: Gain) -> dict[str, Gain]:
    return {row.word: row for row in rows}


MINT: dict[str, Gain] = _table(
    Gain(
        "KPROP",
        0.0,
        "DAC steps per count",
        "Output for each count of following error.",
        "manual",
        "proportional",
    ),
    Gain(
        "KINT",
        0.0,
        "DAC steps per count and loop",
        "Output for the sum of following errors.",
        "memory",
        "integral",
    ),
    Gain(
        "KINTLIMIT",
        100.0,
        "percent of full scale",
        "The most that the integral contributes.",
        "manual",
        "integral_limit",
    ),
    Gain(
        "KINTMODE",
        0.0,
        "0 never, 1 always, 2 at steady speed, 3 at rest",
        "When the integral acts.",
        "manual",
        "integral_mode",
    ),
    Gain(
        "KDERIV",
        0.0,
        "DAC steps per count/loop",
        "Output for the change of the following error.",
        "manual",
        "derivative",
    ),
    Gain(
        "KVEL", 0.0, "DAC steps per count/loop", "Damping by measured speed.", "manual", "velocity_feedback"
    ),
    Gain("KVELFF", 0.0, "DAC steps per count/loop", "Output for demanded speed.", "manual", "velocity_ff"),
    Gain(
        "KACCEL",
        0.0,
        "DAC steps per count/loop²",
        "Output for demanded acceleration.",
        "memory",
        "accel_ff decel_ff",
    ),
    Gain("DACLIMITMAX", 100.0, "percent of full scale", "The most that goes out.", "memory", "output_limit"),
    Gain(
        "LOOPTIME",
        1000.0,
        "microseconds",
        "The time of one servo loop.",
        "manual",
        "servo_rate trajectory_rate",
    ),
)
MCCL: dict[str, Gain] = _table(
    Gain("SG", 0.0, "V per count", "Output for each count of following error.", "code", "proportional"),
    Gain(
        "SI",
        0.0,
        "V per count and sample",
        "Output for the sum of following errors.",
        "code",
        "integral integral_limit",
    ),
    Gain(
        "SD",
        0.0,
        "V per count and derivative sample",
        "Output for the change of the error.",
        "code",
        "derivative",
    ),
    Gain("IL", 0.0, "counts, summed", "Where the sum of errors stops growing.", "memory", "integral_limit"),
    Gain("FR", 0.00025, "s", "The time of one derivative sample.", "code", "derivative_every"),
    Gain("VG", 0.0, "V per unit/s", "Output for demanded velocity.", "manual", "velocity_ff"),
    Gain("AG", 0.0, "V per unit/s²", "Output for demanded acceleration.", "manual", "accel_ff"),
    Gain("DG", 0.0, "V per unit/s²", "Output for demanded deceleration.", "manual", "decel_ff"),
    Gain("OB", 0.0, "V", "An output smaller than this is none.", "memory", "output_deadband"),
    Gain("OO", 0.0, "V", "Added to every output.", "memory", "output_offset"),
    Gain("PH", 0.0, "0 or 1", "1 reverses the output.", "memory", "reversed"),
    Gain("SQ", 10.0, "V", "The most that goes out.", "code", "output_limit"),
    Gain(
        "IO",
        0.0,
        "0, 1 or 2",
        "Integral: always, frozen in motion, cleared and frozen in motion.",
        "memory",
        "integral_mode",
    ),
    Gain(
        "RATE", 4000.0, "Hz", "Servo rate: HS 4000, MS 2000, LS 1000.", "manual", "servo_rate trajectory_rate"
    ),
)
_MINT_MODES = ("never", "always", "steady", "stopped")
_MCCL_MODES = ("always", "stopped", "zeroed")


def mint_loop(values: Mapping[str, float]) -> Loop:
    """The loop that a Mint program's gains describe, by keyword; what is not given has its default."""
    v = _complete(values, MINT)
    rate = 1e6 / _within(v, "LOOPTIME", 50.0, 100_000.0)
    return Loop(
        proportional=v["KPROP"] * MINT_STEP,
        integral=v["KINT"] * MINT_STEP,
        integral_limit=_within(v, "KINTLIMIT", 0.0, 100.0) / 100.0 * FULL_SCALE,
        integral_mode=_MINT_MODES[int(_within(v, "KINTMODE", 0, 3))],
        derivative=v["KDERIV"] * MINT_STEP,
        velocity_feedback=v["KVEL"] * MINT_STEP,
        velocity_ff=v["KVELFF"] * MINT_STEP / rate,
        accel_ff=v["KACCEL"] * MINT_STEP / rate**2,
        decel_ff=v["KACCEL"] * MINT_STEP / rate**2,
        output_limit=_within(v, "DACLIMITMAX", 0.0, 100.0) / 100.0 * FULL_SCALE,
        servo_rate=rate,
        trajectory_rate=rate,
    )


def mccl_loop(values: Mapping[str, float], model: str = "multiflex", scale: float = 1.0) -> Loop:
    """The loop that an MCCL program's gains describe; `scale` is counts per user unit, for VG, AG and DG."""
    if model not in MODELS:
        raise ValueError(f"there is no servo model {model!r}: {' or '.join(MODELS)}")
    if not 0.0 < abs(scale) < inf:
        raise ValueError(f"the scale must not be {scale}")
    v = _complete(values, MCCL)
    return _lm628(v) if model == "dcx" else _multiflex(v, scale)


def _multiflex(v: dict[str, float], scale: float) -> Loop:
    rate = _within(v, "RATE", 1000.0, 4000.0)
    return Loop(
        proportional=v["SG"],
        integral=v["SI"],
        integral_limit=abs(v["SI"]) * _within(v, "IL", 0.0, inf),
        integral_mode=_MCCL_MODES[int(_within(v, "IO", 0, 2))],
        derivative=v["SD"],
        derivative_every=max(1, round(_within(v, "FR", 0.0, 10.0) * rate)),
        velocity_ff=v["VG"] / scale,
        accel_ff=v["AG"] / scale,
        decel_ff=v["DG"] / scale,
        output_deadband=_within(v, "OB", 0.0, FULL_SCALE),
        output_offset=v["OO"],
        reversed=bool(_within(v, "PH", 0, 1)),
        output_limit=_within(v, "SQ", 0.0, FULL_SCALE),
        servo_rate=rate,
        trajectory_rate=min(rate, 1000.0),
    )


def _lm628(v: dict[str, float]) -> Loop:
    """Gains 0 to 32767; FR counts further samples between two derivatives (the API's period / 341 us - 1)."""
    return Loop(
        arithmetic="lm628",
        dac_bits=12,
        proportional=round(_within(v, "SG", 0, 32767)),
        integral=round(_within(v, "SI", 0, 32767)),
        integral_limit=round(_within(v, "IL", 0, 32767)),
        integral_mode=_MCCL_MODES[int(_within(v, "IO", 0, 2))],
        derivative=round(_within(v, "SD", 0, 32767)),
        derivative_every=1 + (round(_within(v, "FR", 0, 255)) if v["FR"] >= 1.0 else 0),
        reversed=bool(_within(v, "PH", 0, 1)),
        output_limit=_within(v, "SQ", 0.0, FULL_SCALE),
        servo_rate=LM628_RATE,
        trajectory_rate=LM628_RATE,
    )


def mint_values(loop: Loop) -> dict[str, float]:
    """The Mint gains that give this loop, at its servo rate."""
    rate = loop.servo_rate
    return {
        "KPROP": loop.proportional / MINT_STEP,
        "KINT": loop.integral / MINT_STEP,
        "KINTLIMIT": min(loop.integral_limit, FULL_SCALE) / FULL_SCALE * 100.0,
        "KINTMODE": float(
            _MINT_MODES.index("stopped" if loop.integral_mode == "zeroed" else loop.integral_mode)
        ),
        "KDERIV": loop.derivative / MINT_STEP,
        "KVEL": loop.velocity_feedback / MINT_STEP,
        "KVELFF": loop.velocity_ff / MINT_STEP * rate,
        "KACCEL": loop.accel_ff / MINT_STEP * rate**2,
        "LOOPTIME": 1e6 / rate,
    }


def mccl_values(loop: Loop, scale: float = 1.0) -> dict[str, float]:
    """The MultiFlex gains that give this loop, but for its servo rate."""
    limit = min(loop.integral_limit, loop.output_limit)
    return {
        "SG": loop.proportional,
        "SI": loop.integral,
        "IL": limit / abs(loop.integral) if loop.integral else 0.0,
        "SD": loop.derivative,
        "FR": loop.derivative_every / loop.servo_rate,
        "VG": loop.velocity_ff * scale,
        "AG": loop.accel_ff * scale,
        "DG": loop.decel_ff * scale,
        "SQ": loop.output_limit,
    }


def _complete(values: Mapping[str, float], table: dict[str, Gain]) -> dict[str, float]:
    for word in values:
        if word not in table:
            raise ValueError(f"{word} is not a servo gain; these are {', '.join(table)}")
    return {word: float(values.get(word, row.default)) for word, row in table.items()}


def _within(values: dict[str, float], word: str, low: float, high: float) -> float:
    value = values[word]
    if not low <= value <= high:
        raise ValueError(f"{word} must be {low:g} to {high:g}, not {value:g}")
    return value
