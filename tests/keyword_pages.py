"""Writes docs/keywords/ from the keyword tables: `python -m tests.keyword_pages`."""

from __future__ import annotations

from pathlib import Path

from motionlang.execution import dialect, dialects
from motionlang.views.keyword_pages import markdown

FOLDER = Path(__file__).parent.parent / "docs" / "keywords"


def pages() -> dict[Path, str]:
    """Each page with what it must say."""
    return {FOLDER / f"{name}.md": markdown(dialect(name).table().rows, name) for name in dialects()}


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for path, text in pages().items():
        path.write_text(text, encoding="utf-8")
