"""`motionlang check FILE --tree` prints the syntax tree of a program."""

from __future__ import annotations

import json

from tests.cases import cases
from tests.cli.programs import Cell


def tree_of(file: str, cell: Cell) -> list[str]:
    """Return the lines below the findings."""
    ran = cell("check", file, "--tree")
    assert (ran.status, ran.err) == (0, "")
    lines = ran.out.splitlines()
    return lines[lines.index("Module") :]


def test_each_node_has_a_line(cell: Cell) -> None:
    cell.write("a.mcl", '1PS0.1,OT"hello"\n  1WS@3\n')
    assert tree_of("a.mcl", cell) == [
        "Module",
        "  Line number=1",
        "    Command axis=1 word='PS' argument=0.1",
        "    Command word='OT' argument='hello'",
        "  Line number=2",
        "    Command axis=1 word='WS'",
        "      argument: Register number=3",
    ]
    cell.write("a.mnt", "If INX(1) Then MOVER(0) = -5\n")
    assert tree_of("a.mnt", cell)[:3] == [
        "Module",
        "  If",
        "    condition: Name name='INX'",
    ]


def test_the_tree_is_part_of_the_document(cell: Cell) -> None:
    cell.write("a.mcl", "1MN\n")
    (row,) = json.loads(cell("check", "a.mcl", "--tree", "--format", "json").out)["files"]
    assert row["tree"].splitlines() == tree_of("a.mcl", cell)


@cases("file", ["wrong.mnt", "wrong.mcl"])
def test_syntax_errors_are_those_of_check(cell: Cell, file: str) -> None:
    cell.write("wrong.mnt", "SPEED(0) = = 1\n")
    cell.write("wrong.mcl", "1MR5 5\n")
    shown, checked = cell("check", file, "--tree"), cell("check", file)
    assert (shown.status, shown.out, shown.err) == (1, checked.out, "")
