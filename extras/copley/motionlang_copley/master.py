"""A master that streams a PVT move to a drive over CANopen.

The steps are those of the manual. Map the status object 0x2012 to an event-driven PDO, fill the buffer, and
raise bit 4 of the control word. Then send more points whenever the status shows that the drive has removed
some from the buffer.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import can
import canopen

from motionlang.lab.pvt.drive import packet
from motionlang.lab.pvt.drive.packet import SIZE
from motionlang.lab.pvt.drive.point import WirePoint
from motionlang_copley.node import object_dictionary
from motionlang_copley.objects import FIXED_TIME, INTERPOLATED_POSITION, SUB_MODES

_Send = Callable[[bytes], None]

TRANSFERS: dict[str, str] = {
    "pdo": "object 0x2010, one PDO per point",
    "sdo": "object 0x2010 by SDO",
    **{str(mode): f"object 0x60C1, {text}" for mode, text in SUB_MODES.items()},
}
SWITCH_ON = (0x06, 0x07, 0x0F)
START, ENABLED = 0x1F, 0x0F
CUBIC_MODE = -3
MOVING_BIT = 0x1000


class StreamError(Exception):
    """The move could not be streamed to its end."""


class Bus(Protocol):
    """A canopen network with a method that waits for messages from the drive."""

    @property
    def network(self) -> canopen.Network: ...

    @property
    def patience(self) -> int:
        """The number of waits without a message after which the master gives up."""

    def wait(self) -> None: ...


@dataclass(slots=True)
class Streamed:
    """Statistics of a stream.

    `sent` counts the messages with points, and `resent` those sent again. `lowest` is the smallest number of
    points observed in the buffer.
    """

    sent: int = 0
    resent: int = 0
    lowest: int = SIZE


class BusMaster:
    """A master for one drive on a bus."""

    def __init__(self, bus: Bus, node_id: int = 1) -> None:
        self.bus = bus
        self.node_id, self.node = node_id, canopen.RemoteNode(node_id, object_dictionary())
        bus.network.add_node(self.node)
        self.status = packet.BufferStatus(0, 0, 0, True)
        self.news = 0

    def prepare(self) -> None:
        """Enable operation in interpolated position mode, with an empty buffer."""
        self._map_pdos()
        self.node.nmt.state = "OPERATIONAL"
        self._write(0x6060, 0, INTERPOLATED_POSITION)
        for control in SWITCH_ON:
            self._write(0x6040, 0, control)
        self.refresh()
        if self.status.errors:
            self._send_sdo(
                packet.encode_command(packet.PacketCommand(packet.CLEAR_ERRORS, self.status.errors))
            )
        if not self.status.empty:
            self._send_sdo(packet.encode_command(packet.PacketCommand(packet.CLEAR)))
        self.refresh()

    def stream(self, points: Sequence[WirePoint], transfer: str = "pdo") -> Streamed:
        """Stream a whole move with one of `TRANSFERS`.

        Raises `StreamError` if the drive or the points do not allow it.
        """
        if transfer not in TRANSFERS:
            raise StreamError(f"there is no way {transfer!r} to stream; there is {', '.join(TRANSFERS)}")
        try:
            return self._stream(points, transfer)
        except packet.BadPacket as problem:
            raise StreamError(str(problem)) from None
        except canopen.SdoCommunicationError:
            raise StreamError(f"node {self.node_id} does not answer") from None
        except canopen.SdoAbortedError as rejected:
            raise StreamError(f"the drive rejected a message: {rejected}") from None
        except can.CanError as problem:
            raise StreamError(f"the bus failed: {problem}") from None

    def _stream(self, points: Sequence[WirePoint], transfer: str) -> Streamed:
        self.prepare()
        if transfer in ("pdo", "sdo"):
            self._write(
                0x60C0, 0, CUBIC_MODE
            )  # any mode but 0, which would drop the points sent before the start
            return self._stream_packets(points, self._send_pdo if transfer == "pdo" else self._send_sdo)
        mode = int(transfer)
        self._write(0x60C0, 0, mode)
        if mode in FIXED_TIME:
            return self._stream_fixed(points, mode)
        return self._stream_records(points, mode)

    def refresh(self) -> None:
        """Read the buffer status by SDO."""
        self.status = packet.decode_status(self._read(0x2012))

    # ------------------------------------------------------------------------------------- the three streams

    def _stream_packets(self, points: Sequence[WirePoint], send: _Send) -> Streamed:
        base = self.status.next_number
        messages = packet.encode_points(points, base)
        done, result = 0, Streamed()
        started, arrived, silent = False, False, 0
        while True:
            lost = self._lost(base + done, everything=done == len(messages) and not arrived)
            arrived = done == len(messages) and not lost
            result.resent += lost
            done -= lost
            burst = messages[done : done + self._room(base + done)]
            for message in burst:
                send(message)
            done += len(burst)
            result.sent += len(burst)
            if not started:
                self._start()
                started = True
            if done < len(messages):
                result.lowest = min(result.lowest, SIZE - self.status.free)
            elif arrived and self.status.empty and not self._moving():
                return result
            silent = self._wait(silent)

    def _stream_records(self, points: Sequence[WirePoint], mode: int) -> Streamed:
        base, result = self.status.next_number, Streamed()
        started, silent = False, 0
        while True:
            room = self._room(base + result.sent)
            for point in points[result.sent : result.sent + room]:
                self._write_record(_absolute_only(point), mode)
                result.sent += 1
            if not started:
                self._start()
                started = True
            self._check()
            if result.sent == len(points) and self._at_rest():
                return result
            if result.sent < len(points):
                result.lowest = min(result.lowest, SIZE - self.status.free)
            silent = self._wait(silent)

    def _stream_fixed(self, points: Sequence[WirePoint], mode: int) -> Streamed:
        """Stream in sub-mode 0 or -1: one position per period.

        The last position is repeated until it is reached. Then bit 4 is cleared.
        """
        period = _common_time(points)
        self._write(0x60C2, 2, -3)
        self._write(0x60C2, 1, period)
        base, result, silent = self.status.next_number, Streamed(), 0
        started = mode == 0
        if started:
            self._start()  # sub-mode 0 drops the points sent before the start
        positions = [_absolute_only(point).position for point in points]
        while True:
            room = self._room(base + result.sent)
            for _ in range(room if mode == -1 else min(room, 1)):
                self._write(0x60C1, 1, positions[min(result.sent, len(positions) - 1)])
                result.sent += 1
            if not started:
                self._start()
                started = True
            self._check()
            if result.sent < len(points):
                result.lowest = min(result.lowest, SIZE - self.status.free)
            elif self._taken(base, result.sent) > len(points):
                # The drive is between the last point and its repetition, so it is at rest.
                self._write(0x6040, 0, ENABLED)
                return result
            silent = self._wait(silent)

    # --------------------------------------------------------------------------------------------- steps

    def _start(self) -> None:
        self._write(0x6040, 0, START)

    def _lost(self, next_number: int, *, everything: bool) -> int:
        """Return how many of the last points a drive lacks after a lost frame.

        Clears the sequence error of the drive. The drive notices a missing segment only when the next one arrives. If
        `everything` has been sent there is no next one, so the status is read. That request arrives after the points.
        """
        if everything:
            self.refresh()
        elif not self.status.errors & packet.SEQUENCE:
            return 0
        missing = next_number - self.status.next_number & 0xFFFF
        if self.status.errors & packet.SEQUENCE:
            self._send_sdo(packet.encode_command(packet.PacketCommand(packet.CLEAR_ERRORS, packet.SEQUENCE)))
            self.refresh()
        return missing

    def _room(self, next_number: int) -> int:
        """Return the free positions less the points in transit at the last status."""
        return max(0, self.status.free - (next_number - self.status.next_number & 0xFFFF))

    def _taken(self, base: int, sent: int) -> int:
        """Return how many of `sent` points had left the buffer at the last status.

        The points are numbered from `base`.
        """
        return sent - (base + sent - self.status.next_number & 0xFFFF) - (SIZE - self.status.free)

    def _check(self) -> None:
        """Raise `StreamError` if the drive's last status has an error that ends a move."""
        if self.status.errors & (packet.UNDERFLOW | packet.OVERFLOW):
            raise StreamError(f"the drive reports: {packet.error_names(self.status.errors)}")

    def _at_rest(self) -> bool:
        """True if the move is over.

        The drive is queried only after it has reported an empty buffer.
        """
        if self.news == 0:
            self.refresh()
        return self.status.empty and not self._moving()

    def _moving(self) -> bool:
        self._check()
        return bool(self._read(0x6041) & MOVING_BIT)

    def _wait(self, silent: int) -> int:
        """Let time pass; return the number of consecutive waits without a message."""
        before = self.news
        self.bus.wait()
        self._check()
        silent = silent + 1 if self.news == before else 0
        if silent > self.bus.patience:
            raise StreamError("the drive does not take points any more")
        return silent

    # -------------------------------------------------------------------------------------------- the bus

    def _map_pdos(self) -> None:
        """Map object 0x2010 to RPDO 1, and 0x2012 to the event-driven TPDO 1."""
        receive, transmit = self.node.rpdo[1], self.node.tpdo[1]
        for pdo, index, can_id in (
            (receive, 0x2010, 0x200 + self.node_id),
            (transmit, 0x2012, 0x180 + self.node_id),
        ):
            pdo.clear()
            pdo.add_variable(index, 0, 64 if index == 0x2010 else 32)
            pdo.cob_id, pdo.trans_type, pdo.enabled = can_id, 255, True
            pdo.save()
        transmit.callbacks.clear()
        transmit.add_callback(self._received)

    def _received(self, pdo: canopen.pdo.PdoMap) -> None:
        self.status = packet.decode_status(int.from_bytes(pdo.data, "little"))
        self.news += 1

    def _send_pdo(self, message: bytes) -> None:
        self.bus.network.send_message(0x200 + self.node_id, message)

    def _send_sdo(self, message: bytes) -> None:
        self.node.sdo.download(0x2010, 0, message)

    def _write_record(self, point: WirePoint, mode: int) -> None:
        self._write(0x60C1, 1, point.position)
        self._write(0x60C1, 2, point.time)
        if mode == -3:
            if point.velocity is None:
                raise StreamError(
                    "sub-mode -3 is cubic throughout: a linear point needs 0x2010 or sub-mode -2"
                )
            self._write(0x60C1, 3, point.velocity)

    def _write(self, index: int, sub: int, value: int) -> None:
        try:
            self._variable(index, sub).raw = value
        except canopen.SdoAbortedError as rejected:
            raise StreamError(f"the drive rejected object {index:#06x}:{sub}: {rejected}") from None

    def _read(self, index: int, sub: int = 0) -> int:
        return int(self._variable(index, sub).raw)

    def _variable(self, index: int, sub: int) -> Any:  # the library types records and variables alike
        found = self.node.sdo[index]
        return found[sub] if sub else found


def _absolute_only(point: WirePoint) -> WirePoint:
    if point.relative:
        raise StreamError("object 0x60C1 has no relative points: use object 0x2010, or absolute points")
    return point


def _common_time(points: Sequence[WirePoint]) -> int:
    times = {point.time for point in points[:-1]}
    if len(times) != 1:
        raise StreamError("sub-modes 0 and -1 need one time for all segments; sub-mode -2 takes any")
    return times.pop()
