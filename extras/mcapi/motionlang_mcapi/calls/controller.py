"""The description of a model: its type, axes, modules and capabilities.

A board has the modules that its model accepts: one per axis, servo or stepper as the machine file says.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Board
from motionlang_mcapi import table as mc
from motionlang_mcapi.calls.channels import BITS, FULL_SCALE, MAX_CHANNEL
from motionlang_mcapi.command import lacks
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import query

if TYPE_CHECKING:
    from motionlang_mcapi.interface import Interface

# MCAPI's number of each model, with the codes of its servo and stepper modules.
MODELS: dict[str, tuple[int, int, int]] = {
    "multiflex": (mc.MFXPCI1000, mc.MFXSERVO, mc.MFXSTEPPER),
    "dcx-pci300": (mc.DCXPCI300, mc.MC300, mc.MC360),
    "dcx-pci100": (mc.DCXPCI100, mc.MC110, mc.MC150),
    "dcx-at200": (mc.DCXAT200, mc.MC200, mc.MC260),
    "dcx-pc100": (mc.DCXPC100, mc.MC110, mc.MC150),
}
LARGEST_RECORDING = 10_000
POINTS = 256
RECORDS = mc.MC_CAPTURE_ACTUAL | mc.MC_CAPTURE_ERROR | mc.MC_CAPTURE_OPTIMAL | mc.MC_CAPTURE_TORQUE


def _is_stepper(board: Board, axis: int) -> bool:
    return board.machine.settings.get(f"axis.{axis}.motor") == "stepper"


def _module(board: Board, axis: int) -> int:
    _, servo, stepper = MODELS[board.model.name]
    return stepper if _is_stepper(board, axis) else servo


def _has(board: Board, name: str) -> int:
    return int(not lacks(board.model, name))


@query("MCGetConfigurationEx")
def configuration(interface: Interface) -> tuple[float, ...]:
    """Return the capabilities of the model, in the order of MCPARAMEX."""
    board = interface.board
    axes = len(board.numbers)
    multiflex = int(board.model.words)
    volts = (-FULL_SCALE, FULL_SCALE, BITS)
    abilities = (_has(board, "US"), _has(board, "CP"), _has(board, "PS"), _has(board, "HS"))
    return (
        *(0, MODELS[board.model.name][0], axes, axes, axes, int(not board.model.whole_gains)),
        *(MAX_CHANNEL, MAX_CHANNEL, MAX_CHANNEL, POINTS),
        *(*abilities, 1, _has(board, "GT"), 1),
        *(*volts, *volts),
        *(1, multiflex, _has(board, "OO"), 0),
    )


@query("MCGetConfiguration")
def old_configuration(interface: Interface) -> tuple[int, ...]:
    """Return the capabilities of the model, in the order of MCPARAM."""
    board = interface.board
    kinds = [mc.MC_TYPE_STEPPER if _is_stepper(board, axis) else mc.MC_TYPE_SERVO for axis in board.numbers]
    abilities = (_has(board, "US"), _has(board, "CP"), _has(board, "PS"), _has(board, "HS"))
    return (
        *(0, MODELS[board.model.name][0], len(board.numbers), MAX_CHANNEL, MAX_CHANNEL, MAX_CHANNEL),
        *(kinds + [0] * 8)[:8],
        *(POINTS, *abilities, 1, _has(board, "GT"), 1),
    )


@query("MCGetAxisConfiguration")
def axis_configuration(interface: Interface, axis: int) -> tuple[float, ...]:
    """Return the module of an axis.

    A servo module has loop rates, a stepper module also ranges of step rates.
    """
    board = interface.board
    stepper = _is_stepper(board, axis)
    kind = mc.MC_TYPE_STEPPER if stepper else mc.MC_TYPE_SERVO
    rates = (4000.0, 2000.0, 1000.0) if _has(board, "HS") else (1.0 / board.model.update,) * 3
    top = 5e6 if stepper else 0.0
    return (
        *(_module(board, axis), axis, kind, RECORDS, LARGEST_RECORDING, 0),
        *rates,
        *(0.0, top, 0.0, top / 8.0, 0.0, top / 64.0),
        1,
    )


@query("MCGetInstalledModules")
def modules(interface: Interface, size: int) -> tuple[int, ...]:
    """Return the module of each site; 15 is an empty site."""
    board = interface.board
    if size <= 0:
        raise CallRefused(mc.MCERR_RANGE)
    found = [_module(board, axis) for axis in board.numbers]
    return tuple((found + [mc.NO_MODULE] * size)[:size])
