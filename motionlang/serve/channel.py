"""The two ends that a host's characters come in by: a TCP connection, and the far side of a serial device."""

from __future__ import annotations

import os
import socket
from typing import Protocol

UNREAD = 65536


class Gone(Exception):
    """The host has broken the connection off."""


class Channel(Protocol):
    """`receive` and `send` never wait: b"" and 0 mean not now. `receive` answers None when no more will come."""

    name: str

    def fileno(self) -> int: ...
    def receive(self, most: int) -> bytes | None: ...
    def send(self, data: bytes) -> int: ...
    def close(self) -> None: ...


class TcpChannel:
    """A host at the other end of a TCP connection."""

    def __init__(self, connection: socket.socket, name: str) -> None:
        self.name = name
        self._socket = connection
        connection.setblocking(False)
        # An answer goes out at once; a host whose machine has died is noticed in the end.
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)

    def fileno(self) -> int:
        return self._socket.fileno()

    def receive(self, most: int) -> bytes | None:
        """What has come, b"" where nothing has, None where the host has hung up. Gone on an error."""
        try:
            return self._socket.recv(most) or None
        except (BlockingIOError, InterruptedError):
            return b""
        except OSError as error:
            raise Gone from error

    def send(self, data: bytes) -> int:
        """Send what can be sent now; how many bytes that was. Gone on an error."""
        try:
            return self._socket.send(data)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError as error:
            raise Gone from error

    def close(self) -> None:
        """Close in good order: unread characters would break the connection off, and lose what was sent last."""
        try:
            self._socket.shutdown(socket.SHUT_WR)
            self._socket.recv(UNREAD)
        except OSError:
            pass
        self._socket.close()


class DeviceChannel:
    """The board's side of a pseudo-terminal, whose other side is a device that hosts open like a serial port.

    The server keeps that other side open too. Like a serial line it has no end: the board does not notice that one
    program has closed the device and another has opened it.
    """

    def __init__(self) -> None:
        import pty
        import tty

        self._board, self._cable = pty.openpty()
        tty.setraw(self._cable)
        os.set_blocking(self._board, False)
        self.name = os.ttyname(self._cable)

    def fileno(self) -> int:
        return self._board

    def receive(self, most: int) -> bytes | None:
        try:
            return os.read(self._board, most)
        except OSError:
            return b""

    def send(self, data: bytes) -> int:
        try:
            return os.write(self._board, data)
        except OSError:
            return 0

    def close(self) -> None:
        os.close(self._board)
        os.close(self._cable)
