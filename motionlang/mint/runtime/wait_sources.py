"""Find the machine file section that can end a wait."""

from __future__ import annotations

import re

from motionlang.mint.keywords import table

_WORD = re.compile(r"([a-z_]\w*)(\s*[(.[])?", re.IGNORECASE)


def what_ends(why: str) -> str:
    """Return a hint for a wait that nothing ends, "" if no section could end it.

    It is derived from the text that says what the wait is for.
    """
    found = dict.fromkeys(filter(None, (_section(word, bracket) for word, bracket in _WORD.findall(why))))
    if not found:
        return ""
    sections = " or ".join(f"[[{each}]]" for each in found)
    hint = f"the machine file says when it comes, {sections}, and with run.until how long to wait for it"
    typed = "; run --realtime takes it from the keyboard of a terminal"
    return hint + typed if found.keys() & {"answer", "key"} else hint


def _section(word: str, bracket: str) -> str:
    """Return the section that drives a keyword.

    Returns "" if the word has no brackets: it is then an ordinary word of the text.
    """
    row = table().get(word)
    if row is None or (row.index != "none" and not bracket and word != row.name):
        return ""
    return row.driven
