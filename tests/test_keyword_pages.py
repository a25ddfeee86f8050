"""The keyword pages match the tables, and show the real output of the examples."""

from __future__ import annotations

import re

import pytest

from motionlang.kernel.lang.dialect import dialect, dialects
from tests.keyword_pages import MENU, stored, with_menu, written


@pytest.mark.slow
@pytest.mark.parametrize("language", dialects())
def test_the_pages_are_what_the_table_says(language: str) -> None:
    assert stored(language) == written(language), "python -m tests.derived writes the pages again"


def test_the_menu_of_the_site_has_them() -> None:
    text = MENU.read_text(encoding="utf-8")
    assert text == with_menu(text), "python -m tests.derived writes the menu again"


@pytest.mark.parametrize("language", dialects())
def test_no_field_is_empty_and_every_heading_is_there_once(language: str) -> None:
    headings: list[str] = []
    for path, text in stored(language).items():
        plain = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
        assert not re.search(r": (·|$)|· ·|\|[ \t]*\||```\n```", plain), path
        if not path.endswith("not-simulated.md"):
            headings += re.findall(r"^## (.+)$", text, re.MULTILINE)
    simulated = [row.name for row in dialect(language).table() if row.simulated]
    assert sorted(headings) == sorted([*simulated, "From A to Z"])


@pytest.mark.parametrize("language", dialects())
def test_the_index_leads_to_each_keyword(language: str) -> None:
    """`test_links.py` checks that the headings exist to which it links."""
    index = stored(language)[f"{language}.md"]
    linked = re.findall(r"\[([^\]]+)\]\([^)#]+#[^)]+\)", index)
    assert linked == sorted(row.name for row in dialect(language).table() if row.simulated)
