"""Encoding and decoding of serial parameter 0x115, the trajectory buffer.

A point is one 16-bit word and one or two 32-bit integers: the position, and the velocity if there is one. A
buffer command is one word. Words are plain integers here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from motionlang.lab.pvt.drive.point import INT32, MAX_TIME, WirePoint

PARAMETER = 0x115
# The op-code of the start-move command.
START_OPCODE = 17
TRAJECTORY_PARAMETER = 0xC8
# The value that parameter 0xC8 must have for PVT interpolation.
PVT_CONFIGURATION = 3

TIME_BITS = 0x00FF
RELATIVE_BIT = 1 << 12
COMMAND_BIT = 1 << 15
RESERVED_IN_POINT = 0x6F00
RESERVED_IN_COMMAND = 0x7E00

CLEAR, POP = 0, 1
COMMANDS: dict[int, str] = {
    CLEAR: "clear the buffer and abort any PVT move in progress",
    POP: "remove the N most recently added points",
}


class BadWord(ValueError):
    """Words that parameter 0x115 does not allow."""


@dataclass(frozen=True, slots=True)
class BufferCommand:
    """A buffer command: its code (`CLEAR`, `POP`) and its data byte."""

    code: int
    data: int = 0


def encode_point(point: WirePoint) -> tuple[int, ...]:
    """Return the words of a point: time, position and, if cubic, velocity.

    The words are unsigned integers.
    """
    if not 0 <= point.time <= MAX_TIME:
        raise BadWord(f"the time {point.time} ms does not fit bits 0-7")
    values = [point.position] if point.velocity is None else [point.position, point.velocity]
    for value in values:
        if value not in INT32:
            raise BadWord(f"{value} does not fit 32 bits")
    word = point.time | (RELATIVE_BIT if point.relative else 0)
    return (word, *(value & 0xFFFFFFFF for value in values))


def encode_command(command: BufferCommand) -> tuple[int, ...]:
    """Return the one word of a buffer command."""
    if command.code not in COMMANDS:
        raise BadWord(f"there is no buffer command {command.code}")
    if not 0 <= command.data <= TIME_BITS:
        raise BadWord(f"the command data {command.data} does not fit bits 0-7")
    return (COMMAND_BIT | command.code << 8 | command.data,)


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
    return WirePoint(position, rest[0] if rest else None, word & TIME_BITS, bool(word & RELATIVE_BIT))


def status_words(free: int) -> tuple[int, int, int]:
    """Return the words that a read of the parameter returns.

    These are the free positions and two reserved words.
    """
    return (free, 0, 0)


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
