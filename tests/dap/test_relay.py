"""The front, the engine and the server of a session, without processes."""

from __future__ import annotations

import base64
import io
import os
import pickle
import signal
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from queue import SimpleQueue
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.dap import engine as engines
from motionlang.dap import server as servers
from motionlang.dap.engine import Engine
from motionlang.dap.framing import MAX_HEADER, read, written
from motionlang.dap.relay import END, PATIENCE, Relay
from motionlang.debug.checkpoints import receive
from tests.dap import client

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the front has an engine on Linux alone")


class Front:
    """A front whose engine is the test, with the engine's two channels."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        ends: list[socket.socket] = []
        make = socket.socketpair

        def pair(*kind: Any) -> tuple[socket.socket, socket.socket]:
            near, far = make(*kind)
            ends.append(far.dup())
            return near, far

        before = set(threading.enumerate())
        with monkeypatch.context() as patched:
            patched.setattr(socket, "socketpair", pair)
            patched.setattr(os, "fork", lambda: 1)
            self.messages: SimpleQueue[dict[str, Any]] = SimpleQueue()
            self.relay = Relay(self.messages.put, lambda: None)
        self.engine, self.announcements = ends
        self.threads = set(threading.enumerate()) - before
        self.waits: list[float | None] = []
        monkeypatch.setattr(self.relay._is_answered, "wait", self.waits.append)

    def request(self, seq: int, command: str) -> dict[str, Any]:
        """Send a request of the client and return it."""
        message = {"type": "request", "seq": seq, "command": command}
        self.relay.handle(message)
        return message

    def answer(self, seq: int, command: str, channel: socket.socket | None = None) -> dict[str, Any]:
        """Send a response of the engine, and return it as the client gets it."""
        message = {"type": "response", "request_seq": seq, "command": command, "success": True, "seq": 70}
        (channel or self.engine).sendall(written(message))
        return self.messages.get(timeout=client.PATIENCE)

    def end(self) -> None:
        """Close all channels, and wait for the end of the threads."""
        self.relay.close()
        self.engine.close()
        self.announcements.close()
        for thread in self.threads:
            thread.join(client.PATIENCE)
            assert not thread.is_alive()
        self.relay._control.close()


@pytest.fixture
def front(monkeypatch: pytest.MonkeyPatch) -> Iterator[Front]:
    made = Front(monkeypatch)
    yield made
    made.end()


def refusal(seq: int, command: str, number: int) -> dict[str, Any]:
    return {
        "type": "response", "request_seq": seq, "command": command, "success": False, "message": END,
        "body": {"error": {"id": 1, "format": END, "showUser": True}}, "seq": number,
    }  # fmt: skip


def test_messages_go_both_ways_and_are_numbered_for_the_client(front: Front) -> None:
    sent = [front.request(4, "threads"), front.request(5, "next")]
    with front.engine.makefile("rb") as stream:
        assert [read(stream) for _ in range(2)] == sent
    assert [front.answer(number, "x")["seq"] for number in (4, 5)] == [1, 2]
    assert (front.relay.is_over, front.waits) == (False, [])
    assert len(front.threads) == 2
    assert all(thread.daemon for thread in front.threads)


def test_the_end_of_the_engine_answers_all_open_requests(front: Front) -> None:
    """Request 5 has its answer; message 6 is no request."""
    for number, command in ((4, "threads"), (5, "next"), (8, "pause")):
        front.request(number, command)
    front.relay.handle({"type": "response", "seq": 6, "command": "runInTerminal"})
    assert front.answer(5, "next")["request_seq"] == 5
    front.engine.shutdown(socket.SHUT_RDWR)
    found = [front.messages.get(timeout=client.PATIENCE) for _ in range(4)]
    assert found == [
        {"type": "event", "event": "output", "body": {"category": "stderr", "output": f"{END}\n"}, "seq": 2},
        refusal(4, "threads", 3),
        refusal(8, "pause", 4),
        {"type": "event", "event": "terminated", "seq": 5},
    ]
    assert front.relay.is_over
    front.request(9, "next")
    front.relay.handle({"type": "response", "seq": 10, "command": "runInTerminal"})
    assert front.messages.get(timeout=client.PATIENCE) == refusal(9, "next", 6)
    assert front.messages.empty()


def test_a_request_during_the_end_of_the_engine_is_refused(
    front: Front, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(front.relay._is_answered, "set", lambda: front.request(9, "next"))
    front.engine.shutdown(socket.SHUT_RDWR)
    assert front.messages.get(timeout=client.PATIENCE) == refusal(9, "next", 1)
    assert front.messages.get(timeout=client.PATIENCE)["event"] == "output"


def test_bytes_that_are_no_message_are_the_end_of_the_engine(front: Front) -> None:
    front.engine.sendall(b"x" * MAX_HEADER)
    found = [front.messages.get(timeout=client.PATIENCE)["event"] for _ in range(2)]
    assert found == ["output", "terminated"]


def test_a_client_that_disconnects_waits_for_the_answer(front: Front) -> None:
    """After it, the end of the engine is no news."""
    front.request(4, "disconnect")
    assert (front.waits, PATIENCE) == ([10.0], 10.0)
    assert front.answer(4, "disconnect")["seq"] == 1
    front.engine.shutdown(socket.SHUT_RDWR)
    for thread in front.threads:
        if thread.name.endswith("(_pass_on)"):
            thread.join(client.PATIENCE)
    assert front.messages.empty()
    assert front.relay.is_over


def test_the_session_continues_in_a_copy(front: Front) -> None:
    """The copy gets the state of the session and the request without an answer."""
    near, far = socket.socketpair()
    other, dropped = socket.socketpair()
    with near, other:
        front.relay.handle({"type": "response", "seq": 3, "command": "runInTerminal"})
        front.request(4, "stepBack")
        for text, channel in (("copy 7", far), ("copy 8", dropped)):
            socket.send_fds(front.announcements, [text.encode()], [channel.fileno()])
            channel.close()
        front.announcements.send(b"drop 3 8")
        assert other.recv(1) == b""
        state = base64.b64encode(b"the state").decode()
        front.engine.sendall(written({"type": "handover", "key": 7, "state": state}))
        assert receive(near) == b"the state"
        with near.makefile("rb") as stream:
            assert read(stream) == {"type": "request", "seq": 4, "command": "stepBack"}
        assert front.answer(4, "stepBack", near) == {
            "type": "response", "request_seq": 4, "command": "stepBack", "success": True, "seq": 1,
        }  # fmt: skip
        near.sendall(written({"type": "event", "event": "stopped"}))
        assert front.messages.get(timeout=client.PATIENCE)["event"] == "stopped"
        front.relay.close()
        assert near.recv(1) == b""


def test_the_front_waits_until_the_copy_is_announced(front: Front, monkeypatch: pytest.MonkeyPatch) -> None:
    near, far = socket.socketpair()
    wait_for = front.relay._announced.wait_for
    known: list[bool] = []

    def announce(predicate: Callable[[], bool], timeout: float) -> bool:
        known.append(predicate())
        socket.send_fds(front.announcements, [b"copy 7"], [far.fileno()])
        far.close()
        return wait_for(predicate, timeout)

    monkeypatch.setattr(front.relay._announced, "wait_for", announce)
    with near:
        front.engine.sendall(written({"type": "handover", "key": 7, "state": ""}))
        assert receive(near) == b""
    assert known == [False]


def test_the_end_of_the_front_ends_the_engine_and_all_copies(front: Front) -> None:
    near, far = socket.socketpair()
    with near:
        socket.send_fds(front.announcements, [b"copy 7"], [far.fileno()])
        far.close()
        with front.relay._announced:
            assert front.relay._announced.wait_for(lambda: 7 in front.relay._copies, client.PATIENCE)
        front.relay.close()
        assert (near.recv(1), front.engine.recv(1)) == (b"", b"")


def test_the_forked_process_is_the_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    """It closes the streams of the client first."""
    closed: list[bool] = []
    channels: list[socket.socket] = []

    def main(*given: socket.socket) -> None:
        channels.extend(given)
        raise SystemExit

    monkeypatch.setattr(os, "fork", lambda: 0)
    monkeypatch.setattr(engines, "main", main)
    with pytest.raises(SystemExit):
        Relay(lambda message: None, lambda: closed.append(True))
    assert (closed, len(channels)) == ([True], 2)
    for each in channels:
        assert each.recv(1) == b""  # the ends of the front are closed
        each.close()


# -------------------------------------------------------------------------------------------------- the engine


@pytest.fixture
def ends(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[socket.socket]]:
    """Yield the channels of an engine, each with the end that the front has.

    The end of the process is an exception.
    """

    def leave(status: int) -> None:
        raise SystemExit(status)

    monkeypatch.setattr(os, "_exit", leave)
    made = [*socket.socketpair(), *socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)]
    yield made
    for each in made:
        each.close()


def test_an_engine_answers_until_its_channel_is_closed(ends: list[socket.socket]) -> None:
    channel, front, announcements, _ = ends
    requests = [("initialize", {"adapterID": "x"}), ("threads", {})]
    for number, (command, arguments) in enumerate(requests, 1):
        front.sendall(written({"type": "request", "seq": number, "command": command, "arguments": arguments}))
    front.shutdown(socket.SHUT_WR)
    with pytest.raises(SystemExit) as caught:
        Engine(channel, announcements).serve()
    assert caught.value.code == 0
    with front.makefile("rb") as stream:
        found = [read(stream) for _ in range(2)]
    assert [(each["request_seq"], each["success"]) for each in found if each] == [(1, True), (2, False)]


def test_an_engine_ends_if_its_front_has_gone(ends: list[socket.socket]) -> None:
    channel, front, announcements, _ = ends
    front.close()
    with pytest.raises(SystemExit) as caught:
        Engine(channel, announcements)._send({"type": "event"})
    assert caught.value.code == 0


def test_an_engine_is_silent_after_it_has_handed_over(
    ends: list[socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the copy it sends again, on the channel of the copy, which a thread serves."""
    channel, front, announcements, control = ends
    engine = Engine(channel, announcements)
    engine._send({"type": "event", "event": "one"})
    engine._send(engine._hand_over(3, {"a": 1}))
    engine._send({"type": "event", "event": "two"})
    channel.shutdown(socket.SHUT_WR)
    with front.makefile("rb") as stream:
        assert read(stream) == {"type": "event", "event": "one"}
        message = read(stream)
        assert read(stream) is None
    assert message is not None
    assert (message["type"], message["key"]) == ("handover", 3)
    state = base64.b64decode(str(message["state"]))
    assert pickle.loads(state) == {"a": 1}
    revived: list[object] = []
    begun: list[dict[str, Any]] = []
    monkeypatch.setattr(engine._adapter, "revive", revived.append)

    def thread(**how: Any) -> SimpleNamespace:
        begun.append(how)
        return SimpleNamespace(start=lambda: None)

    monkeypatch.setattr(threading, "Thread", thread)
    near, far = socket.socketpair()
    with near, far:
        engine._revive(far, state)
        engine._send({"type": "event", "event": "three"})
        with near.makefile("rb") as stream:
            assert read(stream) == {"type": "event", "event": "three"}
    assert (revived, begun) == ([{"a": 1}], [{"target": engine.serve, "name": "reader", "daemon": True}])
    engine._drop([4, 12])
    assert control.recv(100) == b"drop 4 12"
    engine._store(5, near := socket.socket())
    packet, (copy,), _, _ = socket.recv_fds(control, 100, 2)
    assert packet == b"copy 5"
    os.close(copy)
    near.close()


def test_an_engine_closes_the_streams_and_ignores_ctrl_c(
    ends: list[socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    closed: list[int] = []
    handlers: dict[int, object] = {}
    monkeypatch.setattr(engines, "close_here", closed.append)
    monkeypatch.setattr(signal, "signal", handlers.__setitem__)
    ends[1].close()
    with pytest.raises(SystemExit):
        engines.main(ends[0], ends[2])
    assert closed == [0, 1]
    assert handlers == {signal.SIGINT: signal.SIG_IGN, signal.SIGCHLD: signal.SIG_IGN}


# -------------------------------------------------------------------------------------------------- the server


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

    def make(send: Any, close: object) -> Adapter:
        made.append(Adapter(send))
        return made[0]

    monkeypatch.setattr(servers, "_made", make)
    stream = outgoing()
    servers.serve(io.BytesIO(data), stream, lambda: None)
    made[0].send({"of": "the end"})
    assert made[0].seen == [*seen, "closed"]
    assert stream.getvalue().count(b"Content-Length") == answers + (outgoing is io.BytesIO)


@pytest.mark.parametrize("forks", [False, True])
def test_the_first_client_of_a_port_is_served(forks: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its connection and the port wait, which they do not do for several clients."""
    near, far = socket.socketpair()
    near.setblocking(False)
    waits: list[bool] = []

    def made(send: Callable[[dict[str, Any]], None], close: object = None) -> Adapter:
        waits.append(near.getblocking())
        return Adapter(send)

    monkeypatch.setattr(servers, "can_fork", lambda: forks)
    monkeypatch.setattr("motionlang.dap.relay.Relay" if forks else "motionlang.dap.adapter.Adapter", made)
    listener: Any = SimpleNamespace(
        setblocking=waits.append, accept=lambda: (near, None), close=lambda: waits.append(near.getblocking())
    )
    with far:
        far.sendall(message("disconnect"))
        servers.serve_connection(listener)
        with far.makefile("rb") as stream:
            assert read(stream) == {"of": "disconnect"}
    assert waits == [True, False, True]
