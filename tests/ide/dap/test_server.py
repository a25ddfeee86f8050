"""The server of a session, with an adapter that records its messages."""

from __future__ import annotations

import io
import socket
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.ide.dap import server as servers
from motionlang.ide.dap.framing import read, written


class Adapter:
    """An adapter that records its messages; `disconnect` ends it."""

    def __init__(self, send: Any) -> None:
        self.send, self.is_over = send, False
        self.seen: list[str] = []

    def handle(self, message: dict[str, Any]) -> None:
        self.seen.append(message["command"])
        self.is_over = message["command"] == "disconnect"
        self.send({"of": message["command"]})

    def output(self, text: str, category: str) -> None:
        self.seen.append(f"{category}: {text}")

    def close(self) -> None:
        self.seen.append("closed")


class Gone(io.BytesIO):
    """The stream to a client that has gone."""

    def flush(self) -> None:
        raise BrokenPipeError


def message(command: str) -> bytes:
    return written({"command": command})


@pytest.mark.parametrize(
    ("data", "outgoing", "seen", "answers"),
    [
        (message("a") + message("b"), io.BytesIO, ["a", "b"], 2),
        (message("a") + message("disconnect") + message("b"), io.BytesIO, ["a", "disconnect"], 2),
        (
            b"Content-Length: 2\r\n\r\n[]" + message("a"),
            io.BytesIO,
            ["stderr: the message is not an object\n", "a"],
            1,
        ),
        (b"x: 1\r\n\r\n" + message("a"), io.BytesIO, ["stderr: the header has no Content-Length\n"], 0),
        (message("a") + message("b"), Gone, ["a"], 1),
    ],
)
def test_a_client_is_served_until_its_session_ends(
    data: bytes, outgoing: type[io.BytesIO], seen: list[str], answers: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Adapter] = []

    def make(send: Any) -> Adapter:
        made.append(Adapter(send))
        return made[0]

    monkeypatch.setattr(servers, "Adapter", make)
    stream = outgoing()
    servers.serve(io.BytesIO(data), stream)
    made[0].send({"of": "the end"})
    assert made[0].seen == [*seen, "closed"]
    assert stream.getvalue().count(b"Content-Length") == answers + (outgoing is io.BytesIO)


def test_the_first_client_of_a_port_is_served(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its connection and the port wait, which they do not do for several clients."""
    near, far = socket.socketpair()
    near.setblocking(False)
    waits: list[bool] = []

    def made(send: Callable[[dict[str, Any]], None]) -> Adapter:
        waits.append(near.getblocking())
        return Adapter(send)

    monkeypatch.setattr(servers, "Adapter", made)
    listener: Any = SimpleNamespace(
        setblocking=waits.append, accept=lambda: (near, None), close=lambda: waits.append(near.getblocking())
    )
    with far:
        far.sendall(message("disconnect"))
        servers.serve_connection(listener)
        with far.makefile("rb") as stream:
            assert read(stream) == {"of": "disconnect"}
    assert waits == [True, False, True]
