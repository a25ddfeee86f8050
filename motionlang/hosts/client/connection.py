"""The connection of a client; the same for both languages."""

from __future__ import annotations

import os
from types import TracebackType
from typing import Self

from motionlang.hosts.channel import SerialWire, TcpWire, Wire

# Seconds that a client waits for an answer.
TIMEOUT = 5.0


class Connection:
    """A connection to a controller; a context manager that closes it."""

    def __init__(self, wire: Wire, timeout: float = TIMEOUT) -> None:
        self.timeout = timeout
        self._wire = wire

    @classmethod
    def tcp(cls, host: str, port: int, timeout: float = TIMEOUT) -> Self:
        """Connect to a controller on the network, or to `motionlang serve --tcp`."""
        return cls(TcpWire(host, port, timeout), timeout)

    @classmethod
    def serial(cls, path: str | os.PathLike[str], baud: int = 9600, timeout: float = TIMEOUT) -> Self:
        """Connect to a controller at a serial device, or to `motionlang serve --pty`."""
        return cls(SerialWire(str(path), baud, timeout), timeout)

    @classmethod
    def open(cls, where: str, timeout: float = TIMEOUT) -> Self:
        """Connect to `HOST:PORT`, a serial device, or a URL of pyserial."""
        host, colon, port = where.rpartition(":")
        if colon and port.isdecimal() and "://" not in where:
            return cls.tcp(host.strip("[]") or "127.0.0.1", int(port), timeout)
        return cls.serial(where, timeout=timeout)

    def close(self) -> None:
        """Disconnect; programs, tasks and motion continue."""
        self._wire.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()
