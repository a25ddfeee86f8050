"""What of the machine file can end a wait: the section for the words that a condition looks at."""

from __future__ import annotations

import re

from motionlang.mint.keywords import table

_WORD = re.compile(r"([a-z_]\w*)(\s*[(.[])?", re.IGNORECASE)


def what_ends(why: str) -> str:
    """A hint for a wait that nothing ends, from the words that say what it waits for; "" where none is of the world."""
    found = dict.fromkeys(filter(None, (_section(word, bracket) for word, bracket in _WORD.findall(why))))
    if not found:
        return ""
    sections = " or ".join(f"[[{each}]]" for each in found)
    hint = f"the machine file says when it comes, {sections}, and with run.until how long to wait for it"
    typed = "; run --realtime takes it from the keyboard of a terminal"
    return hint + typed if found.keys() & {"answer", "key"} else hint


def _section(word: str, bracket: str) -> str:
    """The section that drives a word; "" for one that lacks its brackets, which is a word of the sentence around it."""
    row = table().get(word)
    if row is None or (row.index != "none" and not bracket and word != row.name):
        return ""
    return row.driven
