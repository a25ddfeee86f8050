"""The line that a host types: characters, backspace, length limit and line end."""

from __future__ import annotations

BACKSPACE, TAB, LF, CR, BLANK, DELETE = 8, 9, 10, 13, 32, 127
# Characters that are only added to a line.
PRINTABLE = bytes(range(BLANK, DELETE))


class TypedLine:
    """The characters typed since the last line end, at most `limit` of them."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._typed = bytearray()
        self._dropped = 0
        # True if the last character was a CR; an LF behind it ends no second line.
        self.after_cr = False

    def type(self, code: int) -> str:
        """Take a character and return its echo, with a line feed at the end of the line."""
        after_cr, self.after_cr = self.after_cr, code == CR
        if code in (CR, LF):
            return "" if code == LF and after_cr else "\n"
        if code in (BACKSPACE, DELETE):
            if not self._typed:
                return ""
            self._typed.pop()
            return "\b \b"
        if code < BLANK and code != TAB:
            return ""
        if len(self._typed) < self._limit:
            self._typed.append(code)
        else:
            self._dropped += 1
        return chr(code)

    def enter(self, line: bytes) -> bool:
        """Take printable characters and a final CR, all at once.

        Returns False, without effect, if there are other characters or the line would be too long.
        """
        typed = len(line) - 1
        if len(self._typed) + typed > self._limit or not line.endswith(b"\r"):
            return False
        if line.translate(None, PRINTABLE) != b"\r":
            return False
        self._typed += line
        del self._typed[-1]
        self.after_cr = True
        return True

    def take(self) -> tuple[str, int]:
        """Begin a new line; return the last one and the number of its dropped characters."""
        text, dropped = self._typed.decode("latin-1"), self._dropped
        self.clear()
        return text, dropped

    def clear(self) -> None:
        """Discard the typed characters."""
        self._typed.clear()
        self._dropped = 0
