"""Writes docs/keywords/ from the keyword tables: `python -m tests.keyword_pages`."""

from __future__ import annotations

from pathlib import Path

from motionlang import run
from motionlang.execution import dialect, dialects
from motionlang.lang.keyword import Keyword
from motionlang.source import Source
from motionlang.views.keyword_pages import markdown

FOLDER = Path(__file__).parent.parent / "docs" / "keywords"
# How long an example may go on, seconds of machine time.
UNTIL = 60.0

# What a machine must have for the examples of MCCL that home an axis, by the keys of the machine file.
HOMING: dict[str, object] = {
    "axis.1.index_every": 1000.0,
    "axis.1.home_switch": [500.0, 600.0],
    "encoder": [{"aux": 1, "velocity": 1000.0, "index_every": 200.0}],
}


def machine_of(row: Keyword) -> dict[str, object]:
    """The machine on which a row's example runs: bare, but for what its help says that it must have."""
    return {key: value for key, value in HOMING.items() if key.rpartition(".")[2] in row.help}


def shown(row: Keyword, language: str) -> list[str]:
    """What a row's example prints."""
    source = Source("example", f"{row.example}\n")
    return run(source, dialect=language, machine=machine_of(row), cache=False, until=UNTIL).output


def page(language: str) -> str:
    """What the page of a language must say."""
    return markdown(dialect(language).table().rows, language, lambda row: shown(row, language))


def path(language: str) -> Path:
    """Where the page of a language is."""
    return FOLDER / f"{language}.md"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name in dialects():
        path(name).write_text(page(name), encoding="utf-8")
