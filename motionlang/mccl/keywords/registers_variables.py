"""The controller's variables, by name (LU) and by address (RB RW RL RV RD, WB WW WL WV WD)."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis.status import word
from motionlang.mccl.axis.variables import NAMES, read, write
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords.registers_operations import wrapped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask


def look_up(task: CommandTask, command: Command) -> None:
    """LU: the address of a variable into the accumulator. Fault for an unknown name."""
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


def read_byte(task: CommandTask, command: Command) -> None:
    task.registers[0] = int(_value(task, command)) & 0xFF


def read_word(task: CommandTask, command: Command) -> None:
    low = int(_value(task, command)) & 0xFFFF
    task.registers[0] = low - 0x10000 if low & 0x8000 else low


def read_long(task: CommandTask, command: Command) -> None:
    task.registers[0] = wrapped(int(_value(task, command)))


def read_real(task: CommandTask, command: Command) -> None:
    task.registers[0] = float(_value(task, command))


def write_byte(task: CommandTask, command: Command) -> None:
    _write_low(task, command, 0xFF)


def write_word(task: CommandTask, command: Command) -> None:
    _write_low(task, command, 0xFFFF)


def write_long(task: CommandTask, command: Command) -> None:
    _write(task, command, int(task.registers[0]))


def write_real(task: CommandTask, command: Command) -> None:
    _write(task, command, float(task.registers[0]))


def get_auxiliary(task: CommandTask, command: Command) -> None:
    value, until = word(task.board, task.axis(command), 1)
    task.poll.attention.note(float, until)
    task.registers[0] = wrapped(value)


def _write_low(task: CommandTask, command: Command, mask: int) -> None:
    """Replace the low bits of a variable by those of the accumulator."""
    old, _ = read(task.board, task.axis(command), task.whole(command))
    _write(task, command, int(old) & ~mask | int(task.registers[0]) & mask)


def _write(task: CommandTask, command: Command, value: float) -> None:
    task.board.effects += 1
    write(task.board, task.axis(command), task.whole(command), value)


def _value(task: CommandTask, command: Command) -> float | int:
    axis = task.axis(command)
    address = task.whole(command)
    value, until = read(task.board, axis, address)
    task.poll.attention.note(float, until)
    return value


ACTIONS: dict[str, Action] = {
    "look_up": look_up,
    "read_byte": read_byte,
    "read_word": read_word,
    "read_long": read_long,
    "read_float": read_real,
    "read_double": read_real,
    "write_byte": write_byte,
    "write_word": write_word,
    "write_long": write_long,
    "write_float": write_real,
    "write_double": write_real,
    "get_auxiliary": get_auxiliary,
}
PURE = frozenset(ACTIONS)
