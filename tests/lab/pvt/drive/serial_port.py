"""The drive's serial port: the two parameters and the op-code of a PVT move.

The framing of the serial protocol is defined in another document. A message here is the content of a parameter.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.lab.pvt.drive import serial
from motionlang.lab.pvt.drive.point import WirePoint
from motionlang.lab.pvt.drive.serial import BadWord

if TYPE_CHECKING:
    from motionlang_copley.drive import Drive

COMMAND_BIT = 1 << 15
TIME_BITS = 0x00FF
RESERVED_IN_POINT = 0x6F00
RESERVED_IN_COMMAND = 0x7E00

CLEAR, POP = 0, 1


@dataclass(frozen=True, slots=True)
class BufferCommand:
    """A buffer command: its code (`CLEAR`, `POP`) and its data byte."""

    code: int
    data: int = 0


def decode(message: Sequence[int]) -> WirePoint | BufferCommand:
    """Return the point or the command of a message.

    Raises `BadWord` for a reserved bit, and for too few or too many values.
    """
    if not message:
        raise BadWord("a message needs at least its 16-bit word")
    word, *values = message
    if not 0 <= word <= 0xFFFF:
        raise BadWord(f"{word:#x} is not a 16-bit word")
    if word & COMMAND_BIT:
        return _decode_command(word, values)
    if word & RESERVED_IN_POINT:
        raise BadWord(f"reserved bits {word & RESERVED_IN_POINT:#06x} of the time word {word:#06x} are set")
    if len(values) not in (1, 2):
        raise BadWord(f"the time word needs one or two 32-bit values after it, not {len(values)}")
    position, *rest = (_signed(value) for value in values)
    return WirePoint(position, rest[0] if rest else None, word & TIME_BITS, bool(word & serial.RELATIVE_BIT))


def _decode_command(word: int, values: Sequence[int]) -> BufferCommand:
    if word & RESERVED_IN_COMMAND:
        raise BadWord(f"reserved bits {word & RESERVED_IN_COMMAND:#06x} of the command {word:#06x} are set")
    if values:
        raise BadWord("no data follows a buffer command")
    return BufferCommand(word >> 8 & 1, word & TIME_BITS)


def _signed(value: int) -> int:
    if not 0 <= value <= 0xFFFFFFFF:
        raise BadWord(f"{value:#x} is not a 32-bit value")
    return value - 2**32 if value >= 2**31 else value


class PortRefused(Exception):
    """The drive's serial port has rejected a request."""


class SerialPort:
    """Parameters 0xC8 and 0x115 and op-code 17 of one drive."""

    def __init__(self, drive: Drive) -> None:
        self.drive = drive
        self.configuration = 0

    def write(self, parameter: int, message: Sequence[int]) -> None:
        """Write a parameter; raise `PortRefused` if it is rejected.

        Writing a point to a full buffer is an overflow.
        """
        if parameter == serial.TRAJECTORY_PARAMETER:
            if list(message) not in ([0], [serial.PVT_CONFIGURATION]):
                raise PortRefused(f"trajectory configuration {list(message)} is not simulated: 3 is PVT")
            self.configuration = message[0]
        elif parameter == serial.PARAMETER:
            self._fill(message)
        else:
            raise PortRefused(f"parameter {parameter:#x} is not simulated")

    def read(self, parameter: int) -> tuple[int, ...]:
        if parameter == serial.TRAJECTORY_PARAMETER:
            return (self.configuration,)
        if parameter == serial.PARAMETER:
            return (self.drive.buffer.free, 0, 0)
        raise PortRefused(f"parameter {parameter:#x} is not simulated")

    def command(self, opcode: int) -> None:
        """Execute an op-code: 17 starts the move in the buffer."""
        if opcode != serial.START_OPCODE:
            raise PortRefused(f"op-code {opcode} is not simulated: {serial.START_OPCODE} starts a move")
        if self.configuration != serial.PVT_CONFIGURATION:
            raise PortRefused("parameter 0xC8 must be 3 (PVT interpolation) before a PVT move starts")
        self.drive.start()

    def _fill(self, message: Sequence[int]) -> None:
        try:
            content = decode(message)
        except BadWord as problem:
            raise PortRefused(str(problem)) from None
        if not isinstance(content, BufferCommand):
            self.drive.add(content)
        elif content.code == CLEAR:
            self.drive.clear()
        else:
            self.drive.pop(content.data)
