"""The examples for Python with functions of this distribution: each prints what its comments say."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.test_examples import OTHERS, SHOWN, lines_of  # noqa: F401


@pytest.mark.parametrize("path", OTHERS, ids=lambda path: path.stem)
def test_an_example_prints_its_comments(path: Path, lines_of: Callable[[Path], list[str]]) -> None:  # noqa: F811
    assert lines_of(path) == SHOWN.findall(path.read_text(encoding="utf-8"))
