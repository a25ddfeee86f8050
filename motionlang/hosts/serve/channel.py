"""Channels that carry a host's characters: a TCP connection or a serial device."""

from __future__ import annotations

import os
import socket
from typing import Protocol

UNREAD = 65536


class Gone(Exception):
    """The host has closed the connection."""


class Channel(Protocol):
    """Both directions of a host's connection; no call waits.

    `receive` and `send` return b"" and 0 if nothing can be transferred now. `receive` returns None after the end of
    the data.
    """

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
        # Send an answer at once, and eventually detect a host whose machine has died.
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)

    def fileno(self) -> int:
        return self._socket.fileno()

    def receive(self, most: int) -> bytes | None:
        """Return the received data, b"" if there is none, None if the host has closed.

        Raises Gone on an error.
        """
        try:
            return self._socket.recv(most) or None
        except (BlockingIOError, InterruptedError):
            return b""
        except OSError as error:
            raise Gone from error

    def send(self, data: bytes) -> int:
        """Send as much as possible now; return the number of bytes.

        Raises Gone on an error.
        """
        try:
            return self._socket.send(data)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError as error:
            raise Gone from error

    def close(self) -> None:
        """Close the connection cleanly.

        Characters left unread would reset the connection and lose the last data sent.
        """
        try:
            self._socket.shutdown(socket.SHUT_WR)
            self._socket.recv(UNREAD)
        except OSError:
            pass
        self._socket.close()


class DeviceChannel:
    """The board's end of a pseudo-terminal; hosts open the other end as a serial port.

    The server keeps the other end open, too, so the connection never ends, just like a serial line. The board does not
    notice when one program closes the device and another opens it.
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
