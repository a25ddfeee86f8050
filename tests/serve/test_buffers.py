"""The buffers of a host are limited; tested without a connection."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pytest

from motionlang.serve import Limits
from motionlang.serve.host import Host


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
