"""The way to a board in this process: nothing is waited for, machine time passes while an answer is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.serve.pace import LockStep

if TYPE_CHECKING:
    from motionlang.mccl.hosts.console import Console


class VirtualWire:
    """A port of `console`; time-outs are machine seconds, and a line takes `step` seconds or as long as it waits."""

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
        """What the board has said, or says within `timeout` machine seconds; b"" where it says nothing."""
        said = self._port.take()
        if said or timeout <= 0.0:
            return said
        end = self.console.now + timeout
        if (not self.console.settle(end) or self._port.busy) and self.console.now < end:
            # It waits for what cannot happen, or for a key: nothing comes in all that time.
            self.console.run(end)
        return self._port.take()

    def now(self) -> float:
        return self.console.now

    def close(self) -> None:
        self.console.close(self._port)
