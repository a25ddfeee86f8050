"""The keyword pages say what the tables say."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.keyword_pages import pages


@pytest.mark.parametrize(("path", "text"), pages().items(), ids=lambda value: getattr(value, "stem", ""))
def test_the_page_is_what_the_table_says(path: Path, text: str) -> None:
    assert path.read_text(encoding="utf-8") == text, "python -m tests.keyword_pages writes the pages anew"
