"""The accumulator (register 0) and the registers: whole numbers of 32 bits that wrap, or real numbers."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis.axis import real
from motionlang.mccl.codes import Fault

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

    Operation = Callable[[float | int, float | int], float | int]

LARGEST = 1e300


def load(task: CommandTask, command: Command) -> None:
    task.registers[0] = wrapped(task.value(command))


def store(task: CommandTask, command: Command) -> None:
    task.set_register(task.whole(command), task.registers[0])


def recall(task: CommandTask, command: Command) -> None:
    task.registers[0] = task.register(task.whole(command))


def complement(task: CommandTask, command: Command) -> None:
    task.registers[0] = wrapped(~_bits(task.registers[0]))


def tell_register(task: CommandTask, command: Command) -> None:
    value = task.register(task.whole(command))
    task.reply(task.board.whole(value) if isinstance(value, int) else real(value))


def wrapped(value: float | int) -> float | int:
    """A whole number in 32 bits, two's complement; a real number as it is."""
    if isinstance(value, int):
        return value if -0x80000000 <= value <= 0x7FFFFFFF else (value + 0x80000000 & 0xFFFFFFFF) - 0x80000000
    if not abs(value) <= LARGEST:
        raise Fault(codes.PARAMETER, "the result is too large for a register", kind="overflow")
    return value


def _with(operation: Operation) -> Action:
    def apply(task: CommandTask, command: Command) -> None:
        task.registers[0] = limited(task, operation(task.registers[0], task.value(command)))

    return apply


def limited(task: CommandTask, value: float | int) -> float | int:
    """A result in 32 bits, as this board has it: wrapped round, or the last number that fits."""
    if task.board.readings.get("mccl.overflow") == "stays" and isinstance(value, int):
        return max(-0x80000000, min(value, 0x7FFFFFFF))
    return wrapped(value)


def divide(task: CommandTask, command: Command) -> None:
    value = task.registers[0]
    if task.board.readings.get("mccl.quotient") == "real":
        value = float(value)
    task.registers[0] = wrapped(_quotient(value, task.value(command)))


def shift_right(task: CommandTask, command: Command) -> None:
    bits = _bits(task.registers[0])
    if task.board.readings.get("mccl.shift-right") == "zeros":
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


def _bits(value: float | int) -> int:
    """The 32 bits of a number; a real one loses its fraction first."""
    return int(value)


ACTIONS: dict[str, Action] = {
    "load": load,
    "store": store,
    "recall": recall,
    "bit_not": complement,
    "tell_register": tell_register,
    "add": _with(lambda a, b: a + b),
    "subtract": _with(lambda a, b: a - b),
    "multiply": _with(lambda a, b: a * b),
    "divide": divide,
    "bit_and": _with(lambda a, b: _bits(a) & _bits(b)),
    "bit_or": _with(lambda a, b: _bits(a) | _bits(b)),
    "bit_xor": _with(lambda a, b: _bits(a) ^ _bits(b)),
    "shift_left": _with(lambda a, b: _bits(a) << int(b)),
    "shift_right": shift_right,
}
# Storing counts its own effect: only a register that changes is one.
PURE = frozenset(ACTIONS) - {"tell_register"}
