"""`motionlang repl`: selecting the language."""

from __future__ import annotations

import io
import sys

import pytest

from tests.cases import cases
from tests.cli.programs import Cell

TYPED = {
    ("repl",): ("PRINT 7\n", "7"),
    ("repl", "mint"): ("PRINT 7\n", "7"),
    ("repl", "mccl"): ("1TP\n", "01 0"),
    ("repl", "--lang", "mccl"): ("1TP\n", "01 0"),
}


@cases(("words", "typed", "shown"), [(words, *each) for words, each in TYPED.items()])
def test_a_language_may_stand_for_a_program(
    words: tuple[str, ...], typed: str, shown: str, cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
    ran = cell(*words)
    assert (ran.status, ran.err) == (0, "")
    assert shown in ran.out


def test_a_file_of_that_name_is_a_program(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("mccl", "PRINT 8\n")
    monkeypatch.setattr(sys, "stdin", io.StringIO("PRINT 7\n"))
    assert cell("repl", "mccl").out.split() == ["8", "7"]
