"""Encoding of objects 0x2010 and 0x2012: PVT points, buffer commands, the status.

Object 0x2010 is eight bytes in one CAN frame. The note refers to the CANopen Programmer's Manual for the
layout. Byte 0 is the header. If bit 7 is set, it is a buffer command with its code in bits 0-6. If bit 7 is
clear, it is a segment: bits 0-2 are the low bits of its running number, and bits 3-6 the format.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from motionlang.lab.pvt.drive.point import WirePoint

CUBIC, CUBIC_COARSE, CUBIC_RELATIVE, CUBIC_RELATIVE_COARSE, INITIAL, LINEAR, LINEAR_RELATIVE = range(7)
FORMATS: dict[int, str] = {
    CUBIC: "time, 24-bit position, 24-bit velocity in 0.1 counts/s",
    CUBIC_COARSE: "time, 24-bit position, 24-bit velocity in 10 counts/s",
    CUBIC_RELATIVE: "time, 24-bit distance, 24-bit velocity in 0.1 counts/s",
    CUBIC_RELATIVE_COARSE: "time, 24-bit distance, 24-bit velocity in 10 counts/s",
    INITIAL: "32-bit position at which the move begins",
    LINEAR: "time, 32-bit position, no velocity",
    LINEAR_RELATIVE: "time, 32-bit distance, no velocity",
}
CLEAR, POP, CLEAR_ERRORS, RESET_ID = range(4)
COMMANDS: dict[int, str] = {
    CLEAR: "clear the buffer and abort any move in progress",
    POP: "remove the N most recently added points; N in bytes 1 and 2",
    CLEAR_ERRORS: "clear the latched errors of the mask in byte 1",
    RESET_ID: "set the running number of the next segment to 0",
}
SEQUENCE, OVERFLOW, UNDERFLOW = 1, 2, 4
ERRORS: dict[int, str] = {SEQUENCE: "sequence error", OVERFLOW: "overflow", UNDERFLOW: "underflow"}

# Tenths of a count per second in the coarse velocity unit of 10 counts/s.
COARSE = 100
INT24 = range(-(2**23), 2**23)
# Capacity of the drive's buffer in points; the note promises no more.
SIZE = 32


class BadPacket(ValueError):
    """Object 0x2010 does not allow these eight bytes, or cannot represent the point."""


@dataclass(frozen=True, slots=True)
class Packet:
    """A segment: its running number, and either a point or an initial position.

    After decoding the number is modulo 8.
    """

    number: int
    point: WirePoint | None = None
    initial: int | None = None


@dataclass(frozen=True, slots=True)
class PacketCommand:
    """A buffer command of object 0x2010."""

    code: int
    data: int = 0


@dataclass(frozen=True, slots=True)
class BufferStatus:
    """Object 0x2012: next running number, free positions, latched errors, empty flag."""

    next_number: int
    free: int
    errors: int
    empty: bool


def encode_points(points: Sequence[WirePoint], number: int = 0) -> list[bytes]:
    """Encode each point as one packet.

    An initial position precedes them if the first position does not fit in 24 bits. Positions beyond 24 bits are
    sent as distances, and velocities beyond 24 bits in units of 10 counts/s (rounded).
    """
    packets, last = list[bytes](), None
    for i, point in enumerate(points):
        position = _initial_position(point, last)
        if i == 0 and position is not None and point.velocity is not None and position not in INT24:
            packets.append(encode_packet(Packet(number, initial=position)))
            last = position
        packets.append(encode_packet(Packet(number + len(packets), _fitting(i, point, last))))
        last = position
    return packets


def encode_packet(packet: Packet) -> bytes:
    """Return the eight bytes of one segment."""
    if packet.initial is not None:
        return _header(packet.number, INITIAL) + packet.initial.to_bytes(4, "little", signed=True) + bytes(3)
    point = packet.point
    assert point is not None
    if point.velocity is None:
        form = LINEAR_RELATIVE if point.relative else LINEAR
        position = _signed_bytes(point.position, 4, "position")
        return _header(packet.number, form) + _time_byte(point.time) + position + bytes(2)
    coarse = point.velocity not in INT24
    velocity = _coarse(point.velocity) if coarse else point.velocity
    form = (CUBIC_RELATIVE if point.relative else CUBIC) + coarse
    fields = _signed_bytes(point.position, 3, "position") + _signed_bytes(velocity, 3, "velocity")
    return _header(packet.number, form) + _time_byte(point.time) + fields


def encode_command(command: PacketCommand) -> bytes:
    """Return the eight bytes of a buffer command."""
    if command.code not in COMMANDS:
        raise BadPacket(f"there is no buffer command {command.code}")
    return bytes([0x80 | command.code]) + command.data.to_bytes(2, "little") + bytes(5)


def decode(data: bytes) -> Packet | PacketCommand:
    """Return the segment or command in eight bytes.

    Raises `BadPacket` for an unknown format or command code.
    """
    if len(data) != 8:
        raise BadPacket(f"object 0x2010 holds 8 bytes, not {len(data)}")
    header = data[0]
    if header & 0x80:
        return _decode_command(header & 0x7F, data)
    number, form = header & 7, header >> 3
    if form == INITIAL:
        return Packet(number, initial=int.from_bytes(data[1:5], "little", signed=True))
    if form in (LINEAR, LINEAR_RELATIVE):
        position = int.from_bytes(data[2:6], "little", signed=True)
        return Packet(number, WirePoint(position, None, data[1], form == LINEAR_RELATIVE))
    if form not in FORMATS:
        raise BadPacket(f"there is no segment format {form}")
    position = int.from_bytes(data[2:5], "little", signed=True)
    velocity = int.from_bytes(data[5:8], "little", signed=True) * (COARSE if form & 1 else 1)
    return Packet(number, WirePoint(position, velocity, data[1], form >= CUBIC_RELATIVE))


def encode_status(status: BufferStatus) -> int:
    """Return the 32 bits of object 0x2012.

    Number is bits 0-15, free 16-23, errors 24-26 and empty 31.
    """
    return (
        status.next_number & 0xFFFF
        | (status.free & 0xFF) << 16
        | (status.errors & 7) << 24
        | (0x80000000 if status.empty else 0)
    )


def decode_status(value: int) -> BufferStatus:
    """Decode the 32 bits of object 0x2012."""
    return BufferStatus(value & 0xFFFF, value >> 16 & 0xFF, value >> 24 & 7, bool(value >> 31 & 1))


def error_names(errors: int) -> str:
    """Return the names of the latched errors."""
    return ", ".join(name for bit, name in ERRORS.items() if errors & bit)


def _initial_position(point: WirePoint, last: int | None) -> int | None:
    """Return the absolute position of a point; None if it is relative to the start."""
    if not point.relative:
        return point.position
    return None if last is None else last + point.position


def _fitting(i: int, point: WirePoint, last: int | None) -> WirePoint:
    """Return the point as absolute or relative, so that its position fits in 24 bits."""
    if point.velocity is None or point.position in INT24:
        return point
    if point.relative or last is None or point.position - last not in INT24:
        raise BadPacket(
            f"point {i}: neither its position nor its distance fits the 24 bits of object 0x2010; "
            "object 0x60C1 has 32"
        )
    return WirePoint(point.position - last, point.velocity, point.time, relative=True)


def _coarse(velocity: int) -> int:
    return round(velocity / COARSE)


def _header(number: int, form: int) -> bytes:
    return bytes([form << 3 | number & 7])


def _time_byte(time: int) -> bytes:
    if not 0 <= time <= 255:
        raise BadPacket(f"the time {time} ms does not fit a byte")
    return bytes([time])


def _signed_bytes(value: int, size: int, name: str) -> bytes:
    try:
        return value.to_bytes(size, "little", signed=True)
    except OverflowError:
        raise BadPacket(f"the {name} {value} does not fit {8 * size} bits") from None


def _decode_command(code: int, data: bytes) -> PacketCommand:
    if code not in COMMANDS:
        raise BadPacket(f"there is no buffer command {code}")
    size = {POP: 2, CLEAR_ERRORS: 1}.get(code, 0)
    return PacketCommand(code, int.from_bytes(data[1 : 1 + size], "little"))
