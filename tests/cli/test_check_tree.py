"""`motionlang check FILE --tree` prints the syntax tree of a program."""

from __future__ import annotations

import json

from tests.cli.programs import Cell


def tree_of(file: str, cell: Cell) -> list[str]:
    """Return the lines below the findings."""
    ran = cell("check", file, "--tree")
    assert (ran.status, ran.err) == (0, "")
    lines = ran.out.splitlines()
    return lines[lines.index("Module") :]


def test_the_tree_is_part_of_the_document(cell: Cell) -> None:
    cell.write("a.mcl", "1MN\n")
    (row,) = json.loads(cell("check", "a.mcl", "--tree", "--format", "json").out)["files"]
    assert row["tree"].splitlines() == tree_of("a.mcl", cell)
