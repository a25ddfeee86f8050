"""The keyword pages have each simulated keyword once."""

from __future__ import annotations

import re

import pytest

from motionlang.kernel import dialect, dialects
from tools.keyword_pages import stored


@pytest.mark.parametrize("language", dialects())
def test_no_field_is_empty_and_every_heading_is_there_once(language: str) -> None:
    headings: list[str] = []
    for path, text in stored(language).items():
        plain = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
        assert not re.search(r": (·|$)|· ·|\|[ \t]*\||```\n```", plain), path
        if not path.endswith("not-simulated.md"):
            headings += re.findall(r"^## (.+)$", text, re.MULTILINE)
    simulated = [row.name for row in dialect(language).table() if row.simulated]
    assert sorted(headings) == sorted([*simulated, "From A to Z", "From memory"])


@pytest.mark.parametrize("language", dialects())
def test_the_index_leads_to_each_keyword(language: str) -> None:
    """`test_links.py` checks that the headings exist to which it links."""
    index = stored(language)[f"{language}.md"]
    linked = re.findall(r"\[([^\]]+)\]\([^)#]+#[^)]+\)", index)
    assert linked == sorted(row.name for row in dialect(language).table() if row.simulated)
