"""The loop and the motor of a `servo` command, from its various sources.

The sources are a machine file, single values, and the gains of a language.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from motionlang.cli.command import Command, option
from motionlang.cli.option_groups import settings_of
from motionlang.cli.readers import integer, real
from motionlang.kernel import dialect
from motionlang.kernel.servo import (
    MODELS,
    PLANT,
    SERVO,
    Key,
    Loop,
    Motor,
    VelocityDrive,
    make_loop,
    make_plant,
    mccl_loop,
    mint_loop,
    section,
)

# The changes of the commands' motor from [axis.N.plant]'s defaults, if no machine file describes one.
EXAMPLE = {"load_inertia": 4e-5, "viscous": 2e-5}
BANDWIDTH = 50.0
# Quantities of MCCL without a command of their own: the integral's mode, and the rate, for which there are three.
FURTHER = {"IO": "integral_mode", "RATE": "rate"}
POSITIVE = real("a number greater than zero", 0.0, above=True)


def gains_of(language: str) -> dict[str, str]:
    """Return the gain keywords of a language, and the loop quantity that each sets."""
    rows = dialect(language).table()
    return {row.name: row.tunes for row in rows if row.tunes} | (FURTHER if language == "mccl" else {})


def written(words: Mapping[str, str], values: Mapping[str, float]) -> dict[str, tuple[float, str]]:
    """Convert values by keyword to the loop's gains; ValueError for an unknown gain."""
    for word in values:
        if word not in words:
            raise ValueError(f"{word} is not a servo gain; these are {', '.join(words)}")
    return {words[word]: (value, word) for word, value in values.items()}


def spoken(words: Mapping[str, str], values: Mapping[str, float]) -> dict[str, float]:
    """Convert values by quantity to values by keyword."""
    by_quantity = {quantity: word for word, quantity in words.items()}
    return {by_quantity[quantity]: value for quantity, value in values.items()}


@dataclass
class MotorAndLoop(Command):
    """A motor and its servo loop."""

    title: ClassVar[str] = "motor and servo loop"
    plant: list[str] = option(
        "NAME=VALUE", "a key of [axis.N.plant], such as resistance=1.5; may be repeated", many=True
    )
    loop: list[str] = option(
        "NAME=VALUE", "a key of [axis.N.servo], such as proportional=0.01; may be repeated", many=True
    )
    bandwidth: float | None = option(
        "HZ", f"closed-loop bandwidth of gains that are calculated, Hz ({BANDWIDTH:.10g})", read=POSITIVE
    )

    def settings(self) -> Mapping[str, object]:
        """Return the settings of the machine; Refused for a wrong machine file."""
        raise NotImplementedError

    def motor_of(self, axis: int) -> Motor | VelocityDrive:
        """Return the motor of an axis; ValueError names an invalid option."""
        options = pairs(self.plant, PLANT)
        example = {} if options.get("kind") == "drive" else EXAMPLE
        return make_plant((section(self.settings(), axis, "plant") or example) | options)


@dataclass
class Gains(MotorAndLoop):
    """A motor, and the gains of its servo loop."""

    mint: list[str] = option(
        "WORD=VALUE", f"a gain in Mint's units: {', '.join(gains_of('mint'))}", many=True
    )
    mccl: list[str] = option(
        "WORD=VALUE", f"a gain in MCCL's units: {', '.join(gains_of('mccl'))}", many=True
    )
    model: str = option(
        "", "the board of the MCCL gains (multiflex)", choices=tuple(MODELS), default="multiflex"
    )

    def loop_of(self, axis: int, plant: Motor | VelocityDrive, scale: float = 1.0) -> Loop:
        """Return the loop of an axis; ValueError names an invalid option.

        If no gain is given, the loop is tuned for the plant, without feed-forward. `scale` is in counts per user unit,
        the unit of MCCL's feed-forward gains.
        """
        if self.mint and self.mccl:
            raise ValueError("give gains of either Mint or MCCL, not both")
        values = section(self.settings(), axis, "servo") | pairs(self.loop, SERVO)
        if self.mint:
            return make_loop(values, mint_loop(written(gains_of("mint"), numbers(self.mint))))
        if self.mccl:
            gains = written(gains_of("mccl"), numbers(self.mccl))
            return make_loop(values, mccl_loop(gains, self.model, scale))
        loop = make_loop(values)
        if any((loop.proportional, loop.integral, loop.derivative, loop.velocity_feedback)):
            return loop
        from motionlang.kernel.servo import suggest

        tuned = suggest(plant, self.bandwidth or BANDWIDTH, loop).loop
        given = {
            name: getattr(loop, name)
            for name in ("velocity_ff", "accel_ff", "decel_ff", "dac_bits", "override")
        }
        return replace(tuned, **given)


@dataclass
class OneAxis(MotorAndLoop):
    """An axis of a machine file."""

    machine: str | None = option("M.toml", "take [axis.N.plant] and [axis.N.servo] from a machine file")
    axis: int = option("N", "the axis of the machine file (0)", read=integer, default=0)

    def settings(self) -> Mapping[str, object]:
        return {} if self.machine is None else settings_of(self.machine)


def pairs(texts: Sequence[str], keys: Mapping[str, Key]) -> dict[str, object]:
    """Parse NAME=VALUE texts by the types of the keys."""
    found: dict[str, object] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals:
            raise ValueError(f"{text!r} is not NAME=VALUE")
        found[name.strip()] = _value(value.strip(), keys.get(name.strip()))
    return found


def numbers(texts: Sequence[str]) -> dict[str, float]:
    """Parse KEYWORD=VALUE texts; return numbers by upper-case keyword."""
    found: dict[str, float] = {}
    for text in texts:
        word, equals, value = text.partition("=")
        try:
            found[word.strip().upper()] = float(value)
        except ValueError:
            raise ValueError(
                f"{text!r} is not WORD=VALUE with a number" if equals else f"{text!r} is not WORD=VALUE"
            ) from None
    return found


def _value(text: str, key: Key | None) -> object:
    if key is not None and key.kind == "flag":
        return {"true": True, "false": False, "1": True, "0": False}.get(text.lower(), text)
    if key is not None and key.kind == "text":
        return text
    try:
        return int(text) if key is not None and key.kind == "count" else float(text)
    except ValueError:
        return text
