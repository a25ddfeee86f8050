"""The accumulator (register 0) and the other registers.

They hold 32-bit integers that wrap, or real numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import real
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group, accumulator, pure
from motionlang.kernel.tools import signed

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask

Operation = Callable[[float | int, float | int], float | int]

LARGEST = 1e300


@accumulator("sets")
@pure
def load(task: CommandTask, command: Command) -> None:
    task.registers[0] = limited(task, task.value(command))


@accumulator("stores")
@pure
def store(task: CommandTask, command: Command) -> None:
    task.set_register(task.whole(command), task.registers[0])


@accumulator("recalls")
@pure
def recall(task: CommandTask, command: Command) -> None:
    task.registers[0] = task.register(task.whole(command))


@accumulator("computes")
@pure
def complement(task: CommandTask, command: Command) -> None:
    task.registers[0] = wrapped(~int(task.registers[0]))


def tell_register(task: CommandTask, command: Command) -> None:
    value = task.register(task.whole(command))
    task.reply(task.whole_text(value) if isinstance(value, int) else real(value))


def wrapped(value: float | int) -> float | int:
    """Wrap an integer to 32 bits, two's complement; return a real number unchanged."""
    if isinstance(value, int):
        return value if -0x80000000 <= value <= 0x7FFFFFFF else signed(value)
    if not abs(value) <= LARGEST:
        raise too_large()
    return value


def too_large() -> Fault:
    """Return the fault of a result that no register can hold."""
    return Fault(codes.PARAMETER, "the result is too large for a register", kind="overflow")


def _with(operation: Operation, way: str = "computes") -> Action:
    @accumulator(way)
    @pure
    def apply(task: CommandTask, command: Command) -> None:
        task.registers[0] = limited(task, operation(task.registers[0], task.value(command)))

    return apply


def limited(task: CommandTask, value: float | int) -> float | int:
    """Return a result limited to 32 bits, wrapped or clamped as on this board."""
    if task.board.assumptions.get("mccl.overflow") == "stays" and isinstance(value, int):
        return max(-0x80000000, min(value, 0x7FFFFFFF))
    return wrapped(value)


@accumulator("computes")
@pure
def divide(task: CommandTask, command: Command) -> None:
    value = task.registers[0]
    if task.board.assumptions.get("mccl.quotient") == "real":
        value = float(value)
    task.registers[0] = limited(task, _quotient(value, task.value(command)))


@accumulator("computes")
@pure
def shift_right(task: CommandTask, command: Command) -> None:
    bits = int(task.registers[0])
    if task.board.assumptions.get("mccl.shift-right") == "zeros":
        bits &= 0xFFFFFFFF
    task.registers[0] = wrapped(bits >> int(task.value(command)))


def _quotient(value: float | int, divisor: float | int) -> float | int:
    if divisor == 0:
        raise Fault(
            codes.PARAMETER, "division by zero", "test the divisor before dividing", "division-by-zero"
        )
    if isinstance(value, int) and isinstance(divisor, int):
        whole = abs(value) // abs(divisor)
        return whole if (value < 0) == (divisor < 0) else -whole
    return value / divisor


# ------------------------------------------------------------------------------------------------- keywords

_G = Group("registers")
_row, _known = _G.row, _G.known
_reports_row = Group("reports").row


ROWS = (
    _row("AL", "command", "W", "none", "number", load, "Load the accumulator.", "AL5,TR0"),
    _row("AR", "command", "W", "none", "number", store, "Copy the accumulator to register n.", "AL5,AR10,TR10",
         low=0, high=255),
    _row("RA", "command", "W", "none", "number", recall, "Copy register n to the accumulator.", "RA10,TR0",
         low=0, high=255, reads="variable"),
    _row("AA", "command", "W", "none", "number", Actions("add", do=_with(lambda a, b: a + b, "adds")),
         "Add to the accumulator.", "AL5,AA3,TR0"),
    _row("AS", "command", "W", "none", "number", Actions("subtract", do=_with(lambda a, b: a - b, "adds")),
         "Subtract from the accumulator.", "AL5,AS3,TR0"),
    _row("AM", "command", "W", "none", "number", Actions("multiply", do=_with(lambda a, b: a * b)),
         "Multiply the accumulator.", "AL246,AM2,TR0"),
    _row("AD", "command", "W", "none", "number", divide,
         "Divide the accumulator; whole numbers give a whole number.",
         "AL7,AD2,TR0"),
    _row("AN", "command", "W", "none", "bits", Actions("bit_and", do=_with(lambda a, b: int(a) & int(b))),
         "Bitwise and with the accumulator.", "AL12,AN10,TR0"),
    _row("AO", "command", "W", "none", "bits", Actions("bit_or", do=_with(lambda a, b: int(a) | int(b))),
         "Bitwise or with the accumulator.", "AL12,AO10,TR0"),
    _row("AX", "command", "W", "none", "bits", Actions("bit_xor", do=_with(lambda a, b: int(a) ^ int(b))),
         "Bitwise exclusive or with the accumulator.",
         "AL12,AX10,TR0"),
    _row("AE", "command", "W", "none", "bits", Actions("bit_xor", do=_with(lambda a, b: int(a) ^ int(b))),
         "Same as AX; it is not known which of the two names is right.", "AL12,AE10,TR0"),
    _row("AC", "command", "C", "none", "bits", Actions("bit_not", do=complement),
         "Complement the accumulator.", "AL5,AC,TR0"),
    _row("SL", "command", "W", "none", "number", Actions("shift_left", do=_with(lambda a, b: int(a) << int(b))),
         "Shift the accumulator left by n bits.", "AL1,SL4,TR0",
         low=0, high=31),
    _row("SR", "command", "W", "none", "number", shift_right,
         "Shift the accumulator right by n bits; the sign bit stays.", "AL16,SR4,TR0", low=0, high=31),
    _known("GU", "command", "axis", "Get a user register; only the name is known."),
    _reports_row("TR", "reading", "R", "none", "number", tell_register, "Tell a register; 0 is the accumulator.",
                 "AL5,TR0", low=0, high=255, meant="PRINT"),
)  # fmt: skip
