"""Generator of `tables.py`, the index of assumptions by keyword for a report.

Run it with `python -m motionlang.assumptions.indexing`.
"""

from __future__ import annotations

from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING

from motionlang.assumptions.entries import assumptions
from motionlang.assumptions.used import is_of
from motionlang.files import replacing
from motionlang.lang.dialect import dialect, dialects
from motionlang.mint.keywords.switchable import name_of, with_default

if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.assumptions.assumption import Assumption
    from motionlang.lang.keyword import Keyword, Table

PLACE = Path(__file__).with_name("tables.py")
HEAD = '''"""The open assumptions by keyword. Written by `indexing`; do not edit."""

from __future__ import annotations

'''
# The roles that put an axis in motion by its speed and its rates.
ROLES = ("move", "path", "act")
# Up to this many characters of keywords are on the line of their assumption.
SHORT = 70
# The longest line, its end included.
WIDTH = 111


def written() -> str:
    """Return the text of `tables.py`."""
    tables = {name: dialect(name).table() for name in dialects()}
    mint = tables["mint"]
    settings = {name_of(row): row for row in with_default()}
    lines = [
        HEAD,
        "# Assumption: the keywords whose use makes a program depend on it. They are by language if it is\n",
        "# about both and they differ.\n",
        "OPEN: dict[str, str | dict[str, str]] = {\n",
        *_open(tables, settings),
        "}\n",
        "# Setting at power-up: its word, and what is written instead of it where it shapes a move.\n",
    ]
    lines += ["DEFAULTS = {\n", '    "mint": {\n', *_defaults(mint, settings), "    },\n", "}\n"]
    moves = [word for row in mint if row.role in ROLES for word in _spellings(row)]
    return "".join((*lines, f"MOTIONS = {_text(moves)}\n"))


def _open(tables: dict[str, Table], settings: dict[str, Keyword]) -> Iterator[str]:
    for name, each in assumptions().items():
        if not each.is_open or name in settings:
            continue
        found = {language: _words(language, table, each) for language, table in tables.items()}
        some = {language: words for language, words in found.items() if words}
        different = {tuple(words) for words in some.values()}
        if len(different) > 1 or (some and not is_of(name, *tables) and len(some) < len(tables)):
            texts = [f'"{language}": {_text(words)}' for language, words in some.items()]
            line = f'    "{name}": {{{", ".join(texts)}}},\n'
            apart = "".join(f"        {text},\n" for text in texts)
            yield (
                line
                if len(line) <= WIDTH and line.count("\n") == 1
                else f'    "{name}": {{\n{apart}    }},\n'
            )
        elif some:
            yield f'    "{name}": {_text(list(different.pop()))},\n'


def _text(words: list[str]) -> str:
    """Return keywords as a quoted text, on several lines if there are many."""
    joined = " ".join(words).replace("\\", "\\\\")
    return f'"{joined}"' if len(joined) < SHORT else f'"""\n{fill(joined, 110)}\n"""'


def _words(language: str, table: Table, assumption: Assumption) -> list[str]:
    """Return an assumption's keywords of a language, in every spelling."""
    prefix = assumption.name.partition(".")[0]
    if is_of(assumption.name, *(each for each in dialects() if each != language)):
        return []
    found: list[str] = []
    for word in assumption.words:
        row = table.get(word)
        if row is not None:
            found += _spellings(row)
        elif word.startswith("@") or prefix == language or not any(map(str.isalpha, word)):
            found.append(word.lower())
    return found


def _defaults(table: Table, settings: dict[str, Keyword]) -> Iterator[str]:
    for name, row in settings.items():
        if assumptions()[name].is_open:
            given = set(row.gives.split())
            same = [each for each in table if given & set(each.gives.split())] if given else []
            instead = " ".join(word for each in same for word in _spellings(each))
            line = f'        "{name}": ("{row.name.lower()}", "{instead}"),\n'
            apart = f'        "{name}": (\n            "{row.name.lower()}",\n            "{instead}",\n        ),\n'
            yield line if len(line) <= WIDTH else apart


def _spellings(row: Keyword) -> list[str]:
    return [spelling.lower() for spelling in (row.name, row.short) if spelling]


if __name__ == "__main__":
    with replacing(str(PLACE)) as file:
        file.write(written().encode())
