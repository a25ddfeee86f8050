"""The open texts of an editor, changed as it reports, with positions in UTF-16.

The documents of pygls are not used. They split lines at characters that are not line ends for an editor, such as a
form feed, and count wrongly after that. Here any position is accepted: a position outside the text is moved to the
nearest one in it, and one inside a surrogate pair to the start of the pair. Line ends become `\\n` as a text arrives,
so that an offset is the same in the text of the editor and in the program.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate

from lsprotocol import types

from motionlang.kernel import Source
from motionlang.kernel.lang import Span

_MARK = "\ufeff"


class OpenDocument:
    """One open text, with the `version` that the editor gave it."""

    __slots__ = ("_source", "_starts", "text", "uri", "version")

    def __init__(self, uri: str, text: str, version: int) -> None:
        self.uri, self.version, self.text = uri, version, _with_line_feeds(text)
        self._starts: list[int] | None = None
        self._source: Source | None = None

    @property
    def name(self) -> str:
        """The file name of the text, or the last part of its URI."""
        return self.uri.rstrip("/").rpartition("/")[2] or self.uri

    @property
    def source(self) -> Source:
        """The text as a program.

        A blank replaces a byte order mark, so that columns are correct.
        """
        if self._source is None:
            text = " " + self.text[1:] if self.text.startswith(_MARK) else self.text
            self._source = Source(self.name, text)
        return self._source

    def change(
        self, changes: Sequence[types.TextDocumentContentChangeEvent], version: int
    ) -> list[tuple[int, int, int]]:
        """Apply an editor's changes in order, each to the result of the previous one.

        Returns the offset of each change, and the number of characters that it removes and adds there.
        """
        self.version, made = version, []
        for each in changes:
            start, end = 0, len(self.text)
            if isinstance(each, types.TextDocumentContentChangePartial):
                start, end = sorted((self.offset(each.range.start), self.offset(each.range.end)))
            text = _with_line_feeds(each.text)
            self.text = self.text[:start] + text + self.text[end:]
            self._starts = self._source = None
            made.append((start, end - start, len(text)))
        return made

    # ------------------------------------------------------------- positions and offsets

    def offset(self, position: types.Position) -> int:
        starts = self._line_starts()
        if position.line >= len(starts):
            return len(self.text)
        start: int = starts[position.line]
        end = self.text.find("\n", start)
        line = self.text[start : end if end >= 0 else len(self.text)]
        return start + characters(line, position.character)

    def position(self, offset: int) -> types.Position:
        """Return the position of an offset in the source."""
        text = self.source.text
        offset = min(max(offset, 0), len(text))
        line, column = self.source.location(offset)
        return types.Position(line - 1, units(text[offset - column + 1 : offset]))

    def source_offset(self, line: int) -> int:
        """Return the source offset at which a line, counted from 1, starts."""
        starts = self._line_starts()
        return starts[min(line, len(starts)) - 1]

    def range(self, span: Span) -> types.Range:
        """Return the range between two offsets in the source."""
        return types.Range(self.position(span[0]), self.position(span[1]))

    def _line_starts(self) -> list[int]:
        if self._starts is None:
            self._starts = [0, *accumulate([len(line) + 1 for line in self.text.split("\n")[:-1]])]
        return self._starts


def _with_line_feeds(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n")


def units(text: str) -> int:
    """Return the number of UTF-16 code units of a text."""
    return len(text) if text.isascii() else len(text.encode("utf-16-le", "surrogatepass")) // 2


def characters(line: str, count: int) -> int:
    """Return the number of characters in the first `count` UTF-16 units of a line."""
    if line.isascii():
        return min(count, len(line))
    found = 0
    for character in line:
        count -= 2 if character > "\uffff" else 1
        if count < 0:
            break
        found += 1
    return found
