"""Export of a PVT move as CSV, serial words or the CAN frames of a whole session.

Frames have the format of can-utils, `identifier#data`, so `cansend` accepts each line. In every format, lines
that begin with # are comments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from motionlang.lab.pvt.drive import packet, serial
from motionlang.lab.pvt.drive.packet import SIZE
from motionlang.lab.pvt.drive.point import WirePoint, from_wire
from motionlang.lab.pvt.table import write_points

Writer = Callable[[Sequence[WirePoint], int], list[str]]

FORMATS: dict[str, str] = {
    "csv": "position, velocity, time: what every motionlang pvt command reads",
    "serial": "the words of serial parameter 0x115",
    "pdo": "CAN frames: one PDO per point (object 0x2010)",
    "sdo": "CAN frames: object 0x2010 by SDO",
    "record": "CAN frames: object 0x60C1 by SDO, sub-mode -3",
}
# The mode of operation that takes points, and the types of the objects that are written.
INTERPOLATED_POSITION = 7
KINDS = {
    (0x6040, 0): "u16",
    (0x6060, 0): "i8",
    (0x60C0, 0): "i16",
    (0x60C1, 1): "i32",
    (0x60C1, 2): "u8",
    (0x60C1, 3): "i32",
}
LATER = "# from here on: whenever object 0x2012 shows free places"


class Unwritable(ValueError):
    """The format cannot represent the move."""


@dataclass(frozen=True, slots=True)
class Export:
    """The lines of a move, and the points that a drive would read from them."""

    lines: list[str]
    read_back: list[WirePoint]


def export(points: Sequence[WirePoint], form: str, node: int = 1) -> Export:
    """Return a move in one of `FORMATS`.

    Raises `Unwritable` if the format cannot represent it.
    """
    if form == "csv":
        return Export(write_points(from_wire(points)), list(points))
    if form == "serial":
        return _serial(points)
    if form == "record":
        return Export(_record_session(points, node), list(points))
    try:
        messages = packet.encode_points(points)
    except packet.BadPacket as problem:
        raise Unwritable(str(problem)) from None
    lines = _packet_session(messages, node, form == "pdo")
    return Export(lines, _read_back(messages))


def sdo_download(node: int, index: int, sub: int, data: bytes) -> list[str]:
    """Return the frames that a master sends to write an object.

    One frame holds up to four bytes; more are sent in segments of seven.
    """
    address = index.to_bytes(2, "little") + bytes([sub])
    size = len(data)
    if size <= 4:
        command = bytes([0x23 | (4 - size) << 2])
        return [frame(0x600 + node, command + address + data.ljust(4, b"\0"))]
    frames = [frame(0x600 + node, b"\x21" + address + size.to_bytes(4, "little"))]
    for i in range(0, size, 7):
        chunk, toggle, last = data[i : i + 7], (i // 7 & 1) << 4, i + 7 >= size
        command = bytes([toggle | (7 - len(chunk)) << 1 | last])
        frames.append(frame(0x600 + node, command + chunk.ljust(7, b"\0")))
    return frames


def frame(can_id: int, data: bytes) -> str:
    """Return one frame in the format of can-utils."""
    return f"{can_id:03X}#{data.hex().upper()}"


def _serial(points: Sequence[WirePoint]) -> Export:
    messages = [serial.encode_point(point) for point in points]
    lines = [
        f"# parameter 0x{serial.TRAJECTORY_PARAMETER:X} = {serial.PVT_CONFIGURATION}: PVT interpolation",
        f"# parameter 0x{serial.PARAMETER:X}, one point per line: time word, position, velocity",
    ]
    texts = [" ".join([f"{word:04X}", *(f"{value:08X}" for value in rest)]) for word, *rest in messages]
    start = f"# op-code {serial.START_OPCODE}: start move"
    lines += [*texts[:SIZE], start]
    if texts[SIZE:]:
        lines += ["# from here on: whenever reading the parameter shows free places", *texts[SIZE:]]
    return Export(lines, list(points))


def _read_back(messages: Sequence[bytes]) -> list[WirePoint]:
    """Return the points in the messages.

    An initial position is added to the point that is relative to it.
    """
    points: list[WirePoint] = []
    initial = None
    for message in messages:
        content = packet.decode(message)
        assert isinstance(content, packet.Packet)
        if content.point is None:
            initial = content.initial
            continue
        point = content.point
        if initial is not None and point.relative:
            point = replace(point, position=initial + point.position, relative=False)
        points.append(point)
        initial = None
    return points


def _packet_session(messages: Sequence[bytes], node: int, by_pdo: bool) -> list[str]:
    def send(message: bytes) -> list[str]:
        if by_pdo:
            return [frame(0x200 + node, message)]
        return sdo_download(node, 0x2010, 0, message)

    lines = _prologue(node)
    if by_pdo:
        lines += ["# PDO 1: object 0x2010 in, object 0x2012 out on every event"]
        lines += _map_pdo(node, 0x1400, 0x200 + node, 0x20100040) + _map_pdo(
            node, 0x1800, 0x180 + node, 0x20120020
        )
    return lines + _session(node, [send(message) for message in messages])


def _record_session(points: Sequence[WirePoint], node: int) -> list[str]:
    groups = []
    for i, point in enumerate(points):
        if point.relative or point.velocity is None:
            kind = "relative" if point.relative else "linear"
            raise Unwritable(f"point {i}: object 0x60C1 in sub-mode -3 has no {kind} points")
        fields = ((1, point.position), (2, point.time), (3, point.velocity))
        groups.append([line for sub, value in fields for line in _write(node, 0x60C1, sub, value)])
    return _prologue(node) + _session(node, groups)


def _prologue(node: int) -> list[str]:
    return [
        "# node operational, interpolated position mode, sub-mode",
        frame(0x000, bytes([1, node])),
        *_write(node, 0x6060, 0, INTERPOLATED_POSITION),
        *_write(node, 0x60C0, 0, -3),
        "# shutdown, switch on, enable operation",
        *(line for control in (0x06, 0x07, 0x0F) for line in _write(node, 0x6040, 0, control)),
    ]


def _session(node: int, groups: Sequence[Iterable[str]]) -> list[str]:
    lines = ["# the buffer filled"]
    lines += [line for group in groups[:SIZE] for line in group]
    lines += ["# start", *_write(node, 0x6040, 0, 0x1F)]
    if groups[SIZE:]:
        lines += [LATER, *(line for group in groups[SIZE:] for line in group)]
    return lines


def _map_pdo(node: int, communication: int, can_id: int, mapped: int) -> list[str]:
    """Return the frames that disable a PDO, map one object and enable it again.

    The PDO is event-driven.
    """
    mapping = communication + 0x200
    steps = (
        (communication, 1, can_id | 1 << 31, 4),
        (communication, 2, 255, 1),
        (mapping, 0, 0, 1),
        (mapping, 1, mapped, 4),
        (mapping, 0, 1, 1),
        (communication, 1, can_id, 4),
    )
    return [
        line
        for index, sub, value, size in steps
        for line in sdo_download(node, index, sub, value.to_bytes(size, "little"))
    ]


def _write(node: int, index: int, sub: int, value: int) -> list[str]:
    kind = KINDS[index, sub]
    data = value.to_bytes(int(kind[1:]) // 8, "little", signed=kind[0] == "i")
    return sdo_download(node, index, sub, data)
