"""A name in a syntax tree: its text and its position."""

from __future__ import annotations


class Word(str):
    """A text that extends from offset `start` to offset `end` of the source.

    A name that a compiler makes up has no position.
    """

    __slots__ = ("end", "start")

    start: int
    end: int

    def __new__(cls, text: str, start: int = 0, end: int = 0) -> Word:
        made = str.__new__(cls, text)
        made.start, made.end = start, end
        return made

    def __getnewargs__(self) -> tuple[str, int, int]:  # type: ignore[override]
        return str(self), self.start, self.end
