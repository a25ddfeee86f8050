"""The ways to a board: TCP, and a serial device or the pseudo-terminal of `motionlang serve --pty`.

A wire has `send(data)`, `receive(timeout)`, which waits for anything at all and answers b"" when nothing came in time,
`now()` for time-outs, `close()`, and `fresh`, which says that nothing older can be on it. Anything that has these,
say around pyserial's `Serial`, can be given to `Client`.
"""

from __future__ import annotations

import os
import select
import socket
import time
from typing import Protocol

from motionlang.client.errors import ConnectionLost

MOST = 65536


class Wire(Protocol):
    """What a client needs: bytes both ways, and the time, s, by which it waits.

    `fresh` says that nothing from before can be on the line. `receive` gives b"" where nothing comes in `timeout`
    seconds; both ways raise `ConnectionLost`.
    """

    fresh: bool

    def send(self, data: bytes) -> None: ...
    def receive(self, timeout: float) -> bytes: ...
    def now(self) -> float: ...
    def close(self) -> None: ...


class TcpWire:
    """A TCP connection. `ConnectionLost` if there is nobody."""

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
        """What comes within `timeout` seconds; b"" where nothing does. ConnectionLost at the end."""
        try:
            self._socket.settimeout(max(timeout, 0.0))
            data = self._socket.recv(MOST)
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
    """A serial device: 8 bits, no parity, 1 stop bit, no handshake."""

    fresh = False

    def __init__(self, path: str, baud: int, timeout: float) -> None:
        try:
            import termios
        except ImportError as error:
            raise ConnectionLost(
                "serial devices need a POSIX system; give Client a wire of your own"
            ) from error
        speed = getattr(termios, f"B{baud}", None)
        if speed is None:
            raise ValueError(f"{baud} is not a baud rate of this system")
        try:
            self._device = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        except OSError as error:
            raise ConnectionLost(f"no board at {path}: {_reason(error)}") from error
        try:
            raw = [0, 0, termios.CS8 | termios.CREAD | termios.CLOCAL, 0, speed, speed]
            termios.tcsetattr(self._device, termios.TCSANOW, [*raw, termios.tcgetattr(self._device)[6]])
            termios.tcflush(self._device, termios.TCIOFLUSH)
        except termios.error as error:
            os.close(self._device)
            raise ConnectionLost(f"{path} is not a serial device") from error
        self._timeout = timeout
        self.now = time.monotonic

    def send(self, data: bytes) -> None:
        """Write all of `data`. ConnectionLost where the device is gone or takes nothing for too long."""
        end = time.monotonic() + self._timeout
        while data:
            select.select([], [self._device], [], max(0.0, end - time.monotonic()))
            try:
                data = data[os.write(self._device, data) :]
            except BlockingIOError:
                if time.monotonic() >= end:
                    raise ConnectionLost("the device takes nothing") from None
            except OSError as error:
                raise ConnectionLost(f"the device is gone: {_reason(error)}") from error

    def receive(self, timeout: float) -> bytes:
        """What comes within `timeout` seconds; b"" where nothing does. ConnectionLost at the end."""
        ready, _, _ = select.select([self._device], [], [], max(timeout, 0.0))
        if not ready:
            return b""
        try:
            data = os.read(self._device, MOST)
        except BlockingIOError:
            return b""
        except OSError as error:
            raise ConnectionLost(f"the device is gone: {_reason(error)}") from error
        if not data:
            raise ConnectionLost("the device is gone")
        return data

    def close(self) -> None:
        os.close(self._device)


def _reason(error: OSError) -> str:
    return (error.strerror or str(error)).lower()
