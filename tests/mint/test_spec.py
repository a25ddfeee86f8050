"""The language by example: each file under tests/spec/mint says in comments `'> …` what its terminal shows.

A `.toml` beside a program is the machine that it runs on.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.lang.machine_file import read_machine
from motionlang.source import Source

SPEC = sorted((Path(__file__).parents[1] / "spec" / "mint").glob("*.mnt"))


def promised(text: str) -> list[str]:
    """The lines after `'> `; `'>` alone is an empty line."""
    return [line.strip()[3:] for line in text.split("\n") if line.strip().startswith("'>")]


@pytest.mark.parametrize("path", SPEC, ids=lambda path: path.stem)
def test_the_terminal_shows_what_the_page_says(path: Path) -> None:
    machine = path.with_suffix(".toml")
    settings = read_machine(Source.read(machine)) if machine.exists() else {}
    result = run(path, machine=settings, cache=False)
    assert [each.message for each in result.diagnostics] == []
    assert result.output == promised(path.read_text())


def test_there_are_pages() -> None:
    assert len(SPEC) >= 20
