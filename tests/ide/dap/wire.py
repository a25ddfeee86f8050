"""Messages of the protocol as a client writes and reads them."""

from __future__ import annotations

import json
from typing import IO, Any


def written(message: object) -> bytes:
    body = json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def read(stream: IO[bytes]) -> dict[str, Any] | None:
    """Return the next message; None at the end of the stream."""
    if not (header := stream.readline()):
        return None
    assert stream.readline() == b"\r\n"
    found: dict[str, Any] = json.loads(stream.read(int(header.removeprefix(b"Content-Length: "))))
    return found
