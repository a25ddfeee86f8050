"""A text in an editor, with its language, its machine and its names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cached_property

from motionlang.kernel import Dialect, Keyword, Program, Source
from motionlang.kernel.lang import Names, Span

# Kinds of token that are no code.
PROSE = frozenset(("comment", "string", "text"))
# Kinds of token that a keyword has.
_WORDS = frozenset(("word", "control", "command", "not-simulated"))


class Page:
    """The text of a program. Its names are computed on first use, unless they are given."""

    def __init__(
        self,
        source: Source,
        language: Dialect,
        settings: Mapping[str, object] | None = None,
        names: Names | None = None,
    ) -> None:
        self.source, self.language, self.settings = source, language, dict(settings or {})
        if names is not None:
            self.names = names
        self._starts: list[int] | None = None

    @property
    def text(self) -> str:
        return self.source.text

    @cached_property
    def program(self) -> Program:
        return self.language.program(self.source, self.settings)

    @cached_property
    def names(self) -> Names:
        """The names of the text."""
        return self.program.names

    def offset(self, line: int, column: int) -> int:
        """Return the character offset of a line and a column, both counted from 1."""
        if self._starts is None:
            self._starts = [0, *(match.end() for match in re.finditer("\n", self.text))]
        if line > len(self._starts):
            return len(self.text)
        start = self._starts[max(line, 1) - 1]
        end = self._starts[line] - 1 if line < len(self._starts) else len(self.text)
        return min(start + max(column, 1) - 1, max(end, start))

    def line_of(self, offset: int) -> Span:
        """Return the start and end of the line that contains an offset."""
        start = self.text.rfind("\n", 0, offset) + 1
        end = self.text.find("\n", offset)
        return start, len(self.text) if end < 0 else end

    def token(self, offset: int) -> tuple[str, str, int] | None:
        """Return kind, text and offset of the token at an offset.

        At the boundary of two tokens, a keyword or a name takes precedence.
        """
        start, end = self.line_of(offset)
        found = None
        for kind, piece, at in self.language.tokens(self.text[start:end]):
            if start + at > offset:
                break
            if offset <= start + at + len(piece) and (found is None or kind in _WORDS):
                found = kind, piece, start + at
        return found

    def keyword(self, offset: int) -> tuple[Keyword, Span] | None:
        """Return the keyword at an offset and its span, or None."""
        token = self.token(offset)
        if token is None or token[0] not in _WORDS:
            return None
        name = token[1].partition(".")[0]
        row = self.language.table().get(name)
        return None if row is None else (row, (token[2], token[2] + len(name)))

    def is_prose(self, offset: int) -> bool:
        """True if text typed at an offset belongs to a comment or a string."""
        start, _ = self.line_of(offset)
        typed = list(self.language.tokens(self.text[start:offset]))
        if not typed:
            return False
        kind, piece, at = typed[-1]
        if kind == "bad":
            return piece[:1] == '"'
        closed = kind != "comment" and len(piece) > 1 and piece[-1:] == '"'
        return kind in PROSE and start + at + len(piece) == offset and not closed
