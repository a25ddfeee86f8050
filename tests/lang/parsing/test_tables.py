"""The tables of MCCL are those of its grammar."""

from __future__ import annotations

import re
from pathlib import Path

from motionlang.lang.parsing import generate
from motionlang.mccl.syntax import tables

PATH = Path(str(tables.__file__))


def test_the_tables_are_those_of_the_grammar() -> None:
    assert PATH.read_text() == generate.generate(PATH.parents[1].name), "run python -m tests.derived"


def test_no_group_is_repeated_possessively() -> None:
    """Python before 3.11.5 goes on at a wrong place after `(?:ab?c)*+`.

    It does not after `(?>(?:ab?c)*)`.
    """
    assert re.findall(r"(?<!\\)\)(?:[*+?]|\{[0-9,]*\})\+.*", PATH.read_text()) == []
