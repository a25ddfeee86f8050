"""Network addresses to listen on, as written on the command line."""

from __future__ import annotations

import ipaddress
import socket

LOOPBACK = "127.0.0.1"


class BadAddress(ValueError):
    """The text is not an address."""


def parse(text: str) -> tuple[str, int]:
    """Return host and port of `HOST:PORT`; the default host is the loopback interface.

    Raises `BadAddress` if the text is invalid.
    """
    host, colon, port = text.rpartition(":")
    host = host.removeprefix("[").removesuffix("]")
    if not port.isdecimal() or int(port) > 65535:
        raise BadAddress(f"{text!r} is not HOST:PORT with a port from 0 (any that is free) to 65535")
    return host or LOOPBACK, int(port)


def shown(host: str, port: int) -> str:
    """Return an address in the form in which a user writes it."""
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


def is_loopback(host: str) -> bool:
    """True if an address is reachable only from this computer.

    `host` is the address as resolved by the system.
    """
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return False


def listen(host: str, port: int) -> socket.socket:
    """Return a listening socket; raise OSError if that fails."""
    family, kind, protocol, _, address = socket.getaddrinfo(
        host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
    )[0]
    listener = socket.socket(family, kind, protocol)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen(128)
        listener.setblocking(False)
    except OSError:
        listener.close()
        raise
    return listener
