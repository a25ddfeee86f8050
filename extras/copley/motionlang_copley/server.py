"""Simulated drives on a CAN bus in real time, for any CANopen master.

One thread receives frames, advances the drives to the present time, and sends what is due. So each frame is processed
at its time of arrival, and no locks are needed. The thread sleeps until the next frame, the end of a motion or a
timer. After a frame, and while a drive moves, it wakes every `CYCLE` and sends the PDOs that have changed.

Some interfaces return a node's own frames to it. The server filters them out, by bit 7 of the identifier.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import Self

import can
import canopen
from can.typechecking import CanFilter

from motionlang.hosts.serve.wall import WallClock
from motionlang_copley.bus import BusError, open_bus
from motionlang_copley.drive import Drive
from motionlang_copley.node import DriveNode
from motionlang_copley.switches import Switches

# Seconds of real time between two updates of a drive, and between two checks of an idle one for the end of the server.
CYCLE, PATIENCE = 0.001, 0.1
# Frames of masters: bit 7 is clear, but for SYNC.
FROM_MASTERS: list[CanFilter] = [
    {"can_id": 0x000, "can_mask": 0x080, "extended": False},
    {"can_id": 0x080, "can_mask": 0x7FF, "extended": False},
]
# The number of profiles that a drive stores, and how often older ones are dropped.
MEMORY, SELDOM = 100, 1000


class DriveServer:
    """Drives with the node numbers 1, 2 and so on at `interface` and `channel`.

    `factor` is machine seconds per second of real time. `switches` has one entry per drive. `complain` is
    called once for each problem of the bus or of a drive. Raises BusError if the bus cannot be opened.
    """

    def __init__(
        self,
        interface: str,
        channel: str,
        drives: int = 1,
        *,
        factor: float = 1.0,
        switches: Sequence[Switches] = (),
        complain: Callable[[str], None] = lambda text: None,
        wall: Callable[[], float] = time.monotonic,
    ) -> None:
        self._bus = open_bus(interface, channel)
        self._bus.set_filters(FROM_MASTERS)
        self.network = canopen.Network(self._bus)
        self.frames = 0
        self._complain = complain
        self._known: set[str] = set()
        self._over = False
        # When the drives were last updated, and true if a frame has come since.
        self._updated, self._news = wall(), False
        self._passes = 0
        self.nodes: list[DriveNode] = []
        for number in range(1, drives + 1):
            at = switches[number - 1] if number <= len(switches) else None
            node = DriveNode(number, Drive(), at)
            node.objects.complain = partial(self._report_drive, number)
            self.network.add_node(node)
            self.nodes.append(node)
        self._clock = WallClock(wall, factor)
        for node in self.nodes:
            self._guard(node.boot)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def now(self) -> float:
        """The current machine time, seconds: `factor` × the real time since the start."""
        return self._clock.due

    def run(self) -> None:
        """Serve until `stop`."""
        while not self._over:
            self.run_once(self._timeout())

    def stop(self) -> None:
        """End `run` soon; may be called from a signal handler or another thread."""
        self._over = True

    def run_once(self, timeout: float = 0.0) -> None:
        """Wait at most `timeout` seconds for a frame, and do what is due."""
        try:
            message = self._bus.recv(timeout)
        except (can.CanError, OSError) as problem:
            self._report(f"the CAN bus: {problem}")
            return
        wall = self._clock.wall()
        if message is None or wall >= self._updated + CYCLE:
            self._updated, self._news = wall, False
        now = round(self.now * 1e6)
        for node in self.nodes:
            self._guard(partial(_advance, node, now, self._updated == wall))
        if message is not None and message.arbitration_id == 0 and len(message.data) < 2:
            self._report(f"a frame was dropped: network management needs 2 bytes, not {len(message.data)}")
        elif message is not None and _is_for_drives(message):
            self.frames += 1
            self._guard(lambda: self.network.notify(message.arbitration_id, message.data, message.timestamp))
            self._news = True
        self._passes += 1
        if self._passes % SELDOM == 0:
            for node in self.nodes:
                node.drive.forget(MEMORY)

    def close(self) -> None:
        """Disconnect from the bus."""
        self._bus.shutdown()

    def _timeout(self) -> float:
        if self._news or any(node.objects.is_moving for node in self.nodes):
            return CYCLE
        left = self._clock.left(min(node.next_time() for node in self.nodes))
        return max(0.0, min(left, PATIENCE))

    def _guard(self, work: Callable[[], None]) -> None:
        """Call `work`; a bus problem or a bad frame does not end the server."""
        try:
            work()
        except (can.CanError, OSError) as problem:
            self._report(f"the CAN bus: {problem}")
        except Exception as error:  # the library raises several kinds for frames that are too short
            self._report(f"a frame was dropped: {type(error).__name__}: {error}")

    def _report_drive(self, number: int, text: str) -> None:
        self._report(f"drive {number}: {text}")

    def _report(self, text: str) -> None:
        if text not in self._known and len(self._known) < 100:
            self._known.add(text)
            self._complain(text)


def _is_for_drives(message: can.Message) -> bool:
    """True for a data frame with an 11-bit identifier, the only kind in CANopen."""
    return not (message.is_error_frame or message.is_remote_frame or message.is_extended_id)


def _advance(node: DriveNode, microseconds: int, update: bool) -> None:
    """Advance a drive to a time, microseconds, and send what is due."""
    drive = node.drive
    drive.run_until(microseconds)
    if update:
        node.update()


__all__ = ["BusError", "DriveServer"]
