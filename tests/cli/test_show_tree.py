"""`motionlang run FILE --show-tree` prints the syntax tree of a program and runs nothing."""

from __future__ import annotations

import re

from tests.cases import cases
from tests.cli.programs import Cell


def test_each_node_has_a_line(cell: Cell) -> None:
    cell.write("a.mcl", '1PS0.1,OT"hello"\n  1WS@3\n')
    ran = cell("run", "a.mcl", "--show-tree")
    assert (ran.status, ran.err) == (0, "")
    assert ran.out.splitlines() == [
        "Module",
        "  Line number=1",
        "    Command axis=1 word='PS' argument=0.1",
        "    Command word='OT' argument='hello'",
        "  Line number=2",
        "    Command axis=1 word='WS'",
        "      argument: Register number=3",
    ]
    cell.write("a.mnt", "If INX(1) Then MOVER(0) = -5\n")
    assert cell("run", "a.mnt", "--show-tree").out.splitlines()[:3] == [
        "Module",
        "  If",
        "    condition: Name name='INX'",
    ]


@cases("file", ["wrong.mnt", "wrong.mcl"])
def test_syntax_errors_are_those_of_check(cell: Cell, file: str) -> None:
    cell.write("wrong.mnt", "SPEED(0) = = 1\n")
    cell.write("wrong.mcl", "1MR5 5\n")
    shown, checked = cell("run", file, "--show-tree"), cell("check", file)
    assert (shown.status, shown.out) == (1, "")
    errors = re.findall(r"error\[.*", checked.out)
    assert errors
    assert re.findall(r"error\[.*", shown.err) == errors


@cases("option", ["--until=3", "--plot=a.png", "--format=none", "--prove", "--trace=a.csv"])
def test_options_of_a_run_are_refused(cell: Cell, option: str) -> None:
    ran = cell("run", "ballscrew.mcl", "--show-tree", option)
    name = option.partition("=")[0]
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(
        f"motionlang run: error: {name} has no effect with --show-tree, which runs nothing\n"
    )
