"""A served board in this process, and hosts that talk to it over real sockets."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Iterator

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.hosts.serve.pace import ServerPace
from motionlang.kernel import Machine

# Seconds after which a waiting test has failed; a successful one never waits that long.
PATIENCE = 20.0


class Wire:
    """The connection of a host, which reads exactly the expected bytes."""

    def __init__(self, address: tuple[str, int]) -> None:
        self.socket = socket.create_connection(address, PATIENCE)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._rest = b""

    def send(self, data: bytes) -> None:
        self.socket.sendall(data)

    def expect(self, wanted: bytes) -> None:
        """Read the number of bytes in `wanted`, and compare."""
        while len(self._rest) < len(wanted) and self._rest == wanted[: len(self._rest)]:
            piece = self.socket.recv(len(wanted) - len(self._rest))
            if not piece:
                break
            self._rest += piece
        found, self._rest = self._rest, b""
        assert found == wanted

    def until(self, mark: bytes) -> bytes:
        """Return everything up to and including `mark`."""
        while mark not in self._rest:
            piece = self.socket.recv(65536)
            assert piece, self._rest
            self._rest += piece
        found, _, self._rest = self._rest.partition(mark)
        return found + mark

    def ask(self, line: bytes) -> bytes:
        """Send a line; return its answer including the prompt."""
        self.send(line + b"\r")
        return self.until(b"\n>")

    def all(self) -> bytes:
        """Return everything until the server closes the connection."""
        found, self._rest = self._rest, b""
        while piece := self.socket.recv(65536):
            found += piece
        return found

    def break_off(self) -> None:
        """Reset the connection, as when a process is killed with unread data."""
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
        self.socket.close()


class Board:
    """A served board that runs in a separate thread."""

    def __init__(self, server: Server, console: Console) -> None:
        self.server, self.console = server, console
        self.address = server.listen("127.0.0.1", 0)
        self.complaints: list[str] = []
        self.wires: list[Wire] = []
        self._thread = threading.Thread(target=server.run, daemon=True)
        self._thread.start()

    def connect(self) -> Wire:
        """Connect another host and return it after its first prompt."""
        wire = Wire(self.address)
        self.wires.append(wire)
        wire.expect(b">")
        return wire

    def end(self) -> None:
        self.server.stop()
        self._thread.join(PATIENCE)
        assert not self._thread.is_alive()
        self.server.close()
        for wire in self.wires:
            wire.socket.close()


Serve = Callable[..., Board]


@pytest.fixture
def serve() -> Iterator[Serve]:
    """Yield a function that serves a board.

    `serve(model="multiflex", clock="lockstep", limits=None)`
    """
    boards: list[Board] = []

    def begin(
        model: str = "multiflex", clock: str = "lockstep", limits: Limits | None = None, factor: float = 1.0
    ) -> Board:
        console = Console(Machine({"controller.model": model}, first_axis=1))
        pace: ServerPace = LockStep(console) if clock == "lockstep" else RealTime(console, factor)
        complaints: list[str] = []
        board = Board(Server(console, pace, limits=limits, complain=complaints.append), console)
        board.complaints = complaints
        boards.append(board)
        return board

    yield begin
    for board in boards:
        board.end()
