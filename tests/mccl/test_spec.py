"""The language by example: files under tests/spec/mccl with each line's output."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.mccl.keywords import table
from motionlang.mccl.resolve.line import Line, lines_of

SPEC = sorted((Path(__file__).parents[1] / "spec" / "mccl").glob("*.mcl"))


def promised(text: str) -> list[str]:
    """Return the lines of expected output, which follow `;> `."""
    return [line[3:] for line in text.split("\n") if line.startswith(";> ")]


@pytest.mark.parametrize("path", SPEC, ids=lambda path: path.stem)
def test_the_terminal_shows_what_the_page_says(path: Path) -> None:
    result = run(path, dialect="mccl", prove=True)
    assert result.output == promised(path.read_text())
    assert result.proof().violations == []


def test_every_word_of_the_table_is_on_a_page() -> None:
    """VE and HE, whose answers change with every version, are tested in `test_models`."""
    lines = [line for path in SPEC for line in lines_of(path.read_text()) if isinstance(line, Line)]
    used = {command.name for line in lines for command in line.commands}
    assert {row.name for row in table()} - used == {"VE", "HE"}
