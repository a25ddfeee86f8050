"""The buffers of a host are limited; tested without a connection."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import pytest

from motionlang.hosts import channel as channels
from motionlang.hosts.channel import DeviceChannel, TcpChannel
from motionlang.hosts.errors import ConnectionLost
from motionlang.hosts.serve import Limits
from motionlang.hosts.serve.host import Host


@dataclass
class Peer:
    """A channel that accepts `room` bytes, and a port that always offers four."""

    room: int
    taken: int = 0
    received: bytearray = field(default_factory=bytearray)

    def take(self) -> bytes:
        self.taken += 1
        return b"abcd"

    def send(self, data: bytes) -> int:
        accepted = data[: self.room - len(self.received)]
        self.received += accepted
        return len(accepted)


@pytest.mark.parametrize(("outbox", "taken"), [(4, 1), (5, 2), (8, 2), (9, 3)])
def test_a_host_that_reads_nothing_stops_the_output_at_its_bound(outbox: int, taken: int) -> None:
    """Four bytes at a time are taken while fewer than `outbox` bytes wait."""
    peer: Any = Peer(0)
    host = Host(1, peer, peer, Limits(outbox=outbox), None)
    for _ in range(5):
        host.flush()
    assert (peer.taken, host.unsent) == (taken, True)


def test_all_output_is_sent_in_order() -> None:
    peer: Any = Peer(10)
    host = Host(1, peer, peer, Limits(outbox=8), None)
    for _ in range(3):
        host.flush()
    assert (bytes(peer.received), host.unsent) == (b"abcdabcdab", True)


def test_a_connection_that_is_not_ready_transfers_nothing_and_does_not_wait() -> None:
    """An error of the network ends it, and so does an empty read."""
    for error in (BlockingIOError(), InterruptedError()):
        connection = MagicMock(recv=MagicMock(side_effect=error), send=MagicMock(side_effect=error))
        channel = TcpChannel(connection, "a host")
        connection.setblocking.assert_called_once_with(False)
        assert (channel.receive(10), channel.send(b"abc")) == (b"", 0)
    connection.recv.side_effect = connection.send.side_effect = ConnectionResetError()
    with pytest.raises(ConnectionLost):
        channel.receive(10)
    with pytest.raises(ConnectionLost):
        channel.send(b"abc")
    connection.recv = MagicMock(return_value=b"")
    assert channel.receive(10) is None


def test_a_device_that_is_not_read_takes_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    """It accepts bytes until the buffer of the system is full; nothing comes in."""
    pytest.importorskip("pty")
    channel = DeviceChannel()
    try:
        assert not os.get_blocking(channel.fileno())
        assert channel.receive(10) == b""
        assert channel.send(b"abc") == 3
        full = SimpleNamespace(write=MagicMock(side_effect=BlockingIOError()), read=os.read)
        monkeypatch.setattr(channels, "os", full)
        assert channel.send(b"abc") == 0
        assert channel.receive(10) == b""
    finally:
        monkeypatch.undo()
        channel.close()
