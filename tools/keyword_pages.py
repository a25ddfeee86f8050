"""Writer of docs/keywords/ and of its menu.

The menu is in mkdocs.yml, with that of the rest of the site.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from motionlang import run
from motionlang.kernel.lang.dialect import dialect, dialects
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.source import Source
from motionlang.views.formatting import dialect_name
from tools.keyword_page_texts import menu_of, pages

ROOT = Path(__file__).parent.parent
FOLDER = ROOT / "docs" / "keywords"
MENU = ROOT / "mkdocs.yml"
_SECTION = re.compile(r"( *# keywords\n).*?( *# end of keywords\n)", re.DOTALL)
# The time limit of an example, seconds of machine time.
UNTIL = 60.0

# Requirements of the machine for MCCL's examples of homing, by key of the machine file.
HOMING: dict[str, object] = {
    "axis.1.index_every": 1000.0,
    "axis.1.home_switch": [500.0, 600.0],
    "encoder": [{"aux": 1, "velocity": 1000.0, "index_every": 200.0}],
}


def machine_of(row: Keyword) -> dict[str, object]:
    """Return the machine of a row's example: only the keys that the row's help names."""
    return {key: value for key, value in HOMING.items() if key.rpartition(".")[2] in row.help}


def shown(row: Keyword, language: str) -> list[str]:
    """Return the output of a row's example."""
    source = Source("example", f"{row.example}\n")
    return run(source, dialect=language, machine=machine_of(row), until=UNTIL).output


def written(language: str) -> dict[str, str]:
    """Return the keyword pages of a language as generated, by path in docs/keywords."""
    return pages(dialect(language).table().rows, language, lambda row: shown(row, language))


def stored(language: str) -> dict[str, str]:
    """Return the keyword pages of a language as stored, by path in docs/keywords."""
    paths = [FOLDER / f"{language}.md", *sorted((FOLDER / language).glob("*.md"))]
    return {each.relative_to(FOLDER).as_posix(): each.read_text(encoding="utf-8") for each in paths}


def with_menu(text: str) -> str:
    """Return the site's configuration with the current menu of keyword pages."""
    return _SECTION.sub(lambda found: found[1] + "".join(_menu()) + found[2], text)


def _menu() -> Iterator[str]:
    for language in dialects():
        yield f"      - {dialect_name(language)}:\n"
        for title, path in menu_of(dialect(language).table().rows, language):
            yield f'          - "{title}": keywords/{path}\n'


def mint() -> dict[Path, str | None]:
    return _files("mint")


def mccl() -> dict[Path, str | None]:
    return _files("mccl")


def menu() -> dict[Path, str]:
    return {MENU: with_menu(MENU.read_text(encoding="utf-8"))}


def _files(language: str) -> dict[Path, str | None]:
    """Return the pages of a language, with None for pages of groups that no longer exist."""
    found: dict[str, str | None] = {**dict.fromkeys(stored(language)), **written(language)}
    return {FOLDER / path: text for path, text in found.items()}
