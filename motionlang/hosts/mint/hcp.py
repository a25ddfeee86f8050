"""HCP, the host comms protocol: frames that read and write the comms array.

    write   EOT c c STX n n text ETX x     answer: ACK or NAK
    read    EOT c c STX n n ENQ            answer: STX n n text ETX x, or NAK

`cc` is the number of the card and `nn` the element, with two digits each. `x` is the exclusive or of all bytes from the
first digit of the element to ETX. The layout is taken from public host programs; numbers are formatted as by PRINT.

A line carries frames between the characters that a person types. `Receiver` separates them, byte by byte. ENQ is
also Ctrl-E: it belongs to a frame only at the end of a read request.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import reduce
from operator import xor
from struct import pack, unpack

from motionlang.kernel.controller import HostMemory

STX, ETX, EOT, ENQ, ACK, NAK = 2, 3, 4, 5, 6, 21
FIRST, LAST = 1, 99
# The number of the card of this controller.
CARD = b"00"
# The longest text of a number; a longer one is answered with NAK.
MAX_TEXT = 40
_CONTROL = 32
_NUMBER = re.compile(r" *[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)? *")
_MAX_FLOAT = 3.4028234663852886e38


def write_frame(element: int, text: str, card: int = 0) -> bytes:
    return _begin(card) + _sealed(_digits(element) + text.encode("ascii"))


def read_frame(element: int, card: int = 0) -> bytes:
    """Return the frame that requests an element."""
    return _begin(card) + bytes([STX]) + _digits(element) + bytes([ENQ])


def answer_frame(element: int, text: str) -> bytes:
    """Return the answer to a read request."""
    return _sealed(_digits(element) + text.encode("ascii"))


def text_of_answer(frame: bytes) -> tuple[int, str] | None:
    """Return element and text of an answer, None if its checksum or layout is wrong."""
    if len(frame) < 5 or frame[0] != STX or frame[-2] != ETX or checksum(frame[1:-1]) != frame[-1]:
        return None
    element, text = frame[1:3], frame[3:-2]
    return (int(element), text.decode("latin-1")) if element.isdigit() else None


def checksum(data: bytes | bytearray) -> int:
    """Return the exclusive or of all bytes."""
    return reduce(xor, data, 0)


def number(text: str) -> float | None:
    """Return the number in a text, which may have blanks around it, or None."""
    if _NUMBER.fullmatch(text) is None:
        return None
    value = float(text)
    return value if abs(value) <= _MAX_FLOAT else None


class Elements:
    """The elements of the comms array for HCP; `shown` formats a number."""

    def __init__(self, memory: Callable[[], HostMemory], shown: Callable[[float], str]) -> None:
        self._memory, self._shown = memory, shown

    def write(self, element: int, text: str) -> bool:
        """Write an element and raise its event; return False if the text is not a number."""
        value = number(text)
        if value is None or not FIRST <= element <= LAST:
            return False
        (word,) = unpack("<i", pack("<f", value))
        self._memory().write("comms", element, [word])
        return True

    def read(self, element: int) -> str | None:
        """Return the text of an element, or None if it does not exist."""
        if not FIRST <= element <= LAST:
            return None
        return self._shown(self._memory().real("comms", element))


class Receiver:
    """Takes the bytes of one line, and answers the frames among them."""

    def __init__(self, elements: Elements) -> None:
        self._elements = elements
        # The bytes since EOT, or None between frames.
        self._frame: bytearray | None = None

    def take(self, code: int) -> bytes | None:
        """Take a byte; return the answer, or None if the byte belongs to no frame.

        The answer is empty until the frame ends.
        """
        frame = self._frame
        if frame is not None and len(frame) > 3 and frame[-1] == ETX:
            return self._written(frame, code)
        if code == EOT:
            self._frame = bytearray()
            return b""
        if frame is None:
            return None
        length = len(frame)
        fits = chr(code).isdigit() and code < 128 if length < 2 else code == STX if length == 2 else True
        if not fits:
            self._frame = None
            return None
        if length == 5 and code == ENQ:
            return self._read(frame)
        if length >= 3 and code < _CONTROL and code != ETX:
            self._frame = None  # Ctrl-E breaks, also where a frame was cut off
            return None if code == ENQ else self._ended(frame, bytes([NAK]))
        if code == ETX or length <= MAX_TEXT + 5:
            frame.append(code)
        return b""

    def _read(self, frame: bytearray) -> bytes:
        element = bytes(frame[3:5])
        text = self._elements.read(int(element)) if element.isdigit() else None
        return self._ended(frame, bytes([NAK]) if text is None else answer_frame(int(element), text))

    def _written(self, frame: bytearray, code: int) -> bytes:
        element, text = bytes(frame[3:5]), bytes(frame[5:-1])
        right = checksum(frame[3:]) == code and element.isdigit() and len(text) <= MAX_TEXT
        ours = bytes(frame[:2]) == CARD
        done = right and ours and self._elements.write(int(element), text.decode("latin-1"))
        return self._ended(frame, bytes([ACK if done else NAK]))

    def _ended(self, frame: bytearray, answer: bytes) -> bytes:
        self._frame = None
        return answer if bytes(frame[:2]) == CARD else b""


def _begin(card: int) -> bytes:
    return bytes([EOT]) + _digits(card)


def _sealed(data: bytes) -> bytes:
    """Return data between STX and ETX, followed by its checksum."""
    data += bytes([ETX])
    return bytes([STX]) + data + bytes([checksum(data)])


def _digits(value: int) -> bytes:
    if not 0 <= value <= 99:
        raise ValueError(f"{value} is not a number of two digits")
    return b"%02d" % value
