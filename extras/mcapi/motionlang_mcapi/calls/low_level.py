"""Low-level functions: registers, ASCII characters, numeric commands, the lock.

They also look up variables of the board.
"""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Board, Command, CommandTask, table
from motionlang.kernel.mccl.axis.variables import NAMES
from motionlang.kernel.mccl.keywords.registers import wrapped
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command, line, own
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import at_once, commands, poll, query

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.calls.motion import Polled
    from motionlang_mcapi.interface import Interface
    from motionlang_mcapi.session import Handle, HostProcess
    from motionlang_mcapi.table import Value

NUMBERS = (mc.MC_TYPE_LONG, mc.MC_TYPE_FLOAT, mc.MC_TYPE_DOUBLE)
# The one numeric code that a source gives.
KNOWN_CODES = {253: "DW"}
CODES = "mccl.codes."


def _typed(value: Value, kind: int) -> float | int:
    """Return a value converted to a numeric type; raise Refused for any other type."""
    if kind not in NUMBERS or isinstance(value, str):
        raise CallRefused(mc.MCERR_CONSTANT)
    return wrapped(int(value)) if kind == mc.MC_TYPE_LONG else float(value)


@commands("MCSetRegister")
def set_register(interface: Interface, reg: int, value: Value, type: int) -> list[Command]:
    """Load the accumulator and store it, the only way to write a register."""
    found = [command("AL", value=_typed(value, type))]
    return found if reg == 0 else [*found, command("AR", value=reg)]


@query("MCGetRegister")
def register(interface: Interface, reg: int, type: int) -> float | int:
    if type not in NUMBERS or reg < 0:
        raise CallRefused(mc.MCERR_CONSTANT if type not in NUMBERS else mc.MCERR_RANGE)
    return _typed(interface.register(reg), type)


@query("pmclookupvar")
def variable(interface: Interface, varname: str) -> int:
    address = NAMES.get(varname.upper())
    if address is None:
        raise CallRefused(mc.MCERR_NOT_FOUND)
    return address


# ------------------------------------------------------------------------------------------------ characters


def _ascii(call: ApiCall) -> Interface:
    """Return the interface of an ASCII handle; raise Refused for a binary one."""
    assert call.handle is not None
    if not call.handle.is_ascii:
        raise CallRefused(mc.MCERR_UNSUPPORTED_MODE)
    return call.handle.interface


@at_once("pmcputs")
def put_text(session: HostProcess, call: ApiCall, buffer: str) -> None:
    call.value = _ascii(call).put(buffer.encode("latin-1", "replace"))


@at_once("pmcputc")
def put_character(session: HostProcess, call: ApiCall, character: int) -> None:
    call.value = _ascii(call).put(bytes([character & 0xFF]))


@at_once("pmcgetc")
def get_character(session: HostProcess, call: ApiCall) -> None:
    found = _ascii(call).get_one()
    call.value = ord(found) if found else 0


@poll("pmcgets")
def get_text(session: HostProcess, call: ApiCall, size: int) -> Polled:
    """Wait for text up to a CR or prompt.

    The buffer needs one character for the terminating zero.
    """
    interface = _ascii(call)
    if size <= 0:
        raise CallRefused(mc.MCERR_RANGE)
    assert call.handle is not None
    room = size - 1

    def finish(_: bool) -> None:
        text = interface.get(room)
        call.value, call.outputs = len(text), (text,)

    return lambda: interface.has_text(room), lambda: inf, call.handle.timeout or inf, finish


@at_once("pmcrdy")
def ready(session: HostProcess, call: ApiCall) -> None:
    assert call.handle is not None
    call.value = int(not call.handle.interface.occupied)


# ---------------------------------------------------------------------------------------------------- codes


def _name_of(board: Board, code: int) -> str:
    """Return the name of the command with a numeric code.

    Codes of the machine file override the known ones. Raises Refused for any other code.
    """
    given = {
        value: key.removeprefix(CODES).upper()
        for key, value in board.machine.settings.items()
        if key.startswith(CODES)
    }
    found = given.get(code, KNOWN_CODES.get(code))
    if found is None or table().get(found) is None:
        raise CallRefused(mc.MCERR_NOTSUPPORTED)
    return found


def _by_code(interface: Interface, axis: int, code: int, value: Value | None, kind: int) -> Command:
    name = _name_of(interface.board, code)
    if kind == mc.MC_TYPE_NONE:
        return command(name, axis)
    if kind == mc.MC_TYPE_REG:
        return command(name, axis, interface.register(int(value or 0)))
    return command(name, axis, _typed(0 if value is None else value, kind))


@at_once("pmccmdex")
def numeric(
    session: HostProcess, call: ApiCall, axis: int, command: int, argument: Value, type: int
) -> bool | None:
    """Carry out a command by its code, or add it to an open block."""
    handle = _handle(call)
    found = _by_code(handle.interface, axis, command, argument, type)
    if handle.interface.block is not None:
        handle.interface.block.add([found])
        return None
    call.line = line([found, own("pmccmdex", lambda task, _: _store(task, handle))])
    return True


@at_once("pmccmdrpyex")
def numeric_with_reply(
    session: HostProcess, call: ApiCall, axis: int, cmd: int, arg: Value, arg_type: int, rpy_type: int
) -> bool:
    """Carry out a command by its code, and return its reply."""
    handle = _handle(call)
    found = _by_code(handle.interface, axis, cmd, arg, arg_type)

    def answer(task: CommandTask, _: Command) -> None:
        _store(task, handle)
        _give(call, handle.reply, rpy_type)

    call.line = line([found, own("pmccmdrpyex", answer)])
    return True


@at_once("pmcrpyex")
def last_reply(session: HostProcess, call: ApiCall, type: int) -> None:
    handle = _handle(call)
    text, handle.reply = handle.reply, ""
    _give(call, text, type)


def _handle(call: ApiCall) -> Handle:
    assert call.handle is not None
    return call.handle


def _store(task: CommandTask, handle: Handle) -> None:
    handle.reply = handle.interface.reply_text


def _give(call: ApiCall, text: str, kind: int) -> None:
    """Make the last number of a reply the result of the call."""
    words = text.split()
    try:
        value = float(words[-1])
    except (IndexError, ValueError):
        call.code = mc.MCERR_NO_REPLY
        return
    if kind not in NUMBERS:
        call.code = mc.MCERR_CONSTANT
        return
    call.outputs = (_typed(value, kind),)


# ----------------------------------------------------------------------------------------------------- lock


@poll("pmclock")
def lock(session: HostProcess, call: ApiCall, wait_msec: int) -> Polled:
    """Reserve the interface for this handle; wait while another handle has it."""
    handle = _handle(call)
    interface = handle.interface

    def finish(is_free: bool) -> None:
        if is_free:
            interface.owner = handle
        else:
            call.value = call.code = mc.MCERR_TIMEOUT

    return lambda: interface.owner in (None, handle), lambda: inf, wait_msec / 1000.0, finish


@at_once("pmcunlock")
def unlock(session: HostProcess, call: ApiCall) -> None:
    handle = _handle(call)
    if handle.interface.owner is handle:
        handle.interface.owner = None
