"""What `diff --explore` says of edits: each program, its edit and the sentences are in `sentences.txt`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.programs import Cell

PAGE = Path(__file__).parent / "sentences.txt"
# Separates lines of an edit.
LINE = " / "


@pytest.mark.slow
def test_each_edit_is_told_as_it_is(cell: Cell, golden: Callable[[Path, str], None]) -> None:
    head, *sections = PAGE.read_text(encoding="utf-8").split("\n== ")
    parts = [head]
    for section in sections:
        given, _, _ = section.partition("\n---\n")
        name, *program, edit = given.split("\n")
        text = "\n".join(program) + "\n"
        old, new = edit.split(" -> ")
        changed = "\n".join(line.strip() for line in program) + "\n"
        old, new = old.replace(LINE, "\n"), new.replace(LINE, "\n")
        assert changed.count(old) == 1, name
        cell.write("a.mnt", text)
        cell.write("b.mnt", changed.replace(old, new))
        ran = cell("diff", "a.mnt", "b.mnt", "--explore")
        parts.append(f"{given}\n---\n{ran.out}{ran.err}exit status {ran.status}\n")
    golden(PAGE, "\n== ".join(parts))
