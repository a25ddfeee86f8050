"""Writes `index.py`, which tells in which group each word stands: `python -m motionlang.mint.keywords.indexing`."""

from __future__ import annotations

import sys
from pathlib import Path
from textwrap import fill

from motionlang.files import replacing
from motionlang.lang.keyword import Table
from motionlang.mint.keywords.all_words import groups, rows

PLACE = Path(__file__).with_name("index.py")
_HEAD = '''"""In which group each word of Mint stands, "" for the type library. Written by `indexing`; do not edit."""

from __future__ import annotations

GROUPS = {
'''


def written() -> str:
    """The text of `index.py`; AssertionError where a word stands twice."""
    table = Table(rows())
    found: dict[str, list[str]] = {}
    seen: set[str] = set()
    for module in groups():
        own = (*module.ROWS, *getattr(module, "HIDDEN", ()))
        found[module.__name__.rpartition(".")[2]] = words = [word for row in own for word in _spellings(row)]
        seen.update(words)
    found[""] = [word for row in table.rows for word in _spellings(row) if word not in seen]
    entries = [_entry(group, words) for group, words in found.items()]
    return _HEAD + "".join(entries) + "}\n"


def _entry(group: str, words: list[str]) -> str:
    return f'    "{group}": """\n{fill(" ".join(words), 110)}\n""",\n'


def _spellings(row: object) -> list[str]:
    return [spelling.lower() for spelling in (row.name, row.short) if spelling]  # type: ignore[attr-defined]


if __name__ == "__main__":
    with replacing(str(PLACE)) as file:
        file.write(written().encode())
    sys.stdout.write(f"{PLACE.name}: {len(rows())} words\n")
