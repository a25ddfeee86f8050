"""The glossary has existing keywords and usual units, and each term only once."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from motionlang.kernel import dialect

PAGE = (Path(__file__).parents[1] / "docs" / "glossary.md").read_text(encoding="utf-8")
COLUMNS = {"mint": 3, "mccl": 4}


def rows() -> Iterator[list[str]]:
    """Yield the cells of each term's line."""
    for line in PAGE.splitlines():
        if line.startswith("| ") and not line.startswith("| term |"):
            yield [cell.strip() for cell in line.strip("|").split("|")]


@pytest.mark.parametrize(("language", "column"), COLUMNS.items())
def test_each_keyword_is_one_of_its_language(language: str, column: int) -> None:
    known = {row.name for row in dialect(language).table()}
    named = {name for cells in rows() if len(cells) == 6 for name in re.findall(r"`(\w+)`", cells[column])}
    assert named
    assert named <= known


def test_each_term_has_one_meaning() -> None:
    terms = [term for cells in rows() for term in cells[0].split(", ")]
    assert len(terms) > 70
    assert sorted(set(terms)) == sorted(terms)
    assert all(cells[1] for cells in rows())
