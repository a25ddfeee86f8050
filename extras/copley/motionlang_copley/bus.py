"""A CAN bus between a master and the simulated drive.

It runs in virtual time and in one thread. Real frames go over python-can's virtual bus, or over another
interface that loops back, such as SocketCAN's vcan. Every send delivers all frames in flight before the call
returns. A run is therefore deterministic, and nothing waits for real time.
"""

from __future__ import annotations

import itertools
import threading
from typing import Self

import can
import canopen

from motionlang_copley.drive import Drive
from motionlang_copley.node import DriveNode

VIRTUAL = "virtual"
# Seconds that a master waits for a message of a real drive before it polls again.
NEWS_TIMEOUT = 0.05
_CHANNELS = itertools.count(1)


class BusError(Exception):
    """The CAN bus cannot be opened."""


def open_bus(interface: str, channel: str) -> can.BusABC:
    """Open one end of a bus.

    Raises `BusError` if python-can or the machine has no such interface or channel.
    """
    try:
        return can.Bus(interface=interface, channel=channel)
    except (can.CanError, OSError, ValueError) as problem:
        where = f"{interface} {channel}".strip()
        raise BusError(f"the CAN bus {where!r} cannot be opened: {problem}") from None


class LockstepNetwork(canopen.Network):
    """A network whose bus delivers its frames, without a receiving thread."""

    def __init__(self, owner: LockstepBus, bus: can.BusABC) -> None:
        super().__init__(bus)
        self.owner, self.end = owner, bus

    def send_message(self, can_id: int, data: bytes, remote: bool = False) -> None:
        """Send a frame; deliver it and all frames sent in response."""
        super().send_message(can_id, data, remote)
        self.owner.deliver()


class RealBus:
    """A bus with a real drive on the other end, or the drive of another program.

    A thread of python-can receives its frames.
    """

    patience = 100

    def __init__(self, node_id: int, interface: str, channel: str) -> None:
        self.network = canopen.Network(open_bus(interface, channel))
        self.network.NOTIFIER_CYCLE = NEWS_TIMEOUT
        self._news = threading.Event()
        self.network.subscribe(0x180 + node_id, lambda *_: self._news.set())
        self.network.connect()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def wait(self) -> None:
        """Wait until the drive sends its buffer status, at most `NEWS_TIMEOUT`."""
        self._news.wait(NEWS_TIMEOUT)
        self._news.clear()

    def close(self) -> None:
        """Disconnect from the bus."""
        self.network.disconnect()


class LockstepBus:
    """A bus with a simulated drive on one end.

    `network` is the master's end, and `wait` lets virtual time pass. `step` is the time, in microseconds,
    between two polls of the bus by the master. `frames` counts the delivered frames.
    """

    patience = 5000

    def __init__(
        self, drive: Drive, node_id: int = 1, step: int = 1000, interface: str = VIRTUAL, channel: str = ""
    ) -> None:
        name = channel or f"motionlang-{next(_CHANNELS)}"
        self.drive, self.step, self.frames = drive, step, 0
        self._delivering = False
        # A virtual bus has no delay; a kernel may need a moment to loop a frame back.
        self._patience = 0.0 if interface == VIRTUAL else 0.01
        near, far = (open_bus(interface, name) for _ in range(2))
        self.network, self._far = LockstepNetwork(self, near), LockstepNetwork(self, far)
        self.node = DriveNode(node_id, drive)
        self._far.add_node(self.node)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def wait(self) -> None:
        """Let one step of virtual time pass."""
        self.drive.run_until(self.drive.microseconds + self.step)

    def deliver(self) -> None:
        """Deliver frames until none is in flight, including those sent in the meantime."""
        if self._delivering:
            return
        self._delivering = True
        try:
            while self._deliver_to(self._far) or self._deliver_to(self.network):
                pass
        finally:
            self._delivering = False

    def close(self) -> None:
        """Disconnect from the bus."""
        self.drive.listener = None
        for network in (self.network, self._far):
            network.end.shutdown()

    def _deliver_to(self, network: LockstepNetwork) -> int:
        count = 0
        while (message := network.end.recv(timeout=self._patience)) is not None:
            network.notify(message.arbitration_id, message.data, message.timestamp)
            count += 1
        self.frames += count
        return count
