"""Messages of the server about a host that waits for something impossible."""

from __future__ import annotations

import pytest

from tests.hosts.serve.conftest import Serve


@pytest.mark.parametrize("clock", ["lockstep", "realtime"])
def test_a_wait_that_nothing_ends_is_reported_at_once(serve: Serve, clock: str) -> None:
    board = serve(clock=clock)
    host, other = board.connect(), board.connect()
    host.ask(b"1MN,1SA1000000,1VM,1GO")
    host.send(b"1WS\r")
    other.ask(b"2MN")
    host.send(b"\x1b")
    host.until(b"?-7")
    assert board.complaints == [
        "host 1 waits for axis 1 to be idle, and nothing in progress ends that; ESC gives it up"
    ]


def test_a_wait_that_ends_is_not_reported(serve: Serve) -> None:
    board = serve()
    host = board.connect()
    host.ask(b"1MN,1MR1000,1WS,WA0.1")
    assert board.complaints == []
