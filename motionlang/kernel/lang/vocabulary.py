"""The keywords of a language, loaded on demand: a program uses few of a thousand.

`index.py` next to the files of keywords lists the keywords of each file. It is derived from their rows. A
file is imported at the first use of one of its keywords; a complete listing imports all files.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from motionlang.kernel.lang.keyword import Keyword


class Vocabulary:
    """All keywords of a language, by name or short form, ignoring case.

    Rows are imported on lookup. `index` has the keywords of each file of `package`.
    """

    def __init__(self, package: str, index: Mapping[str, str]) -> None:
        self._package, self._index = package, index
        self._file_of = {word: file for file, words in index.items() for word in words.split()}
        self._by_name: dict[str, Keyword] = {}
        self._whole: tuple[Keyword, ...] | None = None

    def __iter__(self) -> Iterator[Keyword]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def rows(self) -> tuple[Keyword, ...]:
        """All rows, file by file."""
        if self._whole is None:
            self._whole = tuple(row for file in self._index for row in self._module(file).ROWS)
            self._enter(self._whole)
        return self._whole

    def get(self, word: str) -> Keyword | None:
        """Return the row of a keyword, by its name or its short form, ignoring case."""
        key = word.lower()
        row = self._by_name.get(key)
        if row is None and key in self._file_of:
            module = self.file(key)
            self._enter((*module.ROWS, *getattr(module, "HIDDEN", ())))
            row = self._by_name[key]
        return row

    def homes(self, word: str) -> bool:
        """True if a keyword searches for the zero of an axis."""
        row = self.get(word)
        return row is not None and row.topic == "home"

    def doing(self, function: str) -> str:
        """Return the name of the first keyword with a function."""
        return next(row.name for row in self.rows if row.function == function)

    def group(self, name: str) -> list[Keyword]:
        """Return the keywords of a group, ignoring case."""
        return [row for row in self.rows if (row.group or row.kind).lower() == name.lower()]

    def meant_by(self, word: str) -> list[str]:
        """Return the keywords that people who do not know them write so."""
        upper = word.upper()
        return [row.name for row in self.rows if upper in row.meant.split()]

    def names(self) -> list[str]:
        """Return all names, in the order of the rows."""
        return [row.name for row in self.rows]

    def file(self, word: str) -> Any:
        """Return the module that defines a keyword, imported on first use."""
        return self._module(self._file_of[word.lower()])

    def _module(self, name: str) -> Any:
        return __import__(f"{self._package}.{name}", fromlist=["ROWS"])

    def _enter(self, rows: Iterable[Keyword]) -> None:
        for row in rows:
            self._by_name[row.name.lower()] = row
            if row.short:
                self._by_name[row.short.lower()] = row.shortened()
