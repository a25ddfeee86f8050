"""Blocks: commands that MCBlockBegin collects and MCBlockEnd runs as one line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Command, CommandTask, Line
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command, line, own
from motionlang_mcapi.errors import CallRefused

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.interface import Interface
    from motionlang_mcapi.session import Handle

# The largest number of commands in a block.
MAX_COMMANDS = 1000
# Kinds of contour paths (CP), by the mode of MCBlockBegin.
PATHS = {
    mc.MC_BLOCK_CONTR_USER: 0,
    mc.MC_BLOCK_CONTR_LIN: 1,
    mc.MC_BLOCK_CONTR_CW: 2,
    mc.MC_BLOCK_CONTR_CCW: 3,
}


@dataclass(eq=False, slots=True)
class CommandBlock:
    """The commands collected so far.

    `handle` has begun the block, and the commands `first` precede them in the line.
    """

    handle: Handle
    mode: int
    first: tuple[Command, ...]
    commands: list[Command]

    def add(self, commands: list[Command]) -> None:
        """Add the commands of a call."""
        if len(self.commands) + len(commands) > MAX_COMMANDS:
            raise CallRefused(mc.MCERR_BLOCK_MODE)
        self.commands += commands

    def line(self, call: ApiCall) -> Line:
        """Return the line that carries out the block.

        If the block is a task, the result of the call is the task's number.
        """
        call.outputs = (0,)
        if self.mode != mc.MC_BLOCK_TASK:
            return line((*self.first, *self.commands))
        body = line(self.commands)

        def start(task: CommandTask, _: Command) -> None:
            call.outputs = (task.board.start_task(task.board.written(body), task),)

        return line([own("GT", start)])


def begin(interface: Interface, handle: Handle, mode: int, number: int) -> list[Command]:
    """Begin a block; if its mode acts at once, return the commands."""
    if mode == mc.MC_BLOCK_RESETM:
        return [command("RM")]
    if mode == mc.MC_BLOCK_CANCEL:
        interface.block = None
        return []
    if interface.block is not None:
        raise CallRefused(mc.MCERR_BLOCK_MODE)
    first: tuple[Command, ...] = ()
    if mode == mc.MC_BLOCK_MACRO:
        first = (command("MD", value=number),)
    elif mode in PATHS:
        if number not in interface.board.axes:
            raise CallRefused(mc.MCERR_AXIS_NUMBER if number else mc.MCERR_ALL_AXES)
        first = (command("CP", number, PATHS[mode]),)
    elif mode not in (mc.MC_BLOCK_COMPOUND, mc.MC_BLOCK_TASK):
        raise CallRefused(mc.MCERR_CONSTANT)
    interface.block = CommandBlock(handle, mode, first, [])
    return []


def end(interface: Interface, call: ApiCall) -> Line:
    """End the block and return its line; raise Refused if there is none."""
    block, interface.block = interface.block, None
    if block is None:
        raise CallRefused(mc.MCERR_BLOCK_MODE)
    return block.line(call)
