"""Hints in the notation of a program: they are worded for MintMT, and Mint v4 has dots and square brackets.

`GO(0) starts the buffered moves` is `GO.0 starts the buffered moves`, and VECTORA(0, 1) is VECTORA[0, 1].
"""

from __future__ import annotations

import re

from motionlang.kernel.mint.keywords import table

_BRACKETS = re.compile(r"\b([A-Z]+)\(([^()\n]+)\)")


def in_v4(hint: str, program: str) -> str:
    """Return a hint with the keywords of axes and channels as Mint v4 writes them.

    A part that is the text of the `program` itself is not changed.
    """

    def written(found: re.Match[str]) -> str:
        word, inside = found.groups()
        row = table().get(word)
        if row is None or row.index == "none" or row.kind in ("function", "statement") or found[0] in program:
            return found[0]
        return f"{word}.{inside}" if inside.isdigit() else f"{word}[{inside}]"

    return _BRACKETS.sub(written, hint)
