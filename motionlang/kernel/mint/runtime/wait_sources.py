"""Find the machine file tables that can end a wait."""

from __future__ import annotations

import re

from motionlang.kernel.mint.keywords import table

_WORD = re.compile(r"([a-z_]\w*)(\s*[(.[])?", re.IGNORECASE)


def driven_by(why: str) -> list[str]:
    """Return the tables of the machine file that could end a wait.

    `why` is the text that describes the wait.
    """
    return list(
        dict.fromkeys(filter(None, (_section(word, bracket) for word, bracket in _WORD.findall(why))))
    )


def _section(word: str, bracket: str) -> str:
    """Return the machine file section that drives a keyword.

    Returns "" if the word has no brackets, because it is then an ordinary word of the text.
    """
    row = table().get(word)
    if row is None or (row.index != "none" and not bracket and word != row.name):
        return ""
    return row.driven
