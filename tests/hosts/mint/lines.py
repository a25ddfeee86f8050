"""A Mint controller in this process, connected to a host by a serial line."""

from __future__ import annotations

from motionlang.hosts.mint.console import MintConsole
from motionlang.kernel import Diagnostic, Source


class Line:
    """A host's line to the controller."""

    def __init__(self, program: str = "", echo: bool = False, model: str = "NextMove ESB-2") -> None:
        self.complaints: list[Diagnostic] = []
        self.console = MintConsole({"controller.model": model}, complain=self._complain)
        if program:
            self.console.load(Source("served.mnt", program))
        self.port = self.console.open(echo)

    def _complain(self, found: list[Diagnostic], source: Source) -> None:
        assert found
        assert source.name
        self.complaints += found

    def send(self, data: bytes) -> None:
        """Send characters; the controller executes typed lines."""
        self.port.feed(data)
        self.console.settle(self.console.now + 10.0)

    def run(self, seconds: float) -> None:
        """Advance the machine time, s."""
        self.console.run(self.console.now + seconds)

    def received(self) -> str:
        """Return the output since the last call, with LF as line end."""
        return self.port.take().decode("latin-1").replace("\r\n", "\n")

    def ask(self, data: bytes) -> str:
        """Send characters and return the output that follows."""
        self.received()
        self.send(data)
        return self.received()
