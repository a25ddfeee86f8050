"""Drives on a virtual CAN bus, the other end of it, and a master of one drive."""

from __future__ import annotations

from collections.abc import Sequence
from io import StringIO
from itertools import count
from typing import Any

import can
import canopen

from motionlang_copley.eds import eds
from motionlang_copley.server import DriveServer
from motionlang_copley.switches import Switches

CHANNELS = count(1)
POSITION, STATUS = 0x6064, 0x6041


class Bus:
    """Two drives and the other end of their bus; `time` is the drives' time, s."""

    def __init__(self, factor: float = 1.0, switches: Sequence[Switches] = ()) -> None:
        self.time = 0.0
        channel = f"served-{next(CHANNELS)}"
        self.master = can.Bus(interface="virtual", channel=channel)
        self.complaints: list[str] = []
        self.server = DriveServer(
            "virtual",
            channel,
            2,
            factor=factor,
            switches=switches,
            complain=self.complaints.append,
            wall=lambda: 1000.0 + self.time,
        )

    def close(self) -> None:
        self.server.close()
        self.master.shutdown()

    def send(self, can_id: int, *data: int) -> None:
        self.master.send(can.Message(arbitration_id=can_id, data=data, is_extended_id=False))
        self.server.run_once()

    def until(self, seconds: float) -> list[tuple[int, bytes]]:
        """Advance the time in steps of a millisecond; return the frames of the drives."""
        while self.time < seconds - 1e-9:
            self.time = min(self.time + 1e-3, seconds)
            self.server.run_once()
        return self.frames()

    def frames(self) -> list[tuple[int, bytes]]:
        found = []
        while (message := self.master.recv(0.0)) is not None:
            found.append((message.arbitration_id, bytes(message.data)))
        return found

    def ask(self, node: int, *request: int) -> bytes:
        """Return a drive's answer to an SDO request."""
        self.frames()
        self.send(0x600 + node, *request, *bytes(8 - len(request)))
        (answer,) = [data for can_id, data in self.frames() if can_id == 0x580 + node]
        return answer


class SdoAbort(Exception):
    """A drive has refused an SDO; its argument is the code."""


class Master(Bus):
    """The first drive in some mode, with its operation enabled; a master reads and writes its objects by SDOs."""

    objects: Any = None

    def __init__(self, mode: int = 0, switches: Switches | None = None) -> None:
        super().__init__(switches=[switches] if switches is not None else [])
        if Master.objects is None:
            Master.objects = dictionary(1)
        self.node = self.server.nodes[0]
        self.drive = self.node.drive
        self._emergencies: list[int] = []
        if mode:
            self.write(0x6060, mode)
            for control in (0x06, 0x07, 0x0F):
                self.write(0x6040, control)

    def write(self, index: int, value: int, sub: int = 0) -> None:
        """Write an object; raises SdoAbort."""
        data = self._of(index, sub).encode_raw(value)
        self._ask(0x23 | 4 - len(data) << 2, index, sub, data)

    def read(self, index: int, sub: int = 0) -> int:
        """Return an object; raises SdoAbort."""
        answer = self._ask(0x40, index, sub)
        value: int = self._of(index, sub).decode_raw(answer[4 : 8 - (answer[0] >> 2 & 3)])
        return value

    def at(self, seconds: float) -> int:
        """Let time pass to `seconds`, and return the position."""
        self.time = seconds
        self.server.run_once()
        return self.read(POSITION)

    def has(self, *bits: int) -> list[bool]:
        """Return bits of the status word."""
        return [bool(self.read(STATUS) & bit) for bit in bits]

    def move(self, target: int, control: int = 0x1F) -> None:
        """Write a set-point and complete its handshake."""
        self.write(0x607A, target)
        self.write(0x6040, control)
        self.write(0x6040, 0x0F)

    @property
    def errors(self) -> list[int]:
        """The codes of the emergency messages so far."""
        self._sort(self.frames())
        return self._emergencies

    def _of(self, index: int, sub: int) -> Any:
        found = Master.objects[index]
        return found[sub] if sub else found

    def _ask(self, command: int, index: int, sub: int, data: bytes = b"") -> bytes:
        self._sort(self.frames())
        self.send(0x601, command, index & 255, index >> 8, sub, *data, *bytes(4 - len(data)))
        (answer,) = self._sort(self.frames())
        if answer[0] == 0x80:
            raise SdoAbort(int.from_bytes(answer[4:], "little"))
        return answer

    def _sort(self, frames: list[tuple[int, bytes]]) -> list[bytes]:
        """Keep the emergencies of the drive, and return its answers to SDOs."""
        self._emergencies += [int.from_bytes(data[:2], "little") for name, data in frames if name == 0x081]
        return [data for name, data in frames if name == 0x581]


def dictionary(node: int) -> Any:
    """Return the objects of a drive as canopen, which is not ours, reads them from its EDS file."""
    file = StringIO(eds())
    file.name = "drive.eds"
    return canopen.import_od(file, node_id=node)
