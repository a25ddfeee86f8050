"""The loop of an axis: gains of the program, the machine file, or a suggestion.

A program that sets no gains runs on a controller that was tuned before. If the machine file has no gains
either, suggested gains for the plant replace that tuning, and the report says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from motionlang.kernel.servo.gains import LM628_RATE, Gains, fields, mccl_loop, mint_loop
from motionlang.kernel.servo.loop import GAINS, Loop
from motionlang.kernel.servo.plant import Motor, VelocityDrive
from motionlang.kernel.servo.settings import SERVO, make_loop

_MIN_BANDWIDTH = 0.1


@dataclass(frozen=True, slots=True)
class Chosen:
    """A loop and the source of its gains: "program", "machine file" or "suggested"."""

    loop: Loop
    gains: str
    # The bandwidth that they were suggested for, Hz.
    bandwidth: float = 0.0


def axis_loop(
    section: Mapping[str, object],
    gains: Gains,
    plant: Motor | VelocityDrive,
    model: str = "",
    scale: float = 1.0,
) -> Chosen:
    """Return the loop of an axis from its machine file section and program gains.

    The section is `[axis.N.servo]`. `model` is one of `gains.MODELS` for MCCL, empty for Mint; `scale` is
    counts per user unit. Raises ValueError for invalid entries.
    """
    set_by_program = fields("mccl" if model else "mint", gains)
    from_section = {name: value for name, value in section.items() if name not in set_by_program}
    if not set_by_program.isdisjoint(GAINS):
        loop = _language(section, gains, model, scale)
        # The section's integral acts as the section states, not by the default of a language that did not
        # request one.
        return Chosen(
            make_loop(from_section, _acting(loop, set_by_program) if "integral" in from_section else loop),
            "program",
        )
    loop = _language(section, gains, "multiflex" if model else "", scale)
    if model == "dcx":
        loop = replace(loop, servo_rate=LM628_RATE, trajectory_rate=LM628_RATE)
    loop = make_loop(from_section, _acting(loop, set_by_program))
    if any(name in section for name in GAINS):
        return Chosen(loop, "machine file")
    bandwidth = section.get("bandwidth", SERVO["bandwidth"].default)
    assert isinstance(bandwidth, (int, float))
    return _suggested(loop, plant, float(bandwidth))


def has_gains(loop: Loop) -> bool:
    """True if any gain makes the loop respond to its command."""
    return any(getattr(loop, name) for name in GAINS)


def _acting(loop: Loop, set_by_program: set[str]) -> Loop:
    """Return the loop with an integral that always acts, within the output limit.

    Fields set by the program stay.
    """
    fields: dict[str, str | float] = {"integral_mode": "always", "integral_limit": loop.output_limit}
    return replace(loop, **{name: value for name, value in fields.items() if name not in set_by_program})  # type: ignore[arg-type]


def _language(section: Mapping[str, object], gains: Gains, model: str, scale: float) -> Loop:
    """Return the loop from the program's gains alone.

    It has the servo rate of the section unless the program sets one.
    """
    rate = section.get("servo_rate")
    if model:
        return mccl_loop(gains, model, scale)
    if rate is not None and "period" not in gains:
        gains = {**gains, "period": (1e6 / rate, "servo_rate")}  # type: ignore[operator]
    return mint_loop(gains)


def _suggested(loop: Loop, plant: Motor | VelocityDrive, bandwidth: float) -> Chosen:
    """Return gains for the bandwidth, or for the part of it that the plant can reach.

    The bandwidth is halved until the plant can reach it. The program's deadband of the output stays.
    """
    from motionlang.kernel.servo.tuning import BeyondPlant, linearised, suggested_loop

    linear = linearised(plant)
    while True:
        try:
            found = replace(suggested_loop(linear, bandwidth, loop), output_deadband=loop.output_deadband)
            return Chosen(found, "suggested", bandwidth)
        except BeyondPlant as error:
            bandwidth /= 2.0
            while bandwidth > error.best > 0.0:
                bandwidth /= 2.0
            if bandwidth < _MIN_BANDWIDTH:
                raise
