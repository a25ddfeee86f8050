"""Many hosts at one board: all are served, and the first one too many is rejected."""

from __future__ import annotations

import selectors
import socket

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, Server
from motionlang.kernel import Machine
from tests.hosts.serve.conftest import Serve, Wire


@pytest.mark.parametrize("clock", ["lockstep", "real"])
@pytest.mark.slow
def test_fifty_hosts_at_once_none_starved(serve: Serve, clock: str) -> None:
    """Each host sends again as soon as it is answered, and all get similar shares."""
    board = serve(clock=clock)
    wires = [board.connect() for _ in range(50)]
    counts = dict.fromkeys(wires, 0)
    with selectors.DefaultSelector() as selector:
        for wire in wires:
            wire.socket.setblocking(False)
            selector.register(wire.socket, selectors.EVENT_READ, wire)
            wire.send(b"1TP\r")
        while max(counts.values()) < 200:
            for key, _ in selector.select(20.0):
                wire = key.data
                wire._rest += wire.socket.recv(4096)
                if wire._rest == b"01 0\n>":
                    wire._rest = b""
                    counts[wire] += 1
                    wire.send(b"1TP\r")
    assert min(counts.values()) > 100


def test_a_host_that_sends_much_ahead_does_not_hold_up_one_that_asks(serve: Serve) -> None:
    board = serve(clock="real")
    greedy, modest = board.connect(), board.connect()
    greedy.send(b"1TP\r" * 5_000)
    assert modest.ask(b"2TP") == b"02 0\n>"
    behind = board.server.hosts[0]
    assert behind.waits or behind.port.busy
    greedy.expect(b"01 0\n>" * 5_000)


def test_one_host_too_many(serve: Serve) -> None:
    """It gets the code of an I/O error."""
    board = serve(limits=Limits(hosts=2))
    first, second = board.connect(), board.connect()
    third = Wire(board.address)
    assert third.all() == b"?3\n"
    third.socket.close()
    assert len(board.complaints) == 1
    assert "turned away: 2 hosts are connected already" in board.complaints[0]
    first.socket.shutdown(socket.SHUT_WR)
    assert first.all() == b""
    assert board.connect().ask(b"1TP") == second.ask(b"1TP") == b"01 0\n>"


def test_hosts_come_and_go(serve: Serve) -> None:
    """Two hundred hosts leave nothing behind."""
    board = serve()
    for _ in range(200):
        wire = board.connect()
        assert wire.ask(b"1TP") == b"01 0\n>"
        wire.socket.shutdown(socket.SHUT_WR)
        assert wire.all() == b""
        wire.socket.close()
    last = board.connect()
    assert last.ask(b"1TP") == b"01 0\n>"
    assert len(board.server.hosts) == len(board.console.ports) == len(board.console.board.tasks) == 1


def test_silent_hosts_do_not_shut_out_others(serve: Serve) -> None:
    """The host that has been silent longest is dropped, unless its command still runs."""
    board = serve(limits=Limits(hosts=3, idle=0.0), clock="real")
    busy, silent, later = board.connect(), board.connect(), board.connect()
    assert later.ask(b"1TP") == b"01 0\n>"
    busy.send(b"WA60\r")
    while not board.server.hosts[0].port.busy:
        pass
    fourth = board.connect()
    assert fourth.ask(b"1TP") == b"01 0\n>"
    assert silent.all() == b""
    assert later.ask(b"2TP") == b"02 0\n>"
    assert board.server.hosts[0].port.busy
    assert board.complaints == []


class Listed:
    """A channel with one line to send, which records when it is answered."""

    def __init__(self, order: list[str], name: str) -> None:
        self.name = name
        self._order = order
        self._ends = socket.socketpair()
        self._ends[1].send(b"1TP\r")

    def fileno(self) -> int:
        return self._ends[0].fileno()

    def receive(self, most: int) -> bytes | None:
        return self._ends[0].recv(most)

    def send(self, data: bytes) -> int:
        self._order.append(self.name)
        self._ends[1].send(b"1TP\r")
        return len(data)

    def close(self) -> None:
        for end in self._ends:
            end.close()


def test_another_host_is_answered_first_each_time() -> None:
    """The host that is answered first can also send its next line first."""
    order: list[str] = []
    console = Console(Machine(first_axis=1))
    with Server(console) as server:
        for name in "abc":
            channel = Listed(order, name)
            server._join(channel, server._maker(False))
        order.clear()
        for _ in range(6):
            server.turn()
    firsts = [order[k] for k in range(0, len(order) - 2, 3)]
    assert sorted(firsts[:3]) == sorted(firsts[3:6]) == ["a", "b", "c"]
