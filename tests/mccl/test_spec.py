"""The language by example: each file under tests/spec/mccl says after each line what the terminal shows."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run

SPEC = sorted((Path(__file__).parents[1] / "spec" / "mccl").glob("*.mcl"))


def promised(text: str) -> list[str]:
    """The lines after `;> `."""
    return [line[3:] for line in text.split("\n") if line.startswith(";> ")]


@pytest.mark.parametrize("path", SPEC, ids=lambda path: path.stem)
def test_the_terminal_shows_what_the_page_says(path: Path) -> None:
    assert run(path, dialect="mccl").output == promised(path.read_text())


def test_there_are_pages() -> None:
    assert len(SPEC) >= 8
