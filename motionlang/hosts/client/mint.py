"""Client for the line of a Mint controller: comms array, typed lines, download.

It works in the same way with a real, a served and a virtual controller:

    from motionlang.client import MintClient

    with MintClient.open("127.0.0.1:5300") as line:     # or "/dev/ttyUSB0", or MintClient.virtual(program)
        line.write(1, 250.0)
        while line.read(2) != 250.0:
            pass

A program may print onto the line at any time. `output` collects the text that belongs to no answer.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Self

from motionlang.hosts.client.connection import TIMEOUT, Connection
from motionlang.hosts.errors import FrameRejected, LineRejected, NoReply
from motionlang.hosts.mint import hcp
from motionlang.kernel import Source, checked_settings

if TYPE_CHECKING:
    from motionlang.hosts.channel import Wire
    from motionlang.hosts.mint.console import MintConsole

# Characters of output that are stored.
MAX_OUTPUT = 100_000
# The most bytes that may come before an answer.
MAX_BEFORE = 1_000_000
CTRL_E = b"\x05"
_PROMPT = re.compile(rb"(?:\A|[\r\n])(?:[PC]|\d+)?>\Z")
_BREAK = re.compile(rb"Break[^\r\n]*[\r\n]+(?:[PC]|\d+)?>\Z")
_REPLY = re.compile(rb"[\x06\x15]")


class MintClient(Connection):
    """A connection to a Mint controller; not thread-safe.

    `card` is the number of the controller in HCP frames. Time-outs are in seconds, for a virtual controller in
    machine seconds. Opening it sends nothing, so that it disturbs no program.
    """

    def __init__(self, wire: Wire, timeout: float = TIMEOUT, card: int = 0) -> None:
        super().__init__(wire, timeout)
        self.card = card
        self._output: deque[str] = deque(maxlen=MAX_OUTPUT)

    @classmethod
    def virtual(
        cls,
        program: MintConsole | Source | str = "",
        settings: Mapping[str, object] | None = None,
        *,
        step: float = 0.01,
        timeout: float = TIMEOUT,
    ) -> Self:
        """Create a virtual controller in this process, with or without a program.

        Nothing takes real time. A frame or a line takes `step` machine seconds, or as long as it waits. Raises
        ProgramError if the program has errors, and ValueError for an invalid setting.
        """
        from motionlang.hosts.client.virtual import MintWire
        from motionlang.hosts.mint.console import MintConsole

        if isinstance(program, MintConsole):
            return cls(MintWire(program, step), timeout)
        console = MintConsole(checked_settings(settings or {}))
        if program:
            console.load(program if isinstance(program, Source) else Source("program", program))
        return cls(MintWire(console, step), timeout)

    # ------------------------------------------------------------------------------------------ comms array

    def write(self, element: int, value: float, timeout: float | None = None) -> None:
        """Write an element of the comms array.

        Raises FrameRejected after NAK, and NoReply if no answer arrives.
        """
        self._wire.send(hcp.write_frame(element, f"{value:.9g}", self.card))
        if self._await(_REPLY.search, f"element {element}", timeout) == bytes([hcp.NAK]):
            raise FrameRejected(element)

    def read(self, element: int, timeout: float | None = None) -> float:
        """Read an element of the comms array; raises the errors of `write`."""
        start = re.compile(rb"\x02%02d[^\x02\x03]*\x03[\x00-\xff]|\x15" % element)
        self._wire.send(hcp.read_frame(element, self.card))
        frame = self._await(start.search, f"element {element}", timeout)
        answer = hcp.text_of_answer(frame)
        value = None if answer is None else hcp.number(answer[1])
        if value is None:
            raise FrameRejected(element)
        return value

    # ------------------------------------------------------------------------------------------------- lines

    def command(self, line: str, timeout: float | None = None) -> list[str]:
        """Type a line at the prompt; return the lines of its output.

        Raises LineRejected if it is answered with an error.
        """
        answer = self._typed(line, timeout)
        wrong = [each for each in answer if each.startswith("Error")]
        if wrong:
            raise LineRejected(line, wrong[0])
        return answer

    def break_off(self, timeout: float | None = None) -> str:
        """Interrupt the running program (Ctrl-E); return the text that the break prints."""
        self._wire.send(CTRL_E)
        text = self._await(_BREAK.search, "Ctrl-E", timeout).decode("latin-1")
        return text.splitlines()[0]

    def download(self, text: str, configuration: bool = False, timeout: float | None = None) -> None:
        """Replace the program, or the configuration; ends a running program."""
        self.break_off(timeout)
        for line in ("CON" if configuration else "PROG", "NEW", "EDIT"):
            self.command(line, timeout)
        for line in Source("", text.rstrip("\n")).text.split("\n"):
            self._typed(line or " ", timeout)
        self._typed("", timeout)

    def start(self) -> None:
        """Run the configuration and the program (RUN); `output` returns what they print."""
        self._wire.send(b"RUN\r")

    def type(self, text: str) -> None:
        """Send characters unchanged: keys, or a line for INPUT."""
        self._wire.send(_encoded(text))

    def output(self, timeout: float = 0.0) -> str:
        """Return the output since the last call; wait at most `timeout` seconds for more."""
        data = self._wire.receive(timeout)
        found = "".join(self._output) + _text(data)
        self._output.clear()
        return found

    # ----------------------------------------------------------------------------------------------- private

    def _typed(self, line: str, timeout: float | None) -> list[str]:
        """Type a line and return its output, without its echo and the prompt."""
        data = _encoded(line)
        if any(code < 32 and code != 9 for code in data):
            raise ValueError(f"{line!r} is not one line")
        early = self._wire.receive(0.0)
        self._output.extend(_text(early))
        self._wire.send(data + b"\r")
        seconds = self.timeout if timeout is None else timeout
        received = self._read_until(lambda found: _PROMPT.search(found) is not None, line, seconds)
        lines = _text(received).split("\n")[:-1]
        return lines[1:] if lines and lines[0] == line else lines

    def _await(
        self, search: Callable[[bytes], re.Match[bytes] | None], query: str, timeout: float | None
    ) -> bytes:
        """Wait for the answer and return it; input outside it is output."""
        seconds = self.timeout if timeout is None else timeout
        received = self._read_until(lambda found: search(found) is not None, query, seconds)
        match = search(received)
        assert match is not None
        self._output.extend(_text(received[: match.start()] + received[match.end() :]))
        return match[0]

    def _read_until(self, enough: Callable[[bytes], bool], query: str, seconds: float) -> bytes:
        end, received = self._wire.now() + seconds, b""
        while not enough(received):
            chunk = self._wire.receive(end - self._wire.now())
            received = (received + chunk)[-MAX_BEFORE:]
            if not chunk and self._wire.now() >= end:
                self._output.extend(_text(received))
                raise NoReply(query, seconds)
        return received


def _encoded(text: str) -> bytes:
    return text.encode("latin-1", "replace")


def _text(data: bytes) -> str:
    return data.decode("latin-1").replace("\r\n", "\n").replace("\r", "\n")
