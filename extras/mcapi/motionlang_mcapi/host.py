"""A connection of a host that speaks MCAPI to a served board."""

from __future__ import annotations

from collections.abc import Callable

import motionlang_mcapi.calls  # noqa: F401
from motionlang.hosts.channel import HostChannel
from motionlang.hosts.commands.options import warn
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Server
from motionlang.hosts.serve.host import Host
from motionlang.hosts.serve.limits import Limits
from motionlang.hosts.serve.pace import ServerPace
from motionlang.hosts.serve.server import MakeHost
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import Wait
from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.protocol import MAX_LINE, VERSION, answer, decode, parse
from motionlang_mcapi.session import BadCall, HostProcess, McapiBoard

LF = 10
# The line that names the host process of a connection.
SESSION = "Session"


class McapiPort:
    """The port of one connection: calls in, answers out, one at a time.

    `refused` is True after a line that is not a call.
    """

    waiting: Wait | None = None

    def __init__(self, desk: McapiBoard) -> None:
        self._desk = desk
        self._session: HostProcess | None = None
        self._call: ApiCall | None = None
        self._out = bytearray()
        self.refused = False

    @property
    def busy(self) -> bool:
        """True while a call has no answer."""
        return self._call is not None

    working = busy

    def feed(self, data: bytes) -> int:
        """Accept a whole line, or discard data after a refused one."""
        if not self.refused:
            self._enter(data.rstrip(b"\r\n").decode("latin-1"))
        return len(data)

    def refuse(self, why: str) -> None:
        """Answer a line that is not a call; the connection is then closed."""
        self._out += f"! {why}\n".encode("latin-1", "replace")
        self.refused = True

    def accepts(self, data: bytes | bytearray, by_line: bool = False) -> bool:
        """True if a whole line has arrived and the previous one is answered."""
        return LF in data and not self.busy

    def next_piece(self, data: bytearray, by_line: bool) -> tuple[bytes, bool]:
        """Return the first line of `data` and True, or its beginning and False; all of it if not by line."""
        if not by_line:
            return bytes(data), False
        end = data.find(LF) + 1
        return bytes(data[: end or None]), bool(end)

    def abandon(self) -> None:
        """Refuse a line whose processing has failed with an internal error."""
        self.refuse("internal error")

    def take(self) -> bytes:
        """Return the answers since the last call."""
        output = bytes(self._out)
        self._out.clear()
        return output

    def close(self) -> None:
        """Disconnect; the last connection of a process removes its host."""
        self._call = None
        if self._session is not None:
            self._session.leave()

    def _enter(self, line: str) -> None:
        if not line or line.isspace():
            return
        try:
            if line.startswith(SESSION + " "):
                self._begin(line)
                return
            if self._session is None:
                self._session = self._desk.session()
            call = self._session.call(*parse(line), self._done)
        except (BadCall, ValueError, TypeError) as problem:
            self.refuse(str(problem))
            return
        if not call.done:
            self._call = call

    def _begin(self, line: str) -> None:
        """Join the session of a host process."""
        version, token = (*decode(line.removeprefix(SESSION)), None, None)[:2]
        if version != VERSION or not isinstance(token, str) or self._session is not None:
            self.refuse(f'write {SESSION} {VERSION} "TOKEN" before the first call')
            return
        self._session = self._desk.session(token)
        self._out += b"0\n"

    def _done(self, call: ApiCall) -> None:
        self._call = None
        self._out += answer(call).encode("latin-1", "replace") + b"\n"


class McapiHost(Host):
    """A host whose lines are calls.

    A line is read when the previous one has been answered.
    """

    port: McapiPort

    def __init__(
        self, number: int, channel: HostChannel, desk: McapiBoard, limits: Limits, spy: Spy | None
    ) -> None:
        super().__init__(number, channel, McapiPort(desk), limits, spy)
        desk.console.join(self.port)

    @property
    def done(self) -> bool:
        """True if the host is gone or was refused, and all answers have been sent."""
        return (self.ended is not None or self.port.refused) and self.is_silent

    def feed(self, pace: ServerPace) -> None:
        """Begin the calls that have arrived; in lock step only one."""
        while self._inbox and not self.port.busy:
            end = self._inbox.find(LF) + 1
            if self.port.refused or (not end and len(self._inbox) > MAX_LINE) or end > MAX_LINE:
                if not self.port.refused:
                    self.port.refuse(f"a line has at most {MAX_LINE} characters")
                self._inbox.clear()
            elif end:
                pace.entered()
                self.port.feed(bytes(self._inbox[:end]))
                del self._inbox[:end]
                if pace.by_line:
                    return
            else:
                if self.ended is not None:
                    self._inbox.clear()
                return


def mcapi_hosts(
    server: Server, console: Console, record: Callable[[ApiCall], None] | None = None
) -> MakeHost:
    """Return a function that makes a host speaking MCAPI for each connection.

    `record` is called with every call.
    """
    board = McapiBoard(console, warn, record)
    return lambda number, channel: McapiHost(number, channel, board, server.limits, server.spy)
