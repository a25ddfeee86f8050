"""Writer of docs/keywords/ from the tables: `python -m tests.keyword_pages`."""

from __future__ import annotations

from pathlib import Path

from motionlang import run
from motionlang.execution import dialect, dialects
from motionlang.lang.keyword import Keyword
from motionlang.source import Source
from motionlang.views.keyword_pages import markdown

FOLDER = Path(__file__).parent.parent / "docs" / "keywords"
# The time limit of an example, seconds of machine time.
UNTIL = 60.0

# Requirements of the machine for MCCL's examples of homing, by key of the machine file.
HOMING: dict[str, object] = {
    "axis.1.index_every": 1000.0,
    "axis.1.home_switch": [500.0, 600.0],
    "encoder": [{"aux": 1, "velocity": 1000.0, "index_every": 200.0}],
}


def machine_of(row: Keyword) -> dict[str, object]:
    """Return the machine of a row's example: bare, except for the needs in its help."""
    return {key: value for key, value in HOMING.items() if key.rpartition(".")[2] in row.help}


def shown(row: Keyword, language: str) -> list[str]:
    """Return the output of a row's example."""
    source = Source("example", f"{row.example}\n")
    return run(source, dialect=language, machine=machine_of(row), cache=False, until=UNTIL).output


def page(language: str) -> str:
    """Return the required text of a language's page."""
    return markdown(dialect(language).table().rows, language, lambda row: shown(row, language))


def path(language: str) -> Path:
    """Return the file of a language's page."""
    return FOLDER / f"{language}.md"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name in dialects():
        path(name).write_text(page(name), encoding="utf-8")
