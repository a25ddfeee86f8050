"""Writes what a program finds its words by: `python -m motionlang.mint.keywords.indexing`.

`index.py` tells in which group each word stands, `operations_index.py` in which module what it does.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from textwrap import fill

from motionlang.files import replacing
from motionlang.lang.keyword import Table
from motionlang.mint.keywords.all_words import groups, rows

PLACE = Path(__file__).with_name("index.py")
OPERATIONS_PLACE = Path(__file__).with_name("operations_index.py")
_HEAD = '''"""In which group each word of Mint stands, "" for the type library. Written by `indexing`; do not edit."""

from __future__ import annotations

GROUPS = {
'''
_OPERATIONS_HEAD = '''"""In which module of this folder what a verb does stands, and what raises the events of a kind.

Written by `indexing`; do not edit.
"""

from __future__ import annotations

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


def operations_written() -> str:
    """The text of `operations_index.py`; AssertionError where a verb or a kind of event has two modules."""
    verbs: dict[str, list[str]] = {}
    sources: dict[str, str] = {}
    seen: set[str] = set()
    for path in sorted(set(PLACE.parent.glob("*_*.py")) - {OPERATIONS_PLACE}):
        module = import_module(f"motionlang.mint.keywords.{path.stem}")
        own, raised = getattr(module, "OPERATIONS", {}), getattr(module, "SOURCES", {})
        assert seen.isdisjoint(own), (path.stem, seen & own.keys())
        assert sources.keys().isdisjoint(raised), (path.stem, raised)
        seen.update(own)
        sources.update(dict.fromkeys(raised, path.stem))
        if own:
            verbs[path.stem] = list(own)
    entries = "".join(_entry(name, own) for name, own in verbs.items())
    events = "".join(f'    "{kind}": "{name}",\n' for kind, name in sources.items())
    return f"{_OPERATIONS_HEAD}VERBS = {{\n{entries}}}\nSOURCES = {{\n{events}}}\n"


if __name__ == "__main__":
    for place, text in ((PLACE, written()), (OPERATIONS_PLACE, operations_written())):
        with replacing(str(place)) as file:
            file.write(text.encode())
    sys.stdout.write(f"{PLACE.name}: {len(rows())} words\n")
