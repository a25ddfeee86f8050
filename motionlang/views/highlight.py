"""Highlighting for the prompt and for Pygments: the dialect cuts a text up, the rows say which words it knows."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.lang.dialect import Dialect

# The kinds of a dialect's tokens that name a word of its table.
_WORDS = frozenset(("word", "command", "not-simulated"))


def pieces(dialect: Dialect, text: str) -> Iterator[tuple[int, str, str]]:
    """Offset, kind and text of each piece; nothing of the text is left out, "" is the kind of what is in between.

    A word of the table is "move", "keyword" or "not-simulated"; the other kinds are those of `Dialect.tokens`.
    """
    at = 0
    for kind, piece, offset in dialect.tokens(text):
        if offset > at:
            yield at, "", text[at:offset]
        row = dialect.table().get(piece) if kind in _WORDS else None
        if row is not None:
            kind = "move" if row.kind == "move" else "keyword" if row.simulated else "not-simulated"
        yield offset, kind, piece
        at = offset + len(piece)
    if at < len(text):
        yield at, "", text[at:]
