"""Old names of options and of machine-file sections still work, with a note."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator

import pytest

from motionlang import run
from motionlang.cli.commands import build_parser
from motionlang.cli.parser import OLD_OPTIONS, Parser
from motionlang.errors import OldName
from motionlang.lang.machine.file import read_machine
from motionlang.source import Source
from tests.cli.programs import Cell

VOLTS = "PRINT DRIVEBUSVOLTS(0)\nPRINT 0.5\n"
OLD = '[readings]\n"mint.float-zeros" = "dropped"\n[mint.readings]\nDRIVEBUSVOLTS = 325\n'
NEW = OLD.replace("[readings]", "[assumptions]").replace("mint.readings", "mint.values")
NOTES = (
    "note: machine file: [readings] is now [assumptions]\n"
    "note: machine file: [mint.readings] is now [mint.values]\n"
)


def parsers(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    yield parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for each in action.choices.values():
                yield from parsers(each)


ALL = list(parsers(build_parser("*")))


@pytest.mark.parametrize(("old", "new"), OLD_OPTIONS.items())
def test_each_old_option_has_become_one_option_and_is_hidden(old: str, new: str) -> None:
    renamed = [each for each in ALL if new.partition("=")[0] in each._option_string_actions]
    assert renamed
    assert not [each.prog for each in renamed if old in each._option_string_actions]
    assert not [each.prog for each in renamed if f"{old} " in each.format_help()]


def test_an_old_option_does_what_the_new_one_does_with_one_note(cell: Cell) -> None:
    new = cell("probe", "mccl", "--skip", "mccl.line-length", "--skip", "mccl.overflow")
    old = cell("probe", "mccl", "--without", "mccl.line-length", "--without=mccl.overflow")
    assert (new.status, new.err) == (0, "")
    assert (old.status, old.out) == (0, new.out)
    assert old.err == "note: motionlang probe: --without is now --skip\n"


def test_a_command_without_the_new_option_does_not_know_the_old_one(cell: Cell) -> None:
    ran = cell("check", "ballscrew.mcl", "--without", "x")
    assert ran.status == 2
    assert "unrecognized arguments: --without" in ran.err
    assert isinstance(ALL[0], Parser)


def test_old_sections_of_a_machine_file(cell: Cell) -> None:
    cell.write("volts.mnt", VOLTS)
    cell.write("volts.machine.toml", NEW)
    new = cell("run", "volts.mnt", "--format", "json")
    cell.write("volts.machine.toml", OLD)
    old = cell("run", "volts.mnt", "--format", "json")
    assert json.loads(new.out)["output"] == ["325", "0.5"]
    assert (new.err, old.out) == ("", new.out)
    assert old.err == NOTES


def test_old_sections_on_the_command_line(cell: Cell) -> None:
    cell.write("volts.mnt", VOLTS)
    ran = cell("run", "volts.mnt", "--format", "none", "--set", "mint.readings.DRIVEBUSVOLTS=325")
    assert ran.out.split()[0] == "325.0000"
    assert ran.err == NOTES.splitlines(True)[1]
    ran = cell(
        "sweep", "volts.mnt", "--vary", "mint.readings.DRIVEBUSVOLTS=1,2", "--keep", "number.1", "--jobs", "1"
    )
    assert [line.split() for line in ran.out.splitlines()[-2:]] == [["1", "1"], ["2", "2"]]
    assert ran.err == NOTES.splitlines(True)[1]


def test_old_sections_in_python_are_a_warning() -> None:
    with pytest.warns(OldName, match=r"\[mint.readings\] is now \[mint.values\]"):
        result = run(Source("volts.mnt", VOLTS), machine={"mint.readings.DRIVEBUSVOLTS": 325})
    assert result.output[0] == "325.0000"


def test_a_mistake_in_an_old_section_has_its_line() -> None:
    from motionlang.errors import ProgramError

    with pytest.warns(OldName), pytest.raises(ProgramError) as raised:
        read_machine(Source("m.toml", '[readings]\n"mint.float-zeros" = 3\n'))
    (found,) = raised.value.diagnostics
    assert (found.line, found.column) == (2, 1)


def test_a_command_that_draws_has_no_option_to_draw(cell: Cell) -> None:
    """`plot` names its file in place of the option, `trace` has both."""
    cell.write("a.mnt", "MOVER(0) = 1 : GO(0)\n")
    ran = cell("plot", "a.mnt", "a.html", "--plot", "b.html")
    assert (ran.status, ran.err.splitlines()[0]) == (
        2, "motionlang plot: error: unrecognized arguments: --plot b.html",
    )  # fmt: skip
    assert cell("trace", "a.mnt", "a.csv", "--plot", "b.html").status == 0
    assert (cell.folder / "b.html").exists()
