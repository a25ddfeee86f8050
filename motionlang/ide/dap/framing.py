"""Messages of the protocol on a stream: a header with the length, and JSON.

Content-Length: 42

{"seq": 1, "type": "request", "command": …}
"""

from __future__ import annotations

import json
from typing import IO

Message = dict[str, object]

# Longer headers and messages are no messages of a client.
MAX_HEADER, MAX_BODY = 8192, 64 * 1024 * 1024
_LENGTH = b"content-length"


class WrongMessage(Exception):
    """A message that cannot be read; if it `is_fatal`, the stream cannot continue."""

    def __init__(self, text: str, is_fatal: bool = False) -> None:
        super().__init__(text)
        self.is_fatal = is_fatal


def read(stream: IO[bytes]) -> Message | None:
    """Return the next message, None at the end of the stream; raise WrongMessage."""
    length = _length(stream)
    if length is None:
        return None
    body = b""
    while len(body) < length:
        more = stream.read(length - len(body))
        if not more:
            return None
        body += more
    try:
        message = json.loads(body.decode("utf-8"))
    except (ValueError, RecursionError):
        raise WrongMessage("the message is not JSON in UTF-8") from None
    if not isinstance(message, dict):
        raise WrongMessage("the message is not an object")
    return message


def _length(stream: IO[bytes]) -> int | None:
    """Read a header and return the length of the message that follows."""
    length = None
    read = 0
    while True:
        line = stream.readline(MAX_HEADER)
        if not line:
            return None
        read += len(line)
        if read > MAX_HEADER or not line.endswith(b"\n"):
            raise WrongMessage("the header is too long", True)
        if not line.strip():
            if length is not None:
                return length
            if read > len(line):
                raise WrongMessage("the header has no Content-Length", True)
            read = 0
            continue
        name, _, value = line.partition(b":")
        if name.strip().lower() == _LENGTH:
            if not value.strip().isdigit() or int(value) > MAX_BODY:
                raise WrongMessage(f"the message may have up to {MAX_BODY} bytes", True)
            length = int(value)


def written(message: Message) -> bytes:
    """Return a message as bytes, with its header."""
    body = json.dumps(message, ensure_ascii=False, allow_nan=False).encode("utf-8", "replace")
    return b"Content-Length: %d\r\n\r\n" % len(body) + body
