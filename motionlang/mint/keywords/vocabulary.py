"""The vocabulary of Mint: found word by word, as a program uses a few dozen of a thousand.

`index` says in which group each word stands. A group is loaded when a word of it is met, and all of them when somebody
looks through the whole vocabulary. What belongs to it is written in `all_words`.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword, Table
from motionlang.mint.keywords.index import GROUPS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


class Vocabulary(Table):
    """A table whose rows come when they are wanted."""

    __slots__ = ("_groups", "_whole")

    def __init__(self) -> None:
        self._whole: tuple[Keyword, ...] | None = None
        self._by_name = {}
        self._groups = {word: group for group, words in GROUPS.items() for word in words.split()}

    @property
    def rows(self) -> tuple[Keyword, ...]:  # type: ignore[override]
        """All rows, in the order of the groups."""
        if self._whole is None:
            from motionlang.mint.keywords.all_words import rows

            self._whole = tuple(rows())
            self._enter(self._whole)
        return self._whole

    def get(self, word: str) -> Keyword | None:
        """The row of a word, by its name or its short form, in any case."""
        key = word.lower()
        row = self._by_name.get(key)
        if row is None and key in self._groups:
            self._load(self._groups[key])
            row = self._by_name.get(key)
        return row

    def _load(self, group: str) -> None:
        if not group:  # the library, of which a row depends on which words the groups have
            _ = self.rows
            return
        module = __import__(f"motionlang.mint.keywords.{group}", fromlist=["ROWS"])
        self._enter(module.ROWS)
        self._by_name.update((row.name, row) for row in getattr(module, "HIDDEN", ()))

    def _enter(self, rows: Iterable[Keyword]) -> None:
        for row in rows:
            self._by_name[row.name.lower()] = row
            if row.short:
                self._by_name[row.short.lower()] = row
