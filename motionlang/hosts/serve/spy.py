"""Log of the hosts that connect and leave and, line by line, of their traffic, for authors of clients."""

from __future__ import annotations

import re
from collections.abc import Callable

# Characters of an unfinished line after which it is written.
MAX_LINE = 200
# Characters after which a line is written: LF, CR, ESC, and ENQ, ACK and NAK of a protocol of frames. A frame
# that ends with ETX has a checksum behind it.
ENDS, ETX = (10, 13, 27, 5, 6, 21), 3
# Prompts, which are not shown: those of a board and of a Mint controller.
_PROMPT = re.compile(rb"(?:[PC]|\d+)?>")


class Spy:
    """Writes `1 < 1TP` for data from host 1 and `1 > 01 0` for its answer, and `host 1 has left`.

    Non-printing characters are written as Python escapes. Without `traffic` only the remarks are written.
    """

    def __init__(self, write: Callable[[str], None], traffic: bool = True) -> None:
        self._write, self._traffic = write, traffic
        self._open: dict[tuple[int, str], bytearray] = {}

    def sent(self, number: int, data: bytes) -> None:
        """Log data from a host."""
        if self._traffic:
            self._take(number, "<", data)

    def answered(self, number: int, data: bytes) -> None:
        """Log an answer to a host."""
        if self._traffic:
            self._take(number, ">", data)

    def remark(self, number: int, text: str) -> None:
        """Log a remark about a host."""
        for key in [key for key in self._open if key[0] == number]:
            self._end(key)
        self._write(f"host {number} {text}\n")

    def _take(self, number: int, mark: str, data: bytes) -> None:
        key = (number, mark)
        line = self._open.setdefault(key, bytearray())
        for code in data:
            line.append(code)
            if code in ENDS or line[-2:-1] == bytes([ETX]) or len(line) >= MAX_LINE:
                self._end(key)
        if mark == ">" and _PROMPT.fullmatch(line):
            line.clear()

    def _end(self, key: tuple[int, str]) -> None:
        number, mark = key
        line = self._open.get(key)
        shown = line.decode("latin-1") if line else ""
        if shown not in ("", "\n"):
            shown = shown.removesuffix("\n").removesuffix("\r")
            self._write(f"{number} {mark} {repr(shown)[1:-1]}\n")
        if line is not None:
            line.clear()
