"""From the ordinal of a token to its line and column, computed on demand.

A tree stores ordinals, because they cost nothing to create. The compiler needs lines, which take one pass
over the texts of the tokens. Only messages need columns; to find them the text is split into tokens again.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import islice
from sys import maxsize

from motionlang.lang.parsing.parser import Tables
from motionlang.source import Source

_SIGNS = frozenset("+-~")


class SourceOffsets:
    """Positions of the tokens of a source: lines and columns from 1, ordinals from 0."""

    __slots__ = ("_lines", "_matches", "_spans", "_tables", "_tokens", "source")

    def __init__(self, source: Source, tables: Tables, texts: list[str], kinds: list[str]) -> None:
        self.source = source
        self._tables = tables
        self._tokens = texts, kinds  # until the lines are computed
        self._spans: list[
            tuple[int, int]
        ] = []  # those of the first tokens, and the iterator that finds the others
        self._matches: Iterator[re.Match[str]] | None = None
        self._lines: list[int] = []  # the line of each token, and of the text after the last one

    @property
    def continues(self) -> bool:
        """True if lines of the source may continue on the next line."""
        return self._tables.continues(self.source.text)

    def tokens(self) -> tuple[list[str], list[str]]:
        """Return the texts and kinds of all tokens.

        They are split again if they were discarded once the lines were known.
        """
        texts, kinds = self._tokens
        if not texts:
            texts = self._tables.texts(self.source.text)
            kinds = self._tables.kinds_of(texts)
        return texts, kinds

    def line(self, at: int) -> int:
        """Return the line of a token."""
        if not self._lines:
            self._find_lines()
        return self._lines[min(at, len(self._lines) - 1)]

    def lines(self, ats: Iterable[int]) -> list[int]:
        """Return the lines of many tokens of the source."""
        if not self._lines:
            self._find_lines()
        lines = self._lines
        return [lines[at] for at in ats]

    def column(self, at: int) -> int:
        """Return the column of a token."""
        start = self.span(at)[0]
        return start - self.source.text.rfind("\n", 0, start)

    def length(self, at: int) -> int:
        """Return the number of characters of a token."""
        start, end = self.span(at)
        return max(1, end - start)

    def text(self, at: int) -> str:
        """Return the text of a token."""
        start, end = self.span(at)
        return self.source.text[start:end]

    def value_length(self, at: int) -> int:
        """Return the length of the value that begins with a token.

        The value includes signs, and an expression in parentheses after them.
        """
        start, last = self.span(at)[0], at
        while self.text(last) in _SIGNS:
            last += 1
        if last > at and self.text(last) == "(":
            last = self._closing(last)
        end = self.span(last)[1]
        return end - start if "\n" not in self.source.text[start:end] else self.length(at)

    def _closing(self, at: int) -> int:
        """Return the bracket that closes the one at a token.

        Returns the token itself if its line has no closing bracket.
        """
        depth, last = 0, at
        while (piece := self.text(last)) and "\n" not in piece:
            depth += (piece == "(") - (piece == ")")
            if depth == 0:
                return last
            last += 1
        return at

    def span(self, at: int) -> tuple[int, int]:
        """Return the start and end offsets of a token.

        Past the last token, both are the end of the text.
        """
        spans = self._spans
        if at >= len(spans):
            if self._matches is None:
                self._matches = self._tables.matches(self.source.text)
            spans += [match.span(1) for match in islice(self._matches, at + 1 - len(spans))]
        end = len(self.source.text)
        return spans[at] if at < len(spans) else (end, end)

    def _find_lines(self) -> None:
        (texts, kinds), self._tokens = self._tokens, ([], [])
        if self.continues:
            self._lines_from_spans()
            return
        lines, line, begin = self._lines, 1, 0
        try:
            while True:  # all tokens of one line take one step
                end = kinds.index("_NL", begin) + 1
                lines += [line] * (end - begin)
                line += texts[end - 1].count("\n")
                begin = end
        except ValueError:
            lines += [line] * (len(texts) + 1 - begin)

    def _lines_from_spans(self) -> None:
        """Find the lines by offset, because a continued line ends inside no token."""
        self.span(maxsize - 1)
        text, line, before = self.source.text, 1, 0
        for start, _ in self._spans:
            line += text.count("\n", before, start)
            self._lines.append(line)
            before = start
        self._lines.append(line)
