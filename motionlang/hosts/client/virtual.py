"""Connections to controllers in this process, without real time.

Machine time passes while a client waits for an answer.
"""

from __future__ import annotations

from typing import Any

from motionlang.hosts.console import HostConsole
from motionlang.hosts.serve.pace import LockStep

# Machine seconds between two checks for output of a program.
SLICE = 1e-3


class _ConsoleWire:
    """A port of `console`, with time-outs in machine seconds and `step` seconds for what is sent."""

    fresh = True

    def __init__(self, console: HostConsole[Any], step: float) -> None:
        self.console, self._port = console, console.open(echo=False)
        self._pace = LockStep(console, step)

    def now(self) -> float:
        return self.console.now

    def close(self) -> None:
        self.console.close(self._port)


class VirtualWire(_ConsoleWire):
    """A port of a board; a line takes `step` seconds, or as long as it waits."""

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


class MintWire(_ConsoleWire):
    """A line of a Mint controller; each `send` takes `step` seconds, and a typed line as long as it waits."""

    def __init__(self, console: HostConsole[Any], step: float) -> None:
        super().__init__(console, step)
        self._pace.entered()

    def send(self, data: bytes) -> None:
        """Send characters, after the time that the previous ones take."""
        self._pace.entered()
        self._port.feed(data)

    def receive(self, timeout: float) -> bytes:
        """Return the output within `timeout` machine seconds, or b""."""
        received = self._port.take()
        console, end, busy_until = self.console, self.console.now + max(timeout, 0.0), self._pace.busy_until
        if not received and timeout > 0.0 and console.settle(end) and console.now < busy_until:
            console.run(min(busy_until, end))
        received = received or self._port.take()
        while not received and console.now < end:
            console.run(min(end, max(console.next_time(), console.now) + SLICE))
            received = self._port.take()
        return received
