"""Writes `index.py`, by which a program finds its words: `python -m motionlang.mint.keywords.indexing`."""

from __future__ import annotations

import sys
from pathlib import Path
from textwrap import fill

from motionlang.files import replacing
from motionlang.lang.keyword import Keyword, Table
from motionlang.mint.keywords import table
from motionlang.mint.keywords.all_words import files

PLACE = Path(__file__).with_name("index.py")
_HEAD = '''"""In which file each word of Mint stands, "" for the type library. Written by `indexing`; do not edit."""

from __future__ import annotations

FILES = {
'''


def written() -> str:
    """The text of `index.py`; AssertionError where a word stands twice."""
    Table(table().rows)
    rows = {file.__name__.rpartition(".")[2]: (*file.ROWS, *getattr(file, "HIDDEN", ())) for file in files()}
    entries = [_entry(name, own) for name, own in [*rows.items(), ("", table().library)]]
    return _HEAD + "".join(entries) + "}\n"


def _entry(name: str, rows: tuple[Keyword, ...]) -> str:
    words = [spelling.lower() for row in rows for spelling in (row.name, row.short) if spelling]
    return f'    "{name}": """\n{fill(" ".join(words), 110)}\n""",\n'


if __name__ == "__main__":
    with replacing(str(PLACE)) as file:
        file.write(written().encode())
    sys.stdout.write(f"{PLACE.name}: {len(table().rows)} words\n")
