"""Serial lines and TCP connections, without a device or a network."""

from __future__ import annotations

import errno
import socket
from collections.abc import Callable

import pytest

from motionlang.client import Client, ConnectionLost
from motionlang.hosts.channel import SerialWire, TcpWire, Wire

serial = pytest.importorskip("serial")


class Line:
    """A line with some bytes on it; a read of more of them waits for its time-out."""

    def __init__(self, data: bytes) -> None:
        self.data, self.timeout, self.waited = data, 0.0, 0.0

    @property
    def in_waiting(self) -> int:
        return len(self.data)

    def read(self, size: int) -> bytes:
        found, self.data = self.data[:size], self.data[size:]
        self.waited += self.timeout if len(found) < size else 0.0
        return found


@pytest.mark.parametrize(
    ("data", "timeout", "waited"),
    [(b">", 5.0, 0.0), (b"1TP\r\n", 5.0, 0.0), (b"", 5.0, 5.0), (b"", -1.0, 0.0), (b"x" * 65537, 5.0, 0.0)],
)
def test_a_read_waits_only_for_the_first_byte(
    data: bytes, timeout: float, waited: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A time-out below 0 has passed, so it is as one of 0."""
    line = Line(data)
    monkeypatch.setattr(serial, "serial_for_url", lambda *_, **__: line)
    assert SerialWire("COM1", 9600, 1.0).receive(timeout) == data
    assert line.waited == waited


class Host:
    """A board with a line of old output; `log` lists the reads and writes of a client."""

    in_waiting = 1_000

    def __init__(self) -> None:
        self.data, self.timeout, self.log = b"02 0\n", 0.0, list[str]()

    def recv(self, size: int) -> bytes:
        found, self.data = self.data[:size], self.data[size:]
        self.log.append("read" if found else "silence")
        if not found:
            raise TimeoutError
        return found

    def read(self, size: int) -> bytes:
        try:
            return self.recv(size)
        except TimeoutError:
            return b""

    def sendall(self, data: bytes) -> None:
        self.log.append("send")
        self.data += b"\nMultiFlex\n>"

    write = sendall

    def settimeout(self, timeout: float) -> None:
        self.timeout = timeout

    def setsockopt(self, *option: object) -> None:
        pass


@pytest.mark.parametrize(
    ("opened", "log"),
    [
        (lambda: TcpWire("board", 5000, 1.0), ["send", "read"]),
        (lambda: SerialWire("COM1", 9600, 1.0), ["read", "read", "silence", "send", "read", "read"]),
    ],
    ids=["tcp", "serial"],
)
def test_only_a_serial_line_may_have_old_output(
    opened: Callable[[], Wire], log: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A client reads a serial line until it is silent before it asks for the version."""
    host = Host()
    monkeypatch.setattr(serial, "serial_for_url", lambda *_, **__: host)
    monkeypatch.setattr(socket, "create_connection", lambda *_: host)
    assert Client(opened()).version == "MultiFlex"
    assert host.log == log


@pytest.mark.parametrize(
    ("where", "opened"),
    [
        ("10.0.0.7:5000", ("10.0.0.7", 5000)),
        (":5000", ("127.0.0.1", 5000)),
        ("[::1]:5000", ("::1", 5000)),
        ("board:5000", ("board", 5000)),
        ("board:", "board:"),
        ("5000", "5000"),
        ("COM7", "COM7"),
        ("/dev/ttyUSB0", "/dev/ttyUSB0"),
        ("socket://board:5000", "socket://board:5000"),
    ],
)
def test_an_address_is_a_host_and_a_port_or_a_device(
    where: str, opened: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    found: list[object] = []
    monkeypatch.setattr(Client, "tcp", lambda host, port, timeout: found.append((host, port)))
    monkeypatch.setattr(Client, "serial", lambda path, timeout: found.append(path))
    Client.open(where)
    assert found == [opened]


@pytest.mark.parametrize(
    ("number", "text", "message"),
    [
        (None, "Could not configure port", "COM1 is not a serial device"),
        (errno.EACCES, "Could not configure port", "no board at COM1: permission denied"),
        (None, "Could not open port", "no board at COM1: could not open port"),
    ],
)
def test_a_serial_line_that_cannot_be_opened(
    number: int | None, text: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The reason is the system's, or else that of pyserial."""
    error = serial.SerialException(text)
    error.errno = number

    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(serial, "serial_for_url", fail)
    with pytest.raises(ConnectionLost, match=f"^{message}$"):
        SerialWire("COM1", 9600, 1.0)
