"""Spellings of one recording: `init` finds the same rules in each."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.recording import read_file
from test_explore.recording.rules import assert_same_rules, rules_of
from tests.commands.recording.spelled import Spelling, write
from tests.commands.recording.test_spellings import TABLE


@pytest.mark.parametrize("spelling", TABLE, ids=[each.title for each in TABLE])
def test_a_spelling(spelling: Spelling, tmp_path: Path) -> None:
    found = rules_of(read_file(str(write(spelling, tmp_path))))
    assert_same_rules(found, rules_of(read_file(str(write(TABLE[0], tmp_path)))))
