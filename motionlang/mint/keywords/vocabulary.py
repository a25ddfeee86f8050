"""The vocabulary of Mint: found word by word, as a program uses a few dozen of a thousand.

`index` says in which file each word stands. A file is imported when a word of it is met, and all of them when somebody
looks through the whole vocabulary. What belongs to it is written in `all_words`.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword, Table
from motionlang.mint.keywords.index import FILES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any


class Vocabulary(Table):
    """A table whose rows come when they are wanted."""

    __slots__ = ("_files", "_library", "_whole")

    def __init__(self) -> None:
        self._whole: tuple[Keyword, ...] | None = None
        self._library: tuple[Keyword, ...] | None = None
        self._by_name = {}
        self._files = {word: file for file, words in FILES.items() for word in words.split()}

    @property
    def rows(self) -> tuple[Keyword, ...]:  # type: ignore[override]
        """All rows, in the order of the files."""
        if self._whole is None:
            files = _module("all_words").files()
            self._whole = (*(row for file in files for row in file.ROWS), *self.library)
            self._enter(self._whole)
        return self._whole

    @property
    def library(self) -> tuple[Keyword, ...]:
        """The rows of the words of the type library that no file has."""
        if self._library is None:
            self._library = tuple(_module("all_words").library())
        return self._library

    def get(self, word: str) -> Keyword | None:
        """The row of a word, by its name or its short form, in any case."""
        key = word.lower()
        row = self._by_name.get(key)
        if row is None and key in self._files:
            self._load(key)
            row = self._by_name.get(key)
        return row

    def file(self, word: str) -> Any:
        """The module that has a word, imported at its first use."""
        return _module(self._files[word.lower()])

    def _load(self, key: str) -> None:
        if not self._files[key]:
            self._enter(self.library)
            return
        module = self.file(key)
        self._enter(module.ROWS)
        self._enter(getattr(module, "HIDDEN", ()))

    def _enter(self, rows: Iterable[Keyword]) -> None:
        for row in rows:
            self._by_name[row.name.lower()] = row
            if row.short:
                self._by_name[row.short.lower()] = row


def _module(name: str) -> Any:
    """A module beside this one, which a run may do without."""
    return __import__(f"motionlang.mint.keywords.{name}", fromlist=["rows"])
