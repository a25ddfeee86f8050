"""Functions for digital and analogue channels.

An analogue channel has 12 bits over ±10 V: 0 is -10 V, 4095 is +10 V.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Command, is_on, volts
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import commands, query

if TYPE_CHECKING:
    from motionlang_mcapi.interface import Interface

MAX_CHANNEL = 255
FULL_SCALE = 10.0
BITS = 12
LARGEST = (1 << BITS) - 1


@commands("MCConfigureDigitalIO")
def configure(interface: Interface, channel: int, mode: int) -> list[Command]:
    """Set direction and logic; a latched input has no command."""
    if mode & mc.MC_DIO_LATCH:
        raise CallRefused(mc.MCERR_NOTSUPPORTED)
    chosen = (
        (mc.MC_DIO_INPUT, "CI"),
        (mc.MC_DIO_OUTPUT, "CT"),
        (mc.MC_DIO_HIGH, "CH"),
        (mc.MC_DIO_LOW, "CL"),
    )
    found = [command(name, value=channel) for bit, name in chosen if mode & bit]
    both = (mc.MC_DIO_INPUT | mc.MC_DIO_OUTPUT, mc.MC_DIO_HIGH | mc.MC_DIO_LOW)
    if not found or any(mode & bits == bits for bits in both):
        raise CallRefused(mc.MCERR_CONSTANT)
    return found


@commands("MCEnableDigitalIO")
def enable(interface: Interface, channel: int, state: int) -> list[Command]:
    return [command("CN" if state else "CF", value=channel)]


@commands("MCWaitForDigitalIO")
def wait(interface: Interface, channel: int, state: int) -> list[Command]:
    return [command("WN" if state else "WF", value=channel)]


@commands("MCSetAnalog", "MCSetAnalogEx")
def set_analog(interface: Interface, channel: int, value: int) -> list[Command]:
    if not 0 <= value <= LARGEST:
        raise CallRefused(mc.MCERR_RANGE)
    level = (2.0 * value / LARGEST - 1.0) * FULL_SCALE
    return [command("AL", value=level), command("OA", value=channel)]


@query("MCGetDigitalIO", "MCGetDigitalIOEx")
def state(interface: Interface, channel: int) -> int:
    return int(is_on(interface.board, _checked(channel)))


@query("MCGetDigitalIOConfig")
def configuration(interface: Interface, channel: int) -> int:
    _checked(channel)
    board = interface.board
    direction = mc.MC_DIO_OUTPUT if channel in board.outputs else mc.MC_DIO_INPUT
    return direction | (mc.MC_DIO_LOW if channel in board.controller.inputs.active_low else mc.MC_DIO_HIGH)


@query("MCGetAnalog", "MCGetAnalogEx")
def analog(interface: Interface, channel: int) -> int:
    level = volts(interface.board.controller.analogue_input(_checked(channel)))
    return round((max(-1.0, min(1.0, level / FULL_SCALE)) + 1.0) / 2.0 * LARGEST)


def _checked(channel: int) -> int:
    if not 1 <= channel <= MAX_CHANNEL:
        raise CallRefused(mc.MCERR_RANGE)
    return channel
