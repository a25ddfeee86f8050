"""The kinds of all fragments of a text, for highlighting.

The dialect splits a text into tokens; the rows of its table define the keywords.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.kernel import Dialect

# The kinds of tokens that are looked up in the table of the dialect.
_WORDS = frozenset(("word", "command", "not-simulated"))


def pieces(dialect: Dialect, text: str) -> Iterator[tuple[int, str, str]]:
    """Yield the fragments of a text with offset, kind and text, leaving nothing out.

    Text between tokens has the kind "". A keyword of the table has the kind "move", "keyword" or
    "not-simulated". The other kinds are those of `Dialect.tokens`.
    """
    at = 0
    for kind, piece, offset in dialect.tokens(text):
        if offset > at:
            yield at, "", text[at:offset]
        # `SPEED.0` is one token of Mint v4.
        row = dialect.table().get(piece.partition(".")[0]) if kind in _WORDS else None
        if row is not None:
            kind = "move" if row.kind == "move" else "keyword" if row.simulated else "not-simulated"
        yield offset, kind, piece
        at = offset + len(piece)
    if at < len(text):
        yield at, "", text[at:]
