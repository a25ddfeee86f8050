"""Addresses as they are typed and shown."""

from __future__ import annotations

import pytest

from motionlang.hosts.address import BadAddress, is_loopback, listen, parse, shown


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("host:4410", ("host", 4410)),
        (":0", ("127.0.0.1", 0)),
        ("4410", ("127.0.0.1", 4410)),
        ("[::1]:65535", ("::1", 65535)),
        ("host:65536", None),
        ("host:", None),
        ("host:-1", None),
        ("host", None),
        ("", None),
    ],
)
def test_an_address_of_the_command_line(text: str, wanted: tuple[str, int] | None) -> None:
    if wanted is not None:
        assert parse(text) == wanted
    else:
        with pytest.raises(BadAddress, match="is not HOST:PORT with a port from 0"):
            parse(text)


def test_how_an_address_is_shown() -> None:
    assert (shown("127.0.0.1", 80), shown("::1", 80)) == ("127.0.0.1:80", "[::1]:80")


@pytest.mark.parametrize(
    ("host", "wanted"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("::1%lo", True),
        ("0.0.0.0", False),
        ("x", False),
    ],
)
def test_addresses_of_this_computer_alone(host: str, wanted: bool) -> None:
    assert is_loopback(host) is wanted


def test_a_listening_socket_does_not_wait() -> None:
    with listen("127.0.0.1", 0) as listener:
        assert not listener.getblocking()
        with pytest.raises(BlockingIOError):
            listener.accept()
