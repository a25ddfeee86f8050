"""The MCCL commands that each function stands for."""

from __future__ import annotations

import functools
import io

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
CALLS = """\
MCAbort 0                              AB
MCArcCenter 1 0 5.0                    1CA5
MCArcCenter 1 1 5.0                    1CR5
MCArcCenter 1 2 5.0                    -
MCArcEndAngle 1 0 90.0                 1EA90
MCArcEndAngle 1 1 90.0                 1ER90
MCArcEndAngle 1 -1 90.0                -
MCCancelTask 2                         ET2
MCCaptureData 2 100 0.001 0.0          2PR100
MCConfigureDigitalIO 3 1               CI3
MCConfigureDigitalIO 3 2               CT3
MCConfigureDigitalIO 3 4               CH3
MCConfigureDigitalIO 3 8               CL3
MCConfigureDigitalIO 3 10              CT3,CL3
MCConfigureDigitalIO 3 0               -
MCConfigureDigitalIO 3 3               -
MCConfigureDigitalIO 3 12              -
MCConfigureDigitalIO 3 17              -
MCContourPath 1 0 ""                   -
MCContourPath 1 1 "1MA5,2MA6"          1CP1,1MA5,2MA6
MCContourPath 1 2 ""                   1CP2
MCContourPath 1 3 ""                   1CP3
MCContourPath 1 4 ""                   -
MCDirection 1 0                        -
MCDirection 1 1                        1DI0
MCDirection 1 2                        1DI1
MCEnableAxis 0 0                       MF
MCEnableAxis 2 1                       2MN
MCEnableBacklash 1 2.5 0               1BD2.5,1BF
MCEnableBacklash 1 2.5 1               1BD2.5,1BN
MCEnableDigitalIO 3 0                  CF3
MCEnableDigitalIO 3 1                  CN3
MCEnableGearing 1 2 0.5 0              1SM0
MCEnableGearing 1 2 0.5 1              1SS0.5,1SM2
MCEnableJog 1 0                        1JF
MCEnableJog 1 1                        1JN
MCEnableSync 1 0                       1NS
MCEnableSync 1 1                       1SN
MCGo 1                                 1GO
MCGoEx 1 7.0                           1GO
MCInterruptOnPosition 1 0 9.0          1IP9
MCInterruptOnPosition 1 1 9.0          1IR9
MCLearnPoint 1 4 0                     -
MCLearnPoint 1 4 1                     1LP4
MCLearnPoint 1 4 2                     1LT4
MCMoveAbsolute 1 0.1                   1MA0.1
MCMoveAbsolute 1 -7.0                  1MA-7
MCMoveAbsolute 1 999999999999999.0     1MA999999999999999
MCMoveAbsolute 1 1e15                  1MA1000000000000000.0
MCRepeat 3                             RP3
MCReset 0                              RT
MCReset 1                              1RT
MCSetAnalog 2 0                        AL-10,OA2
MCSetAnalog 2 4095                     AL10,OA2
MCSetAnalogEx 2 4096                   -
MCSetContourConfig 1 4 1.0 2.0 3.0 0.5 1VA1,1VD2,1VV3,1VO0.5
MCSetJogConfig 1 5 1.0 2.0 3.0 4.0 5.0 1JA1,1JV2,1JB3,1JG4,1JO5
MCSetJogConfigEx 1 6 1.0 2.0 3.0 4.0 5.0 6 1JA1,1JV2,1JB3,1JG4,1JO5
MCSetLimits 1 0 0 -5.0 5.0             1LL-5,1HL5,1LM0,1LF15
MCSetLimits 1 3 3 -5.0 5.0             1LL-5,1HL5,1LM0,1LN15
MCSetLimits 1 1 2 -5.0 5.0             1LL-5,1HL5,1LM0,1LF6,1LN9
MCSetLimits 1 2 1 -5.0 5.0             1LL-5,1HL5,1LM0,1LF9,1LN6
MCSetLimits 1 4 8 -5.0 5.0             1LL-5,1HL5,1LM9,1LF15
MCSetLimits 1 139 7 -5.0 5.0           1LL-5,1HL5,1LM134,1LN15
MCSetLimits 1 12 0 -5.0 5.0            -
MCSetLimits 1 0 12 -5.0 5.0            -
MCSetLimits 1 64 0 -5.0 5.0            -
MCSetLimits 1 0 128 -5.0 5.0           -
MCSetOperatingMode 2 1 0               2CM1
MCSetOperatingMode 2 1 1               2GM
MCSetOperatingMode 2 1 2               2PM
MCSetOperatingMode 2 1 3               2QM
MCSetOperatingMode 2 1 4               2VM
MCSetOperatingMode 2 1 5               -
MCSetProfile 1 1                       1PT
MCSetProfile 1 2                       1PS
MCSetProfile 1 4                       1PP
MCSetRegister 0 5 2                    AL5
MCSetRegister 30 5 2                   AL5,AR30
MCSetRegister 30 4294967295 2          AL-1,AR30
MCSetRegister 30 2.5 3                 AL2.5,AR30
MCSetRegister 30 2.5 4                 AL2.5,AR30
MCSetRegister 30 2.5 5                 -
MCSetRegister 30 2.5 1                 -
MCSetScale 1 6 1.0 2.0 3.0 4.0 5.0 6.0 1UK1,1UO2,1UR3,1US4,1UZ5,UT6
MCStop 3                               3ST
MCWait 0.25                            WA0.25
MCWaitForDigitalIO 3 0                 WF3
MCWaitForDigitalIO 3 1                 WN3
MCWaitForEdge 1 0                      1WE1
MCWaitForEdge 1 1                      1WE0
MCGetAccelerationEx 1 +                -
MCGetDigitalIO 3                       TC3
MCGetPositionEx 2 +                    2TP
MCGetRegister 7 + 2                    TR7
MCGetStatusEx 2 +                      2TS0,2TS1,2TS2,2TS3
MCIsStopped 1 5.0                      1TS
MCConfigureCompare 1 0 0 0.0 0 0.0     -
"""


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
