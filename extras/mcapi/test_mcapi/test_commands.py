"""The MCCL commands that each function stands for."""

from __future__ import annotations

import functools
import io
from pathlib import Path

import pytest

import motionlang_mcapi as mc
from motionlang_mcapi.listing import CallListing
from motionlang_mcapi.log import read


@functools.cache
def listing(model: str) -> CallListing:
    return CallListing(model)


def commands(call: str, model: str = "multiflex") -> str:
    """Return the commands of a call on handle 1, "" if it has none."""
    name, _, arguments = call.partition(" ")
    (entry,) = read(io.BytesIO(f"mcapi-log 1\n0.5 0.5 1 {name} 1 {arguments} = 0\n".encode()))
    line = listing(model).line(entry)
    return line.partition(";")[0].rstrip()


# The arguments are those of C, with constants as numbers; `-` is a call that is refused.
CALLS = Path(__file__).with_name("commands.txt").read_text(encoding="utf-8")


@pytest.mark.parametrize("row", CALLS.splitlines(), ids=lambda row: " ".join(row.split()[:-1]))
def test_the_commands_of_a_call(row: str) -> None:
    call, wanted = row.rsplit(maxsplit=1)
    assert commands(call) == ("" if wanted == "-" else wanted)


# A field of a structure, a value, and the commands that set it.
FIELDS = [
    ("Acceleration", 1.5, "1SA1.5"),
    ("Deceleration", 1.5, "1DS1.5"),
    ("Velocity", 1.5, "1SV1.5"),
    ("MinVelocity", 1.5, "1MV1.5"),
    ("Direction", mc.MC_DIR_NEGATIVE, "1DI1"),
    ("Torque", 1.5, "1SQ1.5"),
    ("Deadband", 1.5, "1DB1.5"),
    ("DeadbandDelay", 1.5, "1DT1.5"),
    ("StepSize", mc.MC_STEP_FULL, "1FS"),
    ("StepSize", mc.MC_STEP_HALF, "1SH"),
    ("Current", mc.MC_CURRENT_FULL, "1FC"),
    ("Current", mc.MC_CURRENT_HALF, "1HC"),
    ("EnableAmpFault", 1, "1FN"),
    ("Gain", 1.5, "1SG1.5"),
    ("IntegralGain", 1.5, "1SI1.5"),
    ("IntegrationLimit", 1.5, "1IL1.5"),
    ("IntegralOption", 1, ""),
    ("DerivativeGain", 1.5, "1SD1.5"),
    ("FollowingError", 1.5, "1SE1.5"),
    ("VelocityGain", 1.5, "1VG1.5"),
    ("AccelGain", 1.5, "1AG1.5"),
    ("DecelGain", 1.5, "1DG1.5"),
    ("EncoderScaling", 1.5, "1ES1.5"),
    ("UpdateRate", mc.MC_RATE_LOW, "1LS"),
    ("UpdateRate", mc.MC_RATE_MEDIUM, "1MS"),
    ("UpdateRate", mc.MC_RATE_HIGH, "1HS"),
    ("Rate", mc.MC_RATE_MEDIUM, "1MS"),
    ("PositionDeadband", 1.5, "1DB1.5"),
    ("DelayAtTarget", 1.5, "1DT1.5"),
    ("OutputOffset", 1.5, "1OO1.5"),
    ("OutputDeadband", 1.5, "1OB1.5"),
]
WRITERS = {
    "MCMOTION": "MCSetMotionConfig",
    "MCMOTIONEX": "MCSetMotionConfigEx",
    "MCFILTER": "MCSetFilterConfig",
    "MCFILTEREX": "MCSetFilterConfigEx",
}


@pytest.mark.parametrize(("field", "value", "wanted"), FIELDS)
def test_the_command_of_a_field(field: str, value: float, wanted: str) -> None:
    """In each structure that has the field."""
    for structure, function in WRITERS.items():
        names = getattr(mc, structure).names()
        if field in names:
            count = len(names)
            zeros = commands(f"{function} 1 {count} {' '.join(['0'] * count)}").split(",")
            values = " ".join(str(value if name == field else 0) for name in names)
            found = commands(f"{function} 1 {count} {values}").split(",")
            assert [each for each in found if each not in zeros] == ([wanted] if wanted else [])


@pytest.mark.parametrize(("periods", "wanted"), [(0, "1FR0"), (1, "1FR0"), (1.6, "1FR1"), (4, "1FR3")])
def test_the_derivative_period_is_in_servo_periods(periods: float, wanted: str) -> None:
    """FR counts servo periods, 0 is one; a MultiFlex has a period of 250 µs."""
    assert wanted in commands(f"MCSetFilterConfig 1 8 0.0 {periods * 250e-6} 0 0 0 0 0 0").split(",")
