"""Connections to controllers in this process, without real time.

Machine time passes while a client waits for an answer.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.hosts.serve.pace import LockStep

if TYPE_CHECKING:
    from motionlang.mccl.hosts.console import Console
    from motionlang.mint.hosts.console import MintConsole

# Machine seconds between two checks for output of a program.
SLICE = 1e-3


class VirtualWire:
    """A port of `console`, with time-outs in machine seconds.

    A line takes `step` seconds, or as long as it waits.
    """

    fresh = True

    def __init__(self, console: Console, step: float) -> None:
        self.console = console
        self._port = console.open(echo=False)
        self._pace = LockStep(console, step)

    def send(self, data: bytes) -> None:
        if not self._port.busy:
            self._pace.entered()
        self._port.feed(data)

    def receive(self, timeout: float) -> bytes:
        """Return the board's output within `timeout` machine seconds, or b"".

        Returns at once if there is already output.
        """
        received = self._port.take()
        if received or timeout <= 0.0:
            return received
        end = self.console.now + timeout
        if (not self.console.settle(end) or self._port.busy) and self.console.now < end:
            # The board waits for an impossible event or for a key: it has no output for the whole time.
            self.console.run(end)
        return self._port.take()

    def now(self) -> float:
        return self.console.now

    def close(self) -> None:
        self.console.close(self._port)


class MintWire:
    """A line of a Mint `console`, with time-outs in machine seconds.

    Each `send` takes `step` seconds. A typed line takes as long as it waits.
    """

    fresh = True

    def __init__(self, console: MintConsole, step: float) -> None:
        self.console, self._step = console, step
        self._port = console.open(echo=False)
        self._busy_until = console.now + step

    def send(self, data: bytes) -> None:
        """Send characters, after the time that the previous ones take."""
        if self._busy_until > self.console.now:
            self.console.run(self._busy_until)
        self._port.feed(data)
        self._busy_until = self.console.now + self._step

    def receive(self, timeout: float) -> bytes:
        """Return the output within `timeout` machine seconds, or b""."""
        received = self._port.take()
        console, end = self.console, self.console.now + max(timeout, 0.0)
        if not received and timeout > 0.0 and console.settle(end) and console.now < self._busy_until:
            console.run(min(self._busy_until, end))
        received = received or self._port.take()
        while not received and console.now < end:
            console.run(min(end, max(console.next_time(), console.now) + SLICE))
            received = self._port.take()
        return received

    def now(self) -> float:
        return self.console.now

    def close(self) -> None:
        self.console.close(self._port)
