"""Mint on a machine, by example: pages of tests/spec/mint/machine, each with its machine file and what it shows.

A line that begins with `'| ` is a line of the machine file, `'> ` one that the terminal shows, `'? ` a diagnostic:
the line it is about and its message, `'! ` something that the run could not know.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.lang.machine_file import read_machine
from motionlang.source import Source

PAGES = sorted((Path(__file__).parents[1] / "spec" / "mint" / "machine").glob("*.mnt"))


def said(text: str, mark: str) -> list[str]:
    """What stands behind a mark, line by line."""
    return [line[len(mark) :] for line in text.split("\n") if line.startswith(mark)]


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_page_says_what_happens(path: Path) -> None:
    text = path.read_text()
    settings = read_machine(Source("machine.toml", "\n".join(said(text, "'| "))))
    result = run(path, machine=settings, cache=False)
    assert [f"{each.line}: {each.message}" for each in result.diagnostics] == said(text, "'? ")
    assert result.output == said(text, "'> ")
    assert "'! " not in text or result.not_counted == said(text, "'! ")


def test_there_are_pages() -> None:
    assert len(PAGES) >= 20
