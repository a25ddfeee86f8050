"""Encoding of serial parameter 0x115, the trajectory buffer.

A point is one 16-bit word and one or two 32-bit integers: the position, and the velocity if there is one. Words are
plain integers here.
"""

from __future__ import annotations

from motionlang.lab.pvt.drive.point import INT32, MAX_TIME, WirePoint

PARAMETER = 0x115
# The op-code of the start-move command.
START_OPCODE = 17
TRAJECTORY_PARAMETER = 0xC8
# The value that parameter 0xC8 must have for PVT interpolation.
PVT_CONFIGURATION = 3

RELATIVE_BIT = 1 << 12


class BadWord(ValueError):
    """Words that parameter 0x115 does not allow."""


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
