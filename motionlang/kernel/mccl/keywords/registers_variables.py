"""The controller's variables by name (LU) and by address.

RB RW RL RV RD read the variable at an address; WB WW WL WV WD write it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.status import word
from motionlang.kernel.mccl.axis.variables import NAMES, read, write
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.motion import run_in_velocity_mode
from motionlang.kernel.mccl.keywords.registers import wrapped
from motionlang.kernel.mccl.keywords.row import Group, accumulator, pure

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask


@accumulator("sets")
@pure
def look_up(task: CommandTask, command: Command) -> None:
    """Store the address of a variable in the accumulator (LU).

    Raises Fault for an unknown name.
    """
    name = str(command.value).upper()
    address = NAMES.get(name)
    if address is None:
        known = ", ".join(NAMES)
        raise Fault(
            codes.PARAMETER,
            f"there is no variable {command.value!r}",
            f"the variables are {known}",
            "unknown-word",
        )
    task.registers[0] = address


@accumulator("reads")
@pure
def read_byte(task: CommandTask, command: Command) -> None:
    task.registers[0] = int(_value(task, command, "low")) & 0xFF


@accumulator("reads")
@pure
def read_word(task: CommandTask, command: Command) -> None:
    low = int(_value(task, command, "low")) & 0xFFFF
    task.registers[0] = low - 0x10000 if low & 0x8000 else low


@accumulator("reads")
@pure
def read_long(task: CommandTask, command: Command) -> None:
    task.registers[0] = wrapped(int(_value(task, command, "whole")))


@accumulator("reads")
@pure
def read_real(task: CommandTask, command: Command) -> None:
    task.registers[0] = float(_value(task, command, "real"))


@pure
def write_byte(task: CommandTask, command: Command) -> None:
    _write_low(task, command, 0xFF)


@pure
def write_word(task: CommandTask, command: Command) -> None:
    _write_low(task, command, 0xFFFF)


@pure
def write_long(task: CommandTask, command: Command) -> None:
    _write(task, command, int(task.registers[0]))


@pure
def write_real(task: CommandTask, command: Command) -> None:
    _write(task, command, float(task.registers[0]))


@accumulator("reads")
@pure
def get_auxiliary(task: CommandTask, command: Command) -> None:
    value, until = word(task.board, task.axis(command), 1)
    task.has_read(until)
    task.registers[0] = wrapped(value)


def _write_low(task: CommandTask, command: Command, mask: int) -> None:
    """Replace the low bits of a variable with those of the accumulator."""
    old, _ = read(task.board, task.axis(command), task.whole(command))
    _write(task, command, int(old) & ~mask | int(task.registers[0]) & mask)


def _write(task: CommandTask, command: Command, value: float) -> None:
    axis, address = task.axis(command), task.whole(command)
    task.board.effects += 1
    write(task.board, axis, address, value)
    if address == NAMES["SPEED"] and axis.running:
        run_in_velocity_mode(task, axis)


def _value(task: CommandTask, command: Command, kind: str) -> float | int:
    """Read a variable; `kind` is what the command takes of it: "real", "whole", or its "low" bits."""
    axis = task.axis(command)
    address = task.whole(command)
    value, until = read(task.board, axis, address)
    task.has_read(until, axis, address, kind)
    return value


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("registers").row


ROWS = (
    _row("LU", "command", "W", "none", "text", look_up,
         "Look a variable of the controller up by name; its address comes into the accumulator.",
         'LU"STATUS",1RL@0,TR0'),
    _row("RB", "reading", "W", "axis", "number", read_byte, "Read the low byte of a variable into the accumulator.",
         'LU"STATUS",1RB@0', reads="position"),
    _row("RW", "reading", "W", "axis", "number", read_word, "Read the low word of a variable into the accumulator.",
         'LU"STATUS",1RW@0', reads="position"),
    _row("RL", "reading", "W", "axis", "number", read_long,
         "Read a variable as a whole number into the accumulator.",
         'LU"STATUS",1RL@0', reads="position"),
    _row("RV", "reading", "W", "axis", "number", Actions("read_float", do=read_real),
         "Read a variable as a real number into the accumulator.",
         'LU"POSITION",1RV@0', reads="position"),
    _row("RD", "reading", "W", "axis", "number", Actions("read_double", do=read_real),
         "Read a variable as a double into the accumulator.", 'LU"POSITION",1RD@0', reads="position"),
    _row("WB", "command", "W", "axis", "number", write_byte,
         "Write the low byte of the accumulator into that of a variable.",
         'LU"DEADBAND",AR10,AL5,1WB@10'),
    _row("WW", "command", "W", "axis", "number", write_word,
         "Write the low word of the accumulator into that of a variable.", 'LU"SPEED",AR10,AL5000,1WW@10'),
    _row("WL", "command", "W", "axis", "number", write_long, "Write the accumulator as a whole number to a variable.",
         'LU"SPEED",AR10,AL5000,1WL@10,1RL@10,TR0'),
    _row("WV", "command", "W", "axis", "number", Actions("write_float", do=write_real),
         "Write the accumulator as a real number to a variable.",
         'LU"ACCEL",AR10,AL5000,1WV@10'),
    _row("WD", "command", "W", "axis", "number", Actions("write_double", do=write_real),
         "Write the accumulator as a double to a variable.",
         'LU"ACCEL",AR10,AL5000,1WD@10'),
    _row("GX", "command", "C", "axis", "bits", get_auxiliary, "Get the auxiliary status word into the accumulator.",
         "1GX,TR0", reads="axis"),
)  # fmt: skip
