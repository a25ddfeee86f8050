"""A program's text: read from any encoding, addressed by line and column."""

from __future__ import annotations

import errno
import os
import re
from bisect import bisect_left
from collections.abc import Iterator
from typing import BinaryIO

# The name of standard input on a command line, and elsewhere.
STDIN, STDIN_NAME = "-", "<stdin>"
# Bytes of the largest program, since a device may have no end; smaller ones than a chunk are read at once.
MAX_BYTES, _PIECE = 1 << 26, 1 << 16
# The suffix of the machine file next to a program, after its name without suffix.
MACHINE_SUFFIX = ".machine.toml"


def name_of(file: str) -> str:
    """Return the name of a program for messages and reports: its file name.

    It does not include the folder.
    """
    return STDIN_NAME if file == STDIN else os.path.basename(file)


def contents(file: BinaryIO) -> bytes:
    """Return all bytes of a file; OSError if there are more than `MAX_BYTES`."""
    data = file.read(_PIECE)
    if len(data) == _PIECE:
        data += file.read(MAX_BYTES)
    if len(data) > MAX_BYTES:
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG))
    return data


def without_padding(data: bytes) -> bytes:
    """Return the bytes of a text without the NULs that old disks put at its end.

    Raises OSError if another NUL shows that the file is not text, with its line.
    """
    if b"\0" not in data or _utf16(data):
        return data
    found = data.rstrip(b"\0")
    if not found or b"\0" in found:
        line = data.count(b"\n", 0, data.index(b"\0")) + 1
        raise OSError(errno.EILSEQ, f"not a text file: line {line} has a zero byte")
    return found


def _utf16(data: bytes) -> str:
    """Return the UTF-16 encoding of bytes, or "" if they are not UTF-16.

    They are if they have a byte order mark, or if every other byte is usually NUL.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16-le" if data[0] == 0xFF else "utf-16-be"
    if b"\0" not in data or len(data) % 2:
        return ""
    even, odd = data[::2].count(0), data[1::2].count(0)
    if min(even, odd) or max(even, odd) < len(data) / 4:
        return ""
    return "utf-16-le" if odd else "utf-16-be"


def _as_listed(text: str) -> str:
    """Return a text up to its DOS end-of-file mark, with blanks for form feeds; in strings both are kept."""
    made, end = list[str](), 0
    for found in re.finditer(r'"[^"\n]*"|[\f\x1a]', text):
        if found[0] == "\x1a":
            return "".join([*made, text[end : found.start()]])
        if found[0] == "\f":
            made += [text[end : found.start()], " "]
            end = found.end()
    return "".join([*made, text[end:]])


class Source:
    """`name` for messages and `text` with `\\n` line ends; nothing else of the file.

    Outside strings, a form feed between two pages of a listing becomes a blank, and the text ends at the end-of-file
    mark of DOS (0x1A): what follows is the rest of the last sector. `before` is the number of lines that a session
    has typed before it.
    """

    __slots__ = ("_ends", "_lines", "before", "name", "text")

    def __init__(self, name: str, text: str, before: int = 0) -> None:
        self.name, self.before = name, before
        if "\r" in text:
            text = text.replace("\r\n", "\n").replace("\r", "\n")
        if "\f" in text or "\x1a" in text:
            text = _as_listed(text)
        self.text = text
        self._lines: list[str] | None = None
        self._ends: list[int] | None = None

    @classmethod
    def from_bytes(cls, name: str, data: bytes) -> Source:
        """Decode as UTF-8, as UTF-16 if the bytes look like it, or as Latin-1."""
        wide = _utf16(data)
        try:
            text = data.decode(wide, "replace") if wide else data.decode("utf-8")
        except UnicodeDecodeError:
            text = data.decode("latin-1")
        return cls(name, text.removeprefix("\ufeff"))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Source:
        """Read a file; raise OSError if `open` does, or if the file is not text."""
        with open(path, "rb") as file:
            return cls.from_file(os.path.basename(os.fspath(path)), file)

    @classmethod
    def from_file(cls, name: str, file: BinaryIO) -> Source:
        """Read an open file.

        An OSError has its name, unlike one of an output that cannot be written.
        """
        try:
            return cls.from_bytes(name, without_padding(contents(file)))
        except OSError as error:
            error.filename = name
            raise

    def numbered(self) -> Iterator[tuple[int, str]]:
        """Return the lines of the text with their numbers."""
        return enumerate(self.text.split("\n"), self.before + 1)

    def line(self, number: int) -> str:
        """Return the text of line `number`, counted from 1; "" if there is none."""
        if self._lines is None:
            self._lines = self.text.split("\n")
        index = number - 1 - self.before
        return self._lines[index] if 0 <= index < len(self._lines) else ""

    def location(self, offset: int) -> tuple[int, int]:
        """Return line and column of a character offset, both counted from 1."""
        if self._ends is None:
            # Computed once: a file may have an error on each of its lines.
            self._ends, end = [-1], self.text.find("\n")
            while end >= 0:
                self._ends.append(end)
                end = self.text.find("\n", end + 1)
        line = bisect_left(self._ends, offset)
        return self.before + line, offset - self._ends[line - 1]


def machine_of(program: str | os.PathLike[str] | Source | None, given: str | None = None) -> str | None:
    """Return the machine file of a program: the given one, or the one next to it.

    For `pick.mnt` this is `pick.machine.toml`, or None if that does not exist. Standard input and a `Source` have no
    folder, and so no machine file.
    """
    if given is not None or program is None or isinstance(program, Source) or program == STDIN:
        return given
    path = os.path.splitext(program)[0] + MACHINE_SUFFIX
    return path if os.path.isfile(path) else None
