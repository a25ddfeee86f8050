"""Writer of `index.py` of both languages: `python -m tests.keyword_index`.

It lists the keywords of each file.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from textwrap import fill

from motionlang.lang.keyword import Keyword, Table

PACKAGES = ("motionlang.mint.keywords", "motionlang.mccl.keywords")
_HEAD = '''"""The keywords of each file, in lower case.

Written by `python -m tests.keyword_index`; do not edit.
"""

from __future__ import annotations

FILES = {
'''


def place(package: str) -> Path:
    """Return the file of an index."""
    return Path(str(import_module(package).__file__)).with_name("index.py")


def written(package: str) -> str:
    """Return the text of an index; raise AssertionError for a duplicate keyword."""
    files = {name: import_module(f"{package}.{name}") for name in import_module(package).ORDER.split()}
    Table(row for file in files.values() for row in file.ROWS)
    return _HEAD + "".join(_entry(name, _rows(file)) for name, file in files.items()) + "}\n"


def _rows(file: object) -> tuple[Keyword, ...]:
    return (*getattr(file, "ROWS", ()), *getattr(file, "HIDDEN", ()))


def _entry(name: str, rows: tuple[Keyword, ...]) -> str:
    words = [spelling.lower() for row in rows for spelling in (row.name, row.short) if spelling]
    return f'    "{name}": """\n{fill(" ".join(words), 110)}\n""",\n'


if __name__ == "__main__":
    for each in PACKAGES:
        place(each).write_text(written(each), encoding="utf-8", newline="\n")
        sys.stdout.write(f"{each}: {len(list(import_module(each).table()))} keywords\n")
