"""The keyword pages match the tables, and the examples' output."""

from __future__ import annotations

import re

import pytest

from motionlang.execution import dialects
from tests.keyword_pages import page, path


@pytest.mark.parametrize("language", dialects())
def test_the_page_is_what_the_table_says(language: str) -> None:
    text = path(language).read_text(encoding="utf-8")
    assert text == page(language), "python -m tests.derived writes the pages anew"


@pytest.mark.parametrize("language", dialects())
def test_no_field_is_empty_and_every_heading_is_there_once(language: str) -> None:
    text = path(language).read_text(encoding="utf-8")
    assert not re.search(r": (·|$)|· ·|\|[ \t]*\||```\n```", re.sub(r"```.*?```", "", text, flags=re.DOTALL))
    headings = re.findall(r"^### (.+)$", text, re.MULTILINE)
    assert len(headings) == len(set(headings))
    links = re.findall(r"^\* \[(.+)\]\(#.+\)$", text, re.MULTILINE)
    assert links == re.findall(r"^## (.+)$", text, re.MULTILINE)
