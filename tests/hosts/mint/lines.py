"""A Mint controller in this process, connected to a host by a serial line."""

from __future__ import annotations

from functools import reduce
from operator import xor

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


def write_frame(element: int, text: str, card: int = 0) -> bytes:
    """Return the frame of HCP by which a host writes an element."""
    return b"\x04%02d\x02" % card + _sealed(b"%02d" % element + text.encode())


def read_frame(element: int, card: int = 0) -> bytes:
    """Return the frame by which a host asks for an element."""
    return b"\x04%02d\x02%02d\x05" % (card, element)


def answer_frame(element: int, text: str) -> bytes:
    """Return the frame by which a controller answers."""
    return b"\x02" + _sealed(b"%02d" % element + text.encode())


def _sealed(data: bytes) -> bytes:
    """Add ETX and the exclusive or of all bytes."""
    return data + b"\x03" + bytes([reduce(xor, data + b"\x03")])
