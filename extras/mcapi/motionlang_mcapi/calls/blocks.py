"""Functions for blocks and contour paths."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Command, line_of
from motionlang_mcapi import block
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command, line
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import at_once, commands

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.interface import Interface
    from motionlang_mcapi.session import HostProcess


@at_once("MCBlockBegin")
def begin(session: HostProcess, call: ApiCall, mode: int, num: int) -> bool | None:
    """Begin a block, or act at once, depending on the mode."""
    assert call.handle is not None
    found = block.begin(call.handle.interface, call.handle, mode, num)
    if not found:
        return None
    call.line = line(found)
    return True


@at_once("MCBlockEnd")
def end(session: HostProcess, call: ApiCall) -> bool:
    assert call.handle is not None
    call.line = block.end(call.handle.interface, call)
    return True


@commands("MCRepeat")
def repeat(interface: Interface, count: int) -> list[Command]:
    """Repeat the block so far; raise Refused outside a block."""
    if interface.block is None:
        raise CallRefused(mc.MCERR_BLOCK_MODE)
    return [command("RP", value=count)]


@commands("MCArcCenter")
def arc_center(interface: Interface, axis: int, type: int, position: float) -> list[Command]:
    return [command(_either(type, "CA", "CR"), axis, position)]


@commands("MCArcEndAngle")
def arc_end(interface: Interface, axis: int, type: int, angle: float) -> list[Command]:
    return [command(_either(type, "EA", "ER"), axis, angle)]


@commands("MCInterruptOnPosition")
def breakpoint_at(interface: Interface, axis: int, mode: int, position: float) -> list[Command]:
    return [command(_either(mode, "IP", "IR"), axis, position)]


@commands("MCContourPath")
def contour_path(interface: Interface, axis: int, wMode: int, buffer: str) -> list[Command]:  # noqa: N803
    """Carry out the commands in a text as a contour path."""
    if wMode not in (mc.MC_LINEAR, mc.MC_CIRC_CW, mc.MC_CIRC_CCW):
        raise CallRefused(mc.MCERR_CONSTANT)
    body = line_of(buffer)
    return [command("CP", axis, wMode), *(body.commands if body is not None else ())]


def _either(kind: int, absolute: str, relative: str) -> str:
    if kind not in (mc.MC_ABSOLUTE, mc.MC_RELATIVE):
        raise CallRefused(mc.MCERR_CONSTANT)
    return relative if kind == mc.MC_RELATIVE else absolute
