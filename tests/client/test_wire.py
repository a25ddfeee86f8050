"""A serial line gives its first byte at once, and with it all that has arrived."""

from __future__ import annotations

import pytest

from motionlang.client.wire import SerialWire

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
