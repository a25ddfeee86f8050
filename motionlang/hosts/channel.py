"""Connections that carry characters: a TCP connection, a pseudo-terminal, a serial line.

A server reads and writes its `HostChannel`s without waiting. A client has a `Wire`, whose calls wait. A serial line may
be the pseudo-terminal of `motionlang serve --pty`. Any object with the methods of `Wire`, such as a wrapper of
pyserial's `Serial`, can be passed to `Client`.
"""

from __future__ import annotations

import os
import socket
import time
from typing import Protocol

from motionlang.hosts.errors import ConnectionLost
from motionlang.kernel.tools import MissingExtra, need

# How much is read at once.
UNREAD = 65536


class HostChannel(Protocol):
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

        Raises ConnectionLost on an error.
        """
        try:
            return self._socket.recv(most) or None
        except (BlockingIOError, InterruptedError):
            return b""
        except OSError as error:
            raise ConnectionLost from error

    def send(self, data: bytes) -> int:
        """Send as much as possible now; return the number of bytes.

        Raises ConnectionLost on an error.
        """
        try:
            return self._socket.send(data)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError as error:
            raise ConnectionLost from error

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


class Wire(Protocol):
    """The byte connection that a client needs, with the clock of its time-outs.

    `receive` returns the bytes that arrive within `timeout` seconds, or b"" if there are none. `now()` is the time
    for time-outs, s. `fresh` is True if no earlier data can be on the line. `send` and `receive` raise
    `ConnectionLost`.
    """

    fresh: bool

    def send(self, data: bytes) -> None: ...
    def receive(self, timeout: float) -> bytes: ...
    def now(self) -> float: ...
    def close(self) -> None: ...


class TcpWire:
    """A TCP connection; raises `ConnectionLost` if it cannot be opened."""

    fresh = True

    def __init__(self, host: str, port: int, timeout: float) -> None:
        try:
            self._socket = socket.create_connection((host, port), timeout)
        except OSError as error:
            raise ConnectionLost(f"no board at {host}:{port}: {_reason(error)}") from error
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._timeout = timeout
        self.now = time.monotonic

    def send(self, data: bytes) -> None:
        try:
            self._socket.settimeout(self._timeout)
            self._socket.sendall(data)
        except OSError as error:
            raise ConnectionLost(f"the connection is gone: {_reason(error)}") from error

    def receive(self, timeout: float) -> bytes:
        """Return the data that arrives within `timeout` seconds, or b"".

        Raises ConnectionLost at the end of the connection.
        """
        try:
            self._socket.settimeout(max(timeout, 0.0))
            data = self._socket.recv(UNREAD)
        except (TimeoutError, BlockingIOError):
            return b""
        except OSError as error:
            raise ConnectionLost(f"the connection is gone: {_reason(error)}") from error
        if not data:
            raise ConnectionLost("the board has closed the connection")
        return data

    def close(self) -> None:
        self._socket.close()


class SerialWire:
    """A serial line through pyserial: 8 bits, no parity, 1 stop bit, no handshake.

    `path` is a device, a COM port, or a URL of pyserial such as `socket://host:port`. Raises `ConnectionLost`
    if the device or pyserial (the extra `serial`) is missing, and ValueError for an unsupported baud rate.
    """

    fresh = False

    def __init__(self, path: str, baud: int, timeout: float) -> None:
        try:
            need("a serial line", "serial")
        except MissingExtra as error:
            raise ConnectionLost(str(error)) from error
        import serial

        self._lost = serial.SerialException
        try:
            self._line = serial.serial_for_url(path, baud, timeout=timeout, write_timeout=timeout)
        except serial.SerialException as error:
            if error.errno is None and "configure" in str(error):
                raise ConnectionLost(f"{path} is not a serial device") from error
            raise ConnectionLost(f"no board at {path}: {_reason(error)}") from error
        except ValueError as error:
            raise ValueError(f"{path} at {baud} baud: {str(error).lower()}") from error
        self.now = time.monotonic

    def send(self, data: bytes) -> None:
        """Write all of `data`.

        Raises ConnectionLost if the device is gone or accepts nothing for too long.
        """
        try:
            self._line.write(data)
        except (self._lost, OSError) as error:
            raise ConnectionLost(f"the device is gone: {_reason(error)}") from error

    def receive(self, timeout: float) -> bytes:
        """Return the data that arrives within `timeout` seconds, or b"".

        Raises ConnectionLost at the end of the connection.
        """
        try:
            self._line.timeout = max(timeout, 0.0)
            first: bytes = self._line.read(1)
            return first + self._line.read(min(self._line.in_waiting, UNREAD)) if first else b""
        except (self._lost, OSError) as error:
            raise ConnectionLost(f"the device is gone: {_reason(error)}") from error

    def close(self) -> None:
        self._line.close()


def _reason(error: OSError) -> str:
    # pyserial puts its own sentence where the system's text for the number would be.
    return (os.strerror(error.errno) if error.errno else str(error)).lower()
