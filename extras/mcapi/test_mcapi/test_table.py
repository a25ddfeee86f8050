"""The table of functions: its size and its structures."""

from __future__ import annotations

import pytest

import motionlang_mcapi as mc
import motionlang_mcapi.calls
from motionlang.client import Status
from motionlang_mcapi import Mcapi
from motionlang_mcapi.registry import AT_ONCE, COMMANDS, POLLS, QUERIES
from motionlang_mcapi.table import FUNCTIONS, STRUCTURES
from test_mcapi.conftest import opened

# The bytes of each structure in C, with four-byte packing, from PMC's header compiled on 64-bit Linux.
SIZES = {
    "MCAXISCONFIG": 104,
    "MCCOMMUTATION": 32,
    "MCCONTOUR": 32,
    "MCFILTEREX": 124,
    "MCFILTER": 64,
    "MCJOGEX": 48,
    "MCJOG": 40,
    "MCMOTIONEX": 100,
    "MCMOTION": 96,
    "MCPARAMEX": 128,
    "MCPARAM": 44,
    "MCSCALE": 48,
    "MCSTATUSEX": 36,
}
BYTES = {"i": 4, "s": 2, "d": 8, "D": 8}


def size(name: str) -> int:
    """Return the bytes of a structure; fields are aligned to at most four bytes."""
    at = 4 if STRUCTURES[name].has_size else 0
    for field in STRUCTURES[name].fields:
        each = BYTES[field.kind]
        step = min(each, 4)
        at = -(-at // step) * step + each * field.count
    return -(-at // 4) * 4


def test_it_has_all_functions() -> None:
    """There are 158 functions; at most 25 are unsupported."""
    assert len(FUNCTIONS) == 158
    assert sum(bool(each.unsupported) for each in FUNCTIONS.values()) <= 25


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_function_means_something_here(name: str) -> None:
    """A function has code in one of four tables, a command, or a reason for neither."""
    function = FUNCTIONS[name]
    implementations = [name in found for found in (AT_ONCE, COMMANDS, POLLS, QUERIES)]
    if not any(implementations) and not function.unsupported:
        head, _, parameter = function.mccl.partition("{")
        assert len(head.lstrip("a")) == 2
        assert not parameter or parameter.rstrip("}") in [each.name for each in function.arguments]
    assert sum(implementations) + bool(function.unsupported) <= 1
    assert bool(function.help) is not bool(function.unsupported)


def test_structures_have_the_size_of_c() -> None:
    assert {name: size(name) for name in STRUCTURES} == SIZES


# The functions whose axis 0 means all axes.
ALL_AXES = """
MCAbort MCCaptureData MCDirection MCEnableAxis MCEnableBacklash MCEnableJog MCGo MCGoEx MCGoHome
MCInterruptOnPosition MCIsAtTarget MCIsEdgeFound MCIsIndexFound MCIsStopped MCLearnPoint MCMoveAbsolute
MCMoveRelative MCMoveToPoint MCReset MCSetAcceleration MCSetAuxEncPos MCSetDeceleration MCSetFilterConfig
MCSetFilterConfigEx MCSetGain MCSetJogConfig MCSetJogConfigEx MCSetLimits MCSetModuleInputMode MCSetModuleOutputMode
MCSetMotionConfig MCSetMotionConfigEx MCSetPosition MCSetProfile MCSetScale MCSetServoOutputPhase MCSetTorque
MCSetVelocity MCSetVelocityOverride MCStop MCWaitForStop MCWaitForTarget pmccmdex pmccmdrpyex
"""
ZEROS = {"d": 0.0, "str": ""}


def result_of_axis_0(host: Mcapi, name: str) -> int:
    """Return the result of a call whose arguments are 0, with room for every output."""
    arguments: list[object] = []
    for each in FUNCTIONS[name].arguments:
        if each.out:
            arguments.append(1)
        elif each.kind in STRUCTURES:
            values = STRUCTURES[each.kind]().values()
            arguments += [len(values), *values]
        else:
            arguments.append(ZEROS.get(each.kind, 0))
    host._calls.call(name, host.Handle(), arguments)  # type: ignore[arg-type]
    return host.GetError()


def test_functions_that_take_all_axes() -> None:
    """Any other function rejects axis 0 with error 17."""
    host = opened()
    of_axes = [
        name
        for name, function in FUNCTIONS.items()
        if not function.unsupported and any(each.name == "axis" for each in function.arguments)
    ]
    accepted = [name for name in of_axes if result_of_axis_0(host, name) != mc.MCERR_ALL_AXES]
    assert sorted(accepted) == sorted(ALL_AXES.split())


# The flags of a client from bit 0 of the primary status word on, with PMC's names of these bits.
FLAGS = {
    "BUSY": "BUSY", "MOTOR_ON": "MTR_ENABLE", "AT_TARGET": "MODE_VEL", "STOPPED": "TRAJ", "NEGATIVE": "DIR",
    "JOG_ENABLED": "JOG_ENAB", "HOMED": "HOMED", "MOTOR_ERROR": "ERROR", "LOOKING_FOR_INDEX": "LOOK_INDEX",
    "LOOKING_FOR_EDGE": "LOOK_EDGE", "BREAKPOINT_REACHED": "BREAKPOINT", "FOLLOWING_ERROR": "FOLLOWING",
    "AMPLIFIER_ON": "AMP_ENABLE", "AMPLIFIER_FAULT": "AMP_FAULT", "HARD_PLUS_ENABLED": "PLIM_ENAB",
    "HARD_PLUS_TRIPPED": "PLIM_TRIP", "HARD_MINUS_ENABLED": "MLIM_ENAB", "HARD_MINUS_TRIPPED": "MLIM_TRIP",
    "SOFT_HIGH_ENABLED": "PSOFT_ENAB", "SOFT_HIGH_TRIPPED": "PSOFT_TRIP", "SOFT_LOW_ENABLED": "MSOFT_ENAB",
    "SOFT_LOW_TRIPPED": "MSOFT_TRIP",
}  # fmt: skip


@pytest.mark.parametrize(("bit", "flag"), list(enumerate(FLAGS)))
def test_a_flag_has_the_bit_that_mcapi_numbers(bit: int, flag: str) -> None:
    assert Status[flag] == 1 << bit
    assert getattr(mc, f"MC_STAT_{FLAGS[flag]}") == bit
