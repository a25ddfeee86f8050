"""Spellings of one recording: each has the same answer, and the warnings that its section lists."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.recording import read_file
from tests.commands.recording.spelled import STEP, Spelling, answer, spellings, write

TABLE = spellings(Path(__file__).parent / "spellings.txt")


@pytest.mark.parametrize("spelling", TABLE, ids=[each.title for each in TABLE])
def test_a_spelling(spelling: Spelling, tmp_path: Path) -> None:
    found = answer(read_file(str(write(spelling, tmp_path))))
    right = answer(read_file(str(write(TABLE[0], tmp_path))))
    assert abs(found.delay) < STEP
    assert found.residual < 100.0 * STEP  # of 100 uu/s
    assert abs(found.points - right.points) <= 10
    assert len(found.remarks) == len(spelling.warnings), found.remarks
    for text, remark in zip(spelling.warnings, found.remarks, strict=True):
        assert text in remark


def test_fifty_spellings() -> None:
    assert len({each.title for each in TABLE}) >= 50
