"""Sessions with the commands of this distribution, as text."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.test_transcripts import compared, sections_of  # noqa: F401

PAGES = sorted(Path(__file__).parent.glob("transcripts*.txt"))


@pytest.mark.parametrize(("page", "name"), sections_of(PAGES))
def test_a_transcript(page: Path, name: str, compared: Callable[[Path, str], None]) -> None:  # noqa: F811
    compared(page, name)
